#include "formats/bundle.h"

#include "libbake/base/half.h"
#include "libbake/base/parallel.h"

namespace texbake {

Image<V3f> palette_exemplar(const PrincipalVariation& colors) {
  Image<V3f> exemplar = decode(colors);
  for (V3f& color : exemplar) color = half_exact(color);
  return exemplar;
}

V3f mean_color(ImageView<const V3f> image) {
  std::vector<Imath::V3d> rows(static_cast<size_t>(image.height()), Imath::V3d(0));
  parallel_for(0, image.height(), [&](int y) {
    Imath::V3d sum(0);
    for (int x = 0; x < image.width(); ++x) sum += Imath::V3d(image.row(y)[x]);
    rows[static_cast<size_t>(y)] = sum;
  });
  Imath::V3d total(0);
  for (const Imath::V3d& row : rows) total += row;
  return V3f(total / static_cast<double>(image.size()));
}

}  // namespace texbake
