#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

#include "formats/bundle_io.h"
#include "formats/input_file.h"
#include "formats/json_text.h"
#include "formats/limits.h"
#include "formats/noise_planes.h"
#include "libbake/base/half.h"

namespace texbake {
namespace {

constexpr int kReadAttempts = 8;

std::string display_name(const std::filesystem::path& path) { return path.string(); }

/// The text of bundle.json; empty after an issue.
std::string manifest_text(const std::filesystem::path& path, IssueLog& log) {
  const std::filesystem::path file = path / kManifestName;
  if (is_forbidden(file)) {
    log.add({IssueId::manifest_unreadable,
             {.file = kManifestName},
             fmt::format("expected a readable file, found: {}", std::strerror(EACCES))});
    return {};
  }
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) {
    log.add({IssueId::not_found, {.file = display_name(path)}, "expected a bundle, found nothing"});
    return {};
  }
  if (!std::filesystem::is_directory(path, failed) || !std::filesystem::is_regular_file(file, failed)) {
    log.add({IssueId::not_a_bundle,
             {.file = display_name(path)},
             fmt::format("expected a folder with {}, found none", kManifestName)});
    return {};
  }
  const auto bytes = std::filesystem::file_size(file, failed);
  if (!failed && bytes > kMaxManifestBytes) {
    log.add({IssueId::manifest_too_large,
             {.file = kManifestName},
             fmt::format("expected at most {} bytes, found {}", kMaxManifestBytes, bytes)});
    return {};
  }
  std::string text(failed ? 0 : static_cast<size_t>(bytes), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (failed || !stream.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    log.add({IssueId::manifest_unreadable,
             {.file = kManifestName},
             fmt::format("expected a readable file, found: {}", std::strerror(errno))});
    return {};
  }
  return text;
}

/// Counts the texels of one plane outside their range, and where the first one is.
class RangeCheck {
 public:
  RangeCheck(const ScalePlane& plane, const PlaneShape& shape) : plane_(plane), shape_(shape) {}

  /// Values outside become `fallback`, so that nothing downstream is led astray.
  template <class T>
  void row(int channel, int y, T* values) {
    const ChannelRange& range = plane_.ranges[static_cast<size_t>(channel)];
    for (int x = 0; x < shape_.width; ++x) {
      const auto value = static_cast<double>(values[x]);
      if (value >= range.low && value <= range.high) continue;
      Tally& tally = tallies_[std::isfinite(value) ? range.id : IssueId::not_finite];
      if (tally.count++ == 0) {
        tally.first = {x, y};
        tally.detail = fmt::format("expected {} to {}, found {}", range.low, range.high, value);
      }
      values[x] = T(0);
    }
  }

  void report(const std::string& file, IssueLog& log) const {
    for (const auto& [id, tally] : tallies_)
      log.add({id, {.file = file, .part = shape_.part, .texel = tally.first}, tally.detail, tally.count});
  }

 private:
  struct Tally {
    uint64_t count = 0;
    V2i first{0, 0};
    std::string detail;
  };

  const ScalePlane& plane_;
  const PlaneShape& shape_;
  std::map<IssueId, Tally> tallies_;
};

enum class PlaneUse {
  kept,     ///< values are checked and stored
  checked,  ///< they are checked and left
  hashed,   ///< another name of the part sees to them
};

/// One of the names of a part: where its values go.
class PlaneSink {
 public:
  PlaneSink(const ScalePlane& plane, const PlaneRef& ref, PlaneUse use)
      : plane_(plane), ref_(ref), use_(use), check_(plane, ref.shape) {}

  /// Canonical bytes of one row to the image of the plane, checked on the way.
  void put(int y, const std::byte* row) {
    if (use_ == PlaneUse::hashed) return;
    const auto width = static_cast<size_t>(ref_.shape.width);
    const size_t channel_bytes = width * bytes_of(ref_.shape.type);
    floats_.resize(width);
    labels_.resize(width);
    for (int c = 0; c < static_cast<int>(ref_.shape.channels.size()); ++c, row += channel_bytes) {
      if (ref_.shape.type == PixelType::uint) {
        std::memcpy(labels_.data(), row, channel_bytes);
        check_.row(c, y, labels_.data());
        if (use_ == PlaneUse::kept && plane_.put_labels) plane_.put_labels(c, y, labels_.data());
        continue;
      }
      if (ref_.shape.type == PixelType::half)
        std::copy_n(reinterpret_cast<const Imath::half*>(row), width, floats_.begin());
      else
        std::memcpy(floats_.data(), row, channel_bytes);
      check_.row(c, y, floats_.data());
      if (use_ == PlaneUse::kept && plane_.put_floats) plane_.put_floats(c, y, floats_.data());
    }
  }

  const PlaneRef& ref() const { return ref_; }
  void report(IssueLog& log) const { check_.report(ref_.file, log); }

 private:
  const ScalePlane& plane_;
  const PlaneRef& ref_;
  PlaneUse use_;
  RangeCheck check_;
  std::vector<float> floats_;
  std::vector<uint32_t> labels_;
};

/// Reads the part that the planes of `sinks` name, once. The keys of those whose pixels are what the manifest says go
/// to `read`.
void read_part(const ExrReader& reader, std::vector<PlaneSink>& sinks, std::set<std::string>& read, IssueLog& log) {
  const PlaneShape& shape = sinks.front().ref().shape;
  const auto put_all = [&](int y, const std::byte* row) {
    for (PlaneSink& sink : sinks) sink.put(y, row);
  };
  const std::string found = reader.read(shape, put_all, log);
  if (found.empty()) return;
  for (const PlaneSink& sink : sinks) {
    const PlaneRef& ref = sink.ref();
    if (ref.pixel_hash == found)
      read.insert(ref.key);
    else
      log.add({IssueId::hash_mismatch,
               {.file = ref.file, .part = shape.part},
               fmt::format("expected pixelHash {} for {}, found {}", ref.pixel_hash, ref.key, found)});
  }
  for (const PlaneSink& sink : sinks) sink.report(log);
}

/// Centers and areas follow from idx and owner; for patches, the manifest's are compared with them.
struct ShapeTable {
  std::vector<V2i> centers;
  std::vector<uint32_t> areas_px;
};

ShapeTable shapes_of(const Partition& partition) {
  struct Sum {
    int64_t x = 0, y = 0, count = 0;
  };
  std::vector<Sum> sums(partition.centers.size());
  const int width = partition.idx.width(), height = partition.idx.height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Sum& sum = sums[partition.idx(x, y)];
      sum.x += x - partition.owner(x, y).x * width;
      sum.y += y - partition.owner(x, y).y * height;
      ++sum.count;
    }
  ShapeTable table;
  for (const Sum& sum : sums) {
    const int64_t count = std::max<int64_t>(sum.count, 1);
    table.centers.emplace_back(static_cast<int>(rounded_mean(sum.x, count)),
                               static_cast<int>(rounded_mean(sum.y, count)));
    table.areas_px.push_back(static_cast<uint32_t>(sum.count));
  }
  return table;
}

void compare_patches(const Partition& stored, const ShapeTable& found, const std::string& pointer, IssueLog& log) {
  for (size_t i = 0; i < found.centers.size(); ++i) {
    const std::string at = fmt::format("{}/patches/{}", pointer, i);
    if (found.areas_px[i] == 0)
      log.add({IssueId::shape_empty, {.pointer = at}, "expected texels of the patch, found none"});
    else if (found.areas_px[i] != stored.areas_px[i])
      log.add({IssueId::shape_area,
               {.pointer = at + "/areaPx"},
               fmt::format("expected {}, the texels of the patch, found {}", found.areas_px[i], stored.areas_px[i])});
    else if (found.centers[i] != stored.centers[i])
      log.add({IssueId::shape_center,
               {.pointer = at + "/center"},
               fmt::format("expected ({}, {}), found ({}, {})", found.centers[i].x, found.centers[i].y,
                           stored.centers[i].x, stored.centers[i].y)});
  }
}

/// What the pixels of a scale say about its tables.
void complete_scale(Scale& scale, const std::set<std::string>& read, const std::string& pointer, IssueLog& log) {
  if (scale.fragments && read.contains("fragment")) {
    ShapeTable table = shapes_of(scale.fragments->partition);
    scale.fragments->partition.centers = std::move(table.centers);
    scale.fragments->partition.areas_px = std::move(table.areas_px);
  }
  if (scale.patches && read.contains("patch"))
    compare_patches(scale.patches->partition, shapes_of(scale.patches->partition), pointer, log);
  if (!scale.stores_exemplar && read.contains("index") && read.contains("variation"))
    scale.exemplar = palette_exemplar(*scale.colors);
}

void warn_unlisted(const ExrReader& reader, const PlaneRefs& refs, IssueLog& log) {
  const std::vector<std::string> parts = reader.part_names();
  for (const std::string& part : parts)
    if (std::ranges::none_of(refs, [&](const PlaneRef& ref) { return ref.shape.part == part; }))
      log.add({IssueId::part_unlisted, {.file = refs[0].file, .part = part}, "expected a plane that names the part"});
  const auto preview = std::ranges::find(refs, "preview", &PlaneRef::key);
  if (!parts.empty() && preview != refs.end() && parts.front() != preview->shape.part)
    log.add({IssueId::preview_not_first,
             {.file = refs[0].file, .part = parts.front()},
             fmt::format("expected the part {} first", preview->shape.part)});
}

/// Planes that share one part and its channels are read together.
using PlaneGroup = std::vector<const PlaneRef*>;

std::vector<PlaneGroup> grouped(const PlaneRefs& refs) {
  std::vector<PlaneGroup> groups;
  for (const PlaneRef& ref : refs) {
    const auto same = std::ranges::find_if(groups, [&](const PlaneGroup& group) {
      const PlaneShape& shape = group[0]->shape;
      return shape.part == ref.shape.part && shape.channels == ref.shape.channels && shape.type == ref.shape.type &&
             shape.width == ref.shape.width && shape.height == ref.shape.height;
    });
    if (same == groups.end())
      groups.push_back({&ref});
    else
      same->push_back(&ref);
  }
  return groups;
}

/// Those of `groups` that the file can hold; none where it is too small for all of them.
std::vector<PlaneGroup> readable_groups(const ExrReader& reader, const std::vector<PlaneGroup>& groups, IssueLog& log) {
  std::vector<PlaneGroup> readable;
  std::vector<PlaneShape> shapes;
  for (const PlaneGroup& group : groups)
    if (reader.holds(group[0]->shape, log)) {
      readable.push_back(group);
      shapes.push_back(group[0]->shape);
    }
  if (!reader.has_room_for(shapes, log)) readable.clear();
  return readable;
}

/// The planes that a file is read into, and which of them have room in memory.
struct PlaneTargets {
  std::vector<ScalePlane> planes;
  std::set<std::string> kept;
};
/// Makes room for planes of these keys: called once a file has shown that it can hold them.
using MakeTargets = std::function<PlaneTargets(const std::set<std::string>& readable)>;

/// The preview is the exemplar once more: where both are one part, its values have been looked at.
PlaneUse use_of(const PlaneRef& ref, const PlaneGroup& group, const std::set<std::string>& kept) {
  if (ref.key == "preview" && group.size() > 1) return PlaneUse::hashed;
  return kept.contains(ref.key) ? PlaneUse::kept : PlaneUse::checked;
}

/// Reads the file of `refs`. `read` gets the keys of the planes that are what the manifest says.
void read_payload(const std::filesystem::path& path, const PlaneRefs& refs, const MakeTargets& make_targets,
                  std::set<std::string>& read, IssueLog& log) {
  if (refs.empty()) return;
  const ExrReader reader(path / refs[0].file, log);
  if (!reader.is_open()) return;
  const std::vector<PlaneGroup> groups = readable_groups(reader, grouped(refs), log);
  std::set<std::string> readable;
  for (const PlaneGroup& group : groups)
    for (const PlaneRef* ref : group) readable.insert(ref->key);

  // Only now is memory taken: the file has shown that it can hold what the manifest says.
  const PlaneTargets targets = make_targets(readable);
  for (const PlaneGroup& group : groups) {
    std::vector<PlaneSink> sinks;
    for (const PlaneRef* ref : group) {
      const auto plane = std::ranges::find(targets.planes, ref->key, &ScalePlane::key);
      if (plane != targets.planes.end()) sinks.emplace_back(*plane, *ref, use_of(*ref, group, targets.kept));
    }
    if (!sinks.empty()) read_part(reader, sinks, read, log);
  }
  warn_unlisted(reader, refs, log);
}

bool is_judged(const std::string& key) { return key != "height" && !key.starts_with(kMapKey); }

void read_scale(const std::filesystem::path& path, LoadedBundle& loaded, size_t i, size_t fragment_count,
                KeptPlanes kept, IssueLog& log) {
  Scale& scale = loaded.bundle.scales[i];
  const auto make_targets = [&](const std::set<std::string>& readable) {
    PlaneTargets targets;
    for (const std::string& key : readable)
      if (kept == KeptPlanes::all || is_judged(key)) targets.kept.insert(key);
    allocate_planes(scale, loaded.sizes[i], fragment_count, targets.kept);
    targets.planes = planes_of(scale, loaded.sizes[i]);
    return targets;
  };
  read_payload(path, loaded.refs[i], make_targets, loaded.planes[i], log);
  if (!loaded.planes[i].empty()) complete_scale(scale, loaded.planes[i], fmt::format("/scales/{}", i), log);
}

/// The sizes of spectra and tiles are the manifest's.
void read_noise_planes(const std::filesystem::path& path, LoadedBundle& loaded, IssueLog& log) {
  const NoiseRefs& refs = loaded.noise_refs;
  if (refs.spectra.empty()) return;
  std::vector<Noise>& noises = loaded.bundle.noise->noises;
  const auto make_spectra = [&](const std::set<std::string>& readable) {
    for (size_t k = 0; k < noises.size(); ++k) {
      if (!readable.contains(refs.spectra[k].key)) continue;
      for (NoiseChannel& channel : noises[k].channels)
        channel.spectrum = Image<float>(refs.spectra[k].shape.width, refs.spectra[k].shape.height);
    }
    return PlaneTargets{spectrum_planes(*loaded.bundle.noise), readable};
  };
  const auto make_tiles = [&](const std::set<std::string>& readable) {
    for (size_t k = 0; k < noises.size(); ++k)
      if (readable.contains(refs.tiles[k].key))
        noises[k].tile = Image<V3f>(refs.tiles[k].shape.width, refs.tiles[k].shape.height);
    return PlaneTargets{tile_planes(*loaded.bundle.noise), readable};
  };
  read_payload(path, refs.spectra, make_spectra, loaded.noise_planes, log);
  read_payload(path, refs.tiles, make_tiles, loaded.noise_planes, log);
}

}  // namespace

LoadedBundle load_bundle(const std::filesystem::path& path, const ReadOptions& options, IssueLog& log) {
  LoadedBundle loaded;
  {
    const std::string text = manifest_text(path, log);
    if (log.error_count() > 0) return loaded;
    loaded.manifest = parse_json(text, log);
  }
  if (log.error_count() > 0) return loaded;
  Manifest manifest = parse_manifest(loaded.manifest, options.semantics, log);
  loaded.planes.resize(manifest.refs.size());
  loaded.noise_refs = std::move(manifest.noise_refs);
  loaded.refs = std::move(manifest.refs);
  loaded.sizes = std::move(manifest.sizes);
  loaded.bundle = std::move(manifest.bundle);
  for (size_t i = 0; i < loaded.refs.size(); ++i) {
    read_scale(path, loaded, i, manifest.fragment_counts[i], options.kept, log);
    if (options.scale_read) options.scale_read(loaded, i);
  }
  read_noise_planes(path, loaded, log);
  return loaded;
}

Bundle read_bundle(const std::filesystem::path& path, const ReadOptions& options) {
  IssueLog silent("", IssueLog::OnError::collect);
  for (int attempt = 1;; ++attempt) {
    const std::string before = manifest_text(path, silent);
    try {
      IssueLog log(display_name(path), IssueLog::OnError::throw_first);
      return load_bundle(path, options, log).bundle;
    } catch (const Error&) {
      // A writer may have replaced the bundle between its manifest and its payload: then the manifest has changed.
      if (attempt == kReadAttempts || manifest_text(path, silent) == before) throw;
    }
  }
}

}  // namespace texbake
