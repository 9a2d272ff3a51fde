// The result of every mode: ordered layers of patches. All later stages are common to all modes
// (docs/design.md, The road).
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/chart.h"

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

namespace voluta::layers {

// Patch::group of support, which is broken off afterwards.
inline constexpr int kSupportGroup = -1;
// Patch::group of the first region that has layers of its own; the next regions follow.
inline constexpr int kRegionGroups = 1 << 20;

// The mid-surface of material printed without interruption: a connected triangle surface with its
// boundary on the part. The nozzle tip is at vertex + 1/2 thickness * direction. Triangles are
// counter-clockwise seen against `direction` (from the nozzle's side).
struct Patch {
  geometry::TriangleMesh surface;
  std::vector<double> thicknessMm; // per vertex, > 0
  // per vertex, unit: the normal of the layer, from earlier layers outwards; material grows along
  // it
  std::vector<Eigen::Vector3d> direction;
  // per vertex, unit: a direction in which the head clears earlier material (front normal)
  std::vector<Eigen::Vector3d> clearDirection;
  int layer = 0; // level it was cut from; 0 is on the platform
  int group = 0; // piece or component, kSupportGroup, or from kRegionGroups
  // Per vertex, 1 on a seam: a boundary inside the part where another patch continues. Empty: no
  // seams.
  std::vector<std::uint8_t> innerRim;
  Chart chart{};  // empty if the mode provides none
  int item = 0;   // index in the job's items
  int region = 0; // 0: of the item itself; k: of its k-th region
  int tool = 0;   // index in the job's tooling
};

// A cavity that the layers leave open, to be filled from its top in one shot.
struct Pocket {
  Eigen::Vector3d top = Eigen::Vector3d::Zero();        // centre of its opening [mm]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); // unit, from its bottom to its top
  double volumeMm3 = 0.0;
  double depthMm = 0.0, openingMm = 0.0; // height, diameter of the opening
  int layer = 0;                         // last layer around it, whose top is its top
  int item = 0, tool = 0;                // as of patches
};

// Patches in print order: each patch comes after those that support it.
struct LayerStack {
  std::vector<Patch> patches;
  int layerCount = 0;
  std::vector<Pocket> pockets = {}; // ascending by layer
};

// Returns a finished stack without spare capacity.
std::shared_ptr<LayerStack> kept(LayerStack stack);

} // namespace voluta::layers
