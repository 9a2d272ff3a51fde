// Prints patches with unsupported beads from the supported beads outwards.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

#include <cstddef>
#include <vector>

namespace voluta::toolpath {

struct OrderedPath {
  std::size_t path = 0;
  bool turned = false; // printed from its end to its beginning
  bool operator==(const OrderedPath&) const = default;
};
// Returns the order of the plan's paths that lets beads be pressed against their neighbours
// (tiltable_stretches.h). Within a patch, paths with unsupported stretches longer than half of the
// process's bridge length come last, ordered by their distance from supported beads. Such a path is
// reversed if that prints the lines beside its stretches before the stretches. Otherwise, in
// patches that are entirely unsupported or supports, and in upright plans, the order is unchanged.
// `unsupported`: unsupportedWaypoints().
std::vector<OrderedPath> insideOutOrder(const plan::ToolPlan& plan,
                                        const std::vector<char>& unsupported,
                                        const process::Tooling& tooling);

// Puts the paths in that order. Supports keep their place at the beginning of their patch.
std::optional<PassResult> orderInsideOut(const UnsupportedBeads& beads, const SeenPart& part,
                                         const PassScene& scene, const base::RunContext& ctx);

} // namespace voluta::toolpath
