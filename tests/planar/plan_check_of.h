// The rules of a plan, as its checker takes them.
#pragma once

#include "planar/plan_checker.h"
#include "planar/planar_decomposition.h"

#include <vector>

namespace voluta::test {

inline PlanCheck checkOf(const std::vector<planar::Piece>& pieces,
                         const planar::PlanarOptions& options) {
  PlanCheck check;
  check.overhangRad = options.rule.overhangRad;
  check.contactMm = options.rule.contactMm;
  check.head = options.head;
  check.plate = planar::plateOf(pieces, options);
  return check;
}

} // namespace voluta::test
