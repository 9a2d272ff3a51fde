// Beads of the sparse infill of a layer.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "process/process.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/options.h"
#include "toolpath/sparse/layer_count.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::toolpath {

// The frame in which a sparse pattern is defined.
struct PatternFrame {
  Eigen::Matrix3d fromWork = Eigen::Matrix3d::Identity(); // z along the mean build direction
  double radiusMm = 0.0; // Of patches with a chart: the mean radius; elsewhere unused
};
// Returns a frame per patch, the same for all patches of an item's group, turned about the build
// direction such that straight lines are at 45 degrees to those of the solid infill.
std::vector<PatternFrame> patternFrames(const layers::LayerStack& stack,
                                        const ToolpathOptions& options);

// A sparse part in its stack.
struct SparsePlace {
  const layers::LayerStack& stack;
  std::size_t patch; // Index of its patch
  const LayerCount& layers;
  PatternFrame frame;
};

// Beads of the process's usual width along the pattern's lines, joined along the edge of the patch
// where ends of neighbours are near each other; free ends reach into the wall or skin beside them.
// Where the lines are too far apart for the skin above to bridge, each branches into two over the
// layers below it. `patch`: one of SplitLayers::sparse. None for density 0. Throws Cancelled,
// Error{Usage} for an unknown pattern.
std::vector<Bead> sparseBeads(const layers::Patch& patch, const SparsePlace& place,
                              const process::Process& process, const ToolpathOptions& options,
                              const base::RunContext& ctx);

} // namespace voluta::toolpath
