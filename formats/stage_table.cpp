#include "formats/stage_table.h"

#include <algorithm>

namespace texbake {
namespace {

using Members = std::vector<std::string>;

bool share(const Members& a, const Members& b) {
  return std::ranges::any_of(a, [&](const std::string& member) { return std::ranges::find(b, member) != b.end(); });
}

bool is_finest(const Bundle& bundle, const Scale& scale) { return &scale == &bundle.scales.back(); }

std::vector<StageRow> rows() {
  return {
      {"convert",
       StageUse::always,
       {},
       {"size", "tileFromSource", "maps", "mean", "palette", "planes.preview", "planes.exemplar", "planes.index",
        "planes.variation", "planes.height"},
       {"colors", [](const Bundle&, const Scale& scale) { return scale.colors.has_value(); }}},
      {"decompose",
       StageUse::layers,
       {"planes.exemplar"},
       {"mean", "palette", "planes.structure", "planes.masks", "planes.index", "planes.variation"},
       {"structure", [](const Bundle&, const Scale& scale) { return scale.structure.has_value(); },
        [](Bundle&, Scale& scale) {
          scale.structure.reset();
          scale.masks.clear();
        }}},
      {"estimate-psd",
       StageUse::layers,
       {"planes.exemplar", "planes.structure", "planes.masks"},
       {"noise"},
       {"noises",
        [](const Bundle& bundle, const Scale& scale) { return bundle.noise.has_value() && is_finest(bundle, scale); },
        [](Bundle& bundle, Scale&) { bundle.noise.reset(); }}},
      {"fragment",
       StageUse::always,
       {"palette", "planes.exemplar", "planes.structure", "planes.index", "planes.variation"},
       {"fragments", "planes.fragment", "planes.fragmentClass", "planes.fragmentColor"},
       {"fragments", [](const Bundle&, const Scale& scale) { return scale.fragments.has_value(); },
        [](Bundle&, Scale& scale) { scale.fragments.reset(); }}},
      {"patch",
       StageUse::always,
       {"fragments", "planes.exemplar", "planes.structure", "planes.fragment"},
       {"patches", "planes.patch"},
       {"patches", [](const Bundle&, const Scale& scale) { return scale.patches.has_value(); },
        [](Bundle&, Scale& scale) { scale.patches.reset(); }}},
      {"select-contents",
       StageUse::always,
       {"palette", "patches", "planes.exemplar", "planes.structure", "planes.index", "planes.variation",
        "planes.patch"},
       {"contents", "softBorder"},
       {"contents", [](const Bundle&, const Scale& scale) { return scale.contents.has_value(); },
        [](Bundle&, Scale& scale) {
          scale.contents.reset();
          scale.soft_border_px = 0;
        }}},
      {"heightmap",
       StageUse::never,
       {"palette", "planes.exemplar", "planes.structure", "planes.index", "planes.variation"},
       {"planes.height"}},
      {"stack", StageUse::never, {}, {"transfer"}},
  };
}

/// stack reads all that the other stages write, once each.
std::vector<StageRow> make_table() {
  std::vector<StageRow> table = rows();
  Members& read_by_stack = table.back().reads;
  for (const StageRow& row : std::span(table).first(table.size() - 1))
    for (const std::string& member : row.writes)
      if (std::ranges::find(read_by_stack, member) == read_by_stack.end()) read_by_stack.push_back(member);
  return table;
}

}  // namespace

std::span<const StageRow> stage_table() {
  static const std::vector<StageRow> table = make_table();
  return table;
}

const StageRow* find_row(std::string_view verb) {
  const auto found = std::ranges::find(stage_table(), verb, &StageRow::verb);
  return found == stage_table().end() ? nullptr : &*found;
}

const StageRow& first_stage() { return stage_table().front(); }

std::vector<const StageRow*> derived_stages(std::string_view verb) {
  const StageRow* start = find_row(verb);
  std::vector<const StageRow*> derived;
  if (!start || !is_in_chain(*start)) return derived;
  Members changed = start->writes;
  for (const StageRow* row = start + 1; row != stage_table().data() + stage_table().size(); ++row)
    if (is_in_chain(*row) && share(row->reads, changed)) {
      derived.push_back(row);
      changed.insert(changed.end(), row->writes.begin(), row->writes.end());
    }
  return derived;
}

}  // namespace texbake
