#include "formats/picture_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "libbake/base/error.h"

namespace texbake {
namespace {

std::string low(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

// "diffuse.R" is the channel "r" of the layer "diffuse".
struct ChannelName {
  std::string layer;
  std::string last;  // small letters
};
ChannelName split_name(const std::string& name) {
  const size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {"", low(name)};
  return {name.substr(0, dot), low(name.substr(dot + 1))};
}

bool is_alpha(const std::string& last) { return last == "a" || last == "alpha"; }
bool is_depth(const std::string& last) { return last == "z" || last == "zback" || last == "depth"; }

// The channels of one layer.
struct Layer {
  std::string name;
  std::vector<int> channels;
  std::vector<std::string> last;  // of each channel

  // The channel of one of these names.
  std::optional<int> find(std::initializer_list<const char*> wanted) const {
    for (const char* const word : wanted)
      for (size_t i = 0; i < last.size(); ++i)
        if (last[i] == word) return channels[i];
    return std::nullopt;
  }
  std::vector<int> find_three(std::initializer_list<const char*> a, std::initializer_list<const char*> b,
                              std::initializer_list<const char*> c) const {
    const auto x = find(a), y = find(b), z = find(c);
    return x && y && z ? std::vector{*x, *y, *z} : std::vector<int>();
  }
  std::vector<int> rgb() const { return find_three({"r", "red"}, {"g", "green"}, {"b", "blue"}); }
  std::vector<int> xyz() const { return find_three({"x"}, {"y"}, {"z"}); }
  std::vector<int> all_but(bool (*is_left_out)(const std::string&)) const {
    std::vector<int> left;
    for (size_t i = 0; i < last.size(); ++i)
      if (!is_left_out(last[i])) left.push_back(channels[i]);
    return left;
  }
};

std::vector<Layer> layers_of(const std::vector<std::string>& names) {
  std::vector<Layer> layers;
  for (size_t i = 0; i < names.size(); ++i) {
    const ChannelName name = split_name(names[i]);
    auto layer = std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.name == name.layer; });
    if (layer == layers.end()) layer = layers.insert(layers.end(), Layer{name.layer, {}, {}});
    layer->channels.push_back(static_cast<int>(i));
    layer->last.push_back(name.last);
  }
  return layers;
}

// What of `layer` suits `role`; nothing where its channels do not.
std::vector<int> suiting(const Layer& layer, PictureRole role) {
  const auto left_out = [](const std::string& last) { return is_alpha(last) || is_depth(last); };
  if (role == PictureRole::normal && !layer.xyz().empty()) return layer.xyz();
  if (!layer.rgb().empty()) return layer.rgb();
  const std::vector<int> values = layer.all_but(+left_out);
  if (role == PictureRole::normal) {
    const auto x = layer.find({"r", "red", "x"}), y = layer.find({"g", "green", "y"});
    return x && y && values.size() == 2 ? std::vector{*x, *y} : std::vector<int>();
  }
  if (values.size() == 1) return values;
  const std::vector<int> with_depth = layer.all_but(is_alpha);
  if (values.empty() && with_depth.size() == 1 && role == PictureRole::data) return with_depth;
  return {};
}

std::string quoted_list(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

[[noreturn]] void throw_unsuited(const std::string& path, const std::vector<std::string>& names, PictureRole role) {
  const bool vectors = role == PictureRole::normal;
  const char* const hint = role == PictureRole::color ? ", or name one of them with --layer" : "";
  throw Error(ErrorKind::bad_data,
              fmt::format("{}: expected {} channels besides alpha, found {} ({}); export it as {}{}", path,
                          vectors ? "3" : "1 or 3", names.size(), quoted_list(names), vectors ? "RGB" : "gray or RGB",
                          names.size() > 1 ? hint : ""));
}

std::vector<Layer>::const_iterator named_layer(const std::vector<Layer>& layers, const std::string& name) {
  const auto by_name = [&](const Layer& layer) { return low(layer.name) == low(name); };
  return std::find_if(layers.begin(), layers.end(), by_name);
}

std::optional<int> named_channel(const std::vector<std::string>& names, const std::string& name) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& other) { return low(other) == low(name); });
  return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()));
}

// R, G, B before anything else, channels without a layer before those of a layer, then in the order of the file.
const Layer* best_layer(const std::vector<Layer>& layers, PictureRole role) {
  const auto is_whole = [](const Layer& layer) { return !layer.rgb().empty() || !layer.xyz().empty(); };
  for (const bool whole : {true, false})
    for (const bool bare : {true, false})
      for (const Layer& layer : layers)
        if (layer.name.empty() == bare && is_whole(layer) == whole && !suiting(layer, role).empty()) return &layer;
  return nullptr;
}

void refuse_chroma(const std::string& path, const std::vector<Layer>& layers) {
  for (const Layer& layer : layers)
    if (layer.find({"ry"}) && layer.find({"by"}))
      throw Error(ErrorKind::unsupported,
                  fmt::format("{}: expected R, G, B, found luminance with chroma (Y, RY, BY), which is not supported; "
                              "export it as RGB",
                              path));
}

}  // namespace

bool has_layer(const std::vector<std::string>& names, const std::string& layer) {
  const std::vector<Layer> layers = layers_of(names);
  return named_layer(layers, layer) != layers.end() || named_channel(names, layer);
}

ChannelChoice choose_channels(const std::string& path, const std::vector<std::string>& names, PictureRole role,
                              const std::string& layer) {
  const std::vector<Layer> layers = layers_of(names);
  const Layer* chosen = nullptr;
  if (layer.empty()) {
    chosen = best_layer(layers, role);
    if (!chosen || chosen->rgb().empty()) refuse_chroma(path, layers);
  } else if (const auto found = named_layer(layers, layer); found != layers.end()) {
    chosen = &*found;
  } else if (const auto channel = named_channel(names, layer)) {
    return {.color = {*channel}, .layer = layer};
  } else {
    throw Error(ErrorKind::usage, fmt::format("--layer {}: {} has no such layer; it has the channels {}", layer, path,
                                              quoted_list(names)));
  }
  if (!chosen || suiting(*chosen, role).empty()) throw_unsuited(path, names, role);

  ChannelChoice choice{.color = suiting(*chosen, role), .layer = chosen->name};
  choice.is_vector = role == PictureRole::normal && choice.color == chosen->xyz();
  choice.alpha = chosen->find({"a", "alpha"}).value_or(-1);
  for (const Layer& other : layers)
    if (&other != chosen && !other.name.empty() && !suiting(other, role).empty())
      choice.other_layers.push_back(other.name);
  return choice;
}

}  // namespace texbake
