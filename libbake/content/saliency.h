// How much each texel stands out by its variation coordinate, among the texels of its color class.
// Based on: Perazzi et al. 2012, "Saliency filters", eq. 1-6; Vanhoey et al. 2013, §5.2.
#pragma once

#include "libbake/color/palette.h"

namespace texbake {

/// Saliency of each texel, 0 … 1, 1 for the most salient element of the picture; 0 everywhere when v is constant.
/// Elements are the texels of one class inside one cell of a regular grid of about 32 × 32 cells on the torus. Their
/// uniqueness is the mean squared difference of v to the other elements of the class, near ones weighing more; their
/// distribution is the spread over the tile of the elements with a similar v. Texels take a mean of the elements around
/// them, similar ones weighing more. Elements of different classes are not compared: their v run along different axes.
Image<float> saliency(const PrincipalVariation& colors);

/// The value that splits `values` (0 … 1) into two groups of least variance inside the groups (Otsu 1979), on 256 bins:
/// values above it are the upper group. 1 when all values are alike.
float two_class_threshold(ImageView<const float> values);

}  // namespace texbake
