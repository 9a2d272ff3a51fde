// The ways of building a part: one row a mode. A mode takes a placed part to a LayerStack; all
// that follows is the same road for every mode.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "pipeline/job.h"
#include "pipeline/report.h"
#include "process/process.h"
#include "voxel/solid_voxels.h"

#include <memory>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

struct ModeInput {
  const geometry::TriangleMesh& part; // placed
  const Choices& choices;
  const base::ParameterValues& values;
  const process::Process& process;
  bool untilDecompose = false; // layers are not asked for
};

struct ModeResult {
  std::vector<Eigen::Vector2d> platform;                      // polygon material starts on
  std::shared_ptr<const curved::Decomposition> decomposition; // null in modes without voxels
  std::shared_ptr<const layers::LayerStack> layers;           // null after untilDecompose
};

struct Mode {
  std::string_view id, label;
  // Fills in the decomposition and layers of `report`, its findings and timings.
  ModeResult (*build)(const ModeInput&, Report& report, const base::RunContext&);
};

const std::vector<Mode>& modes();
// Precondition: the id is known (checkChoices).
const Mode& findMode(std::string_view id);

} // namespace voluta::pipeline
