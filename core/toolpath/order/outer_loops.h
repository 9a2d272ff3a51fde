// The closed outermost walls of one layer, for a spiral.
#pragma once

#include "layers/layer_stack.h"
#include "toolpath/coverage/bead.h"

#include <span>
#include <vector>

namespace voluta::toolpath {

// A closed wall and the patch that it belongs to.
struct OuterLoop {
  Bead bead;
  std::size_t patch = 0; // index in the stack
};

// Joins loops to one where contours of the layer touch: both are opened over a bead's width at
// their nearest places, and their ends are joined. Contours that are further than 0.05 mm apart do
// not touch. A joined loop belongs to the patch of its first loop.
std::vector<OuterLoop> joinedWhereTouching(std::vector<OuterLoop> loops,
                                           std::span<const layers::Patch> patches);

// Returns the index of the loop that encloses the largest area. Precondition: there are loops.
std::size_t largestLoop(std::span<const OuterLoop> loops);

} // namespace voluta::toolpath
