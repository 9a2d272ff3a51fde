// Results of the stages up to the layers, each with its payload, its findings, its part of the
// report and its computing times (docs/design.md, Stages).
#pragma once

#include "geometry/placement.h"
#include "plan/finding.h"
#include "platform/platform_solid.h"
#include "project/job_stage.h"
#include "project/mode_result.h"
#include "project/report.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::layers {
struct LayerStack;
}
namespace voluta::voxel {
struct SolidVoxels;
}

namespace voluta::modes {

struct LoadStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  double scale = 1.0;
  geometry::Placement placement;                      // resolved from the choices
  std::shared_ptr<const geometry::TriangleMesh> part; // placed in the work frame
  // Only for a voxel object in text format; null and empty for a mesh.
  std::shared_ptr<const voxel::SolidVoxels> voxels; // its cells, placed like `part`
  // convex hull of its own platform cells, work frame; empty if the part was tipped over
  std::vector<Eigen::Vector2d> platform;
  project::ModelReport report; // without the file's name and notes
  plan::Findings findings;     // of the placement
  project::Timings timings;
};

struct DecomposeStage {
  static constexpr project::Stage kStage = project::Stage::Decompose;
  platform::PlatformSolid platform; // the surface material starts on, work frame
  project::ModeResult result;
  project::DecompositionReport report; // without the mode
  plan::Findings findings;
  project::Timings timings;
};

struct LayersStage {
  static constexpr project::Stage kStage = project::Stage::Layers;
  std::shared_ptr<const layers::LayerStack> layers;
  plan::LayerStatistics report;
  double supportVolumeMm3 = 0.0; // of supports made together with the layers
  plan::Findings findings;
  project::Timings timings;
};

} // namespace voluta::modes
