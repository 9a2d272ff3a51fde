#include "curved/cell_contour.h"

#include <algorithm>

namespace voluta::curved {

namespace {

struct Tables {
  std::array<CubeEdge, 12> edges{};
  std::array<std::uint8_t, 12> faces{}; // Bit f: the edge is on face f
  std::array<std::vector<std::vector<int>>, 256> loops;
};

int edgeBetween(const std::array<CubeEdge, 12>& edges, int a, int b) {
  for (int e = 0; e < 12; ++e) {
    const CubeEdge& edge = edges[static_cast<std::size_t>(e)];
    if ((edge.from == a && edge.to == b) || (edge.from == b && edge.to == a))
      return e;
  }
  return -1;
}

// Returns the corners of face 2 axis + side, counter-clockwise seen from outside.
std::array<int, 4> faceCorners(int axis, int side) {
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
  if (side == 1)
    return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

Tables makeTables() {
  Tables t;
  std::size_t count = 0;
  for (int a = 0; a < 8; ++a)
    for (int bit = 1; bit < 8; bit <<= 1)
      if ((a & bit) == 0)
        t.edges[count++] = {a, a | bit};
  for (int face = 0; face < 6; ++face) {
    const auto c = faceCorners(face / 2, face % 2);
    for (std::size_t k = 0; k < 4; ++k)
      t.faces[static_cast<std::size_t>(edgeBetween(t.edges, c[k], c[(k + 1) % 4]))] |=
          static_cast<std::uint8_t>(1 << face);
  }
  for (int below = 0; below < 256; ++below) {
    // Around a face, a run of corners below the level starts at one crossed edge and ends at
    // another; the loop leads from the first to the second. An edge starts a run on one of its
    // faces and ends one on the other, so `next` forms closed loops.
    std::array<int, 12> next;
    next.fill(-1);
    const auto isBelow = [&](int corner) { return (below >> corner & 1) != 0; };
    for (int face = 0; face < 6; ++face) {
      const auto c = faceCorners(face / 2, face % 2);
      for (std::size_t k = 0; k < 4; ++k) {
        if (isBelow(c[k]) || !isBelow(c[(k + 1) % 4]))
          continue;
        std::size_t last = (k + 1) % 4;
        while (isBelow(c[(last + 1) % 4]))
          last = (last + 1) % 4;
        next[static_cast<std::size_t>(edgeBetween(t.edges, c[k], c[(k + 1) % 4]))] =
            edgeBetween(t.edges, c[last], c[(last + 1) % 4]);
      }
    }
    std::array<bool, 12> used{};
    for (int e = 0; e < 12; ++e) {
      if (next[static_cast<std::size_t>(e)] < 0 || used[static_cast<std::size_t>(e)])
        continue;
      std::vector<int> loop;
      for (int at = e; !used[static_cast<std::size_t>(at)];
           at = next[static_cast<std::size_t>(at)]) {
        used[static_cast<std::size_t>(at)] = true;
        loop.push_back(at);
      }
      t.loops[static_cast<std::size_t>(below)].push_back(std::move(loop));
    }
  }
  return t;
}

const Tables& tables() {
  static const Tables t = makeTables();
  return t;
}

} // namespace

const std::array<CubeEdge, 12>& cubeEdges() {
  return tables().edges;
}

const std::vector<std::vector<int>>& cubeLoops(std::uint8_t below) {
  return tables().loops[below];
}

bool shareFace(int a, int b) {
  return (tables().faces[static_cast<std::size_t>(a)] &
          tables().faces[static_cast<std::size_t>(b)]) != 0;
}

} // namespace voluta::curved
