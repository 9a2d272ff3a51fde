// A part as loaded from its file, before placement.
#pragma once

#include "geometry/placement.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/open_surface.h"
#include "project/region.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::geometry {
struct RepairResult;
struct TriangleMesh;
} // namespace voluta::geometry
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::voxel {
struct VoxelObject;
}

namespace voluta::project {

struct LoadedPart {
  std::string name; // file name without folder; "vase.stl" for sample:vase
  // of a text voxel object; the meshes are then its surface, lengths in cells. Null: a mesh
  std::shared_ptr<const voxel::VoxelObject> cells;
  std::shared_ptr<const geometry::TriangleMesh> source; // as read
  std::shared_ptr<const geometry::TriangleMesh> mesh;   // as used: repaired, or `source` itself
  // Tool-paths from the file (build3mf/build_reader.h) in the mesh's coordinates; null: none.
  // Already in the work frame if `inWorkFrame`.
  std::shared_ptr<const plan::ToolPlan> toolPaths;
  bool inWorkFrame = false;
  // From the file; the choices of an item take them when it is opened: takeFromFile().
  std::vector<Region> regions;
  std::string layerEvents;                   // a value of that parameter; empty: none
  bool repair = true;                        // whether repair was requested
  std::vector<base::Message> readNotes;      // about omitted file content, a sentence each
  std::vector<base::Message> notes;          // all defects found and repaired, readNotes included
  std::vector<base::Message> remains;        // defects that could not be repaired, a sentence each
  geometry::Diagnosis found;                 // of `source`, before any repair
  std::optional<geometry::OpenSurface> open; // of `mesh`, if the repair left it open
  geometry::UnitGuess units;                 // of `mesh`
  std::string hash; // hexadecimal; of the content of `source` or `cells`, and of `toolPaths`
  double readS = 0.0, repairS = 0.0; // durations [s], wall clock
};

// Parts built into the program, loaded as "sample:NAME".
std::vector<std::string> sampleNames();

// Makes cells the content of a part: its surface is the source.
void setCells(LoadedPart& part, std::shared_ptr<const voxel::VoxelObject> cells);

// Returns LoadedPart::hash of a part that is a mesh.
std::string hashOf(const LoadedPart& part);

// Reads a part (project/part_formats.h) and repairs it if `repair`; cells, and the solid of a
// slicer's beads, need no repair. `part` is a path or "sample:NAME". Throws Error{UnreadableFile,
// UnusableInput}; Error{Usage} for an unknown sample; Cancelled.
std::shared_ptr<const LoadedPart> loadPart(const std::string& part, bool repair,
                                           const base::RunContext& ctx);

// Repairs a part that the first repair left open: closes every rim and removes sheets. Throws
// Error{UnusableInput} if only sheets remain. Throws Cancelled.
geometry::RepairResult closedPart(const LoadedPart& part, const base::RunContext& ctx);

// Makes a part from a mesh in memory, e.g. of a project file. Throws as loadPart does.
std::shared_ptr<const LoadedPart> loadedFrom(std::string name,
                                             std::shared_ptr<const geometry::TriangleMesh> source,
                                             std::vector<base::Message> readNotes, bool repair,
                                             const base::RunContext& ctx);

// Makes a part from cells in memory. Throws as loadPart does.
std::shared_ptr<const LoadedPart> loadedFrom(std::string name,
                                             std::shared_ptr<const voxel::VoxelObject> cells,
                                             bool repair, const base::RunContext& ctx);

// Returns `part` itself if it was loaded with this choice; else repairs it, or returns it as read.
std::shared_ptr<const LoadedPart> withRepair(std::shared_ptr<const LoadedPart> part, bool repair,
                                             const base::RunContext& ctx);

} // namespace voluta::project
