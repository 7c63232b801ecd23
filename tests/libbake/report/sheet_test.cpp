#include "libbake/report/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libbake/report/choice_sheets.h"
#include "tests/libbake/report/tile_fixture.h"

namespace texbake {
namespace {

TEST(Sheet, HoldsEveryCellUnchangedInItsPlace) {
  const V3f colors[] = {{0.9f, 0.1f, 0.1f}, {0.1f, 0.9f, 0.1f}, {0.1f, 0.1f, 0.9f}};
  Sheet sheet{"title", 2, {}};
  for (const V3f& color : colors) sheet.cells.push_back({"label", Image<V3f>(40, 30, color)});
  const Image<V3f> picture = draw(sheet);
  for (const V3f& color : colors) EXPECT_EQ(std::count(picture.begin(), picture.end(), color), 40 * 30);
  // The third cell stands below the first.
  const auto first = [&](const V3f& color) {
    const auto at = std::find(picture.begin(), picture.end(), color) - picture.begin();
    return V2i(static_cast<int>(at % picture.width()), static_cast<int>(at / picture.width()));
  };
  EXPECT_EQ(first(colors[0]).y, first(colors[1]).y);
  EXPECT_EQ(first(colors[0]).x, first(colors[2]).x);
  EXPECT_GT(first(colors[2]).y, first(colors[0]).y + 30);
}

TEST(Sheet, LabelsAreDrawn) {
  const auto dark = [](const std::string& label) {
    Sheet sheet{"", 1, {}};
    sheet.cells.push_back({label, Image<V3f>(200, 20, V3f(0.5f))});
    const Image<V3f> picture = draw(sheet);
    return std::count_if(picture.begin(), picture.end(), [](const V3f& c) { return c.x < 0.2f; });
  };
  EXPECT_EQ(dark(""), 0);
  EXPECT_GT(dark("label"), 40);
  EXPECT_GT(dark("label\nof two lines"), dark("label") + 40);
}

PrincipalVariation colors_of(const Image<V3f>& base) { return convert(base, {}, {.classes = 3}).colors; }

TEST(ChoiceSheets, ShowEveryChoice) {
  const TileFixture fixture = tile_fixture(64, 1);
  const PrincipalVariation colors = colors_of(fixture.base);
  EXPECT_EQ(convert_sheet(fixture.base, {}).cells.size(), 8u);
  const Sheet fragments = fragment_sheet(colors, fixture.base, {});
  ASSERT_EQ(fragments.cells.size(), 9u);
  EXPECT_NE(fragments.cells[0].label.find("--threshold"), std::string::npos);
  const Sheet contents = select_contents_sheet(colors, fixture.base, fixture.patches, {});
  ASSERT_EQ(contents.cells.size(), 9u);
  EXPECT_NE(contents.cells[0].label.find("--count 6 --seed 1"), std::string::npos);
  EXPECT_NE(contents.cells[8].label.find("--count 11 --seed 3"), std::string::npos);
}

TEST(ChoiceSheets, OfOneColorHasOnlyWhatThereIs) {
  const Image<V3f> flat(64, 64, V3f(0.2f, 0.4f, 0.3f));
  EXPECT_EQ(convert_sheet(flat, {}).cells.size(), 2u);
}

}  // namespace
}  // namespace texbake
