#include "bake/bake_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace texbake {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> verbs_for(Layers layers) {
  std::vector<std::string> verbs;
  for (const StageRow* row : stages_for({layers})) verbs.push_back(row->verb);
  return verbs;
}

TEST(BakeRequest, TheChainOfAnExemplarHasNoLayers) {
  EXPECT_THAT(verbs_for(Layers::exemplar), ElementsAre("convert", "fragment", "patch", "select-contents"));
}

TEST(BakeRequest, TheChainOfStructureAndNoiseSplitsTheExemplarFirst) {
  EXPECT_THAT(verbs_for(Layers::structure_noise),
              ElementsAre("convert", "decompose", "estimate-psd", "fragment", "patch", "select-contents"));
}

TEST(BakeRequest, EveryStageOfTheTableThatBakeRunsHasOptions) {
  BakeRequest request;
  for (const StageRow& row : stage_table()) {
    int structs = 0;
    for_each_options_of(row.verb, request, [&](auto&) { ++structs; });
    EXPECT_EQ(structs > 0, is_in_chain(row)) << row.verb;
  }
}

TEST(BakeRequest, TheSchemaOfRecipesNamesTheStagesOfTheTable) {
  std::ifstream file(TEXBAKE_SOURCE "/bake/recipe.schema.json");
  const Json schema = Json::parse(file);
  std::vector<std::string> named, known;
  for (const auto& [verb, rule] : schema["properties"]["stages"]["properties"].items()) named.push_back(verb);
  for (const StageRow& row : stage_table())
    if (is_in_chain(row)) known.push_back(row.verb);
  EXPECT_EQ(named, known);
}

TEST(BakeRequest, NoiseIsNotTakenFromTheCompactFormOfAPicture) {
  BakeRequest request;
  request.convert.storage.color = ColorForm::palette;
  EXPECT_NO_THROW(check_request(request));
  request.layers.layers = Layers::structure_noise;
  EXPECT_THROW(check_request(request), Error);
}

}  // namespace
}  // namespace texbake
