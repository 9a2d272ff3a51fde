#include "motion/trajectory_csv.h"

#include "base/error.h"
#include "base/units.h"

#include <fmt/format.h>
#include <iterator>

namespace voluta::motion {

std::string trajectoryCsv(const plan::Trajectory& trajectory,
                          const std::vector<robot::JointKind>& kinds, double filamentDiameterMm) {
  base::require(filamentDiameterMm > 0.0, "filament diameter > 0");
  const double section = 0.25 * base::kPi * filamentDiameterMm * filamentDiameterMm;
  std::string text = "timeS";
  auto out = std::back_inserter(text);
  text.reserve(trajectory.pointCount() * 100);
  const auto kindOf = [&](int joint) {
    const auto j = static_cast<std::size_t>(joint);
    return j < kinds.size() ? kinds[j] : robot::JointKind::Turning;
  };
  for (int j = 0; j < trajectory.dof; ++j)
    fmt::format_to(out, ",q{}{}", j + 1, kindOf(j) == robot::JointKind::Sliding ? "Mm" : "Deg");
  text += ",extrudedMm3,extrudedMm,waypoint,move\n";
  for (std::size_t i = 0; i < trajectory.pointCount(); ++i) {
    fmt::format_to(out, "{:.6f}", trajectory.timeS[i]);
    for (int j = 0; j < trajectory.dof; ++j)
      fmt::format_to(out, ",{:.7f}", robot::shownValue(kindOf(j), trajectory.at(i)[j]));
    fmt::format_to(out, ",{:.5f},{:.5f},", trajectory.extrudedMm3[i],
                   trajectory.extrudedMm3[i] / section);
    if (trajectory.waypoint[i] == plan::kNoWaypoint)
      text += "-1";
    else
      fmt::format_to(out, "{}", trajectory.waypoint[i]);
    switch (trajectory.move[i]) {
    case plan::MoveKind::Print:
      text += ",print\n";
      break;
    case plan::MoveKind::Linear:
      text += ",linear\n";
      break;
    case plan::MoveKind::Joint:
      text += ",joint\n";
      break;
    case plan::MoveKind::Wipe:
      text += ",wipe\n";
      break;
    }
  }
  return text;
}

} // namespace voluta::motion
