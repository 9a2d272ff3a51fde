// Reads the G-code of a milled part back.
#pragma once

#include "base/text.h"

#include <Eigen/Core>
#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::milling {

// One motion, in the coordinates that the program has selected.
struct ReadMove {
  std::size_t line = 0; // 1-based
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  bool rapid = false;
  bool home = false;   // to the machine's reference position; `to` is unknown
  bool turned = false; // the block is turned by 180 deg
  double feedMmPerMin = 0.0;
  double rpm = 0.0; // 0: the spindle is at rest
};

struct MillDefect {
  std::size_t line = 0;
  base::Message reason;
};

struct ReadMilling {
  std::vector<ReadMove> moves;
  std::vector<MillDefect> defects;
  bool complete = false; // ends with M30
};

// Never throws on bad text: a line that is not understood is a defect.
ReadMilling readMilling(std::string_view text);

} // namespace voluta::milling
