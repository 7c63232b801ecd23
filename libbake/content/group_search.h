// Searches given groups of translations for those of least impact; what the exact and the refined search share.
#pragma once

#include <vector>

#include "libbake/base/progress.h"
#include "libbake/content/candidates.h"
#include "libbake/content/class_distances.h"
#include "libbake/content/impact_kernel.h"
#include "libbake/content/patch_border.h"

namespace texbake {

/// A group of translations, see kGroupSize, and the patches that want to know about them.
struct GroupTask {
  V2i translation{0, 0};
  std::vector<uint8_t> wanted;  ///< for each patch; empty for all
};

/// A tile made ready for the search.
class GroupSearch {
 public:
  GroupSearch(ImageView<const uint8_t> classes, const ClassDistances& distances, const PatchBorders& borders);

  /// take_separated of all translations of `tasks`, for each patch. The search learns its limits from the first tasks,
  /// so they should be spread over the tile; kBatch tasks that follow each other are searched together, so they should
  /// be near each other.
  SearchResult run(const std::vector<GroupTask>& tasks, const SearchRequest& request, const Progress& progress) const;

 private:
  V2i size_;
  int patch_count_;
  BorderProgram program_;
  DistanceField field_;
  std::vector<uint32_t> order_;
};

inline constexpr int kBatch = 4;

/// 0 … count−1 with any stretch of batches spread over the whole, by steps of a golden section, and order kept in each.
std::vector<int> scattered_batches(int count);

}  // namespace texbake
