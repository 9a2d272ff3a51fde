// Each stage as a pure function from what goes in to a value that can be kept: its payload, its
// findings, its part of the report and its seconds (DESIGN §3).
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "pipeline/job.h"
#include "pipeline/report.h"
#include "pipeline/stage.h"
#include "plan/finding.h"
#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/decomposition.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/cell.h"
#include "voxel/solid_voxels.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct LoadStage {
  static constexpr Stage kStage = Stage::Load;
  double scale = 1.0;
  std::shared_ptr<const geometry::TriangleMesh> part; // placed in the work frame
  // Of a text voxel object; null and empty for a mesh.
  std::shared_ptr<const voxel::SolidVoxels> voxels; // its cells, placed like `part`
  std::vector<Eigen::Vector2d> platform; // hull of its own platform cells, work frame; empty where
                                         // it was tipped over
  ModelReport report;                    // but for what names the file and its repairs
  plan::Findings findings;               // of the placement
  Timings timings;
};

struct DecomposeStage {
  static constexpr Stage kStage = Stage::Decompose;
  platform::PlatformSolid platform; // what material starts on, work frame
  // What of the placed part is to be printed where the platform takes some of it; null: all.
  std::shared_ptr<const geometry::TriangleMesh> lessPlatform;
  std::shared_ptr<const curved::Decomposition> decomposition; // null in modes without voxels
  std::shared_ptr<const planar::PlanarDecomposition> pieces;  // null in modes without pieces
  DecompositionReport report;
  plan::Findings findings;
  Timings timings;
};

struct LayersStage {
  static constexpr Stage kStage = Stage::Layers;
  std::shared_ptr<const layers::LayerStack> layers;
  LayersReport report;
  double supportVolumeMm3 = 0.0; // of supports that came with the layers
  plan::Findings findings;
  Timings timings;
};

struct ToolpathStage {
  static constexpr Stage kStage = Stage::Toolpath;
  std::shared_ptr<const plan::ToolPlan> toolPlan;
  ToolpathReport report;
  plan::Findings findings;
  Timings timings;
};

struct MotionStage {
  static constexpr Stage kStage = Stage::Motion;
  std::shared_ptr<const plan::Trajectory> trajectory; // null when nothing is left to print
  MotionReport report;
  plan::Findings findings;
  Timings timings;
};

// A place in a program's text. line is 1-based; 0: nowhere in particular.
struct TextLine {
  std::uint32_t file = 0, line = 0;
};

// One program, read back and replayed; the Replay stage is one of these for each format.
struct CheckedProgram {
  static constexpr Stage kStage = Stage::Replay;
  plan::Program program; // files named as if it passed
  ReplayReport verdict;
  plan::Findings findings;            // each reason begins with the format
  std::vector<TextLine> findingLines; // of each finding
  bool passed = false;
  std::string failed; // the thresholds that were not kept; "passed" when all were
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;
  std::vector<TextLine> motionLines; // of each motion, as its reader found it
  Timings timings;
};

// The line of each point of the trajectory that `program` was written from: writers make one motion
// a point. A point whose motion is missing from the text has line 0.
std::vector<TextLine> linesOfPoints(const CheckedProgram& program,
                                    const plan::Trajectory& trajectory);

// The loaded part turned, scaled and put where it is to lie. A voxel object's cells are voxelMm
// times the scale wide and stay as they are where it is turned by quarter turns and lifted by whole
// cells; elsewhere its surface is cut into new cells, which is told. Throws Error{Usage}: the
// scale; Cancelled.
std::shared_ptr<const LoadStage> loadStage(const LoadedPart& loaded, const Choices& choices,
                                           const process::Process& process,
                                           const base::RunContext& ctx = {});
// Defects that could not be mended, as findings.
plan::Findings remainingDefects(const LoadedPart& loaded);

std::shared_ptr<const ToolpathStage> toolpathStage(const layers::LayerStack& layers,
                                                   const platform::PlatformSolid& platform,
                                                   const process::Process& process,
                                                   const base::ParameterValues& values,
                                                   const base::RunContext& ctx);

std::shared_ptr<const MotionStage>
motionStage(const plan::ToolPlan& toolPlan, const platform::PlatformSolid& platform,
            const robot::Cell& cell, const process::Process& process,
            const base::ParameterValues& values, int seed, const base::RunContext& ctx);

// Writes the program, reads it back and replays it. `name`: of the part, without extension.
struct ProgramStageInput {
  const geometry::TriangleMesh& part; // what is to be printed
  const platform::PlatformSolid& platform;
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const robot::Cell& cell;
  const process::Process& process;
  std::string name;
};
std::shared_ptr<const CheckedProgram>
programStage(const std::string& format, const ProgramStageInput& in, const base::RunContext& ctx);

} // namespace voluta::pipeline
