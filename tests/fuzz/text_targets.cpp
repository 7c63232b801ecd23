// Files that people write: clicks, recipes, cameras.
#include "bake/bake_request.h"
#include "cli/camera.h"
#include "formats/click_file.h"
#include "formats/json_text.h"
#include "tests/fuzz/json_mutation.h"
#include "tests/fuzz/target.h"

namespace texbake::fuzz {
namespace {

/// Reads `input` as a file of this extension; a message is what a reader may answer.
template <class Read>
void read_as(const std::string& extension, std::string_view input, const Read& read) {
  const std::filesystem::path path = scratch() / ("input" + extension);
  write_file(path, input);
  try {
    read(path.string());
  } catch (const Error&) {
  }
}

std::vector<std::string> click_seeds() {
  return {"j[[12, 34, 0.5], {\"x\": 1, \"y\": 2.5, \"height\": 0.25}]", "j{\"clicks\": [[0, 0, 1]]}",
          "cx,y,height\n1,2,0.5\n# a remark\n3;4\t0.75\n", "c12 34 +0.5\r\n\r\n1e3,2,1e-3"};
}

/// The first byte says whether the others are JSON.
std::string mutate_clicks(const std::string& input, Random& random) {
  if (input.empty()) return "c";
  const std::string rest = input.substr(1);
  return input[0] + (input[0] == 'j' ? mutate_json_text(rest, random) : mutate_bytes(rest, random));
}

void run_clicks(const std::string& input) {
  if (input.empty()) return;
  read_as(input[0] == 'j' ? ".json" : ".csv", std::string_view(input).substr(1),
          [](const std::string& path) { read_clicks(path); });
}

std::vector<std::string> recipe_seeds() {
  return {R"({"asset": {"kind": "texbake.recipe", "version": "1.0"},
 "files": [{"name": "color", "file": "a.png", "sha256": ""}, {"name": "normal", "file": "b.png"}],
 "stages": {"convert": {"color": "exact", "classes": null}, "fragment": {"threshold": 20},
            "patch": {"count": 9, "seed": 1}, "select-contents": {"contents": 8}}})",
          R"({"asset": {"kind": "texbake.recipe", "version": "1.0"}, "files": [{"name": "color", "file": "a.png"}],
 "stages": {"convert": {}, "decompose": {}, "estimate-psd": {}, "fragment": {}, "patch": {}, "select-contents": {}}})"};
}

void run_recipe(const std::string& input) {
  read_as(".json", input, [](const std::string& path) { read_recipe(path); });
}

std::vector<std::string> camera_seeds() {
  return {R"({"window": {"origin": [-3.5, "12345678901234567890.25"], "step": 1.5, "seed": 7, "filter": "bilinear",
 "map": null, "size": [64, 32]}})",
          R"({"window": {}})"};
}

void run_camera(const std::string& input) {
  read_as(".json", input, [](const std::string& path) { read_camera(path); });
}

}  // namespace

const Target kClicks = {"clicks", click_seeds, mutate_clicks, run_clicks};
const Target kRecipe = {"recipe", recipe_seeds, mutate_json_text, run_recipe};
const Target kCamera = {"camera", camera_seeds, mutate_json_text, run_camera};

}  // namespace texbake::fuzz
