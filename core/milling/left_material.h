// Material that a milled block still has in the space that should be free.
#pragma once

#include "milling/mill_passes.h"
#include "milling/stock.h"

#include <Eigen/Core>

namespace voluta::milling {

struct LeftMaterial {
  double volumeMm3 = 0.0;                         // more than a round cutter leaves everywhere
  double thickestMm = 0.0;                        // greatest height of it in one place
  Eigen::Vector3d atMm = Eigen::Vector3d::Zero(); // there, as side A sees it
  double cornersMm3 = 0.0; // what a round cutter leaves in corners and between lines
};

// Least volume that is reported [mm3]: below it are single cells.
inline constexpr double kMinLeftMm3 = 1.0;

// Returns the material above and below the part, in its undercuts and hollows, in holes through it,
// and in gaps of its silhouette that are narrower than the cutter. `corners` are what a round
// cutter leaves everywhere: layers along the normal up to 0.41 of its radius (a right-angled
// groove) or the ridge between two lines, whichever is more; and within a radius of places that it
// clears to the same height (the foot of a wall), layers up to a radius, or all that no line could
// clear. A cell is added to each bound. `rest`: the block afterwards, as side A sees it.
LeftMaterial leftMaterial(const Stock& rest, const MillPlan& plan, const MillRule& rule);

} // namespace voluta::milling
