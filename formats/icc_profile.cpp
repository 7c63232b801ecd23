#include "formats/icc_profile.h"

#include <fmt/format.h>
#include <lcms2.h>

#include <cmath>

#include "libbake/color/luv.h"

namespace texbake {
namespace {

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct DeleteTransform {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using ProfileHandle = std::unique_ptr<void, CloseProfile>;
using TransformHandle = std::unique_ptr<void, DeleteTransform>;

constexpr int kCurveEntries = 65536;  // every code of 8 and of 16 bits is an entry

// Curves that differ by less than this in linear light are the same: tables of profiles are rounded.
constexpr float kSameCurve = 2e-3f;

bool is_near(const std::vector<float>& table, float (*curve)(float)) {
  for (int i = 0; i < kCurveEntries; i += 257)
    if (std::fabs(table[static_cast<size_t>(i)] - curve(static_cast<float>(i) / (kCurveEntries - 1))) > kSameCurve)
      return false;
  return true;
}

InputCurve input_curve(const cmsToneCurve* tone) {
  std::vector<float> table(kCurveEntries);
  for (int i = 0; i < kCurveEntries; ++i)
    table[static_cast<size_t>(i)] = cmsEvalToneCurveFloat(tone, static_cast<float>(i) / (kCurveEntries - 1));
  if (is_near(table, [](float x) { return x; })) return InputCurve::linear();
  if (is_near(table, linear_from_srgb)) return InputCurve::srgb();
  const double gamma = cmsEstimateGamma(tone, 0.01);
  return InputCurve::sampled(std::move(table), gamma > 0 ? fmt::format("gamma {:.3g}", gamma) : "profile");
}

const cmsToneCurve* tone_curve(cmsHPROFILE profile, cmsTagSignature tag) {
  return static_cast<const cmsToneCurve*>(cmsReadTag(profile, tag));
}

// Curves and primaries, where the profile has no more than those.
void read_curves(cmsHPROFILE handle, IccProfile& profile) {
  if (profile.channels == 1) {
    if (const cmsToneCurve* tone = tone_curve(handle, cmsSigGrayTRCTag)) profile.curves = {input_curve(tone)};
    return;
  }
  if (profile.channels != 3 || !cmsIsMatrixShaper(handle) || cmsIsTag(handle, cmsSigAToB0Tag)) return;
  constexpr cmsTagSignature curves[] = {cmsSigRedTRCTag, cmsSigGreenTRCTag, cmsSigBlueTRCTag};
  constexpr cmsTagSignature primaries[] = {cmsSigRedColorantTag, cmsSigGreenColorantTag, cmsSigBlueColorantTag};
  std::vector<InputCurve> read;
  for (int c = 0; c < 3; ++c) {
    const cmsToneCurve* const tone = tone_curve(handle, curves[c]);
    const auto* const xyz = static_cast<const cmsCIEXYZ*>(cmsReadTag(handle, primaries[c]));
    if (!tone || !xyz) return;
    read.push_back(input_curve(tone));
    profile.xyz_d50_from_rgb[c][0] = xyz->X;
    profile.xyz_d50_from_rgb[c][1] = xyz->Y;
    profile.xyz_d50_from_rgb[c][2] = xyz->Z;
  }
  profile.curves = std::move(read);
}

ProfileHandle linear_rec709() {
  const cmsCIExyY white = {0.3127, 0.3290, 1};
  const cmsCIExyYTRIPLE primaries = {{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
  cmsToneCurve* const line = cmsBuildGamma(nullptr, 1);
  cmsToneCurve* const curves[] = {line, line, line};
  ProfileHandle profile(cmsCreateRGBProfile(&white, &primaries, curves));
  cmsFreeToneCurve(line);
  return profile;
}

class LittleCmsTransform : public IccTransform {
 public:
  LittleCmsTransform(TransformHandle transform, int channels) : transform_(std::move(transform)), channels_(channels) {}

  void apply(const float* encoded, float* linear, int count) const override {
    if (channels_ != 4) return cmsDoTransform(transform_.get(), encoded, linear, static_cast<cmsUInt32Number>(count));
    std::vector<float> percent(encoded, encoded + 4 * static_cast<size_t>(count));  // inks are percents
    for (float& ink : percent) ink *= 100;
    cmsDoTransform(transform_.get(), percent.data(), linear, static_cast<cmsUInt32Number>(count));
  }

 private:
  TransformHandle transform_;
  int channels_;
};

std::shared_ptr<const IccTransform> make_transform(cmsHPROFILE handle, int channels) {
  const ProfileHandle target = linear_rec709();
  const cmsUInt32Number format = channels == 4 ? TYPE_CMYK_FLT : channels == 3 ? TYPE_RGB_FLT : TYPE_GRAY_FLT;
  TransformHandle transform(cmsCreateTransform(handle, format, target.get(), TYPE_RGB_FLT, INTENT_RELATIVE_COLORIMETRIC,
                                               cmsFLAGS_NOCACHE | cmsFLAGS_NOOPTIMIZE));
  return transform ? std::make_shared<LittleCmsTransform>(std::move(transform), channels) : nullptr;
}

std::string description_of(cmsHPROFILE handle) {
  char text[256] = "";
  cmsGetProfileInfoASCII(handle, cmsInfoDescription, "en", "US", text, sizeof(text));
  return text;
}

}  // namespace

std::optional<IccProfile> read_icc_profile(std::string_view bytes) {
  const ProfileHandle handle(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
  if (!handle) return std::nullopt;
  IccProfile profile;
  switch (cmsGetColorSpace(handle.get())) {
    case cmsSigGrayData:
      profile.channels = 1;
      break;
    case cmsSigRgbData:
      profile.channels = 3;
      break;
    case cmsSigCmykData:
      profile.channels = 4;
      break;
    default:
      return std::nullopt;
  }
  profile.name = description_of(handle.get());
  read_curves(handle.get(), profile);
  if (profile.curves.empty()) profile.transform = make_transform(handle.get(), profile.channels);
  if (profile.curves.empty() && !profile.transform) return std::nullopt;
  return profile;
}

}  // namespace texbake
