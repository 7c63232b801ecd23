#include "formats/plane_refs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formats/json_text.h"
#include "formats/sha256.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

bool is_plain_file_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && name != kManifestName &&
         name.find_first_of(std::string("/\\:\0", 4)) == std::string::npos;
}

}  // namespace

std::string content_hash(const PlaneRefs& refs) {
  std::string lines;
  std::set<std::string> seen;
  for (const PlaneRef& ref : refs)
    if (seen.insert(ref.shape.part).second)
      lines += fmt::format("{} {} {} {} {} {}\n", ref.shape.part, ref.shape.width, ref.shape.height,
                           name_of(ref.shape.type), fmt::join(ref.shape.channels, ","), ref.pixel_hash);
  return sha256(lines);
}

std::string payload_name(const std::string& scale_name, const PlaneRefs& refs) {
  return fmt::format("{}-{}.exr", scale_name, content_hash(refs).substr(0, 12));
}

PlaneRefs hash_planes(const std::vector<ScalePlane>& planes, const std::string& name) {
  PlaneRefs refs(planes.size());
  parallel_for(0, static_cast<int>(planes.size()), [&](int i) {
    const auto at = static_cast<size_t>(i);
    const bool shared = at > 0 && planes[at].shape.part == planes[at - 1].shape.part;
    refs[at] = {planes[at].key, "", planes[at].shape, shared ? "" : pixel_hash(exr_part(planes[at]))};
  });
  for (size_t i = 1; i < refs.size(); ++i)
    if (refs[i].pixel_hash.empty()) refs[i].pixel_hash = refs[i - 1].pixel_hash;
  const std::string file = payload_name(name, refs);
  for (PlaneRef& ref : refs) ref.file = file;
  return refs;
}

Json plane_json(const PlaneRef& ref) {
  return {{"file", ref.file},
          {"part", ref.shape.part},
          {"channels", ref.shape.channels},
          {"type", name_of(ref.shape.type)},
          {"pixelHash", ref.pixel_hash}};
}

PlaneRef plane_ref(const std::string& key, const Json& json, const std::string& pointer, V2i size, IssueLog& log) {
  const std::string file = json["file"];
  if (!is_plain_file_name(file))
    log.add({IssueId::file_name_unsafe,
             {.pointer = pointer + "/file"},
             fmt::format("expected a plain file name, found {}", compact_json(json["file"]))});
  const std::string type = json["type"];
  PlaneShape shape{json["part"], json["channels"], PixelType::half, size.x, size.y};
  if (type != "half") shape.type = type == "uint" ? PixelType::uint : PixelType::float32;
  return {key, file, std::move(shape), json["pixelHash"]};
}

void check_payload_name(const std::string& name, const PlaneRefs& refs, const std::string& pointer, IssueLog& log) {
  const std::string expected = payload_name(name, refs);
  for (const PlaneRef& ref : refs)
    if (ref.file != expected && is_plain_file_name(ref.file))
      return log.add(
          {IssueId::file_name_hash, {.pointer = pointer}, fmt::format("expected {}, found {}", expected, ref.file)});
}

void warn_unknown_members(const Json& object, const std::string& pointer, const std::set<std::string>& known,
                          IssueLog& log) {
  for (const auto& [key, value] : object.items())
    if (!known.contains(key))
      log.add({IssueId::member_unknown, {.pointer = pointer_below(pointer, key)}, "expected a member of version 1.0"});
}

}  // namespace texbake
