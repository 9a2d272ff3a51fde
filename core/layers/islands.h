// Removal of islands: patches without support below.
#pragma once

#include "base/run_context.h"
#include "layers/absorb.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"

#include <vector>

namespace voluta::layers {

struct IslandOptions {
  // as in checkSupport: enlarges the distance at which a foot still counts as supported
  double supportReach = 1.25;
  double supportedShare = 0.02; // a patch with a smaller supported share of its area is an island
  // share of its volume that neighbours must have room for, so that it may be removed
  double minMergedShare = 0.5;
  double dropMm2 = 20.0; // smaller ones are removed in any case
};

// For beads of this width: islands of less than four by four widths are removed in any case.
IslandOptions islandOptions(double beadWidthMm);

struct AbsorbedIslands {
  Absorbed absorbed;
  std::vector<SupportCheck> support; // of each remaining patch
};

// Removes islands from below and distributes their volume to neighbouring patches (absorbSlivers),
// so that the unsupported region becomes an overhang carried by its neighbours; repeats while that
// creates new islands. Large ones without enough room remain: the part needs support there. Support
// patches are neither removed nor changed. The order is kept, layers are renumbered. Precondition:
// print order. Throws Cancelled.
AbsorbedIslands absorbIslands(LayerStack& stack, const IslandOptions& options,
                              const AbsorbOptions& absorb, const base::RunContext& ctx,
                              const Ground& ground = {});

} // namespace voluta::layers
