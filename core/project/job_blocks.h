// Writes and reads a job's results as blocks. Structs are stored as columns, so that the format
// doesn't depend on their layout.
#pragma once

#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/planar_decomposition.h"
#include "project/block_file.h"
#include "project/job.h"

#include <string>

namespace voluta::project {

// Added data must outlive the writer. Getters throw Error{UnreadableFile}.
void addMesh(BlockWriter& out, const std::string& name, const geometry::TriangleMesh& mesh);
bool hasMesh(const BlockReader& in, const std::string& name);
// Throws also if a triangle's vertex is missing or a coordinate is not finite, because the part is
// displayed while the rest is read.
geometry::TriangleMesh getMesh(const BlockReader& in, const std::string& name);

void addDecomposition(BlockWriter& out, const curved::Decomposition& decomposition);
// Without findings: the report has them.
curved::Decomposition getDecomposition(const BlockReader& in);

void addPieces(BlockWriter& out, const planar::PlanarDecomposition& pieces);
// Without findings: the report has them.
planar::PlanarDecomposition getPieces(const BlockReader& in);

void addLayers(BlockWriter& out, const layers::LayerStack& stack);
layers::LayerStack getLayers(const BlockReader& in);

// `name`: prefix of the blocks' names.
void addToolPlan(BlockWriter& out, const plan::ToolPlan& toolPlan,
                 const std::string& name = "plan");
plan::ToolPlan getToolPlan(const BlockReader& in, const std::string& name = "plan");
bool isSound(const plan::ToolPlan& toolPlan);

void addTrajectory(BlockWriter& out, const plan::Trajectory& trajectory);
plan::Trajectory getTrajectory(const BlockReader& in, int dof);

void addPlatform(BlockWriter& out, const platform::PlatformSolid& platform);
// Throws Error{UnusableInput} for an invalid rod.
platform::PlatformSolid getPlatform(const BlockReader& in);

// Returns whether all indices are within their arrays, array lengths match, coordinates are finite
// and all results up to `reached` exist.
bool isConsistent(const Job& job);

} // namespace voluta::project
