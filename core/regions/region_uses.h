// The table of what a region may be for.
#pragma once

#include "base/text.h"
#include "project/region.h"
#include "regions/region_kinds.h"

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace voluta::regions {

// The layers that a region has of its own.
enum class RegionLayers {
  None,
  Surface, // parallel to the part's upper surface; of skins
  Around,  // at constant distance from the rest of the part
  Flat,    // perpendicular to a direction
  Turning  // planes that turn from horizontal to a direction, thicker on one side
};

// What a region does under the part's load (docs/algorithms/loads.md).
enum class RegionLoad { None, Held, Force };

struct RegionUse {
  std::string_view id; // before the colon of its text
  base::Text label;
  bool cuts = false;     // the part ends at the region
  bool isInsert = false; // where the part ends, the operator puts a body in
  RegionLayers layers = RegionLayers::None;
  RegionLoad load = RegionLoad::None;
  std::vector<ShapeField> fields = {}; // of its text, as those of shapes

  bool hasLayers() const { return layers != RegionLayers::None; }
  // Settings of its own hold in the region.
  bool hasSettings() const { return !cuts && load == RegionLoad::None; }
};

// In the order shown to users.
const std::vector<RegionUse>& regionUses();

// The form of a use, for example "flat:[DX,DY,DZ]".
std::string formOf(const RegionUse& use);

// Returns the use of a text such as "flat:0,1,1". Throws Error{Usage} that names the nearest one,
// or its form.
const RegionUse& findUse(std::string_view text);
// Returns whether the layers of one of the regions tilt the head.
bool tiltHead(const std::vector<project::Region>& regions);
// Returns the unit direction that the text of a use states. Throws Error{Usage} for a direction of
// no length. Precondition: the use has a direction.
Eigen::Vector3d directionOf(std::string_view text);
// Returns the layer of the part, from 1, before which the body of an insert is put in; 0: the first
// one that ends above it. Precondition: the use is an insert's.
int layerOf(std::string_view text);
// Returns the force [N] that the text of a use states, in the axes of the part's file. Throws as
// directionOf(). Precondition: the use is one with a force.
Eigen::Vector3d forceOf(std::string_view text);

} // namespace voluta::regions
