// Compares the processor with the reference shader on OpenGL, over windows chosen to find differences.
#pragma once

#include <vector>

#include "libbake/draw/compare.h"
#include "libbake/gl/gl_renderer.h"

namespace texbake {

struct ParityOptions {
  int windows = 16;        ///< at least, each of side × side pixels, all filters in turn
  int most_windows = 256;  ///< more are drawn until every content was seen, or there are this many
  int side = 256;
  uint32_t seed = 1;  ///< of the choice of windows; each has its own seed of contents
};

/// Random windows: origins near tile 0, at negative coordinates, near 2^31 and 2^32 and anywhere; steps from 1/16 to 8
/// texels to a pixel, with the trilinear filter to 1024.
std::vector<Window> parity_windows(V2i tile_size, const ParityOptions& options = {});

/// The window in which values differ most.
struct WorstWindow {
  Window window;
  std::string plane;
  WorstPixel pixel;
};

/// The first point at which decisions differ.
struct DifferingDecision {
  Window window;
  V2i pixel{0, 0};
  PixelDecision expected, found;
};

struct ParityReport {
  uint64_t points = 0;
  uint64_t differing_decisions = 0;
  uint64_t differing_points = 0;  ///< values differ in some bit
  uint64_t differing_bits = 0;
  uint64_t nan_points = 0;
  uint64_t drawn_contents = 0;  ///< how many of the P · N_t contents were seen
  uint64_t contents = 0;        ///< P · N_t
  std::optional<WorstWindow> worst;
  std::optional<DifferingDecision> first_decision;
  std::string driver;

  bool equal() const { return differing_decisions == 0 && differing_points == 0; }
};

/// Marks the contents that a frame shows: patch · content_count + content.
void count_contents(const Frame& frame, int content_count, std::vector<bool>& seen);

/// Adds what two frames of one window show, the processor's and the driver's.
void add_frames(ParityReport& report, const Window& window, const std::string& plane, const Frame& expected,
                const Frame& found);

/// Base and every map of `planes`.
ParityReport check_parity(const EvaluatorPlanes& planes, const GlContext& context, const ParityOptions& options = {});

}  // namespace texbake
