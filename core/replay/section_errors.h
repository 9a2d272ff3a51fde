// What the beads get at the speeds that the controller really has (controller_time.h).
#pragma once

#include "plan/program.h"
#include "plan/trajectory.h"
#include "replay/executed_path.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::replay {

// Of a bead's section: a motion that lays more or less than that is in error.
inline constexpr double kSectionTolerance = 0.05;

// Material of each motion: the amount that the text gives, else its flow x `seconds`. mm3.
std::vector<double> flowingMm3(const plan::ReadProgram& program,
                               const std::vector<double>& seconds);

struct SectionErrors {
  double fraction = 0.0;            // of the printed length
  std::optional<std::size_t> first; // motion
  std::optional<std::size_t> worst; // motion whose section is most wrong, by share
};
// Against the plan where a motion goes from one of its points to the next, else against what the
// text lays without ramps. `pointOf`: per motion, as of alignment.h. Sections are compared by
// volume, as both have one length.
SectionErrors sectionErrors(const plan::ReadProgram& program, const ExecutedPath& path,
                            const plan::Trajectory& trajectory,
                            const std::vector<std::size_t>& pointOf,
                            const std::vector<double>& seconds);

} // namespace voluta::replay
