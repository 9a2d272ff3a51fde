// Parts of the kinds that people print, by the hundred, from seeds: brackets with pockets, arches,
// hooks, stairs, fins, trees, bowls, tubes with flanges. Closed, 25 to 80 mm, walls of 2.6 mm and
// more, standing on z = 0 as a designer would leave them: some lean over further than a bead may.
#pragma once

#include "geometry/triangle_mesh.h"

#include <string>

namespace voluta::test {

struct MadePart {
  std::string name; // "hook-17": kind and seed
  geometry::TriangleMesh mesh;
};

// The same solid for the same seed.
MadePart madePart(unsigned seed);

} // namespace voluta::test
