// Regions: places within a part that are printed by settings, or in layers, of their own.
#pragma once

#include "geometry/triangle_mesh.h"

#include <map>
#include <memory>
#include <string>

namespace voluta::project {

// The user's choices for one region of an item. Regions lie in an order: where two overlap, the
// later one holds.
struct Region {
  std::string name = {};        // shown; empty: its shape
  std::string shape = {};       // as in regions/region_kinds.h, for example "height:5,10"
  std::string use = "settings"; // id in regions::regionUses()
  // In the coordinates of the part's file, unscaled: the closed body of a shape from a file, or the
  // painted surface; null for other shapes.
  std::shared_ptr<const geometry::TriangleMesh> mesh = {};
  // Values as text that differ from the item's, of parameters that a region may have.
  std::map<std::string, std::string> parameters = {};
};

bool operator==(const Region& a, const Region& b);
// For base::keyText(): without the name, and with the content of the mesh.
std::string keyOf(const Region& region);

} // namespace voluta::project
