#include "replay/approach.h"

#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;

constexpr double kSlack = 1.05, kSameMm = 0.05;

// Returns the lowest height at which the nozzle touches nothing.
double clearMm(const plan::ReadProgram& program, const plan::ToolPlan& plan,
               const platform::PlatformSolid& platform) {
  if (!program.tableAxisMm)
    return program.motions[program.firstMotion].position.z();
  const Eigen::Vector2d& axis = *program.tableAxisMm;
  double reach = 0.0;
  const auto add = [&](const Eigen::Vector2d& p, double z) {
    reach = std::max(reach, std::hypot(p.norm() + std::abs(axis.x()), z + axis.y()));
  };
  for (const Eigen::Vector3d& p : plan.position)
    add(p.head<2>(), p.z());
  for (const Eigen::Vector2d& corner : platform.polygon)
    add(corner, 0.0);
  return reach - axis.y();
}

} // namespace

double firstMmPerS(const process::Process& process) {
  return std::max(kFirstMmPerS, kSlack * process.travelSpeedMmPerS);
}

std::vector<TextFinding> judgeApproach(const plan::ReadProgram& program, const plan::ToolPlan& plan,
                                       const platform::PlatformSolid& platform,
                                       const process::Tooling& tooling) {
  std::vector<TextFinding> found;
  if (program.approaches.empty() || program.firstMotion >= program.motions.size())
    return found;
  const double clear = clearMm(program, plan, platform);
  const process::Process& process = tooling.at(program.motions[program.firstMotion].tool).process;
  for (const plan::ProgramApproach& approach : program.approaches) {
    const TextPlace place{approach.file + 1, approach.line};
    if (!approach.heightMm || !(*approach.heightMm >= clear - kSameMm))
      found.push_back(
          textFinding(program, StatementChanged, place,
                      {{"statement", base::Message("the nozzle's height beside the print"_text)},
                       {"found", approach.heightMm ? base::Value(base::mm(*approach.heightMm))
                                                   : base::Value(base::Message("none"_text))},
                       {"planned", base::message("at least {height:.1f}"_text, base::mm(clear))}}));
    if (approach.mmPerS > firstMmPerS(process) || approach.radPerS > kFirstRadPerS)
      found.push_back(textFinding(program, FirstMotionFast, place, {}));
  }
  return found;
}

} // namespace voluta::replay
