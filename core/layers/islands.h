// Patches that would begin in the air.
#pragma once

#include "base/run_context.h"
#include "layers/absorb.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"

#include <vector>

namespace voluta::layers {

struct IslandOptions {
  double supportReach = 1.25; // as checkSupport: a foot so much further still lies on what is below
  double supportedShare = 0.02; // with less of its area on something a patch is an island
  double leastMerged = 0.5;     // share of its volume that has to find room, for it to go
  double dropMm2 = 20.0;        // smaller ones go in any case
};

// For beads so wide: islands smaller than four of them across go in any case.
IslandOptions islandOptions(double beadWidthMm);

struct AbsorbedIslands {
  Absorbed absorbed;
  std::vector<SupportCheck> support; // of each patch that is left
};

// Takes out islands, from below, and lets the patches over them have their volume (absorbSlivers),
// so that what began in the air becomes an overhang that hangs on its neighbours; again while that
// leaves new islands. Large ones that find no room stay as they are: the part needs support there.
// Support patches neither go nor take anything. Order is kept, layers are numbered anew.
// Precondition: print order. Throws Cancelled.
AbsorbedIslands absorbIslands(LayerStack& stack, const IslandOptions& options,
                              const AbsorbOptions& absorb, const base::RunContext& ctx,
                              const Ground& ground = {});

} // namespace voluta::layers
