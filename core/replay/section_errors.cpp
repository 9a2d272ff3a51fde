#include "replay/section_errors.h"

#include "replay/beads.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {
constexpr double kRoundingMm3 = 1e-3; // of amounts in a program's text
} // namespace

std::vector<double> flowingMm3(const plan::ReadProgram& program,
                               const std::vector<double>& seconds) {
  std::vector<double> volume(program.motions.size());
  for (std::size_t m = 0; m < volume.size(); ++m)
    volume[m] = motionVolume(program.motions[m], seconds[m]);
  return volume;
}

SectionErrors sectionErrors(const plan::ReadProgram& program, const ExecutedPath& path,
                            const plan::Trajectory& trajectory,
                            const std::vector<std::size_t>& pointOf,
                            const std::vector<double>& seconds) {
  const std::vector<double> volume = flowingMm3(program, seconds);
  SectionErrors result;
  double printed = 0.0, wrong = 0.0, worst = 0.0;
  for (std::size_t m = 1; m < volume.size(); ++m) {
    if (!program.motions[m].extruding || program.motions[m].trailing)
      continue;
    const double length = (path.targetTip[m] - path.targetTip[m - 1]).norm();
    const std::size_t j = pointOf[m];
    const bool planned = j > 0 && j < trajectory.pointCount() && pointOf[m - 1] + 1 == j;
    const double wanted = planned ? trajectory.extrudedMm3[j] - trajectory.extrudedMm3[j - 1]
                                  : motionVolume(program, path, m);
    printed += length;
    if (std::abs(volume[m] - wanted) <= kSectionTolerance * wanted + kRoundingMm3)
      continue;
    wrong += length;
    if (!result.first)
      result.first = m;
    const double share = std::abs(volume[m] - wanted) / std::max(wanted, kRoundingMm3);
    if (share > worst) {
      worst = share;
      result.worst = m;
    }
  }
  result.fraction = printed > 0.0 ? wrong / printed : 0.0;
  return result;
}

} // namespace voluta::replay
