// A sheet of labeled pictures, to choose a parameter by eye. Based on: Guingo et al. 2017, Fig. 14.
#pragma once

#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

struct SheetCell {
  std::string label;  ///< ASCII; two lines where it holds a line break
  Image<V3f> linear;  ///< linear Rec.709
};

struct Sheet {
  std::string title;  ///< ASCII
  int columns = 3;
  std::vector<SheetCell> cells;  ///< by rows
};

/// The cells in a grid, each under its label, all as wide and high as the largest; dark on light.
Image<V3f> draw(const Sheet& sheet);

/// Draws `text` in `color`, the first line's baseline starting at `at`; `scale` 1 is about 22 texels high. What lies
/// outside the picture is left out.
void draw_text(ImageView<V3f> picture, const std::string& text, V2i at, double scale, V3f color);

}  // namespace texbake
