// Limits on the time between a bead and the bead that covers it, at each place.
#pragma once

namespace voluta::plan {

struct LayerTimes {
  double minS = 0.0; // The covered bead has to cool for so long; 0: no limit
  double maxS = 0.0; // Beads bond up to this age; 0: no limit
};

} // namespace voluta::plan
