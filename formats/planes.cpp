#include "formats/planes.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "libbake/base/half.h"

namespace texbake {
namespace {

const std::vector<std::string> kRgb = {"R", "G", "B"};

ScalePlane plane(const std::string& key, const std::string& part, std::vector<std::string> channels, PixelType type,
                 V2i size, ChannelRange range) {
  ScalePlane result;
  result.key = key;
  result.ranges.assign(channels.size(), range);
  result.shape = {part, std::move(channels), type, size.x, size.y};
  return result;
}

template <class ImageT>
V2i size_of(ImageT& image) {
  return {image.width(), image.height()};
}

template <class ImageT>
ScalePlane color_plane(const std::string& key, const std::string& part, ImageT& image) {
  ScalePlane result = plane(key, part, kRgb, PixelType::half, size_of(image), {0, kAnyFloat, IssueId::color_range});
  result.get_floats = [&image](int c, int y, float* row) {
    for (int x = 0; x < image.width(); ++x) row[x] = image.row(y)[x][c];
  };
  if constexpr (writable<ImageT>)
    result.put_floats = [&image](int c, int y, const float* row) {
      for (int x = 0; x < image.width(); ++x) image.row(y)[x][c] = row[x];
    };
  return result;
}

template <class ImageT>
ScalePlane float_plane(const std::string& name, PixelType type, ImageT& image, ChannelRange range) {
  ScalePlane result = plane(name, name, {name}, type, size_of(image), range);
  result.get_floats = [&image](int, int y, float* row) { std::copy_n(image.row(y), image.width(), row); };
  if constexpr (writable<ImageT>)
    result.put_floats = [&image](int, int y, const float* row) { std::copy_n(row, image.width(), image.row(y)); };
  return result;
}

/// The weights of all noises: one channel for each.
template <class ImagesT>
ScalePlane mask_plane(ImagesT& masks) {
  std::vector<std::string> channels;
  for (size_t k = 0; k < masks.size(); ++k) channels.push_back("mask" + std::to_string(k));
  ScalePlane result = plane(kMasksKey, "mask", std::move(channels), PixelType::half, size_of(masks.front()),
                            {0, 1, IssueId::mask_range});
  result.get_floats = [&masks](int c, int y, float* row) {
    const auto& mask = masks[static_cast<size_t>(c)];
    std::copy_n(mask.row(y), mask.width(), row);
  };
  if constexpr (writable<ImagesT>)
    result.put_floats = [&masks](int c, int y, const float* row) {
      auto& mask = masks[static_cast<size_t>(c)];
      std::copy_n(row, mask.width(), mask.row(y));
    };
  return result;
}

template <class ImageT>
ScalePlane index_plane(ImageT& index, size_t classes) {
  ScalePlane result = plane("index", "index", {"index"}, PixelType::uint, size_of(index),
                            {0, static_cast<double>(classes) - 1, IssueId::index_range});
  result.get_labels = [&index](int, int y, uint32_t* row) { std::copy_n(index.row(y), index.width(), row); };
  if constexpr (writable<ImageT>)
    result.put_labels = [&index](int, int y, const uint32_t* row) {
      for (int x = 0; x < index.width(); ++x) index.row(y)[x] = static_cast<uint8_t>(row[x]);
    };
  return result;
}

template <class PartitionT>
ScalePlane partition_plane(const std::string& name, PartitionT& partition) {
  ScalePlane result = plane(name, name, {"idx", "owner"}, PixelType::uint, size_of(partition.idx),
                            {0, static_cast<double>(partition.count()) - 1, IssueId::label_range});
  result.ranges[1] = {0, 8, IssueId::owner_range};
  result.get_labels = [&partition](int c, int y, uint32_t* row) {
    const int width = partition.idx.width();
    if (c == 0) std::copy_n(partition.idx.row(y), width, row);
    if (c == 1) std::transform(partition.owner.row(y), partition.owner.row(y) + width, row, owner_code);
  };
  if constexpr (writable<PartitionT>)
    result.put_labels = [&partition](int c, int y, const uint32_t* row) {
      const int width = partition.idx.width();
      if (c == 0) std::copy_n(row, width, partition.idx.row(y));
      if (c == 1) std::transform(row, row + width, partition.owner.row(y), owner_of);
    };
  return result;
}

/// The entries of a table that lie in row y of its plane; what is beyond the last entry is 0.
template <class Table, class Row, class Copy>
void for_table_row(Table& table, int width, int y, Row* row, const Copy& copy) {
  const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(width);
  for (size_t x = 0; x < static_cast<size_t>(width); ++x)
    if (begin + x < table.size())
      copy(table[begin + x], row[x]);
    else if constexpr (!std::is_const_v<Row>)
      row[x] = 0;
}

template <class Table>
ScalePlane fragment_class_plane(Table& fragments, V2i tile, size_t classes) {
  const int width = tile.x;
  ScalePlane result =
      plane("fragmentClass", "fragmentClass", {"class"}, PixelType::uint, table_size(fragments.size(), tile),
            {0, static_cast<double>(classes) - 1, IssueId::fragment_class_range});
  result.get_labels = [&fragments, width](int, int y, uint32_t* row) {
    for_table_row(fragments, width, y, row, [](const Fragment& from, uint32_t& to) { to = from.class_idx; });
  };
  if constexpr (writable<Table>)
    result.put_labels = [&fragments, width](int, int y, const uint32_t* row) {
      for_table_row(fragments, width, y, row, [](Fragment& to, const uint32_t& from) { to.class_idx = from; });
    };
  return result;
}

template <class Table>
ScalePlane fragment_color_plane(Table& fragments, V2i tile) {
  const int width = tile.x;
  ScalePlane result = plane("fragmentColor", "fragmentColor", kRgb, PixelType::float32,
                            table_size(fragments.size(), tile), {0, kAnyFloat, IssueId::color_range});
  result.get_floats = [&fragments, width](int c, int y, float* row) {
    for_table_row(fragments, width, y, row, [c](const Fragment& from, float& to) { to = from.mean_color[c]; });
  };
  if constexpr (writable<Table>)
    result.put_floats = [&fragments, width](int c, int y, const float* row) {
      for_table_row(fragments, width, y, row, [c](Fragment& to, const float& from) { to.mean_color[c] = from; });
    };
  return result;
}

ChannelRange range_of(const Map& map) {
  if (map.is_float) return {-kAnyFloat, kAnyFloat, IssueId::not_finite};
  return {map.name == "normal" ? -1.0 : 0.0, 1, IssueId::map_range};
}

template <class MapT>
ScalePlane map_plane(MapT& map) {
  const std::string key = kMapKey + map.name;
  ScalePlane result =
      plane(key, key, map.channels == 3 ? kRgb : std::vector<std::string>{"Y"},
            map.source_bits <= 8 ? PixelType::half : PixelType::float32, size_of(map.planes[0]), range_of(map));
  result.get_floats = [&map](int c, int y, float* row) {
    std::copy_n(map.planes[c].row(y), map.planes[c].width(), row);
  };
  if constexpr (writable<MapT>)
    result.put_floats = [&map](int c, int y, const float* row) {
      std::copy_n(row, map.planes[c].width(), map.planes[c].row(y));
    };
  return result;
}

/// The dominant colors, which stand for the picture where it is not stored: few values, so they take little room.
ScalePlane palette_preview(const PrincipalVariation& colors) {
  ScalePlane result =
      plane("preview", "preview", kRgb, PixelType::half, size_of(colors.index), {0, kAnyFloat, IssueId::color_range});
  PrincipalVariation classes{colors.palette, Image<uint8_t>(static_cast<int>(colors.palette.classes.size()), 1), {}};
  for (int k = 0; k < classes.index.width(); ++k) classes.index(k, 0) = static_cast<uint8_t>(k);
  const Image<V3f> decoded = decode_dominant(classes);
  std::vector<V3f> dominant;
  for (const V3f& color : decoded)
    dominant.push_back(half_exact(V3f(std::max(color.x, 0.0f), std::max(color.y, 0.0f), std::max(color.z, 0.0f))));
  result.get_floats = [&colors, dominant](int c, int y, float* row) {
    for (int x = 0; x < colors.index.width(); ++x) row[x] = dominant[colors.index.row(y)[x]][c];
  };
  return result;
}

/// The exemplar once more, for those who read no manifest: written, and when it is read, checked and left.
ScalePlane stored_preview(const Image<V3f>& exemplar) { return color_plane("preview", "preview", exemplar); }

template <class ScaleT>
std::vector<ScalePlane> list_planes(ScaleT& scale, V2i tile) {
  std::vector<ScalePlane> planes;
  if (scale.stores_exemplar) {
    planes.push_back(stored_preview(scale.exemplar));
    planes.push_back(color_plane("exemplar", "preview", scale.exemplar));
  } else if (scale.colors) {
    planes.push_back(palette_preview(*scale.colors));
  }
  if (scale.structure) planes.push_back(color_plane("structure", "structure", *scale.structure));
  if (!scale.masks.empty()) planes.push_back(mask_plane(scale.masks));
  if (scale.colors) {
    planes.push_back(index_plane(scale.colors->index, scale.colors->palette.classes.size()));
    planes.push_back(float_plane("variation", PixelType::half, scale.colors->variation,
                                 {-kAnyFloat, kAnyFloat, IssueId::not_finite}));
  }
  if (scale.fragments) {
    planes.push_back(partition_plane("fragment", scale.fragments->partition));
    const size_t classes = scale.colors ? scale.colors->palette.classes.size() : kMaxClasses;
    planes.push_back(fragment_class_plane(scale.fragments->fragments, tile, classes));
    planes.push_back(fragment_color_plane(scale.fragments->fragments, tile));
  }
  if (scale.patches) planes.push_back(partition_plane("patch", scale.patches->partition));
  if (scale.height)
    planes.push_back(float_plane("height", PixelType::float32, *scale.height, {0, 1, IssueId::height_range}));
  for (auto& map : scale.maps) planes.push_back(map_plane(map));
  return planes;
}

[[maybe_unused]] bool is_half_exact(const float* row, int count) {
  return std::all_of(row, row + count, [](float x) { return half_exact(x) == x || x != x; });
}

}  // namespace

std::vector<ScalePlane> planes_of(const Scale& scale) { return list_planes(scale, scale.size()); }
std::vector<ScalePlane> planes_of(Scale& scale, V2i size) { return list_planes(scale, size); }

void allocate_planes(Scale& scale, V2i size, size_t fragment_count, const std::set<std::string>& keys) {
  const auto allocate = [&](const char* key, auto& image) {
    if (keys.contains(key)) image = std::remove_reference_t<decltype(image)>(size.x, size.y);
  };
  const auto allocate_partition = [&](const char* key, Partition& partition) {
    allocate(key, partition.idx);
    allocate(key, partition.owner);
  };
  allocate("exemplar", scale.exemplar);
  if (scale.structure) allocate("structure", *scale.structure);
  for (Image<float>& mask : scale.masks) allocate(kMasksKey, mask);
  if (scale.height) allocate("height", *scale.height);
  if (scale.colors) allocate("index", scale.colors->index);
  if (scale.colors) allocate("variation", scale.colors->variation);
  if (scale.fragments) {
    allocate_partition("fragment", scale.fragments->partition);
    if (keys.contains("fragment")) {
      scale.fragments->partition.centers.assign(fragment_count, V2i(0));
      scale.fragments->partition.areas_px.assign(fragment_count, 0);
    }
    if (keys.contains("fragmentClass") || keys.contains("fragmentColor"))
      scale.fragments->fragments.resize(fragment_count);
  }
  if (scale.patches) allocate_partition("patch", scale.patches->partition);
  for (Map& map : scale.maps)
    for (int c = 0; c < map.channels; ++c) allocate((kMapKey + map.name).c_str(), map.planes[c]);
}

V2i table_size(size_t count, V2i tile) {
  const size_t width = static_cast<size_t>(std::max(tile.x, 1));
  return {tile.x, static_cast<int>(std::max<size_t>(1, (count + width - 1) / width))};
}

uint32_t owner_code(OwnerOffset owner) { return static_cast<uint32_t>((owner.x + 1) + 3 * (owner.y + 1)); }

OwnerOffset owner_of(uint32_t code) {
  const auto value = static_cast<int>(code);
  return {static_cast<int8_t>(value % 3 - 1), static_cast<int8_t>(value / 3 - 1)};
}

ExrPart exr_part(const ScalePlane& plane) {
  const auto fill = [plane](int y, std::byte* row) {
    const int width = plane.shape.width;
    const size_t channel_bytes = plane.shape.row_bytes() / plane.shape.channels.size();
    std::vector<float> floats(static_cast<size_t>(width));
    for (size_t c = 0; c < plane.shape.channels.size(); ++c, row += channel_bytes) {
      if (plane.shape.type == PixelType::uint) {
        plane.get_labels(static_cast<int>(c), y, reinterpret_cast<uint32_t*>(row));
        continue;
      }
      plane.get_floats(static_cast<int>(c), y, floats.data());
      if (plane.shape.type == PixelType::float32) {
        std::memcpy(row, floats.data(), channel_bytes);
        continue;
      }
      assert(is_half_exact(floats.data(), width) && "stages round to half before they hand over");
      std::transform(floats.begin(), floats.end(), reinterpret_cast<Imath::half*>(row),
                     [](float x) { return Imath::half(x); });
    }
  };
  return {plane.shape, fill};
}

}  // namespace texbake
