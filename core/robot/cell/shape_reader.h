// Reads shapes and pairs of bodies in robot and cell files.
#pragma once

#include "robot/body.h"

#include <utility>
#include <vector>

namespace voluta::base {
class JsonNode;
}

namespace voluta::robot {

// Reads a list of shapes, each an object with one key, mm, in the body's own frame:
//   {"capsule": {"p0Mm": [x,y,z], "p1Mm": [x,y,z], "radiusMm": r}}
//   {"box":     {"pose": {"xyzMm": [..], "rpyDeg": [..]}, "sizeMm": [x,y,z]}}   full edge lengths
//   {"frustum": {"p0Mm": [..], "p1Mm": [..], "r0Mm": r, "r1Mm": r}} Throws Error{UnusableInput}
//   naming file and key, also for an empty list.
std::vector<Shape> readShapes(const base::JsonNode& list);

// Reads a list of {"pair": [name, name], "why": text} as indices into `bodies`, the lower first.
// Throws Error{UnusableInput} naming file and key for an unknown name or a body paired with itself.
std::vector<std::pair<int, int>> readBodyPairs(const base::JsonNode& list,
                                               const std::vector<Body>& bodies);

} // namespace voluta::robot
