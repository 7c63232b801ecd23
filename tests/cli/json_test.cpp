// Every verb's --json against the published schemas, by running the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace texbake {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What the program wrote to stdout.
std::string run(const std::string& arguments) {
  const std::string command = std::string(TEXBAKE_PROGRAM) + " " + arguments + " 2> /dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> block{};
  for (size_t count; (count = fread(block.data(), 1, block.size(), pipe)) > 0;) text.append(block.data(), count);
  pclose(pipe);
  return text;
}

/// The messages of the schema's validator; empty for a valid document.
std::string faults(const std::string& schema_name, const json& document) {
  const json schema_json = json::parse(std::ifstream(fs::path(TEXBAKE_SOURCE) / schema_name));
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::string text;
  for (valijson::ValidationResults::Error error; results.popError(error);) text += error.description + "\n";
  return text;
}

class CommandLineJson : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder() = fs::temp_directory_path() / ("texbake_json_test_" + std::to_string(getpid()));
    fs::create_directory(folder());
    const std::string draw = std::string(TEXBAKE_EXEMPLARS) + " " + folder().string() + " 128";
    ASSERT_EQ(std::system(draw.c_str()), 0);
    run("bake " + at("pebbles.png") + " -o " + at("a.texbundle"));
  }
  static void TearDownTestSuite() { fs::remove_all(folder()); }

  static fs::path& folder() {
    static fs::path path;
    return path;
  }
  static std::string at(const std::string& name) { return (folder() / name).string(); }
  /// Runs with --json; checks the schema and that the exit code is the one expected.
  static json valid_output(const std::string& arguments, int exit_code) {
    const std::string text = run(arguments + " --json");
    const json output = json::parse(text, nullptr, false);
    EXPECT_FALSE(output.is_discarded()) << arguments << ": not one JSON object:\n" << text;
    if (output.is_discarded()) return {};
    EXPECT_EQ(faults("cli/output.schema.json", output), "") << arguments << "\n" << text;
    EXPECT_EQ(output["exitCode"], exit_code) << text;
    return output;
  }
};

TEST_F(CommandLineJson, PlanesFollowTheirSchema) {
  const json exported = valid_output("export " + at("a.texbundle") + " --planes -o " + at("planes"), 0);
  const json planes = json::parse(std::ifstream(exported["result"]["planes"].get<std::string>()));
  EXPECT_EQ(faults("pages/planes.schema.json", planes), "");
  json spoiled = planes;
  spoiled["bindings"][0]["textures"]["base"]["format"] = "RGB8";
  EXPECT_NE(faults("pages/planes.schema.json", spoiled), "");
}

TEST_F(CommandLineJson, EveryVerbWritesOneObjectOfTheSchema) {
  const std::string bundle = at("a.texbundle");
  valid_output("convert " + at("bricks.png") + " -o " + at("b.texbundle"), 0);
  valid_output("fragment " + bundle + " -o " + at("b.texbundle"), 0);
  valid_output("patch " + bundle + " -o " + at("b.texbundle"), 0);
  valid_output("select-contents " + bundle + " -o " + at("b.texbundle"), 0);
  valid_output("decompose " + bundle + " --local-size 2 -o " + at("c.texbundle"), 0);
  valid_output("estimate-psd " + at("c.texbundle"), 0);
  valid_output("bake " + at("bricks.png") + " -o " + at("b.texbundle"), 0);
  std::ofstream(at("clicks.json")) << "[[5, 5, 0.5]]";
  valid_output(
      "heightmap " + bundle + " " + at("clicks.json") + " --preview " + at("p.png") + " -o " + at("c.texbundle"), 0);
  valid_output("stack " + bundle + " " + at("b.texbundle") + " -o " + at("s.texbundle"), 0);
  valid_output("info " + at("s.texbundle"), 0);
  valid_output("render " + bundle + " --size 16 -o " + at("a.png"), 0);
  valid_output("export " + bundle + " --web -o " + at("web"), 0);
  valid_output("verify " + bundle, 0);
  valid_output("info " + bundle, 0);
}

TEST_F(CommandLineJson, ReportsAreObjectsOfTheSchemaAndNeverPassWhatIsNotThere) {
  const json good = valid_output("report " + at("a.texbundle") + " --quick --tiles 3", 0)["result"];
  for (const json& measure : good["measures"]) EXPECT_TRUE(measure["bundle"].contains("mean")) << measure;
  run("convert " + at("bricks.png") + " -o " + at("c.texbundle"));
  const json bare = valid_output("report " + at("c.texbundle") + " --quick --tiles 2 --fail-on fail", 1)["result"];
  EXPECT_EQ(bare["contents"], 0);
  for (const json& measure : bare["measures"]) {
    if (measure["key"] != "repetitionFar") continue;
    EXPECT_THAT(measure["bundle"]["notDefined"], testing::HasSubstr("select-contents"));
  }
}

TEST_F(CommandLineJson, FailuresAreObjectsOfTheSchemaToo) {
  EXPECT_THAT(valid_output("bake " + at("nothing.png"), 4)["error"], testing::HasSubstr("nothing.png"));
  EXPECT_EQ(valid_output("bake --zoom 3", 2)["status"], "usage");
  valid_output("convrt", 2);
  const json verdict = valid_output("verify " + at("pebbles.png"), 1);
  EXPECT_EQ(verdict["result"]["verdict"], "invalid");
  EXPECT_FALSE(verdict["result"]["issues"].empty());
}

TEST_F(CommandLineJson, ComparedFramesAndShadersAreObjectsOfTheSchema) {
  const std::string bundle = at("a.texbundle"), camera = at("camera.json");
  const json window = {{"window", {{"origin", {"-12", 7.5}}, {"seed", 3}, {"map", nullptr}, {"size", {24, 16}}}}};
  EXPECT_EQ(faults("cli/camera.schema.json", window), "");
  EXPECT_NE(faults("cli/camera.schema.json", {{"window", {{"sead", 3}}}}), "");
  EXPECT_EQ(faults("cli/camera.schema.json", {{"plane", {{"camera-height", 600}, {"light", {1, 2, 3}}}}}), "");
  EXPECT_NE(faults("cli/camera.schema.json", {{"plane", {{"step", 3}}}}), "");
  EXPECT_NE(faults("cli/camera.schema.json", {{"plane", json::object()}, {"window", json::object()}}), "");
  std::ofstream(camera) << window;
  run("render " + bundle + " --origin -12,7.5 --seed 3 --size 24x16 -o " + at("frame.png"));
  run("render " + bundle + " --origin -12,7.5 --seed 4 --size 24x16 -o " + at("other.exr"));
  const std::string verify = "verify " + bundle + " --camera " + camera + " --frame ";
  EXPECT_EQ(valid_output(verify + at("frame.png"), 0)["result"]["frame"]["equal"], true);
  EXPECT_EQ(valid_output(verify + at("other.exr"), 1)["result"]["frame"]["samples"], "half");

  const json drawn = json::parse(run("verify " + bundle + " --backend gl --windows 1 --json"));
  EXPECT_EQ(faults("cli/output.schema.json", drawn), "") << drawn;
  if (drawn["exitCode"] == 5) GTEST_SKIP() << "no OpenGL: " << drawn["error"];
  EXPECT_EQ(drawn["result"]["gl"].size(), 2u);
}

TEST_F(CommandLineJson, WarningsAreInTheObject) {
  const json output = valid_output("convert " + at("leaves.png") + " -o " + at("b.texbundle"), 0);
  EXPECT_THAT(output["warnings"].dump(), testing::HasSubstr("does not tile"));
}

TEST_F(CommandLineJson, RecipesFollowTheirSchema) {
  const json output = valid_output("info " + at("a.texbundle") + " --recipe", 0);
  EXPECT_EQ(faults("bake/recipe.schema.json", output["result"]["recipe"]), "");
  EXPECT_EQ(json::parse(run("info " + at("a.texbundle") + " --recipe")), output["result"]["recipe"]);
}

}  // namespace
}  // namespace texbake
