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
#include "modes/part_voxels.h"
#include "modes/stages.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/job.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::modes {

struct ModeChoices {
  const project::Choices& choices;
  const base::ParameterValues& values;
  const process::Process& process;
};

// What a decomposition is made from.
struct DecomposeInput {
  const LoadStage& placed;
  const ModeChoices& choices;
  // partVoxels() of the placed part; kept ones where there are.
  std::function<std::shared_ptr<const PartVoxels>(const base::RunContext&)> voxels;
  // Called on the running thread with what has come out so far: ranks, then the field as rounds
  // improve it. May be empty.
  std::function<void(std::shared_ptr<const curved::Decomposition>)> onPreview;
};

// What a mode is printed with unless something else is chosen.
struct Companions {
  std::string cell, process;
  project::Platform platform;
};
// As Choices begin.
Companions usualOnPlate();

struct Mode {
  std::string_view id;
  base::Text label;
  // What of the choices goes into each of the two stages, as text for their keys.
  std::string (*decomposeKey)(const ModeChoices&);
  std::string (*layersKey)(const ModeChoices&);
  std::shared_ptr<const DecomposeStage> (*decompose)(const DecomposeInput&,
                                                     const base::RunContext&);
  // `part` is placed, less what the platform takes of it.
  std::shared_ptr<const LayersStage> (*layers)(const DecomposeStage&,
                                               const geometry::TriangleMesh& part,
                                               const ModeChoices&, const base::RunContext&);
  std::vector<project::PlatformUse> platforms = {
      project::PlatformUse::Plate}; // as what it takes one
  bool aroundRod = false;           // does it need a cell with a rod
  Companions usual = usualOnPlate();
  // Where a part lies that nobody has placed, for geometry::place with this scale; null: as
  // geometry::Placement's defaults. Decided by the mesh and what placeKey tells.
  geometry::Placement (*place)(const geometry::TriangleMesh&, double scale,
                               const ModeChoices&) = nullptr;
  std::string (*placeKey)(const ModeChoices&) = nullptr; // text for the Load stage's key
  // What scale "fit" comes to, of a mesh with units so many mm long; null: what is in the robot's
  // reach on a plate.
  double (*fittingScale)(const geometry::TriangleMesh&, double unitMm,
                         const ModeChoices&) = nullptr;
  // What material starts on, where that does not wait for a decomposition; null: a plate, as
  // plateOf() has it.
  platform::PlatformSolid (*platform)(const LoadStage& placed, const ModeChoices&) = nullptr;
  // Parameters whose default is another one in this mode, as text.
  std::vector<std::pair<std::string_view, std::string_view>> defaults = {};
  // Of modeParameters() those that have a say in it; takesParameter() knows the others.
  std::vector<std::string> parameters = {};
  bool grows = false; // by one of the growth schemes
};

// What modes share: heights and a head as text for keys, statistics as the report has them.
std::string heightsText(const process::Process& process);
std::string headText(const process::HeadShape& head);
project::LayersReport reportOf(const layers::LayerStatistics& statistics);

} // namespace voluta::modes
