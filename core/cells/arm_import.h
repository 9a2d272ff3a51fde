// An arm that comes as a URDF, made ready to print with: its robot's file, the file of a cell laid
// out for it, and what was found, assumed and left out.
#pragma once

#include "base/run_context.h"
#include "cells/cell_layout.h"
#include "robot/urdf/arm_recognition.h"
#include "robot/urdf/link_meshes.h"
#include "robot/urdf/urdf_reader.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::cells {

struct ArmImport {
  robot::UrdfRobot arm; // with its neverMeet
  robot::ArmKind kind = robot::ArmKind::Other;
  CellLayout layout;
  std::vector<robot::LinkMesh> linkMeshes = {}; // what it looks like
};

// `process`: whose head the nozzle is. Without an id in `options` an arm whose name is that of one
// that comes along is called NAME-imported.
// Throws what robot::readUrdf and layOut throw; Error{Usage}: options.id is the id of a robot that
// comes along, whose place no other can take.
ArmImport importArm(const std::filesystem::path& urdf, const robot::UrdfOptions& options,
                    robot::Mount nozzle, const process::Process& process,
                    const base::RunContext& ctx);

struct ImportedFiles {
  std::filesystem::path robot, cell;
};
// Writes folder/robots/ID.json, its link meshes beside it, and folder/cells/CELL.json. Throws
// Error{CannotWrite}.
ImportedFiles writeImport(const ArmImport& import, const std::filesystem::path& folder);

} // namespace voluta::cells
