// Import of an arm from a URDF file: the robot's description, a cell laid out for it, and notes on
// assumptions and omitted data.
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
  robot::UrdfRobot arm; // including its neverMeet
  robot::ArmKind kind = robot::ArmKind::Other;
  CellLayout layout;
  std::vector<robot::LinkMesh> linkMeshes = {}; // for display
};

// `process`: its head is used as the nozzle. Without an id in `options`, an arm with the name of a
// built-in robot gets the id NAME-imported. Throws as robot::readUrdf and layOut, and Error{Usage}
// if options.id is the id of a built-in robot, which cannot be replaced.
ArmImport importArm(const std::filesystem::path& urdf, const robot::UrdfOptions& options,
                    robot::Mount nozzle, const process::Process& process,
                    const base::RunContext& ctx);

struct ImportedFiles {
  std::filesystem::path robot, cell;
};
// Returns the files of an earlier import, or of the user's, that writeImport() would replace.
std::vector<std::filesystem::path> conflictingFiles(const ArmImport& import,
                                                    const std::filesystem::path& folder);

enum class Existing { Refuse, Replace };
// Writes folder/robots/ID.json, its link meshes beside it, and folder/cells/CELL.json. Throws
// Error{CannotWrite}; Error{Usage} if there are files that may not be replaced.
ImportedFiles writeImport(const ArmImport& import, const std::filesystem::path& folder,
                          Existing existing = Existing::Refuse);

} // namespace voluta::cells
