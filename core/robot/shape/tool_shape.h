// What a cell's head, its holder and what carries its platform look like, within their solids.
#pragma once

#include "robot/body.h"
#include "robot/shape/arm_shape.h"

namespace voluta::robot {

// Solids in the body's frame. Head: nozzle, heater block, cooler and motor; its tip is the first
// shape's end, the tool frame's origin. Holder: tubes with a clamp at each end, or a profile rail
// where it is long. Platform: the stem alone. Nothing for other bodies.
std::vector<ShapeSolid> toolShape(const Body& body);

} // namespace voluta::robot
