// The ur5-moving cell with a tool changer, as the text of a cell's file.
#pragma once

#include "base/data_files.h"
#include "base/files.h"
#include "replay/replay_scene.h"

#include <string>

namespace voluta::test {

inline std::string changerCell() {
  usesSourceTreeResources();
  std::string cell = base::readFile(base::resourceFolder() / "cells/ur5-moving.json");
  const std::string dock = R"({"beforeDeg": [75, -81.2, -82, -106.8, 90, -7.4],
                               "inDeg": [75, -75, -95, -100, 90, -7.4]})";
  cell.insert(cell.find('{') + 1,
              R"("toolChange": {"by": "changer", "docks": [)" + dock + ", " + dock + "]},");
  return cell;
}

} // namespace voluta::test
