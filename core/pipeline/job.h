// The project file: a part, the choices made for it and what was planned (DESIGN §3, §5).
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

// What the user chose; together with the mesh it decides every result.
struct Choices {
  std::string mode = "curved";
  std::string growth = "auto";
  std::string platform = "fit:0";
  std::string cell = "ur5-fixed";
  std::string process = "fdm-1.0";
  std::string scale = "1";                       // a number or "fit"
  std::vector<std::string> formats;              // empty: the cell's controller and gcode-extended
  std::map<std::string, std::string> parameters; // changed ones, as text
  int seed = 1;
};

struct Job {
  std::string partName;                               // file name without folder
  std::shared_ptr<const geometry::TriangleMesh> part; // repaired and placed in the work frame
  double scale = 1.0;                                 // what `scale` came to
  Choices choices;
  std::vector<Eigen::Vector2d> platform;              // polygon material starts on, work frame
  std::shared_ptr<const plan::ToolPlan> toolPlan;     // null: not planned that far
  std::shared_ptr<const plan::Trajectory> trajectory; // null: not planned that far
};

// job.voluta as bytes: a line "VOLUTA 1", the length of a JSON header, the header (choices and a
// table of blocks), then the blocks: little-endian arrays, each with a CRC-32.
std::string jobBytes(const Job& job);
// Throws Error{UnreadableFile} that says what is wrong: not a job, a newer version, cut short, a
// damaged block.
Job readJob(const std::filesystem::path& file);

} // namespace voluta::pipeline
