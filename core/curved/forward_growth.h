// Forward growth as the sources do it. All four schemes may lose voxels.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/incremental_front.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

enum class ForwardScheme {
  Greedy,      // algorithm 1 of the dissertation (3.4.2), GCFA of the thesis
  Incremental, // algorithm 2: of each layer only what shadows nothing, voxel by voxel (GCFA-ISP)
  Adaptive,    // algorithm 3: the same, halving the layer
  Guided       // algorithms 4 and 5: adaptive, held back by the peeling field
};

// How Incremental orders a layer's voxels before it tries them (list Q).
enum class QueueOrder { Insertion, Flooding };

// What is lost where no voxel of a layer is safe.
enum class Sacrifice {
  Layer, // what the whole layer shadows (as printed)
  Least  // no more than its most harmless voxel shadows, for as many of the layer as that allows
};

struct ForwardOptions {
  // A voxel joins its layer while the layer shadows fewer than this many further voxels. 1: none
  // (the dissertation's rule). 0: fewer than the whole layer would (the thesis's rule, 6.1.2).
  std::int32_t ispThreshold = 1;
  QueueOrder queue = QueueOrder::Flooding;
  Boundary boundary = Boundary::Outside;
  Sacrifice sacrifice = Sacrifice::Layer;
  std::int32_t fieldStep = 1; // Guided: by how much the threshold of the peeling field rises, >= 1
};

struct ForwardGrowth {
  std::vector<std::int32_t> rank;    // per voxel: 1 stands on the platform; 0: never laid
  std::int32_t ranks = 0;            // layers
  std::vector<std::int32_t> peeling; // peelingField(), Guided only, else empty
  std::size_t reduced = 0;           // layers cut down so that they shadow less
  std::size_t sacrificed = 0;        // layers of which nothing was safe
};

// Every voxel of rank r > 1 has an AM-stable neighbour of lower rank and lies not inside the hull
// of the platform and all lower ranks (`boundary` says what is inside); rank 1 are all voxels on
// the platform. Nothing depends on the number of threads. Throws Cancelled.
//
// What differs from the printed algorithms:
// - A layer is proposed from the neighbours of all that is laid, not of the last layer only. For
//   Greedy it is the same; otherwise a voxel that was held back would be found again only by the
//   chance of a neighbour in a later layer. Algorithm 5 needs it too: as printed its current layer
//   stays empty after the threshold was raised, and growth ends.
// - Shadowed is a voxel inside the front that is neither laid nor still waiting for its turn in
//   the layer at hand: such a voxel may be laid with this layer. The thesis counts it.
// - Algorithm 3, line 11, adds sets that shadow; only those that do not are added. Halving is run
//   to single voxels as an order: a set whose hull swallows nothing is one whose voxels can be
//   added one after the other, so both give the same layer, and none needs a hull of its own.
// - Algorithm 2 of the thesis, line 6, is inverted: the layer is taken whole when it shadows no
//   more than is shadowed already. The threshold counts from there, for each layer anew; a count
//   of all that was ever shadowed would end prevention once it is reached.
// - Flooding starts from the layer's first voxel instead of a random one.
// - Where no voxel of a layer is safe, it is laid whole and what it shadows is lost, as printed
//   (Sacrifice::Layer). Guided first lets go on what its field still holds back: only where nothing
//   at all is safe is something lost.
// - Algorithm 2 tests one voxel after the other with a hull from scratch; the same answers come
//   from one hull that keeps, facet by facet, the voxels it must not swallow (incremental_front.h).
ForwardGrowth forwardGrowth(const VoxelGraph& graph, ForwardScheme scheme,
                            const ForwardOptions& options, const base::RunContext& ctx);

// growthIsp, growthQueue, growthBoundary, growthSacrifice: ForwardOptions for a user.
base::ParameterTable forwardParameters();
// From values over a table that has them.
ForwardOptions forwardOptions(const base::ParameterValues& values);

} // namespace voluta::curved
