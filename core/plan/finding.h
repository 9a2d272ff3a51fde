// What cannot be printed, reached or verified, as data (docs/design.md, Findings): never an error.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voluta::plan {

struct Finding {
  std::string stage; // "load", "decompose", "layers", "toolpath", "motion", "replay"
  std::string kind;  // camelCase, e.g. "missedVoxels", "collision"
  std::optional<Eigen::Vector3d> where; // work frame, mm
  std::optional<double> whenS;          // seconds from program start
  std::size_t count = 1;
  std::string reason;   // one sentence, names the place in words a user understands
  std::string remedy;   // one sentence, what would help
  bool blocking = true; // false: worth knowing, exit code stays 0
  std::optional<double> remedyMm =
      std::nullopt; // the length that `remedy` names, where a button can set it
};

using Findings = std::vector<Finding>;

} // namespace voluta::plan
