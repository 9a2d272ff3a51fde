// A part as it came from its file, before it is placed.
#pragma once

#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/open_surface.h"
#include "geometry/repair/repair.h"
#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "voxel/voxel_object.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::project {

struct LoadedPart {
  std::string name; // file name without folder; "vase.stl" for sample:vase
  std::shared_ptr<const voxel::VoxelObject> cells; // of a text voxel object: then the meshes are
                                                   // its surface, lengths in cells. Null: a mesh
  std::shared_ptr<const geometry::TriangleMesh> source; // as read
  std::shared_ptr<const geometry::TriangleMesh> mesh;   // as used: mended, or `source` itself
  // Tool-paths that the file brought with it (build3mf/build_reader.h), in the mesh's coordinates;
  // null: none. In the work frame's already where `inWorkFrame`.
  std::shared_ptr<const plan::ToolPlan> toolPaths;
  bool inWorkFrame = false;
  bool repair = true;                        // was mending asked for
  std::vector<base::Message> readNotes;      // what reading left out, a sentence each
  std::vector<base::Message> notes;          // all that was found and mended, readNotes among them
  std::vector<base::Message> remains;        // what could not be mended, a sentence each
  geometry::Diagnosis found;                 // of `source`, before any repair
  std::optional<geometry::OpenSurface> open; // of `mesh`, where mending left it open
  geometry::UnitGuess units;                 // of `mesh`
  std::string hash;                          // of the content of `source` or `cells`, and of
                                             // `toolPaths`, hexadecimal
  double readS = 0.0, repairS = 0.0;         // wall seconds it took
};

// Parts that the program makes itself, to be named "sample:NAME".
std::vector<std::string> sampleNames();

// Is it a text voxel object: by the ending .txt or .voxels, or else by the content?
bool isVoxelText(const std::string& name, std::string_view bytes);

// LoadedPart::hash of a part that is a mesh.
std::string hashOf(const LoadedPart& part);

// Reads a part and, where `repair` is true, mends it: a mesh, or a text voxel object, whose surface
// needs no mending; a 3MF with tool-paths brings them, and where it has no object the solid that
// their beads make. `part` is a path or "sample:NAME". Throws Error{UnreadableFile, UnusableInput};
// Error{Usage} for an unknown sample; Cancelled.
std::shared_ptr<const LoadedPart> loadPart(const std::string& part, bool repair,
                                           const base::RunContext& ctx);

// A part that mending left open, mended anew: with every rim closed and without sheets.
// Throws Error{UnusableInput}: nothing but sheets. Throws Cancelled.
geometry::RepairResult closedPart(const LoadedPart& part, const base::RunContext& ctx);

// A part from a mesh at hand, e.g. of a project file. Throws as loadPart does.
std::shared_ptr<const LoadedPart> loadedFrom(std::string name,
                                             std::shared_ptr<const geometry::TriangleMesh> source,
                                             std::vector<base::Message> readNotes, bool repair,
                                             const base::RunContext& ctx);

// A part from cells at hand. Throws as loadPart does.
std::shared_ptr<const LoadedPart> loadedFrom(std::string name,
                                             std::shared_ptr<const voxel::VoxelObject> cells,
                                             bool repair, const base::RunContext& ctx);

// `part` itself where it was loaded with that choice; else mended anew, or as it was read.
std::shared_ptr<const LoadedPart> withRepair(std::shared_ptr<const LoadedPart> part, bool repair,
                                             const base::RunContext& ctx);

} // namespace voluta::project
