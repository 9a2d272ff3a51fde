#include "pipeline/turned_part.h"
#include "modes/plate.h"

#include "base/stopwatch.h"
#include "base/units.h"
#include "pipeline/choices.h"
#include "placement/orient.h"

#include <cmath>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

constexpr double kSame = 1e-6; // rad

std::string turnIn(const Eigen::Quaterniond& turn) {
  const Eigen::AngleAxisd by(turn);
  const auto clean = [](double x) { return std::round(100.0 * x) / 100.0 + 0.0; };
  return fmt::format("{:.0f} degrees about ({:g}, {:g}, {:g})", base::radiansToDegrees(by.angle()),
                     clean(by.axis().x()), clean(by.axis().y()), clean(by.axis().z()));
}

// What was looked at, now and before.
std::string won(const placement::Orientation& found, bool fewestMissed) {
  const std::string area = fmt::format("{:.0f} mm2 overhang instead of {:.0f}",
                                       found.score.riskyMm2, found.before.riskyMm2);
  if (!fewestMissed)
    return area;
  return fmt::format("one pass of growth misses {} voxels of {:.2f} mm instead of {}, {}",
                     found.missed, found.searchMm, found.missedBefore, area);
}

plan::Finding findingOf(const placement::Orientation& found, bool fewestMissed, bool turned) {
  plan::Finding f;
  f.stage = "load";
  f.kind = turned ? "turned" : "notTurned";
  f.count = found.tried;
  f.reason = turned ? fmt::format("the part is turned by {}: {}", turnIn(found.turn),
                                  won(found, fewestMissed))
                    : fmt::format("the part stays as it lies: none of {} ways that stand is better",
                                  found.tried);
  f.remedy = turned ? "orient=none leaves it as it was put" : "put it another way by hand";
  f.blocking = false;
  return f;
}

} // namespace

TurnedPart turnedPart(const geometry::TriangleMesh& placed, const project::Choices& choices,
                      const base::ParameterValues& values, double voxelMm, bool onlyQuarters,
                      const base::RunContext& ctx) {
  TurnedPart out;
  out.placement = choices.placement;
  const std::string orient = values.text("orient");
  if (orient == "none")
    return out;
  const base::Stopwatch clock;
  const bool fewestMissed = orient == "fewestMissed";
  placement::OrientOptions options;
  options.voxelMm = voxelMm;
  options.overhangRad = base::degreesToRadians(values.number("overhangAngle"));
  options.quarterTurns = onlyQuarters;
  options.centreMm = choices.placement.centreMm;
  options.platform = [&](const voxel::SolidVoxels& part) {
    return modes::plateOf(choices.platform, part);
  };
  const placement::Orientation found = placement::bestOrientation(
      placed, fewestMissed ? placement::Objective::FewestMissed : placement::Objective::LeastRisky,
      options, ctx);
  const bool turned = found.turn.angularDistance(Eigen::Quaterniond::Identity()) > kSame;
  if (turned)
    out.placement.rotation = (found.turn * choices.placement.rotation.normalized()).normalized();
  out.findings.push_back(findingOf(found, fewestMissed, turned));
  out.seconds = clock.seconds();
  return out;
}

std::string turnText(const project::Choices& choices, const base::ParameterValues& values) {
  const std::string orient = values.text("orient");
  if (orient == "none")
    return {};
  return fmt::format("orient {}\nwidth {} mm\noverhang {}\n", orient, values.number("voxelMm"),
                     values.number("overhangAngle")) +
         (orient == "fewestMissed" ? fmt::format("platform {}\n", choices.platform.text()) : "");
}

} // namespace voluta::pipeline
