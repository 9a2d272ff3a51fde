// Bead sections at the speeds that the controller really reaches (controller_time.h).
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "replay/executed_path.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::replay {

// Share of a bead's section by which a motion may deposit more or less without being in error.
inline constexpr double kSectionTolerance = 0.05;

// Returns the material of each motion [mm³]: the amount in the text, else its flow x `seconds`.
std::vector<double> flowingMm3(const plan::ReadProgram& program,
                               const std::vector<double>& seconds);

struct SectionErrors {
  double fraction = 0.0;            // of the printed length
  std::optional<std::size_t> first; // motion
  std::optional<std::size_t> worst; // motion with the largest relative error of its section
};
// Compares with the plan if a motion leads from one of its points to the next, else with the amount
// of the text without ramps. `pointOf`: per motion, as in alignment.h. Sections are compared by
// volume, since both have the same length. Motions that a stop lag feeds are left out: no program
// can vary their flow.
SectionErrors sectionErrors(const plan::ReadProgram& program, const ExecutedPath& path,
                            const plan::Trajectory& trajectory,
                            const std::vector<std::size_t>& pointOf,
                            const std::vector<double>& seconds);

} // namespace voluta::replay
