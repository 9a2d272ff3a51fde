// The project file (docs/design.md, Project file): a part, the choices for it and the planned
// results.
#pragma once

#include "geometry/placement.h"
#include "platform/platform_solid.h"
#include "project/choices.h"
#include "project/job_stage.h"
#include "project/mode_result.h"
#include "project/report.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class ParameterTable;
}
namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::layers {
struct LayerStack;
}
namespace voluta::plan {
struct ToolPlan;
struct Trajectory;
} // namespace voluta::plan

namespace voluta::project {

struct LoadedPart;

// Key of a stage of a resumed print, whose result does not follow from the choices alone.
inline constexpr const char* kResumedKey = "resumed";

// Metadata of a stage, apart from its result.
struct StageRecord {
  std::string key; // its inputs as text; empty: not run
  // how many of the report's findings are from this stage; they are sorted by stage
  std::size_t findings = 0;
  Timings timings; // [s]; without `total`
};

// One part of a job, with its own way of building. Results are null if the plan ended before their
// stage. Copies are cheap: arrays are shared.
struct JobItem {
  std::string partName; // file name without folder
  std::shared_ptr<const LoadedPart> loaded;
  double scale = 1.0; // the value of the item's scale; for "fit" the one computed
  // Placement of `part`, including one computed by the mode or a search. None: not placed, or read
  // from an older project that did not store it.
  std::optional<geometry::Placement> placement;
  std::shared_ptr<const geometry::TriangleMesh> part; // placed in the work frame
  platform::PlatformSolid platform; // the surface that printing starts on, work frame
  ModeResult result;
  std::shared_ptr<const layers::LayerStack> layers;

  // Returns the mesh to print. Precondition: part.
  const geometry::TriangleMesh& printed() const;
  // Returns the result of a mode with voxels, or with pieces; else null.
  Voxels decomposition() const { return resultAs<Voxels>(result); }
  Pieces pieces() const { return resultAs<Pieces>(result); }
};

// Results are null if the plan ended before their stage. Copies are cheap: arrays are shared.
struct Job {
  Choices choices;
  std::vector<JobItem> items = {JobItem{}}; // one or more, as choices.items

  std::optional<Stage> reached; // last completed stage; none: nothing planned
  std::array<StageRecord, kStageCount> stages;
  Report report; // of all completed stages

  std::shared_ptr<const plan::ToolPlan> toolPlan;     // of all items, in print order
  std::shared_ptr<const plan::Trajectory> trajectory; // also null if nothing is left to print
  // Resumed print: the point of the trajectory at which its programs begin; everything before it
  // was printed earlier. 0: a whole print.
  std::size_t resumedAt = 0;

  JobItem& item(std::size_t i = 0) { return items.at(i); }
  const JobItem& item(std::size_t i = 0) const { return items.at(i); }
  // Returns the keys of the present results, for comparison with stageKeys() of a request.
  StageKeys keys() const;
};

// Returns the meshes to be printed of all items as one mesh; that of a single item is not copied
// and lives as long as the job. Precondition: every item is placed.
std::shared_ptr<const geometry::TriangleMesh> printedOf(const Job& job);

// Returns the first triangle of each item in printedOf(); empty for a single item.
std::vector<std::size_t> firstTriangles(const Job& job);
// Returns the surface that printing starts on: the platform of the only item, or one plate around
// the plates of several. Precondition: every item has a plate, if there are several.
platform::PlatformSolid platformOf(const Job& job);

// Returns the job without the results after `last`; none: without any results.
Job upTo(Job job, std::optional<Stage> last);

// Returns the content of a .voluta file: a line "VOLUTA 3", a line with length and CRC-32 of a JSON
// header, the header (choices, counts and a table of blocks), then the blocks: little-endian
// arrays, each with a CRC-32. Thread-safe. Precondition: every item is loaded.
std::string jobBytes(const Job& job);
// Writes jobBytes() to a file, completely or not at all. Throws Error{CannotWrite}.
void writeJob(const std::filesystem::path& file, const Job& job);

// Reads a project file. `table`: all parameters; projects of "VOLUTA 2" store those of the job with
// each item. Throws Error{UnreadableFile} with the cause: not a job, another version, truncated, a
// damaged block.
Job readJob(const std::filesystem::path& file, const base::ParameterTable& table);
// Same for the content of a file; `where` names it in errors.
Job jobOf(std::string_view bytes, const std::string& where, const base::ParameterTable& table);

} // namespace voluta::project
