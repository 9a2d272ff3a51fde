// Where lines of sparse infill branch below a skin.
#pragma once

#include "process/process.h"
#include "toolpath/options.h"
#include "toolpath/sparse/patterns.h"

#include <vector>

namespace voluta::toolpath {

// How the lines of a pattern branch towards a skin above, so that it finds spans that its beads can
// bridge. In each layer the branches are a little farther apart.
class Branches {
public:
  // `maySag`: bridges as long as process::saggingBridgeMm() are good enough.
  Branches(const SparsePattern& pattern, double periodMm, const process::Process& process,
           bool maySag);

  // Layers below the skin in which lines branch.
  int layers() const;
  int stages() const { return static_cast<int>(layers_.size()) + 1; }

  // Stages: 0 has no branches; in stage k the k-th branching is going on. `left`: layers to the
  // skin.
  int stageOf(int left) const;
  // Returns the branching at a place, as seen from a stage that may be another than its own.
  Branching of(int left, int stage) const;

private:
  double beadMm_;
  std::vector<int> layers_;   // Per branching
  std::vector<double> apart_; // Per branching, its end [mm]
};

// Returns the branches of the options' pattern at their density. Throws Error{Usage} for an unknown
// pattern. Precondition: density > 0.
Branches branchesOf(const process::Process& process, const ToolpathOptions& options);

} // namespace voluta::toolpath
