// Images of several scales in one, as shaders/stack_bindings.glsl reads them.
#pragma once

#include <algorithm>
#include <vector>

#include "libbake/base/image.h"

namespace texbake {

/// One below the other; narrower ones leave the right side as `empty`.
template <class T>
Image<T> stacked(const std::vector<const Image<T>*>& images, T empty) {
  int width = 1, height = 0;
  for (const Image<T>* image : images) {
    width = std::max(width, image->width());
    height += image->height();
  }
  Image<T> all(width, std::max(height, 1), empty);
  int row = 0;
  for (const Image<T>* image : images)
    for (int y = 0; y < image->height(); ++y, ++row) std::copy_n(image->row(y), image->width(), all.row(row));
  return all;
}

template <class T>
std::vector<const Image<T>*> pointers_to(const std::vector<Image<T>>& images) {
  std::vector<const Image<T>*> pointers;
  for (const Image<T>& image : images) pointers.push_back(&image);
  return pointers;
}

/// The same of images that are not needed any more: where one alone has pixels, it is taken as it is.
template <class T>
Image<T> in_one(std::vector<Image<T>> images, T empty) {
  std::erase_if(images, [](const Image<T>& image) { return image.empty(); });
  if (images.size() == 1) return std::move(images[0]);
  return stacked(pointers_to(images), empty);
}

}  // namespace texbake
