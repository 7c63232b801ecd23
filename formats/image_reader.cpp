#include "formats/image_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <memory>

#include "formats/input_file.h"
#include "formats/normal_vectors.h"
#include "formats/picture_input.h"
#include "formats/picture_plan.h"
#include "formats/picture_texels.h"
#include "formats/png_check.h"
#include "formats/sha256.h"
#include "libbake/base/half.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

std::vector<ImageView<const float>> views(const Picture& picture) {
  return {picture.planes, picture.planes + picture.channels};
}

void note(Picture& picture, const std::string& path, const std::string& words) {
  picture.notes.push_back(fmt::format("{}: {}", path, words));
}

void finish_color(const std::string& path, Picture& picture) {
  check_largest(path, views(picture), kLargestHalf);
  size_t negative = 0;
  for (int c = 0; c < picture.channels; ++c)
    for (float& value : picture.planes[c]) {
      if (value < 0) ++negative;
      if (!(value > 0)) value = 0;  // also −0
    }
  if (negative) note(picture, path, fmt::format("{} negative color values were set to 0", negative));
  if (picture.channels == 1) {
    picture.planes[1] = picture.planes[0].clone();
    picture.planes[2] = picture.planes[0].clone();
    picture.channels = 3;
  }
}

void finish_data(const std::string& path, Picture& picture) {
  if (picture.channels != 3 || picture.planes[0] != picture.planes[1] || picture.planes[0] != picture.planes[2]) return;
  picture.channels = 1;
  picture.planes[1] = {};
  picture.planes[2] = {};
  note(picture, path, "its three channels are equal: read as one channel");
}

void finish_normal(const PictureInput& open, const PicturePlan& plan, Picture& picture) {
  const NormalNumbers numbers = reads_codes(open, plan)   ? NormalNumbers::codes
                                : plan.channels.is_vector ? NormalNumbers::vectors
                                                          : NormalNumbers::floats;
  for (const std::string& words : finish_normals(picture.planes, plan.channels.color.size(), numbers))
    note(picture, open.path, words);
  picture.channels = 3;
}

void note_layers(const PictureInput& open, const ChannelChoice& channels, PictureRole role, Picture& picture) {
  if (channels.layer.empty() && channels.other_layers.empty()) return;
  const std::string others =
      channels.other_layers.empty()
          ? ""
          : fmt::format("; {}: {}", role == PictureRole::color ? "--layer chooses another" : "not",
                        fmt::join(channels.other_layers, ", "));
  note(picture, open.path,
       channels.layer.empty() ? fmt::format("the channels without a layer were read{}", others)
                              : fmt::format("the layer \"{}\" was read{}", channels.layer, others));
}

void note_what_was_ignored(PictureInput& open, const PicturePlan& plan, size_t transparent,
                           const PictureRequest& request, Picture& picture) {
  const OIIO::ImageSpec& spec = open.spec;
  const auto add = [&](const std::string& words) { note(picture, open.path, words); };
  for (const std::string& words : open.warnings) add(words);
  if (transparent)
    add(fmt::format("alpha was dropped: {} of {} texels are not opaque{}", transparent, picture.planes[0].size(),
                    plan.is_premultiplied ? ", and their color was divided by it" : ""));
  if (plan.orientation != 1) add(fmt::format("EXIF orientation {} was applied", plan.orientation));
  if (open.format == FileFormat::openexr && (spec.x != spec.full_x || spec.y != spec.full_y ||
                                             spec.width != spec.full_width || spec.height != spec.full_height))
    add(fmt::format("only the data window was read: {} x {} of a {} x {} frame", spec.width, spec.height,
                    spec.full_width, spec.full_height));
  note_layers(open, plan.channels, request.role, picture);
  for (const std::string& words : plan.color.notes) add(words);
  const bool has_more = open.format != FileFormat::psd && open.input->seek_subimage(1, 0);
  if (has_more && request.layer.empty()) add("it contains several pictures: the first was read");
}

}  // namespace

Picture read_picture(const PictureRequest& request) {
  const std::string& path = request.path;
  const PictureRole role = request.role;
  check_input_file(path);
  const PngCheck png = check_png(path);
  if (png.damage) throw_reader_failure(path, *png.damage);
  const std::unique_ptr<PictureInput> open = open_picture_input(path);
  for (const std::string& words : png.warnings) open->warnings.push_back(words + ": read all the same");
  const PicturePlan plan = plan_picture(*open, request, png);
  const OIIO::ImageSpec& spec = open->spec;

  Picture picture;
  picture.channels = static_cast<int>(std::min<size_t>(plan.channels.color.size(), 3));
  if (role == PictureRole::normal && request.values == PictureValues::checked) picture.channels = 3;
  picture.is_float = spec.format.is_floating_point();
  picture.source_bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8);
  picture.space = plan.color.space;
  picture.name = fs::path(path).filename().string();
  picture.size_bytes = fs::file_size(path);
  picture.sha256 = sha256_file(path);

  const size_t transparent = read_texels(*open, plan, role, picture);
  picture.alpha_dropped = plan.channels.alpha >= 0;
  if (request.values == PictureValues::checked) {
    check_finite(path, views(picture));
    if (role == PictureRole::color) finish_color(path, picture);
    if (role == PictureRole::data) finish_data(path, picture);
    if (role == PictureRole::normal) finish_normal(*open, plan, picture);
  }
  note_what_was_ignored(*open, plan, transparent, request, picture);
  return picture;
}

Image<V3f> interleave(const Image<float> (&planes)[3]) {
  assert(same_size(planes[0], planes[1]) && same_size(planes[0], planes[2]));
  Image<V3f> image(planes[0].width(), planes[0].height());
  for (size_t i = 0; i < image.size(); ++i)
    image.data()[i] = {planes[0].data()[i], planes[1].data()[i], planes[2].data()[i]};
  return image;
}

}  // namespace texbake