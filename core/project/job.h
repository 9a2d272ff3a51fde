// The project file: a part, the choices made for it and what was planned
// (docs/design.md, Project file).
#pragma once

#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "platform/platform_solid.h"
#include "project/choices.h"
#include "project/loaded_part.h"
#include "project/mode_result.h"
#include "project/report.h"
#include "project/stage.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::project {

// Key of a stage whose result is not what the choices alone come to: of a print that is taken up
// again.
inline constexpr const char* kResumedKey = "resumed";

// What is kept of a stage beside its payload.
struct StageRecord {
  std::string key;          // what went in; empty: not made
  std::size_t findings = 0; // how many of the report's findings are its own; they follow one
                            // another in the order of the stages
  Timings timings;          // its own seconds, `total` apart
};

// One part of a job, with its own way of building. Results are null where the plan did not come
// that far. Copies are cheap: arrays are shared.
struct JobItem {
  std::string partName; // file name without folder
  std::shared_ptr<const LoadedPart> loaded;
  double scale = 1.0; // what `scale` came to
  // The part's placement, also where the mode or a search has found it; none: not placed, or read
  // from a project that did not keep it yet.
  std::optional<geometry::Placement> placement;
  std::shared_ptr<const geometry::TriangleMesh> part; // placed in the work frame
  platform::PlatformSolid platform;                   // what material starts on, work frame
  ModeResult result;
  std::shared_ptr<const layers::LayerStack> layers;

  // What is to be printed. Precondition: part.
  const geometry::TriangleMesh& printed() const;
  // The result of a mode that has voxels, or pieces; else null.
  Voxels decomposition() const { return resultAs<Voxels>(result); }
  Pieces pieces() const { return resultAs<Pieces>(result); }
};

// Results are null where the plan did not come that far. Copies are cheap: arrays are shared.
struct Job {
  Choices choices;
  std::vector<JobItem> items = {JobItem{}}; // one or more, as choices.items

  std::optional<Stage> reached; // last stage that is done; none: nothing planned
  std::array<StageRecord, kStageCount> stages;
  Report report; // of all stages that are done

  std::shared_ptr<const plan::ToolPlan> toolPlan;     // of all items, in print order
  std::shared_ptr<const plan::Trajectory> trajectory; // also null when nothing is left to print
  // Of a resumed print: the point of the trajectory at which its programs begin; points before it
  // were printed earlier. 0: the whole.
  std::size_t resumedAt = 0;

  JobItem& item(std::size_t i = 0) { return items.at(i); }
  const JobItem& item(std::size_t i = 0) const { return items.at(i); }
  // Keys of what is there, to be compared with stageKeys() of what is wanted.
  StageKeys keys() const;
};

// What is to be printed of all items, as one mesh; that of a single item is not copied and lives as
// long as the job. Precondition: every item is placed.
std::shared_ptr<const geometry::TriangleMesh> printedOf(const Job& job);

// The job without the results after `last`; none: without any.
Job upTo(Job job, std::optional<Stage> last);

// job.voluta as bytes: a line "VOLUTA 2", a line with length and CRC-32 of a JSON header, the
// header (choices, counts and a table of blocks), then the blocks: little-endian arrays, each with
// a CRC-32. Good for any thread. Precondition: every item is loaded.
std::string jobBytes(const Job& job);
// jobBytes into a file, whole or not at all. Throws Error{CannotWrite}.
void writeJob(const std::filesystem::path& file, const Job& job);

// Also reads "VOLUTA 1", which holds neither the part before it was placed (`loaded` is then made
// from the placed one) nor decomposition, layers and report.
// Throws Error{UnreadableFile} that says what is wrong: not a job, a newer version, cut short, a
// damaged block.
Job readJob(const std::filesystem::path& file);

} // namespace voluta::project
