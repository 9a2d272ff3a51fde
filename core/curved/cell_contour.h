// Intersection of a level with one cube: marching cubes (Lorensen and Cline 1987), with the table
// computed from one rule.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// Corner c of a cube is at (c & 1, c >> 1 & 1, c >> 2). Edge e joins two corners.
struct CubeEdge {
  int from, to;
};
const std::array<CubeEdge, 12>& cubeEdges();

// Returns the closed loops of crossed edges for a set of corners below the level (bit c set). Each
// loop is counter-clockwise seen from above the level. On a face with four crossings the corners
// below are kept separate; this rule depends only on the face, so neighbouring cubes agree and
// there are no cracks.
const std::vector<std::vector<int>>& cubeLoops(std::uint8_t below);

// Returns whether two edges are on a common face of the cube. A diagonal between such edges could
// coincide with a diagonal of the neighbouring cube.
bool shareFace(int edgeA, int edgeB);

} // namespace voluta::curved
