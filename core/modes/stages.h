// What modes take and make: the stages up to the layers, each with its payload, its findings, its
// part of the report and its seconds (docs/design.md, Stages).
#pragma once

#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "platform/platform_solid.h"
#include "project/mode_result.h"
#include "project/report.h"
#include "project/stage.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::modes {

struct LoadStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  double scale = 1.0;
  geometry::Placement placement;                      // what the choices' came to
  std::shared_ptr<const geometry::TriangleMesh> part; // placed in the work frame
  // Of a text voxel object; null and empty for a mesh.
  std::shared_ptr<const voxel::SolidVoxels> voxels; // its cells, placed like `part`
  std::vector<Eigen::Vector2d> platform; // hull of its own platform cells, work frame; empty where
                                         // it was tipped over
  project::ModelReport report;           // but for the file's name and notes
  plan::Findings findings;               // of the placement
  project::Timings timings;
};

struct DecomposeStage {
  static constexpr project::Stage kStage = project::Stage::Decompose;
  platform::PlatformSolid platform; // what material starts on, work frame
  project::ModeResult result;
  project::DecompositionReport report; // but for the mode
  plan::Findings findings;
  project::Timings timings;
};

struct LayersStage {
  static constexpr project::Stage kStage = project::Stage::Layers;
  std::shared_ptr<const layers::LayerStack> layers;
  project::LayersReport report;
  double supportVolumeMm3 = 0.0; // of supports that came with the layers
  plan::Findings findings;
  project::Timings timings;
};

} // namespace voluta::modes
