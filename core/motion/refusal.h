// What is not printed, and why.
#pragma once

#include "collision/cell_collision.h"

#include <cstddef>
#include <cstdint>

namespace voluta::motion {

// Why a waypoint is not printed.
enum class Refusal : std::uint8_t {
  None,
  Unreachable, // no joints within limits, whatever the turn about the nozzle
  Collision,   // every way to be there meets something: `contact` is the commonest
  Leans,       // out of upright, which is all that the cell's arm can do
  HeadPart,    // the head would be in the part, whatever the arm does
  HeadPlatform,
  BeyondRod,   // further out, or further along, than the cell prints around its rod
  CloserLook,  // something meets there where the motion is looked at more closely
  NoConnection // could be reached, but from neither neighbour without a lift
};
struct Refused {
  std::size_t waypoint = 0;
  Refusal why = Refusal::None;
  collision::Contact contact; // Collision
};

} // namespace voluta::motion
