// Where a level passes through one cube: marching cubes (Lorensen and Cline 1987), with its table
// worked out from one rule instead of typed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2). Edge e joins two corners.
struct CubeEdge {
  int from, to;
};
const std::array<CubeEdge, 12>& cubeEdges();

// The closed loops of crossed edges for a set of corners below the level (bit c set). Each loop is
// counter-clockwise seen from above the level. On a face with four crossings the corners below are
// kept apart; the rule knows only the face, so neighbouring cubes agree and there are no cracks.
const std::vector<std::vector<int>>& cubeLoops(std::uint8_t below);

// Do two edges lie on a common face of the cube? A diagonal between them could be met by the same
// diagonal in the neighbouring cube.
bool shareFace(int edgeA, int edgeB);

} // namespace voluta::curved
