// A way of building a part. A mode takes a placed part to a LayerStack; all that follows is the
// same road for every mode.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "base/text.h"
#include "curved/decomposition.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_checks.h"
#include "modes/from_options.h"
#include "modes/part_voxels.h"
#include "modes/stages.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/mode_result.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::modes {

// What a decomposition is made from.
struct DecomposeInput {
  const LoadStage& placed;
  // partVoxels() of the placed part; kept ones where there are.
  std::function<std::shared_ptr<const PartVoxels>(double voxelMm, const base::RunContext&)> voxels;
  // Called on the running thread with what has come out so far: ranks, then the field as rounds
  // improve it. May be empty.
  std::function<void(std::shared_ptr<const curved::Decomposition>)> onPreview = {};
  // Is a plan with these findings of no use? Then the stage may end with what there is, and nobody
  // keeps it. May be empty: every plan is.
  std::function<bool(const plan::Findings&)> isRejected = {};
};

// What a mode is printed with unless something else is chosen.
struct Defaults {
  std::string cell, process;
  project::Platform platform;
};
// As Choices begin.
Defaults usualOnPlate();

struct Mode {
  std::string_view id;
  base::Text label;
  FromOptions<std::shared_ptr<const DecomposeStage>(const DecomposeInput&, const base::RunContext&)>
      decompose;
  // The mesh is the part as it is placed, less what the ground takes of it.
  FromOptions<std::shared_ptr<const LayersStage>(
      const DecomposeStage&, const geometry::TriangleMesh&, const base::RunContext&)>
      layers;
  project::ResultKind result; // of `decompose`
  // Keys of those of modeParameters() that have a say in it; takesParameter() knows the others.
  std::vector<std::string> parameters;
  bool grows = false;   // by the scheme that is chosen
  bool cuts = false;    // the part into pieces
  bool upright = false; // are its layers level, the nozzle upright over all of them
  // What it takes a platform as, the usual way first.
  std::vector<project::PlatformUse> platforms = {project::PlatformUse::Plate};
  bool aroundRod = false; // does it need a cell with a rod
  Defaults usual = usualOnPlate();
  // Where a part lies that nobody has placed, for geometry::place with this scale. Nothing: as
  // geometry::Placement's defaults.
  FromOptions<geometry::Placement(const geometry::TriangleMesh&, double scale)> place = {};
  // What scale "fit" comes to, of a mesh with units so many mm long. Nothing: what is in the
  // robot's reach on a plate.
  FromOptions<double(const geometry::TriangleMesh&, double unitMm)> fittingScale = {};
  // What material starts on, where that does not wait for a decomposition. Nothing: a plate, as
  // plateOf() has it.
  FromOptions<platform::PlatformSolid(const LoadStage&)> platform = {};
  // Parameters whose default is another one in this mode, as text.
  std::vector<std::pair<std::string_view, std::string_view>> defaults = {};

  bool requiresParameter(std::string_view parameter) const;
};

// Statistics as the report has them.
project::LayersReport reportOf(const layers::LayerStatistics& statistics);

} // namespace voluta::modes
