// The stages as pure functions. Each returns a value that can be cached: its result, its findings,
// its part of the report and its timings (docs/design.md, Stages).
#pragma once

#include "base/run_context.h"
#include "motion/too_large.h"
#include "plan/finding.h"
#include "plan/statistics.h"
#include "project/job_stage.h"
#include "project/report.h"

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voluta::collision {
class GrowingPart;
}
namespace voluta::geometry {
struct Placement;
struct TriangleMesh;
} // namespace voluta::geometry
namespace voluta::layers {
struct LayerStack;
}
namespace voluta::modes {
struct LoadStage;
struct ModeChoices;
} // namespace voluta::modes
namespace voluta::plan {
struct ToolPlan;
struct Trajectory;
} // namespace voluta::plan
namespace voluta::platform {
struct PlatformSolid;
}
namespace voluta::process {
struct Process;
class Tooling;
} // namespace voluta::process
namespace voluta::project {
struct Choices;
struct LoadedPart;
} // namespace voluta::project
namespace voluta::robot {
class Cell;
}
namespace voluta::toolpath {
struct ItemLayers;
}

namespace voluta::pipeline {

struct Resolved;

struct ToolpathStage {
  static constexpr project::Stage kStage = project::Stage::Toolpath;
  std::shared_ptr<const plan::ToolPlan> toolPlan;
  plan::ToolpathStatistics report;
  plan::Findings findings;
  project::Timings timings;
};

struct MotionStage {
  static constexpr project::Stage kStage = project::Stage::Motion;
  std::shared_ptr<const plan::Trajectory> trajectory; // null if nothing is left to print
  project::MotionReport report;
  // Reported before the findings, by the caller that knows the scale
  std::optional<motion::TooLarge> tooLarge;
  plan::Findings findings;
  project::Timings timings;
};

// Returns the loaded part rotated, scaled and placed. The cells of a voxel object are unitMm()
// times the scale wide. They are kept if the object is rotated by quarter turns and lifted by whole
// cells; otherwise its surface is voxelized again, which a finding reports. Throws Error{Usage} for
// the scale; Cancelled.
std::shared_ptr<const modes::LoadStage> loadStage(const project::LoadedPart& loaded,
                                                  const Resolved& resolved,
                                                  const base::RunContext& ctx = {});
// Returns whether a part in the work frame of its file keeps that place: it is printed along the
// file's tool-paths, alone, and the user has not placed it.
bool keepsGivenPlacement(const project::LoadedPart& loaded, const Resolved& resolved);
// Returns whether the part can be printed at another scale. Voxel objects and parts printed onto
// bodies cannot.
bool takesAnyScale(const project::LoadedPart& loaded, const project::Choices& choices);

// Findings on the part's size and on the width of its walls (part_size.h).
struct SizeStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings;
};
std::shared_ptr<const SizeStage> sizeStage(const project::LoadedPart& loaded,
                                           const modes::LoadStage& placed, const Resolved& resolved,
                                           const base::RunContext& ctx);
// Returns the placement before any search for a better one: the user's if there is one, else the
// mode's.
geometry::Placement placementByHandOrMode(const geometry::TriangleMesh& mesh, double scale,
                                          const modes::ModeChoices& in);
// Returns the surface that printing will start on, as far as it is known before a decomposition:
// the mode's own base, else the plate. Throws Error{Usage, UnusableInput} for the platform.
platform::PlatformSolid plannedPlatform(const modes::LoadStage& placed, const Resolved& resolved);
// Returns the choices that determine plannedPlatform(), as text.
std::string plannedPlatformKey(const Resolved& resolved);
// Returns the defects that could not be repaired, as findings. Returns none for an open part:
// loadStage() reports how it is handled.
plan::Findings remainingDefects(const project::LoadedPart& loaded);
// Returns the figures of a part as placed, without its file's name, notes and scale.
project::ModelReport modelReport(const geometry::TriangleMesh& part);
plan::Findings defectFindings(const std::vector<base::Message>& remains);

struct MadeToolpaths {
  std::shared_ptr<const ToolpathStage> stage;
  // The part grown along these tool-paths (toolpath::ToolpathResult), for the next stage; too large
  // to cache.
  std::shared_ptr<const collision::GrowingPart> grown;
};
// `items`: with all options but the platform, which is set here. `joined`: their layers in print
// order. `others`: places where other items are printed.
MadeToolpaths toolpathStage(std::vector<toolpath::ItemLayers> items,
                            const layers::LayerStack& joined, const robot::Cell& cell,
                            const platform::PlatformSolid& platform,
                            const process::Tooling& tooling, const base::RunContext& ctx,
                            std::span<const Eigen::Vector3d> others = {});

} // namespace voluta::pipeline
