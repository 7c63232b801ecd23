// The image types of texbake. Row 0 is the top, x runs right, y runs down; the center of texel (x, y) is
// (x + 0.5, y + 0.5). An exemplar is a torus: texel (width, y) is texel (0, y).
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace texbake {

/// Borrows the pixels of an image; passed by value. `ImageView<const T>` reads, `ImageView<T>` also writes.
template <class T>
class ImageView {
 public:
  ImageView() = default;
  ImageView(T* data, int width, int height) : data_(data), width_(width), height_(height) {}
  /// A view that writes is also a view that reads.
  template <class U>
  requires(std::is_same_v<T, const U>) ImageView(ImageView<U> other)
      : ImageView(other.data(), other.width(), other.height()) {}

  int width() const { return width_; }
  int height() const { return height_; }
  size_t size() const { return static_cast<size_t>(width_) * static_cast<size_t>(height_); }
  bool empty() const { return size() == 0; }
  T* data() const { return data_; }
  T* row(int y) const { return data_ + static_cast<size_t>(y) * static_cast<size_t>(width_); }
  T& operator()(int x, int y) const {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    return row(y)[x];
  }
  T* begin() const { return data_; }
  T* end() const { return data_ + size(); }

 private:
  T* data_ = nullptr;
  int width_ = 0;
  int height_ = 0;
};

/// A zero of any pixel type. Imath's vectors are left uninitialized by their default constructor.
template <class T>
constexpr T zero_pixel() {
  if constexpr (std::is_constructible_v<T, int>)
    return T(0);
  else
    return T{};
}

/// Owns the pixels of an image, contiguous by rows. Moves; a copy is spelled `clone()`.
template <class T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, const T& value = zero_pixel<T>()) : Image(unset(width, height)) {
    std::fill(begin(), end(), value);
  }
  /// Pixels that mean nothing until they are written, all of them. Memory is taken by the threads that write it.
  static Image unset(int width, int height) {
    Image image;
    image.pixels_ = std::make_unique_for_overwrite<T[]>(static_cast<size_t>(width) * static_cast<size_t>(height));
    image.width_ = width;
    image.height_ = height;
    return image;
  }
  Image(Image&& other) noexcept { *this = std::move(other); }
  Image& operator=(Image&& other) noexcept {
    pixels_ = std::move(other.pixels_);
    width_ = std::exchange(other.width_, 0);
    height_ = std::exchange(other.height_, 0);
    return *this;
  }
  Image clone() const {
    Image copy = unset(width_, height_);
    std::copy(begin(), end(), copy.begin());
    return copy;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  size_t size() const { return view().size(); }
  bool empty() const { return size() == 0; }
  T* data() { return pixels_.get(); }
  const T* data() const { return pixels_.get(); }
  T* row(int y) { return data() + static_cast<size_t>(y) * static_cast<size_t>(width_); }
  const T* row(int y) const { return data() + static_cast<size_t>(y) * static_cast<size_t>(width_); }
  T& operator()(int x, int y) { return view()(x, y); }
  const T& operator()(int x, int y) const { return view()(x, y); }
  T* begin() { return data(); }
  T* end() { return data() + size(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }

  ImageView<T> view() { return {data(), width_, height_}; }
  ImageView<const T> view() const { return {data(), width_, height_}; }
  operator ImageView<T>() { return view(); }
  operator ImageView<const T>() const { return view(); }

  bool operator==(const Image& other) const {
    return width_ == other.width_ && height_ == other.height_ && std::equal(begin(), end(), other.begin());
  }

 private:
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;

  std::unique_ptr<T[]> pixels_;
  int width_ = 0;
  int height_ = 0;
};

template <class A, class B>
bool same_size(const A& a, const B& b) {
  return a.width() == b.width() && a.height() == b.height();
}

}  // namespace texbake
