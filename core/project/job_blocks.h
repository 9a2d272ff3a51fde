// The results of a job as blocks. Structs are stored as columns, so that the format doesn't depend
// on their layout.
#pragma once

#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/decomposition.h"
#include "project/block_file.h"
#include "project/job.h"

#include <string>

namespace voluta::project {

// What is added has to outlive the writer. Getters throw Error{UnreadableFile}.
void addMesh(BlockWriter& out, const std::string& name, const geometry::TriangleMesh& mesh);
bool hasMesh(const BlockReader& in, const std::string& name);
// Also where its corners are not there or not finite: a part is looked at while it is read.
geometry::TriangleMesh getMesh(const BlockReader& in, const std::string& name);

void addDecomposition(BlockWriter& out, const curved::Decomposition& decomposition);
// Findings are not among it: the report has them.
curved::Decomposition getDecomposition(const BlockReader& in);

void addPieces(BlockWriter& out, const planar::PlanarDecomposition& pieces);
// Findings are not among it: the report has them.
planar::PlanarDecomposition getPieces(const BlockReader& in);

void addLayers(BlockWriter& out, const layers::LayerStack& stack);
layers::LayerStack getLayers(const BlockReader& in);

// `name` begins the blocks' names.
void addToolPlan(BlockWriter& out, const plan::ToolPlan& toolPlan,
                 const std::string& name = "plan");
plan::ToolPlan getToolPlan(const BlockReader& in, const std::string& name = "plan");
bool isSound(const plan::ToolPlan& toolPlan);

void addTrajectory(BlockWriter& out, const plan::Trajectory& trajectory);
plan::Trajectory getTrajectory(const BlockReader& in, int dof);

void addPlatform(BlockWriter& out, const platform::PlatformSolid& platform);
// Throws Error{UnusableInput} for a rod that is none.
platform::PlatformSolid getPlatform(const BlockReader& in);

// Do indices lie in their arrays, are arrays of one length, are coordinates finite, is there what
// `reached` says?
bool isConsistent(const Job& job);

} // namespace voluta::project
