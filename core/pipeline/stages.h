// Each stage as a pure function from what goes in to a value that can be kept: its payload, its
// findings, its part of the report and its seconds (docs/design.md, Stages).
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
#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/decomposition.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "program/program_options.h"
#include "project/job.h"
#include "project/report.h"
#include "project/stage.h"
#include "replay/judged_runs.h"
#include "replay/worst_places.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct ToolpathStage {
  static constexpr project::Stage kStage = project::Stage::Toolpath;
  std::shared_ptr<const plan::ToolPlan> toolPlan;
  project::ToolpathReport report;
  plan::Findings findings;
  project::Timings timings;
};

struct MotionStage {
  static constexpr project::Stage kStage = project::Stage::Motion;
  std::shared_ptr<const plan::Trajectory> trajectory; // null when nothing is left to print
  project::MotionReport report;
  std::optional<motion::TooLarge> tooLarge; // told before the findings, by who knows the scale
  plan::Findings findings;
  project::Timings timings;
};

// A place in a program's text. line is 1-based; 0: nowhere in particular.
struct TextLine {
  std::uint32_t file = 0, line = 0;
};

// One program, read back and replayed; the Replay stage is one of these for each format.
struct CheckedProgram {
  static constexpr project::Stage kStage = project::Stage::Replay;
  plan::Program program; // files named as if it passed
  project::ReplayReport verdict;
  plan::Findings findings;            // of this format
  std::vector<TextLine> findingLines; // of each finding
  bool passed = false;
  std::vector<base::Message> failed;           // the thresholds that were not kept
  std::vector<std::size_t> collidingWaypoints; // as Verification::collidingWaypoints
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;
  std::vector<SlowSpan> slow;       // of its controller
  std::vector<TextLine> pointLines; // of each point of the trajectory; line 0: it has none
  project::Timings timings;
  replay::WorstPlaces worst;
  std::size_t deviations = 0; // places where the text is not what was planned
  bool armChecked = false;    // replay::Verification's
};

// The line of each point of the trajectory that `program` was written from. A point whose motion is
// missing from the text has line 0.
std::vector<TextLine> linesOfPoints(const CheckedProgram& program,
                                    const plan::Trajectory& trajectory);

// The loaded part turned, scaled and put where it is to lie. A voxel object's cells are unitMm()
// times the scale wide and stay as they are where it is turned by quarter turns and lifted by whole
// cells; elsewhere its surface is cut into new cells, which is told. Throws Error{Usage}: the
// scale; Cancelled.
std::shared_ptr<const modes::LoadStage> loadStage(const project::LoadedPart& loaded,
                                                  const project::Choices& choices,
                                                  const process::Process& process,
                                                  const base::RunContext& ctx = {});
// Can the part be printed at another size? Of cells and of bodies to print on there is no other.
bool takesAnyScale(const project::LoadedPart& loaded, const project::Choices& choices);

// Whether the part is of a size to print, and its walls wide enough (part_size.h).
struct SizeStage {
  static constexpr project::Stage kStage = project::Stage::Load;
  plan::Findings findings;
};
std::shared_ptr<const SizeStage> sizeStage(const project::LoadedPart& loaded,
                                           const modes::LoadStage& placed,
                                           const project::Choices& choices,
                                           const process::Process& process,
                                           const base::RunContext& ctx);
// Where the mesh lies before any search for a better place: as the user has laid it, else as the
// mode does.
geometry::Placement placementByHandOrMode(const geometry::TriangleMesh& mesh, double scale,
                                          const modes::ModeChoices& in);
// What material will start on, as far as that can be told before a decomposition: what the mode
// builds on, else the plate. Throws Error{Usage, UnusableInput}: the platform.
platform::PlatformSolid plannedPlatform(const modes::LoadStage& placed,
                                        const project::Choices& choices);
// What of the choices it is made from, as text. Throws Error{Usage}: a parameter.
std::string plannedPlatformKey(const project::Choices& choices);
// Defects that could not be mended, as findings. Of an open part none: loadStage() tells what
// becomes of it.
plan::Findings remainingDefects(const project::LoadedPart& loaded);
plan::Findings defectFindings(const std::vector<base::Message>& remains);

struct MadeToolpaths {
  std::shared_ptr<const ToolpathStage> stage;
  // Of its tool-paths (toolpath::ToolpathResult's), for the stage that follows; too large to keep.
  std::shared_ptr<const collision::GrowingPart> grown;
};
// `options`: but for the platform.
MadeToolpaths toolpathStage(const layers::LayerStack& layers, const robot::Cell& cell,
                            const platform::PlatformSolid& platform,
                            const process::Process& process, toolpath::ToolpathOptions options,
                            const base::RunContext& ctx);

// Writes the program, reads it back and replays it. `name`: of the part, without extension.
struct ProgramStageInput {
  const geometry::TriangleMesh& part; // what is to be printed
  const platform::PlatformSolid& platform;
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  const process::Process& process;
  std::string name;
  program::ProgramOptions options = {};
  std::size_t firstPoint = 0; // of the trajectory at which the program begins: Job::resumedAt
  std::string job = {};       // program::ProgramInput::job
  std::vector<std::size_t> commonPoint = {}; // replay::ReplayInput's
};
// `judged`: of programs of the same motion (replay/verification.h).
std::shared_ptr<const CheckedProgram> programStage(const std::string& format,
                                                   const ProgramStageInput& in,
                                                   const base::RunContext& ctx,
                                                   replay::JudgedRuns* judged = nullptr);

} // namespace voluta::pipeline
