#include "cli/camera.h"

#include <filesystem>

#include "bake/option_json.h"
#include "formats/input_file.h"
#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

/// The members of "window" that are scalars, under the names of render's flags.
struct CameraFields {
  WindowOptions& window;
  std::optional<std::string>& map;
  std::string size;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    WindowOptions::fields(self.window, visit);
    visit(self.map, Field{.name = "map"});
    visit(self.size, Field{.name = "size"});
  }
};

[[noreturn]] void refuse(const std::string& where, const std::string& expected, const Json& found) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: expected {}, found {}", where, expected, compact_json(found)));
}

/// The two elements of a list as `first` SEPARATOR `second`. Text is taken as it is: it may have more digits than a
/// number type.
std::string joined(const Json& pair, const std::string& where, const char* expected, char separator) {
  if (!pair.is_array() || pair.size() != 2) refuse(where, expected, pair);
  std::string text;
  for (const Json& element : pair) {
    if (!element.is_number() && !element.is_string()) refuse(where, expected, pair);
    if (!text.empty()) text += separator;
    text += element.is_string() ? element.get<std::string>() : element.dump();
  }
  return text;
}

void check_type(const Json& window, const char* name, const std::string& where, bool is_right, const char* expected) {
  if (window.contains(name) && !is_right) refuse(fmt::format("{}.{}", where, name), expected, window[name]);
}

/// What flags read leniently, a file must spell: numbers as numbers.
void check_types(const Json& window, const std::string& where) {
  const auto is = [&](const char* name, bool (Json::*type)() const noexcept) {
    return window.contains(name) && (window[name].*type)();
  };
  check_type(window, "step", where, is("step", &Json::is_number), "a number");
  check_type(window, "seed", where, is("seed", &Json::is_number_integer), "a whole number");
  check_type(window, "filter", where, is("filter", &Json::is_string), "the name of a filter");
  check_type(window, "map", where, is("map", &Json::is_string) || is("map", &Json::is_null),
             "the name of a map, or null for the color");
}

Json parsed(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw Error(ErrorKind::io, fmt::format("{}: expected a camera file, found a folder", path));
  return parse_json(file_bytes(path), path);
}

}  // namespace

Camera camera_of(const Json& json, const std::string& where) {
  static const std::vector<std::string> kMembers = {"window"};
  if (!json.is_object()) refuse(where, "an object {\"window\": {...}}", json);
  for (const auto& [name, value] : json.items())
    if (name != kMembers[0])
      throw Error(ErrorKind::bad_data,
                  fmt::format("{}: unknown member \"{}\"{}", where, name, suggestion(name, kMembers)));
  if (!json.contains("window")) refuse(where, "a member \"window\"", json);

  Json window = json["window"];
  const std::string inside = where + ": window";
  if (!window.is_object()) refuse(inside, "an object", window);
  check_types(window, inside);
  if (window.contains("origin"))
    window["origin"] = joined(window["origin"], inside + ".origin", "[x, y] as numbers or decimal strings", ',');
  if (window.contains("size"))
    window["size"] = joined(window["size"], inside + ".size", "[width, height] in pixels", 'x');

  Camera camera;
  CameraFields fields{camera.window, camera.map, ""};
  JsonReader reader(window, inside);
  reader.read(fields);
  reader.finish();
  try {
    check_options(camera.window);
    window_of(camera.window, {1, 1}, {1, 1});  // is it one in any tile?
    if (!fields.size.empty()) camera.frame_size = parse_size("size", fields.size);
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_data, fmt::format("{}: {}", inside, error.what()));
  }
  return camera;
}

Camera read_camera(const std::string& path) { return camera_of(parsed(path), path); }

}  // namespace texbake
