// Divides the patches of layers between an item and its regions.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"

#include <span>

namespace voluta::regions {

// Returns the parameter interlockMm.
base::ParameterTable regionParameters();

// A region that has settings of its own, but the layers of its item.
struct SettingsRegion {
  int number = 0;              // Patch::region
  geometry::TriangleMesh body; // closed, work frame
  // Of plane layers: in every other layer the region, in those between what is around it, reaches
  // half of it over the body's surface.
  double interlockMm = 0.0;
};

// Returns the stack with each patch divided at the bodies; the later region holds where two
// overlap. Supports stay whole. The ends of a region are walls: each side is covered up to them.
// Plane layers are divided as polygons, others as surfaces; parts of plane layers that are narrower
// than half a bead go to the other side. Throws Cancelled.
layers::LayerStack dividedPatches(const layers::LayerStack& stack,
                                  std::span<const SettingsRegion> regions, double beadWidthMm,
                                  const base::RunContext& ctx);

} // namespace voluta::regions
