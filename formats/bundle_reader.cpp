#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

#include "formats/bundle_io.h"
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
  explicit RangeCheck(const ScalePlane& plane) : plane_(plane) {}

  /// Values outside become `fallback`, so that nothing downstream is led astray.
  template <class T>
  void row(int channel, int y, T* values) {
    const ChannelRange& range = plane_.ranges[static_cast<size_t>(channel)];
    for (int x = 0; x < plane_.shape.width; ++x) {
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
      log.add({id, {.file = file, .part = plane_.shape.part, .texel = tally.first}, tally.detail, tally.count});
  }

 private:
  struct Tally {
    uint64_t count = 0;
    V2i first{0, 0};
    std::string detail;
  };

  const ScalePlane& plane_;
  std::map<IssueId, Tally> tallies_;
};

/// Canonical bytes of one row to the image of the plane, checked on the way.
void put_row(const ScalePlane& plane, RangeCheck& check, int y, const std::byte* row, std::vector<float>& floats,
             std::vector<uint32_t>& labels) {
  const auto width = static_cast<size_t>(plane.shape.width);
  const size_t channel_bytes = width * bytes_of(plane.shape.type);
  for (int c = 0; c < static_cast<int>(plane.shape.channels.size()); ++c, row += channel_bytes) {
    if (plane.shape.type == PixelType::uint) {
      std::memcpy(labels.data(), row, channel_bytes);
      check.row(c, y, labels.data());
      if (plane.put_labels) plane.put_labels(c, y, labels.data());
      continue;
    }
    if (plane.shape.type == PixelType::half)
      std::copy_n(reinterpret_cast<const Imath::half*>(row), width, floats.begin());
    else
      std::memcpy(floats.data(), row, channel_bytes);
    check.row(c, y, floats.data());
    if (plane.put_floats) plane.put_floats(c, y, floats.data());
  }
}

/// Reads the part of `refs`, which are one or several names for the same pixels. True where all is right.
bool read_plane(const ExrReader& reader, const ScalePlane& plane, const std::vector<const PlaneRef*>& refs,
                IssueLog& log) {
  const PlaneShape& shape = refs.front()->shape;
  RangeCheck check(plane);
  std::vector<float> floats(static_cast<size_t>(shape.width));
  std::vector<uint32_t> labels(static_cast<size_t>(shape.width));
  const std::string found = reader.read(
      shape, [&](int y, const std::byte* row) { put_row(plane, check, y, row, floats, labels); }, log);
  if (found.empty()) return false;
  bool right = true;
  for (const PlaneRef* ref : refs) {
    if (ref->pixel_hash == found) continue;
    right = false;
    log.add({IssueId::hash_mismatch,
             {.file = ref->file, .part = shape.part},
             fmt::format("expected pixelHash {} for {}, found {}", ref->pixel_hash, ref->key, found)});
  }
  check.report(refs.front()->file, log);
  return right;
}

/// Centres and areas follow from idx and owner; for patches, the manifest's are compared with them.
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

/// Keys of planes that share one part and its channels are read once; the one that is stored in memory goes first.
std::vector<std::vector<const PlaneRef*>> grouped(const PlaneRefs& refs) {
  std::vector<std::vector<const PlaneRef*>> groups;
  for (const PlaneRef& ref : refs) {
    const auto same = std::ranges::find_if(groups, [&](const auto& group) {
      return group[0]->shape.part == ref.shape.part && group[0]->shape.channels == ref.shape.channels &&
             group[0]->shape.type == ref.shape.type;
    });
    if (same == groups.end())
      groups.push_back({&ref});
    else
      same->insert(ref.key == "preview" ? same->end() : same->begin(), &ref);
  }
  return groups;
}

/// Makes images for the planes of these keys, and lists them: called once a file has shown that it can hold them.
using MakePlanes = std::function<std::vector<ScalePlane>(const std::set<std::string>& readable)>;

/// Reads the file of `refs`. `read` gets the keys of the planes that are what the manifest says.
void read_payload(const std::filesystem::path& path, const PlaneRefs& refs, const MakePlanes& make_planes,
                  std::set<std::string>& read, IssueLog& log) {
  if (refs.empty()) return;
  const ExrReader reader(path / refs[0].file, log);
  if (!reader.is_open()) return;
  const std::vector<std::vector<const PlaneRef*>> groups = grouped(refs);
  std::set<std::string> readable;
  for (const auto& group : groups)
    if (reader.holds(group[0]->shape, log)) readable.insert(group[0]->key);

  // Only now is memory taken: the file has shown that it can hold what the manifest says.
  const std::vector<ScalePlane> planes = make_planes(readable);
  for (const auto& group : groups) {
    const auto plane = std::ranges::find(planes, group[0]->key, &ScalePlane::key);
    if (!readable.contains(group[0]->key) || plane == planes.end()) continue;
    if (read_plane(reader, *plane, group, log))
      for (const PlaneRef* ref : group) read.insert(ref->key);
  }
  warn_unlisted(reader, refs, log);
}

void read_scale(const std::filesystem::path& path, Manifest& manifest, size_t i, std::set<std::string>& read,
                IssueLog& log) {
  Scale& scale = manifest.bundle.scales[i];
  const auto make_planes = [&](const std::set<std::string>& readable) {
    allocate_planes(scale, manifest.sizes[i], manifest.fragment_counts[i], readable);
    return planes_of(scale);
  };
  read_payload(path, manifest.refs[i], make_planes, read, log);
  if (!read.empty()) complete_scale(scale, read, fmt::format("/scales/{}", i), log);
}

/// The sizes of spectra and tiles are the manifest's.
void read_noise_planes(const std::filesystem::path& path, Manifest& manifest, std::set<std::string>& read,
                       IssueLog& log) {
  const NoiseRefs& refs = manifest.noise_refs;
  if (refs.spectra.empty()) return;
  std::vector<Noise>& noises = manifest.bundle.noise->noises;
  const auto make_spectra = [&](const std::set<std::string>& readable) {
    for (size_t k = 0; k < noises.size(); ++k) {
      if (!readable.contains(refs.spectra[k].key)) continue;
      for (NoiseChannel& channel : noises[k].channels) {
        channel.spectrum = Image<float>(refs.spectra[k].shape.width, refs.spectra[k].shape.height);
        channel.equalisation.values.assign(Equalisation::kEntries, 0.0f);
      }
    }
    return spectrum_planes(*manifest.bundle.noise);
  };
  const auto make_tiles = [&](const std::set<std::string>& readable) {
    for (size_t k = 0; k < noises.size(); ++k)
      if (readable.contains(refs.tiles[k].key))
        noises[k].tile = Image<V3f>(refs.tiles[k].shape.width, refs.tiles[k].shape.height);
    return tile_planes(*manifest.bundle.noise);
  };
  read_payload(path, refs.spectra, make_spectra, read, log);
  read_payload(path, refs.tiles, make_tiles, read, log);
}

}  // namespace

LoadedBundle load_bundle(const std::filesystem::path& path, const ReadOptions& options, IssueLog& log) {
  LoadedBundle loaded;
  const std::string text = manifest_text(path, log);
  if (log.error_count() > 0) return loaded;
  loaded.manifest = parse_json(text, log);
  if (log.error_count() > 0) return loaded;
  Manifest manifest = parse_manifest(loaded.manifest, options.semantics, log);
  loaded.planes.resize(manifest.refs.size());
  for (size_t i = 0; i < manifest.refs.size(); ++i) read_scale(path, manifest, i, loaded.planes[i], log);
  read_noise_planes(path, manifest, loaded.noise_planes, log);
  loaded.noise_refs = std::move(manifest.noise_refs);
  loaded.refs = std::move(manifest.refs);
  loaded.sizes = std::move(manifest.sizes);
  loaded.bundle = std::move(manifest.bundle);
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
