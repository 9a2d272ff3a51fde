// The programs of a station's machines as the common replay takes them.
#pragma once

#include "pipeline/plan_result.h"
#include "plan/program.h"
#include "replay/shared_run.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::pipeline {

// Returns the program of each machine in its place, with the beads that were printed before it.
// `programs`, `plans`, `shared_T_world`: per machine; the first two outlive the result.
std::vector<replay::PlacedProgram>
placedPrograms(const std::vector<plan::ReadProgram>& programs, const std::vector<PlanResult>& plans,
               const std::vector<Eigen::Isometry3d>& shared_T_world);

} // namespace voluta::pipeline
