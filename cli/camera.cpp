#include "cli/camera.h"

#include <algorithm>
#include <filesystem>

#include "bake/option_json.h"
#include "formats/input_file.h"
#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

/// A list of numbers that an option takes as text.
struct ListMember {
  const char* name;
  size_t count;
  char separator;
  const char* expected;
};

constexpr ListMember kLists[] = {{"origin", 2, ',', "[x, y] as numbers or decimal strings"},
                                 {"size", 2, 'x', "[width, height] in pixels"},
                                 {"stretch", 2, ',', "[x, y] as numbers"},
                                 {"view-direction", 3, ',', "[x, y, z] as numbers"},
                                 {"light", 3, ',', "[x, y, z] as numbers"}};

/// What flags read leniently, a file must spell: numbers as numbers.
struct TypedMembers {
  bool (Json::*is_type)() const noexcept;
  const char* expected;
  std::initializer_list<const char*> names;
};

const TypedMembers kTypes[] = {
    {&Json::is_number,
     "a number",
     {"step", "rotate", "turbulence", "relief", "ambient", "camera-height", "pitch", "yaw", "fov"}},
    {&Json::is_number_integer,
     "a whole number",
     {"seed", "turbulence-cell", "relief-steps", "relief-refinements", "supersample"}},
    {&Json::is_string, "a name", {"filter", "shade"}},
};

/// The options of a window are not those of a plane.
bool is_offered(View view, std::string_view name) {
  static const std::vector<std::string_view> kOfWindow = {"step",       "rotate",          "stretch",
                                                          "turbulence", "turbulence-cell", "view-direction"};
  static const std::vector<std::string_view> kOfPlane = {"camera-height", "pitch", "yaw", "fov"};
  return name != "view" && std::ranges::count(view == View::plane ? kOfWindow : kOfPlane, name) == 0;
}

/// The members of "window" or "plane", under the names of render's flags.
struct CameraFields {
  PictureOptions& picture;
  std::string size;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    const auto offer = [&](auto& member, const Field& field) {
      if (is_offered(self.picture.view.view, field.name)) visit(member, field);
    };
    WindowOptions::fields(self.picture.window, offer);
    ViewOptions::fields(self.picture.view, offer);
    DeformOptions::fields(self.picture.deform, offer);
    ReliefOptions::fields(self.picture.relief, offer);
    SlantOptions::fields(self.picture.slant, offer);
    visit(self.picture.map, Field{.name = "map"});
    visit(self.size, Field{.name = "size"});
  }
};

[[noreturn]] void refuse(const std::string& where, const std::string& expected, const Json& found) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: expected {}, found {}", where, expected, compact_json(found)));
}

/// The elements of a list, side by side. Text is taken as it is: it may have more digits than a number type.
std::string joined(const Json& list, const std::string& where, const ListMember& member) {
  if (!list.is_array() || list.size() != member.count) refuse(where, member.expected, list);
  std::string text;
  for (const Json& element : list) {
    if (!element.is_number() && !element.is_string()) refuse(where, member.expected, list);
    if (!text.empty()) text += member.separator;
    text += element.is_string() ? element.get<std::string>() : element.dump();
  }
  return text;
}

void check_types(const Json& view, const std::string& where) {
  for (const auto& [is_type, expected, names] : kTypes)
    for (const char* name : names)
      if (view.contains(name) && !(view[name].*is_type)())
        refuse(fmt::format("{}.{}", where, name), expected, view[name]);
  if (view.contains("map") && !view["map"].is_string() && !view["map"].is_null())
    refuse(where + ".map", "the name of a map, or null for the color", view["map"]);
}

Json parsed(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw Error(ErrorKind::io, fmt::format("{}: expected a camera file, found a folder", path));
  return parse_json(file_bytes(path), path);
}

}  // namespace

Camera camera_of(const Json& json, const std::string& where) {
  static const std::vector<std::string> kMembers = {"window", "plane"};
  if (!json.is_object()) refuse(where, "an object {\"window\": {...}} or {\"plane\": {...}}", json);
  for (const auto& [name, value] : json.items())
    if (std::ranges::count(kMembers, name) == 0)
      throw Error(ErrorKind::bad_data,
                  fmt::format("{}: unknown member \"{}\"{}", where, name, suggestion(name, kMembers)));
  if (json.size() != 1) refuse(where, "a member \"window\" or a member \"plane\"", json);

  const std::string& kind = json.begin().key();
  Json view = json.begin().value();
  const std::string inside = fmt::format("{}: {}", where, kind);
  if (!view.is_object()) refuse(inside, "an object", view);
  check_types(view, inside);
  for (const ListMember& member : kLists)
    if (view.contains(member.name))
      view[member.name] = joined(view[member.name], fmt::format("{}.{}", inside, member.name), member);

  Camera camera;
  camera.picture.view.view = kind == "plane" ? View::plane : View::flat;
  CameraFields fields{camera.picture, ""};
  JsonReader reader(view, inside);
  reader.read(fields);
  reader.finish();
  try {
    check_picture(camera.picture, {1, 1});
    if (!fields.size.empty()) camera.frame_size = parse_size("size", fields.size);
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_data, fmt::format("{}: {}", inside, error.what()));
  }
  return camera;
}

Camera read_camera(const std::string& path) { return camera_of(parsed(path), path); }

}  // namespace texbake
