#include "libbake/content/distance_field.h"

#include "libbake/base/torus.h"

namespace texbake {

DistanceField::DistanceField(ImageView<const uint8_t> classes, const ClassDistances& distances)
    : distances_(distances) {
  const int group_end = (classes.width() + kGroupWidth - 1) / kGroupWidth * kGroupWidth;
  const int rows = 2 * classes.height() + 2 * kMaskRadius + kGroupRows - 1;
  stride_ = classes.width() + group_end + 2 * kMaskRadius;
  plane_count_ = (distances.class_count + 15) / 16;
  plane_size_ = static_cast<size_t>(stride_) * static_cast<size_t>(rows);
  planes_.reserve(plane_size_ * static_cast<size_t>(plane_count_));
  for (int k = 0; k < plane_count_; ++k)
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < stride_; ++x) {
        const int class_idx = classes(wrap(x - kMaskRadius, classes.width()), wrap(y - kMaskRadius, classes.height()));
        planes_.push_back(class_idx / 16 == k ? static_cast<uint8_t>(class_idx % 16) : uint8_t{128});
      }
  classes_.reserve(plane_size_);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < stride_; ++x)
      classes_.push_back(classes(wrap(x - kMaskRadius, classes.width()), wrap(y - kMaskRadius, classes.height())));

  for (int a = 0; a < distances.class_count; ++a)
    for (int k = 0; k < plane_count_; ++k)
      for (int b = 16 * k; b < 16 * k + 16; ++b)
        tables_.push_back(b < distances.class_count ? distances.at(a, b) : uint8_t{0});
}

}  // namespace texbake
