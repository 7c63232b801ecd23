// References from the manifest to planes: made when a bundle is written, read back and checked when it is read.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "formats/bundle.h"
#include "formats/exr_planes.h"
#include "formats/issues.h"
#include "formats/planes.h"

namespace texbake {

/// Where a plane lies and what it must hold.
struct PlaneRef {
  std::string key;  ///< as ScalePlane::key
  std::string file;
  PlaneShape shape;
  std::string pixel_hash;
};

/// The planes of one scale.
using PlaneRefs = std::vector<PlaneRef>;

/// The hash that names the payload file of `refs`: SHA-256 of one line for each part, in the order of the file,
///   PART WIDTH HEIGHT TYPE CHANNEL,CHANNEL,... PIXELHASH\n
std::string content_hash(const PlaneRefs& refs);
/// NAME-<12 digits of the content hash>.exr
std::string payload_name(const std::string& scale_name, const PlaneRefs& refs);

/// Hashes the planes and names their file, whose stem is `name`.
PlaneRefs hash_planes(const std::vector<ScalePlane>& planes, const std::string& name);

Json plane_json(const PlaneRef& ref);

/// The plane `json` at `pointer`, whose shape the schema has vouched for. Reports file_name_unsafe.
PlaneRef plane_ref(const std::string& key, const Json& json, const std::string& pointer, V2i size, IssueLog& log);

/// All of `refs` lie in one file, whose name tells what it holds: else reports file_name_hash at `pointer`.
void check_payload_name(const std::string& name, const PlaneRefs& refs, const std::string& pointer, IssueLog& log);

/// Reports member_unknown for members of `object` that are not `known`.
void warn_unknown_members(const Json& object, const std::string& pointer, const std::set<std::string>& known,
                          IssueLog& log);

}  // namespace texbake
