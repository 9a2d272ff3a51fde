// Forward growth by the four schemes of the sources. All of them may lose voxels.
#pragma once

#include "base/run_context.h"
#include "curved/incremental_front.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

enum class ForwardScheme {
  Greedy, // Algorithm 1 of the dissertation (3.4.2), GCFA of the thesis
  // Algorithm 2: voxel by voxel, only the part of each layer that shadows nothing (GCFA-ISP)
  Incremental,
  Adaptive, // Algorithm 3: the same, by halving the layer
  Guided    // Algorithms 4 and 5: adaptive, held back by the peeling field
};

// How Incremental orders the voxels of a layer before trying them (list Q).
enum class QueueOrder { Insertion, Flooding };

// Voxels that are lost where no voxel of a layer is safe.
enum class Sacrifice {
  Layer, // All that the whole layer shadows (as published)
  // At most as many as the layer's most harmless voxel shadows; the layer keeps as many voxels as
  // that allows
  Fewest
};

struct ForwardOptions {
  // A voxel joins its layer while the layer shadows fewer than this many further voxels. 1: none
  // (the dissertation's rule). 0: fewer than the whole layer would (the thesis's rule, 6.1.2).
  std::int32_t ispThreshold = 1;
  QueueOrder queue = QueueOrder::Flooding;
  Boundary boundary = Boundary::Outside;
  Sacrifice sacrifice = Sacrifice::Layer;
  std::int32_t fieldStep = 1; // Guided: increment of the peeling field's threshold, >= 1
};

struct ForwardGrowth {
  std::vector<std::int32_t> rank;    // Per voxel: 1 on the platform; 0: never printed
  std::int32_t ranks = 0;            // Number of layers
  std::vector<std::int32_t> peeling; // peelingField(), Guided only, else empty
  std::size_t reduced = 0;           // Layers reduced so that they shadow less
  std::size_t sacrificed = 0;        // Layers without any safe voxel
};

// Every voxel of rank r > 1 has an AM-stable neighbour of lower rank and is not inside the hull of
// the platform and all lower ranks (`boundary` defines inside); rank 1 is all voxels on the
// platform. The result does not depend on the number of threads. Throws Cancelled.
//
// Differences from the published algorithms:
// - A layer is proposed from the neighbours of all printed voxels, not of the last layer only. For
//   Greedy the result is the same; otherwise a voxel that was held back would be found again only
//   if a later layer happens to have it as a neighbour. Algorithm 5 needs it too: as published its
//   current layer stays empty after the threshold was raised, and growth ends.
// - A voxel is shadowed if it is inside the front, not printed, and not waiting in the current
//   layer: such a voxel may be printed with this layer. The thesis counts it.
// - Algorithm 3, line 11, adds sets that shadow; here only sets that do not shadow are added.
//   Halving runs down to single voxels and serves as an order: the voxels of a set whose hull
//   swallows nothing can be added one after the other, so both give the same layer, and no set
//   needs a hull of its own.
// - Algorithm 2 of the thesis, line 6, is inverted: the layer is taken whole if it shadows no more
//   than is shadowed already. The threshold counts from there, for each layer anew; a count of all
//   voxels ever shadowed would end prevention once it is reached.
// - Flooding starts from the layer's first voxel instead of a random one.
// - Where no voxel of a layer is safe, the whole layer is printed and the voxels it shadows are
//   lost, as published (Sacrifice::Layer). Guided first releases voxels that its field still holds
//   back and loses voxels only if nothing at all is safe.
// - Algorithm 2 tests one voxel after the other with a hull from scratch; here one hull that keeps,
//   facet by facet, the voxels it must not swallow gives the same answers (incremental_front.h).
ForwardGrowth forwardGrowth(const VoxelGraph& graph, ForwardScheme scheme,
                            const ForwardOptions& options, const base::RunContext& ctx);

} // namespace voluta::curved
