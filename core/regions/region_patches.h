// Divides the patches of layers between an item and its regions.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"

#include <cstddef>
#include <span>
#include <vector>

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

// How a region meets a patch of a layer, from the least effect to the greatest.
enum class RegionMeeting {
  None,
  Narrow,  // of a plane patch: its section is narrower than half a bead
  Crossed, // of a plane patch: the interlock of the part around the region reaches through it
  Divided
};

// Of the layers that a region meets: their number, and in how many it has no effect.
struct LayersMet {
  std::size_t layers = 0, narrow = 0, crossed = 0;
};

struct DividedLayers {
  layers::LayerStack stack;
  std::vector<LayersMet> met; // per region
};

// Returns the stack with each patch divided at the bodies; the later region holds where two
// overlap. Supports stay whole. The ends of a region are walls: each side is covered up to them.
// Plane layers are divided as polygons, others as surfaces; parts of plane layers that are narrower
// than half a bead go to the other side. Throws Cancelled.
DividedLayers dividedPatches(const layers::LayerStack& stack,
                             std::span<const SettingsRegion> regions, double beadWidthMm,
                             const base::RunContext& ctx);

} // namespace voluta::regions
