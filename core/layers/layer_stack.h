// What every mode ends in: ordered layers of patches. From here on there is one road
// (docs/design.md, The road).
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/chart.h"

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

namespace voluta::layers {

// Patch::group of what is laid as support and broken off afterwards.
inline constexpr int kSupportGroup = -1;

// The mid-surface of material laid in one go: a triangle surface, connected, with its boundary on
// the part. The nozzle tip runs at vertex + 1/2 thickness * direction. Triangles are
// counter-clockwise seen against `direction` (from the side of the nozzle).
struct Patch {
  geometry::TriangleMesh surface;
  std::vector<double> thicknessMm;        // per vertex, > 0
  std::vector<Eigen::Vector3d> direction; // per vertex, unit: the normal of the layer, from earlier
                                          // layers outwards; material grows along it
  std::vector<Eigen::Vector3d> clearDirection; // per vertex, unit: a direction in which the head
                                               // clears what is printed earlier (front normal)
  int layer = 0;                               // level it was cut from, 0 is on the platform
  int group = 0;                               // piece or component, or kSupportGroup
  // Per vertex, 1 on a seam: a boundary inside the part where another patch takes over. Empty:
  // nowhere.
  std::vector<std::uint8_t> innerRim;
  Chart chart{}; // empty where the mode gives none
  int item = 0;  // index in the job's items
  int tool = 0;  // index in the job's tooling
};

// Patches in print order: a patch comes after what supports it.
struct LayerStack {
  std::vector<Patch> patches;
  int layerCount = 0;
};

// A stack that is done: without the room in which its patches grew.
std::shared_ptr<LayerStack> kept(LayerStack stack);

} // namespace voluta::layers
