#include "libbake/planes/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"
#include "libbake/planes/prepare_noise.h"

namespace texbake {
namespace {

template <class Pixels>
void check_size(const Pixels& pixels, V2i size, const std::string& what) {
  if (pixels.width() != size.x || pixels.height() != size.y)
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected {} x {} texels, as in the base, found {} x {}", what,
                                                 size.x, size.y, pixels.width(), pixels.height()));
}

void check_base(ImageView<const V3f> base) {
  const int longest = std::max(base.width(), base.height());
  if (base.empty() || longest > kMaxTileSide)
    throw Error(ErrorKind::bad_data, fmt::format("base: expected a tile of 1 to {} texels on each side, found {} x {}",
                                                 kMaxTileSide, base.width(), base.height()));
}

Plane base_plane(ImageView<const V3f> base) {
  Plane plane{"base", MapKind::plain, 3, Image<glsl::vec4>(base.width(), base.height(), {0, 0, 0, 0})};
  parallel_for(0, base.height(), [&](int y) {
    for (int x = 0; x < base.width(); ++x) {
      const V3f& c = base(x, y);
      plane.texels(x, y) = {c.x, c.y, c.z, 0};
    }
  });
  return plane;
}

Plane map_plane(const MapInput& map, V2i size) {
  const int channels = static_cast<int>(map.channels.size());
  const bool is_normal = map.kind == MapKind::normal_opengl || map.kind == MapKind::normal_directx;
  if (channels < (is_normal ? 3 : 1) || channels > 4)
    throw Error(ErrorKind::bad_data, fmt::format("map \"{}\": expected {} channels, found {}", map.name,
                                                 is_normal ? "3 or 4" : "1 to 4", channels));
  for (const auto& channel : map.channels) check_size(channel, size, fmt::format("map \"{}\"", map.name));

  const auto value = [&](int channel, int x, int y) {
    return channel < channels ? map.channels[static_cast<size_t>(channel)](x, y) : 0.0f;
  };
  Plane plane{map.name, map.kind, channels, Image<glsl::vec4>(size.x, size.y, {0, 0, 0, 0})};
  parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x)
      plane.texels(x, y) = {value(0, x, y), value(1, x, y), value(2, x, y), value(3, x, y)};
  });
  return plane;
}

Image<glsl::PatchTexel> patch_plane(const PatchMap* patches, V2i size) {
  Image<glsl::PatchTexel> plane(size.x, size.y);
  if (!patches) return plane;
  const Partition& partition = patches->partition;
  check_size(partition.idx, size, "patches");
  check_size(partition.owner, size, "owner offsets of the patches");
  const auto count = static_cast<uint32_t>(partition.count());
  if (count == 0 || count > 65535)
    throw Error(ErrorKind::bad_data, fmt::format("patches: expected 1 to 65535, found {}", count));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const uint32_t idx = partition.idx(x, y);
      const OwnerOffset owner = partition.owner(x, y);
      if (idx >= count || std::abs(owner.x) > 1 || std::abs(owner.y) > 1)
        throw Error(ErrorKind::bad_data,
                    fmt::format("patches: texel ({}, {}) has patch {} of {} and owner offset ({}, {})", x, y, idx,
                                count, owner.x, owner.y));
      plane(x, y) = {static_cast<uint16_t>(idx), static_cast<uint16_t>((owner.x + 1) | (owner.y + 1) << 2)};
    }
  return plane;
}

Image<glsl::ivec4> center_table(const PatchMap* patches) {
  if (!patches) return Image<glsl::ivec4>(1, 1, {0, 0, 0, 0});
  const auto& centers = patches->partition.centers;
  Image<glsl::ivec4> table(static_cast<int>(centers.size()), 1, {0, 0, 0, 0});
  for (int i = 0; i < table.width(); ++i)
    table(i, 0) = {centers[static_cast<size_t>(i)].x, centers[static_cast<size_t>(i)].y, 0, 0};
  return table;
}

constexpr glsl::ivec4 kIdentity{0, 65536, 65536, 0};

Image<glsl::ivec4> content_table(const EvaluatorInput& input, int patch_count, V2i size) {
  if (!input.contents) return Image<glsl::ivec4>(1, patch_count, kIdentity);
  const ContentTable& contents = *input.contents;
  const auto entries = static_cast<size_t>(contents.patch_count) * static_cast<size_t>(contents.content_count);
  if (!input.patches || contents.patch_count != patch_count || contents.content_count < 1 ||
      contents.content_count > 65535 || contents.contents.size() != entries)
    throw Error(ErrorKind::bad_data,
                fmt::format("contents: expected a table of {} patches, found {} patches x {} contents in {} entries",
                            patch_count, contents.patch_count, contents.content_count, contents.contents.size()));
  // λ ≥ 0.5 keeps |a|, |b| within two units: the products of the evaluator then fit 32 bits.
  constexpr int kMaxMatrix = 2 * 65536;
  Image<glsl::ivec4> table(contents.content_count, patch_count, kIdentity);
  for (int patch = 0; patch < patch_count; ++patch)
    for (int content = 0; content < contents.content_count; ++content) {
      const Content& c = contents.at(patch, content);
      if (std::abs(int64_t{c.a}) > kMaxMatrix || std::abs(int64_t{c.b}) > kMaxMatrix)
        throw Error(ErrorKind::bad_data,
                    fmt::format("contents: patch {} content {}: expected a matrix within ±{}, found ({}, {})", patch,
                                content, kMaxMatrix, c.a, c.b));
      if (!(c.scale > 0 && c.scale <= 1))
        throw Error(ErrorKind::bad_data,
                    fmt::format("contents: patch {} content {}: expected a scale in 0 to 1, found {}", patch, content,
                                c.scale));
      const V2i t = wrap(c.translation, size);
      table(content, patch) = {t.x | t.y << 16, static_cast<int>(std::lround(c.scale * 65536.0f)), c.a, c.b};
    }
  return table;
}

void add_colors(const PrincipalVariation& colors, TilePlanes& planes) {
  check_size(colors.index, planes.size, "index");
  check_size(colors.variation, planes.size, "variation");
  std::vector<V3f> dominants;
  for (const ColorClass& c : colors.palette.classes) dominants.push_back(linear_from_luv(c.dominant));
  planes.variation = colors.variation.clone();
  planes.dominant = Image<V3f>(planes.size.x, planes.size.y);
  for (int y = 0; y < planes.size.y; ++y)
    for (int x = 0; x < planes.size.x; ++x) {
      const size_t index = colors.index(x, y);
      if (index >= dominants.size())
        throw Error(ErrorKind::bad_data,
                    fmt::format("index: texel ({}, {}) has class {} of {}", x, y, index, dominants.size()));
      planes.dominant(x, y) = dominants[index];
    }
}

}  // namespace

const Plane* TilePlanes::map(const std::string& name) const {
  const auto found = std::find_if(maps.begin(), maps.end(), [&](const Plane& plane) { return plane.name == name; });
  return found == maps.end() ? nullptr : &*found;
}

void check_soft_border_fits(int width_px, V2i size) {
  if (width_px < 0 || width_px > max_soft_border_px(size))
    throw Error(ErrorKind::bad_data, fmt::format("soft borders: expected 0 to {} px on a tile of {} x {}, found {}",
                                                 max_soft_border_px(size), size.x, size.y, width_px));
}

TilePlanes prepare_tile(const EvaluatorInput& input) {
  check_base(input.base);
  TilePlanes planes;
  planes.size = {input.base.width(), input.base.height()};
  planes.base = base_plane(input.base);
  planes.patch_plane = patch_plane(input.patches, planes.size);
  planes.centers = center_table(input.patches);
  planes.patch_count = planes.centers.width();
  planes.contents = content_table(input, planes.patch_count, planes.size);
  planes.content_count = planes.contents.width();
  planes.grain_apart = input.grain_apart;
  add_noise(input.noise, planes);
  for (const MapInput& map : input.maps) planes.maps.push_back(map_plane(map, planes.size));
  if (input.fragments) {
    check_size(input.fragments->partition.idx, planes.size, "fragments");
    planes.fragment_idx = input.fragments->partition.idx.clone();
  }
  if (input.colors) add_colors(*input.colors, planes);
  check_soft_border_fits(input.soft_border_px, planes.size);
  planes.soft_border_px = input.patches ? input.soft_border_px : 0;
  return planes;
}

EvaluatorPlanes prepare(const EvaluatorInput& input) { return EvaluatorPlanes(prepare_tile(input)); }

}  // namespace texbake
