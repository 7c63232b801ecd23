#include "formats/asset.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "formats/bundle.h"
#include "formats/json_text.h"

namespace texbake {
namespace {

struct Version {
  int major = 0;
  int minor = 0;
  auto operator<=>(const Version&) const = default;
};

constexpr Version kOurVersion{1, 0};

/// "1.0"; nothing for any other text.
std::optional<Version> version_of(const Json& json) {
  if (!json.is_string()) return std::nullopt;
  const std::string& text = json.get_ref<const std::string&>();
  const char* const end = text.data() + text.size();
  Version version;
  const auto dot = std::from_chars(text.data(), end, version.major);
  if (dot.ec != std::errc() || dot.ptr == end || *dot.ptr != '.') return std::nullopt;
  const auto rest = std::from_chars(dot.ptr + 1, end, version.minor);
  if (rest.ec != std::errc() || rest.ptr != end || version.major < 0 || version.minor < 0) return std::nullopt;
  return version;
}

const Json& member(const Json& object, const char* key) {
  static const Json absent;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : absent;
}

}  // namespace

void check_asset(const Json& json, Semantics semantics, IssueLog& log) {
  const Json& asset = member(json, "asset");
  const auto version = version_of(member(asset, "version"));
  const auto least = version_of(member(asset, "minVersion"));
  const Json& number = member(asset, "semantics");
  if (member(asset, "kind") != "texbake.bundle" || !version || !least || !number.is_number_integer())
    return log.add(
        {IssueId::asset_kind,
         {.pointer = "/asset"},
         fmt::format("expected kind \"texbake.bundle\", version and minVersion \"MAJOR.MINOR\" and an integer "
                     "semantics, found {}",
                     shortened(compact_json(asset), 200))});
  if (version->major != kOurVersion.major)
    log.add({IssueId::version_too_new,
             {.pointer = "/asset/version"},
             fmt::format("expected {}.x, found {}.{}", kOurVersion.major, version->major, version->minor)});
  if (*least > kOurVersion)
    log.add({IssueId::version_too_new,
             {.pointer = "/asset/minVersion"},
             fmt::format("expected at most {}, found {}.{}", kBundleVersion, least->major, least->minor)});
  const Json& required = member(json, "extensionsRequired");
  if (!required.is_null() && !(required.is_array() && required.empty()))
    log.add({IssueId::extension_unknown,
             {.pointer = "/extensionsRequired"},
             fmt::format("expected no required extension, found {}", shortened(compact_json(required), 200))});
  if (semantics == Semantics::known && number != kSemantics)
    log.add({IssueId::semantics_unknown,
             {.pointer = "/asset/semantics"},
             fmt::format("expected {}, found {}", kSemantics, compact_json(number))});
}

}  // namespace texbake
