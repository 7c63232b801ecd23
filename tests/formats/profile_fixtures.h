// Color profiles for the tests, made by Little CMS.
#pragma once

#include <lcms2.h>

#include <algorithm>
#include <string>

#include "formats/picture_color.h"

namespace texbake {

/// The bytes of a profile, which is closed.
inline std::string saved_profile(cmsHPROFILE profile) {
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

/// RGB of these primaries, by the curve light = number^gamma.
inline std::string profile_bytes(const Chromaticities& c, double gamma, const char* name = "") {
  const cmsCIExyY white = {c.xy[3][0], c.xy[3][1], 1};
  const cmsCIExyYTRIPLE primaries = {
      {c.xy[0][0], c.xy[0][1], 1}, {c.xy[1][0], c.xy[1][1], 1}, {c.xy[2][0], c.xy[2][1], 1}};
  cmsToneCurve* const curve = cmsBuildGamma(nullptr, gamma);
  cmsToneCurve* const curves[] = {curve, curve, curve};
  cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
  cmsFreeToneCurve(curve);
  if (*name) {
    cmsMLU* const text = cmsMLUalloc(nullptr, 1);
    cmsMLUsetASCII(text, "en", "US", name);
    cmsWriteTag(profile, cmsSigProfileDescriptionTag, text);
    cmsMLUfree(text);
  }
  return saved_profile(profile);
}

/// CMYK of inks that are all black: L* falls from 100 without ink to 0 where any ink is full.
inline std::string ink_profile_bytes() {
  cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
  cmsSetDeviceClass(profile, cmsSigOutputClass);
  cmsSetColorSpace(profile, cmsSigCmykData);
  cmsSetPCS(profile, cmsSigLabData);
  cmsSetProfileVersion(profile, 4.3);
  cmsPipeline* const pipeline = cmsPipelineAlloc(nullptr, 4, 3);
  cmsStage* const table = cmsStageAllocCLut16bit(nullptr, 2, 4, 3, nullptr);
  const auto sample = [](const cmsUInt16Number inks[], cmsUInt16Number lab[], void*) -> cmsInt32Number {
    const cmsUInt16Number most = std::max({inks[0], inks[1], inks[2]});
    lab[0] = static_cast<cmsUInt16Number>(most || inks[3] ? 0 : 0xFFFF);
    lab[1] = lab[2] = 0x8080;
    return 1;
  };
  cmsStageSampleCLut16bit(table, sample, nullptr, 0);
  cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 4, nullptr));
  cmsPipelineInsertStage(pipeline, cmsAT_END, table);
  cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, nullptr));
  cmsWriteTag(profile, cmsSigAToB0Tag, pipeline);
  cmsPipelineFree(pipeline);
  return saved_profile(profile);
}

}  // namespace texbake
