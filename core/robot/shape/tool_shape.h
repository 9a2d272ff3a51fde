// The visual shapes of a cell's head, its holder and the stem of its platform, inside their
// collision solids.
#pragma once

#include "robot/body.h"
#include "robot/shape/arm_shape.h"

namespace voluta::robot {

// Returns visual solids in the body's frame. Head: nozzle, heater block, cooler and motor; its tip
// is the first shape's end, the tool frame's origin. Holder: tubes with a clamp at each end, or a
// profile rail if it is long. Platform: only the stem. Empty for other bodies.
std::vector<ShapeSolid> toolShape(const Body& body);

} // namespace voluta::robot
