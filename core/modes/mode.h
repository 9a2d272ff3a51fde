// A mode, that is, a way of decomposing a part into layers. A mode turns a placed part into a
// LayerStack; all later stages are the same for every mode.
#pragma once

#include "base/text.h"
#include "modes/from_options.h"
#include "plan/finding.h"
#include "project/mode_result.h"
#include "project/platform.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::curved {
struct Decomposition;
}
namespace voluta::layers {
struct SupportPlaces;
}
namespace voluta::geometry {
struct Placement;
struct TriangleMesh;
} // namespace voluta::geometry
namespace voluta::platform {
struct PlatformSolid;
}

namespace voluta::modes {

struct DecomposeStage;
struct LayersStage;
struct LoadStage;
struct PartVoxels;

// Input of a mode's decomposition.
struct DecomposeInput {
  const LoadStage& placed;
  // Returns partVoxels() of the placed part, from the cache if possible.
  std::function<std::shared_ptr<const PartVoxels>(double voxelMm, const base::RunContext&)> voxels;
  // Called on the running thread with intermediate results: the ranks first, then the field after
  // each round of smoothing. May be empty.
  std::function<void(std::shared_ptr<const curved::Decomposition>)> onPreview = {};
  // Returns whether a plan with these findings will be discarded. The stage may then stop early
  // with an incomplete result, which is not cached. If empty, every plan is kept.
  std::function<bool(const plan::Findings&)> isRejected = {};
  const layers::SupportPlaces* supports = nullptr; // of regions; null: none
};

// Input of a mode's layers.
struct LayersInput {
  const geometry::TriangleMesh& part; // placed, without the volume that the ground occupies
  const layers::SupportPlaces& supports;
};

// The cell, process and platform a mode uses unless the user chooses others.
struct Defaults {
  std::string cell, process;
  project::Platform platform;
};
// Returns the defaults of project::Choices.
Defaults usualOnPlate();

struct Mode {
  std::string_view id;
  base::Text label;
  FromOptions<std::shared_ptr<const DecomposeStage>(const DecomposeInput&, const base::RunContext&)>
      decompose;
  FromOptions<std::shared_ptr<const LayersStage>(const DecomposeStage&, const LayersInput&,
                                                 const base::RunContext&)>
      layers;
  project::ResultKind result; // type of the result of `decompose`
  // Keys of the entries of modeParameters() that affect this mode; takesParameter() also handles
  // the other parameters.
  std::vector<std::string> parameters;
  bool grows = false;   // grows voxels by the chosen growth scheme
  bool cuts = false;    // cuts the part into pieces
  bool upright = false; // all layers are horizontal and the nozzle stays upright
  // Accepted uses of a platform, the default first.
  std::vector<project::PlatformUse> platforms = {project::PlatformUse::Plate};
  bool aroundRod = false; // needs a cell with a rod
  bool onPart = false;    // lays beads on the part, which exists already
  Defaults usual = usualOnPlate();
  // Returns the default placement for geometry::place() at this scale. If empty, the defaults of
  // geometry::Placement.
  FromOptions<geometry::Placement(const geometry::TriangleMesh&, double scale)> place = {};
  // Returns the scale that "fit" stands for, for a mesh whose unit is unitMm long. If empty, the
  // part is fitted into the robot's reach on a plate.
  FromOptions<double(const geometry::TriangleMesh&, double unitMm)> fittingScale = {};
  // Returns the surface the material starts on, if that does not depend on the decomposition. If
  // empty, a plate as returned by plateOf().
  FromOptions<platform::PlatformSolid(const LoadStage&)> platform = {};
  // Parameters with another default value in this mode, and that value as text.
  std::vector<std::pair<std::string_view, std::string_view>> defaults = {};

  bool requiresParameter(std::string_view parameter) const;
};

} // namespace voluta::modes
