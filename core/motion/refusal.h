// Waypoints that are not printed, and why.
#pragma once

#include "collision/cell_collision.h"

#include <cstddef>
#include <cstdint>

namespace voluta::motion {

// Why a waypoint is not printed.
enum class Refusal : std::uint8_t {
  None,
  Unreachable, // No joints within limits at any rotation about the nozzle
  Collision,   // Every pose collides: `contact` is the most frequent collision
  Leans,       // Tilted direction, while the cell's arm only prints upright
  HeadPart,    // The head would be in the part at every pose of the arm
  HeadPlatform,
  BeyondRod,   // Further from the rod's axis, or further along it, than the cell prints
  CloserLook,  // A collision was found in the closer check of the motion
  NoConnection // Reachable, but from neither neighbour without a lift
};
struct Refused {
  std::size_t waypoint = 0;
  Refusal why = Refusal::None;
  collision::Contact contact; // Set for Collision
};

} // namespace voluta::motion
