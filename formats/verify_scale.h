// Checks of one scale that need its pixels or its tables as a whole.
#pragma once

#include <set>
#include <string>

#include "formats/bundle.h"
#include "formats/issues.h"

namespace texbake {

/// A scale and the names by which its issues point at it.
struct ScaleUnderTest {
  const Scale& scale;
  V2i size;                             ///< by the manifest: there are no pixels where they could not be read
  std::string pointer;                  ///< "/scales/0"
  std::string file;                     ///< payload
  const std::set<std::string>& planes;  ///< keys of those that were read and are what the manifest says
  bool has(const char* plane) const { return planes.contains(plane); }
};

void check_palette(const ScaleUnderTest& test, IssueLog& log);
/// Recorded means of the base, whole and over each fragment. `mean` is the manifest's.
void check_means(const ScaleUnderTest& test, const V3f& mean, IssueLog& log);
/// Connectivity, unwrapping, centers of fragments and patches; patches are unions of whole fragments.
void check_partitions(const ScaleUnderTest& test, IssueLog& log);
void check_contents(const ScaleUnderTest& test, IssueLog& log);

}  // namespace texbake
