#include "libbake/content/choice_figures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "libbake/base/mean.h"
#include "libbake/base/parallel.h"
#include "libbake/content/far_view.h"
#include "libbake/content/shown_source.h"

namespace texbake {
namespace {

// The two sums of G.
struct GSums {
  double shared = 0;
  double all = 0;

  double repetition() const { return all > 0.0 ? shared / all : 0.0; }
};

// Adds what the colors `z` that show at one place with the contents of its patch contribute.
template <class ColorOf>
void add_place(std::span<const Content> contents, const ColorOf& color_of, GSums& sums) {
  V3f sum(0);
  double energy = 0.0;
  for (const Content& content : contents) {
    const V3f z = color_of(content);
    sum += z;
    energy += static_cast<double>(z.length2());
  }
  const auto n = static_cast<double>(contents.size());
  sums.shared += static_cast<double>(sum.length2()) / (n * n);
  sums.all += energy / n;
}

double repetition_near(const ContentTable& table, ImageView<const V3f> luv, const Partition& patches) {
  const V3f mean = mean_of(luv);
  std::vector<GSums> rows(static_cast<size_t>(luv.height()));
  parallel_for(0, luv.height(), [&](int y) {
    for (int x = 0; x < luv.width(); ++x) {
      const uint32_t patch = patches.idx(x, y);
      const auto color_of = [&](const Content& content) {
        const V2i source = shown_source(patches, patch, {x, y}, content);
        return luv(source.x, source.y) - mean;
      };
      add_place(table.of(static_cast<int>(patch)), color_of, rows[static_cast<size_t>(y)]);
    }
  });
  GSums total;
  for (const GSums& row : rows) {
    total.shared += row.shared;
    total.all += row.all;
  }
  return total.repetition();
}

double repetition_far(const ContentTable& table, ImageView<const V3f> luv, const Partition& patches) {
  const FarView view(luv, patches);
  FarField mean = view.blank();
  double varying = 0.0;  // contents are drawn for each patch by itself, so their variances add up
  for (uint32_t patch = 0; patch < static_cast<uint32_t>(patches.count()); ++patch) {
    const auto contents = table.of(static_cast<int>(patch));
    const float per_content = 1.0f / static_cast<float>(contents.size());
    std::optional<FarField> of_patch;
    for (const Content& content : contents) {
      FarField shown = view.shown(patch, content);
      varying += view.energy(shown) / static_cast<double>(contents.size());
      shown *= per_content;
      if (of_patch)
        *of_patch += shown;
      else
        of_patch = std::move(shown);
    }
    varying -= view.energy(*of_patch);
    view.add(*of_patch, mean);
  }
  const double shared = view.energy(mean);
  return shared + varying > 0.0 ? shared / (shared + varying) : 0.0;
}

double use_deviation(const ContentTable& table, const Partition& patches) {
  Image<int> use(patches.size().x, patches.size().y);
  for (int y = 0; y < use.height(); ++y)
    for (int x = 0; x < use.width(); ++x) {
      const uint32_t patch = patches.idx(x, y);
      for (const Content& content : table.of(static_cast<int>(patch))) {
        const V2i source = shown_source(patches, patch, {x, y}, content);
        ++use(source.x, source.y);
      }
    }
  double sum = 0.0, squares = 0.0;
  for (const int u : use) {
    sum += u;
    squares += static_cast<double>(u) * u;
  }
  const auto n = static_cast<double>(use.size());
  return std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0)) / (sum / n);
}

}  // namespace

ChoiceFigures choice_figures(const ContentTable& table, ImageView<const V3f> base_luv, const Partition& patches) {
  return {repetition_near(table, base_luv, patches), repetition_far(table, base_luv, patches),
          use_deviation(table, patches)};
}

}  // namespace texbake
