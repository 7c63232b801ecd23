// From the numbers of a file to linear Rec.709: which curve, which primaries, or which profile.
// Based on: ITU-R BT.709; ITU-T H.273 (code points); Bradford chromatic adaptation (ICC.1:2010, annex E).
#pragma once

#include <Imath/ImathMatrix.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formats/icc_profile.h"
#include "formats/picture_values.h"

namespace texbake {

/// CIE x, y of red, green, blue and white.
struct Chromaticities {
  double xy[4][2];
};

/// Are these the primaries and the white of Rec.709, as files round them?
bool is_rec709(const Chromaticities& chromaticities);

/// What a file says of its colors. `source` names what says it, for people: "its chunk cHRM".
struct ColorFacts {
  std::string profile = {};  ///< the bytes of an ICC profile; counts before the rest
  std::optional<Chromaticities> primaries = {};
  std::optional<InputCurve> curve = {};
  std::string source = {};
  std::string doubt = {};  ///< what is not known: a sentence for people
};

/// How numbers become light: by a curve for each channel and then a matrix, or by a transform.
struct ColorReading {
  std::vector<InputCurve> curves = {InputCurve::linear()};  ///< one for all channels, or three
  std::optional<Imath::M33d> rec709_from_file = {};         ///< a row vector of light times this
  std::shared_ptr<const IccTransform> transform = {};
  std::string space = "linear";         ///< the name of the curve
  std::vector<std::string> notes = {};  ///< what was done beyond the curve
};

/// `channels` is 1 (gray), 3 (RGB) or 4 (CMYK); `usual` is the curve where the file says nothing. A `space` that is not
/// automatic is the curve of Rec.709 primaries, whatever the file says. Throws Error(unsupported) for CMYK without a
/// profile of its own.
ColorReading color_reading(const std::string& path, const ColorFacts& facts, InputSpace space, int channels,
                           const InputCurve& usual);

/// Color primaries and transfer characteristics by their numbers in H.273, as cICP and nclx give them; numbers that
/// say nothing leave `facts` as it is. Throws Error(unsupported) for PQ and HLG.
void add_code_points(const std::string& path, int primaries, int transfer, ColorFacts& facts);

}  // namespace texbake
