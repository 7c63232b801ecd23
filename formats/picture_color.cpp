#include "formats/picture_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/error.h"

namespace texbake {
namespace {

using Imath::M33d;
using Imath::V3d;

constexpr Chromaticities kRec709 = {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}}};
constexpr double kWhiteD50[3] = {0.9642, 1.0, 0.8249};  // of the profile connection space

// Matrices that differ by less than this are the same: primaries of files are rounded to three or four digits.
constexpr double kSameMatrix = 4e-3;

V3d xyz_of(const double (&xy)[2]) { return {xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]}; }

// Rows are the primaries, scaled so that (1, 1, 1) is white.
M33d xyz_from_rgb(const Chromaticities& c) {
  M33d rows;
  for (int i = 0; i < 3; ++i) {
    const V3d primary = xyz_of(c.xy[i]);
    for (int k = 0; k < 3; ++k) rows[i][k] = primary[k];
  }
  const V3d share = xyz_of(c.xy[3]) * rows.inverse();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) rows[i][k] *= share[i];
  return rows;
}

// Bradford: row vectors of XYZ under one white to those under another.
M33d adaptation(const V3d& from, const V3d& to) {
  const M33d lms_from_xyz(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);
  const V3d a = from * lms_from_xyz, b = to * lms_from_xyz;
  M33d scale;
  for (int k = 0; k < 3; ++k) scale[k][k] = b[k] / a[k];
  return lms_from_xyz * scale * lms_from_xyz.inverse();
}

M33d rec709_from(const M33d& xyz_from_file, const V3d& white) {
  return xyz_from_file * adaptation(white, xyz_of(kRec709.xy[3])) * xyz_from_rgb(kRec709).inverse();
}

bool is_identity(const M33d& m) {
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (!(std::fabs(m[i][k] - (i == k ? 1 : 0)) < kSameMatrix)) return false;
  return true;
}

bool is_sane(const Chromaticities& c) {
  for (const auto& xy : c.xy)
    if (!(std::fabs(xy[0]) < 2 && xy[1] > -2 && xy[1] < 2 && std::fabs(xy[1]) > 1e-6)) return false;
  const V3d white = xyz_of(c.xy[3]);
  const M33d m = xyz_from_rgb(c);
  return std::isfinite(m[0][0]) && std::isfinite(m[2][2]) && white.x > 0 && white.z > 0 &&
         std::fabs(m.determinant()) > 1e-6;
}

void set_curve(const InputCurve& curve, ColorReading& reading) {
  reading.curves = {curve};
  reading.space = curve.name();
}

// `matrix` where it is more than Rec.709 rounded, with the word for people.
void set_matrix(const M33d& matrix, const std::string& source, ColorReading& reading) {
  if (is_identity(matrix)) return;
  reading.rec709_from_file = matrix;
  reading.notes.push_back(fmt::format(
      "its colors were converted to Rec.709 primaries, from those of {} (--input-space keeps the numbers)", source));
}

// A profile where there is one that can be used; false where the file's other words count.
bool apply_profile(const ColorFacts& facts, int channels, ColorReading& reading) {
  if (facts.profile.empty()) return false;
  const auto profile = read_icc_profile(facts.profile);
  if (!profile || (profile->channels != channels && channels == 4)) {
    reading.notes.emplace_back("its color profile cannot be used and was ignored");
    return false;
  }
  const std::string source = fmt::format("its profile \"{}\"", profile->name);
  if (profile->transform && profile->channels == channels) {
    reading.transform = profile->transform;
    reading.space = "profile";
    reading.notes.push_back(
        fmt::format("its colors were converted to Rec.709 through {} (--input-space keeps the numbers)", source));
    return true;
  }
  if (profile->curves.empty()) return false;  // a table of colors, but a gray picture
  reading.curves = profile->curves;
  const auto same = [&](const InputCurve& curve) {
    return curve.name() == reading.curves.front().name() && (curve.name() == "srgb" || curve.name() == "linear");
  };
  if (std::all_of(reading.curves.begin(), reading.curves.end(), same) || channels == 1)
    reading.curves.resize(1, InputCurve::linear());
  reading.space = profile->curves.front().name();
  if (channels == 3 && profile->channels == 3)
    set_matrix(rec709_from(profile->xyz_d50_from_rgb, {kWhiteD50[0], kWhiteD50[1], kWhiteD50[2]}), source, reading);
  return true;
}

}  // namespace

bool is_rec709(const Chromaticities& chromaticities) {
  return is_sane(chromaticities) &&
         is_identity(rec709_from(xyz_from_rgb(chromaticities), xyz_of(chromaticities.xy[3])));
}

ColorReading color_reading(const std::string& path, const ColorFacts& facts, InputSpace space, int channels,
                           const InputCurve& usual) {
  ColorReading reading;
  if (channels == 4) {
    if (space == InputSpace::automatic && apply_profile(facts, channels, reading)) return reading;
    throw Error(ErrorKind::unsupported,
                fmt::format("{}: expected gray or RGB, found CMYK inks without a color profile that says what they "
                            "look like, which is not supported; convert it to sRGB",
                            path));
  }
  if (space != InputSpace::automatic) {
    set_curve(space == InputSpace::srgb ? InputCurve::srgb() : InputCurve::linear(), reading);
    return reading;
  }
  if (!facts.doubt.empty()) reading.notes.push_back(facts.doubt);
  if (apply_profile(facts, channels, reading)) return reading;
  set_curve(facts.curve.value_or(usual), reading);
  if (channels == 3 && facts.primaries && is_sane(*facts.primaries))
    set_matrix(rec709_from(xyz_from_rgb(*facts.primaries), xyz_of(facts.primaries->xy[3])), facts.source, reading);
  return reading;
}

void add_code_points(const std::string& path, int primaries, int transfer, ColorFacts& facts) {
  constexpr double kD65[2] = {0.3127, 0.3290};
  switch (primaries) {
    case 1:
      facts.primaries = kRec709;
      break;
    case 5:
      facts.primaries = {{{0.64, 0.33}, {0.29, 0.60}, {0.15, 0.06}, {kD65[0], kD65[1]}}};
      break;
    case 6:
    case 7:
      facts.primaries = {{{0.630, 0.340}, {0.310, 0.595}, {0.155, 0.070}, {kD65[0], kD65[1]}}};
      break;
    case 9:
      facts.primaries = {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {kD65[0], kD65[1]}}};
      break;
    case 11:
      facts.primaries = {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.314, 0.351}}};
      break;
    case 12:
      facts.primaries = {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {kD65[0], kD65[1]}}};
      break;
    default:
      break;
  }
  if (transfer == 16 || transfer == 18)
    throw Error(ErrorKind::unsupported, fmt::format("{}: expected the curve of sRGB, a power or none, found {}, which "
                                                    "is not supported; export it as linear OpenEXR",
                                                    path, transfer == 16 ? "PQ" : "HLG"));
  if (transfer == 8) facts.curve = InputCurve::linear();
  if (transfer == 4) facts.curve = InputCurve::exact_power(2.2);
  if (transfer == 5) facts.curve = InputCurve::exact_power(2.8);
  // Pictures that name the curve of video cameras (1, 6, 14, 15) are shown, and edited, as sRGB.
  if (transfer == 1 || transfer == 6 || transfer == 13 || transfer == 14 || transfer == 15)
    facts.curve = InputCurve::srgb();
}

}  // namespace texbake
