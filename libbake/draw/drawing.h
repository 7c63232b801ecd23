// A picture of a material, whatever it shows: one scale or several, the color or a map, a flat window or an endless
// plane in perspective. Everything that it needs is prepared once; then it is drawn by rows.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "libbake/draw/feature.h"
#include "libbake/draw/perspective_view.h"
#include "libbake/draw/show.h"
#include "libbake/draw/window.h"
#include "libbake/planes/drawn_material.h"
#include "libbake/planes/relief_planes.h"
#include "libbake/planes/stack_planes.h"

namespace texbake {

/// Relief of the coarsest scale, and from where it is seen and lit.
struct Relief {
  ReliefOptions options;
  Direction viewer{0, 0, 1};  ///< of a flat window
  Direction light = kDefaultLight;
};

/// What a picture shows.
struct DrawRequest {
  std::variant<Window, Perspective> view;  ///< counts in texels of the finest scale
  std::string map = {};                    ///< of the finest scale; "": the color, of all scales together
  Show show = Show::color;                 ///< of the finest scale, where it is not the color
  Relief relief = {};                      ///< none where its depth is 0
  int samples = 1;  ///< above 1: the mean of samples × samples points of each pixel at level 0, in place of a filter

  int width() const;
  int height() const;
  bool is_flat() const { return std::holds_alternative<Window>(view); }
  bool is_deformed() const;
  bool has_relief() const { return relief.options.depth_px > 0; }
  Features features() const;  ///< all but the scales of the material
};

/// The channels of the picture, 1 or 3. Throws Error(usage) for a map that the material lacks.
int drawn_channels(const DrawnMaterial& material, const DrawRequest& request);

/// A picture, ready to be drawn.
class Drawing {
 public:
  /// Borrows what `material` views until it returns. Throws Error(usage) as check_features does, for a map or a height
  /// map that the material lacks, and for views outside their range; Error(bad_data) as prepare and prepare_stack do.
  Drawing(const DrawnMaterial& material, const DrawRequest& request);

  /// Rows row_begin ≤ j < row_end: light in linear Rec.709, or the values of a map, whose channels beyond `channels`
  /// are 0. The result does not depend on how a picture is cut into rows, nor on threads.
  Image<V3f> rows(int row_begin, int row_end) const;

  const DrawRequest& request() const { return request_; }
  int channels() const { return plane_ ? plane_->channels : 3; }  ///< drawn_channels

  /// What is bound: planes of one scale and the one of them that is drawn, or those of a stack. The simpler text draws
  /// one scale without relief, since a stack of one scale shows the same and costs many times as much.
  const EvaluatorPlanes& tile() const { return tile_; }
  const Plane* plane() const { return plane_; }  ///< nullptr: the stack is drawn
  const StackPlanes& stack() const { return stack_; }
  const ReliefPlanes* relief() const { return relief_ ? &*relief_ : nullptr; }

  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

 private:
  Image<V3f> tile_rows(const Window& window, int row_begin, int row_end) const;
  Image<V3f> tile_rows(const Perspective& view, int row_begin, int row_end) const;
  Image<V3f> stack_rows(const Window& window, int row_begin, int row_end) const;
  Image<V3f> stack_rows(const Perspective& view, int row_begin, int row_end) const;

  DrawRequest request_;
  EvaluatorPlanes tile_;
  const Plane* plane_ = nullptr;
  StackPlanes stack_;
  std::optional<ReliefPlanes> relief_;
};

}  // namespace texbake
