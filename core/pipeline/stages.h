// The stages as pure functions. Each returns a value that can be cached: its result, its findings,
// its part of the report and its timings (docs/design.md, Stages).
#pragma once

#include "base/run_context.h"
#include "collision/growing_part.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "modes/mode.h"
#include "modes/stages.h"
#include "motion/too_large.h"
#include "pipeline/slow_spans.h"
#include "plan/finding.h"
#include "plan/layer_times.h"
#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/decomposition.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "program/program_input.h"
#include "program/program_options.h"
#include "project/job.h"
#include "project/report.h"
#include "project/stage.h"
#include "replay/verification.h"
#include "replay/worst_places.h"
#include "robot/cell.h"
#include "toolpath/plan_toolpaths.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voluta::pipeline {

class SharedRuns;

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

// A place in a program's text. `line` is 1-based; 0: no particular line.
struct TextLine {
  std::uint32_t file = 0, line = 0;
};

// One program, read back and replayed. The Replay stage has one of these per format.
struct CheckedProgram {
  static constexpr project::Stage kStage = project::Stage::Replay;
  plan::Program program; // its files are named as if it passed
  project::ReplayReport verdict;
  plan::Findings findings;            // of this format only
  std::vector<TextLine> findingLines; // the line of each finding
  bool passed = false;
  std::vector<base::Message> failed;           // the exceeded thresholds
  std::vector<std::size_t> collidingWaypoints; // as Verification::collidingWaypoints
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;
  std::vector<SlowSpan> slow;       // spans in which its controller is slow
  std::vector<TextLine> pointLines; // the line of each point of the trajectory; line 0: none
  project::Timings timings;
  replay::WorstPlaces worst;
  std::size_t deviations = 0; // places where the text differs from the plan
  bool armChecked = false;    // as replay::Verification::armChecked
};

// Returns the line of each point of the trajectory that `program` was written from. A point whose
// motion is missing from the text has line 0.
std::vector<TextLine> linesOfPoints(const CheckedProgram& program,
                                    const plan::Trajectory& trajectory);

// Returns the loaded part rotated, scaled and placed. The cells of a voxel object are unitMm()
// times the scale wide. They are kept if the object is rotated by quarter turns and lifted by whole
// cells; otherwise its surface is voxelized again, which a finding reports. Throws Error{Usage} for
// the scale; Cancelled.
std::shared_ptr<const modes::LoadStage> loadStage(const project::LoadedPart& loaded,
                                                  const project::Choices& choices,
                                                  const process::Process& process,
                                                  const base::RunContext& ctx = {});
// Returns whether the part can be printed at another scale. Voxel objects and parts printed onto
// bodies cannot.
bool takesAnyScale(const project::LoadedPart& loaded, const project::Choices& choices);

// Findings on the part's size and on the width of its walls (part_size.h).
struct SizeStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings;
};
std::shared_ptr<const SizeStage> sizeStage(const project::LoadedPart& loaded,
                                           const modes::LoadStage& placed,
                                           const project::Choices& choices,
                                           const process::Process& process,
                                           const base::RunContext& ctx);
// Returns the placement before any search for a better one: the user's if there is one, else the
// mode's.
geometry::Placement placementByHandOrMode(const geometry::TriangleMesh& mesh, double scale,
                                          const modes::ModeChoices& in);
// Returns the surface that printing will start on, as far as it is known before a decomposition:
// the mode's own base, else the plate. Throws Error{Usage, UnusableInput} for the platform.
platform::PlatformSolid plannedPlatform(const modes::LoadStage& placed,
                                        const project::Choices& choices);
// Returns the choices that determine plannedPlatform(), as text. Throws Error{Usage} for a
// parameter.
std::string plannedPlatformKey(const project::Choices& choices);
// Returns the defects that could not be repaired, as findings. Returns none for an open part:
// loadStage() reports how it is handled.
plan::Findings remainingDefects(const project::LoadedPart& loaded);
plan::Findings defectFindings(const std::vector<base::Message>& remains);

struct MadeToolpaths {
  std::shared_ptr<const ToolpathStage> stage;
  // The part grown along these tool-paths (toolpath::ToolpathResult), for the next stage; too large
  // to cache.
  std::shared_ptr<const collision::GrowingPart> grown;
};
// `items`: with all options but the platform, which is set here. `joined`: their layers in print
// order.
MadeToolpaths toolpathStage(std::vector<toolpath::ItemLayers> items,
                            const layers::LayerStack& joined, const robot::Cell& cell,
                            const platform::PlatformSolid& platform,
                            const process::Tooling& tooling, const base::RunContext& ctx);

// Input of programStage(). `name`: of the part, without extension.
struct ProgramStageInput {
  const geometry::TriangleMesh& part; // the part to print
  const platform::PlatformSolid& platform;
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  process::Tooling tooling;
  std::string name;
  program::ProgramOptions options = {};
  std::size_t firstPoint = 0; // trajectory point at which the program begins: Job::resumedAt
  std::string job = {};       // as program::ProgramInput::job
  std::vector<std::size_t> commonPoint = {};   // as replay::ReplayInput::commonPoint
  std::vector<std::size_t> firstTriangle = {}; // as replay::ReplayInput::firstTriangle
  std::span<const program::ArcVia> arcs = {};  // as program::ProgramInput::arcs
  replay::WholePlan whole = {};                // before its points were merged
  plan::LayerTimes layerTimes = {};            // as replay::ReplayInput::layerTimes
};
// Writes the program, reads it back and replays it. If the dialect has no word for an event of the
// trajectory, the program has no files and did not pass. Throws as program::requireOwnRobot and
// program::requireRodTurns. `shared`: results shared by the programs of one motion; null: none.
std::shared_ptr<const CheckedProgram> programStage(const std::string& format,
                                                   const ProgramStageInput& in,
                                                   const base::RunContext& ctx,
                                                   SharedRuns* shared = nullptr);

} // namespace voluta::pipeline
