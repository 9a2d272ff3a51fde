// The least clearance along joint motions, against dense sampling.
#include "collision/way_clearance.h"

#include "base/run_context.h"
#include "process/process.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

plan::ToolPlan tower() {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 20; ++layer) {
    const std::size_t first = plan.waypointCount();
    for (int k = 0; k <= 12; ++k) {
      const double a = 2.0 * M_PI * k / 12;
      plan.position.emplace_back(15.0 * std::cos(a), 15.0 * std::sin(a), 0.8 * (layer + 1));
      plan.direction.push_back(Vector3d::UnitZ());
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(0.8f);
      plan.speedMmPerS.push_back(20.0f);
    }
    plan.paths.push_back({.first = first, .count = 13});
  }
  return plan;
}

class WayClearances : public testing::TestWithParam<const char*> {};

} // namespace

// What is reported is kept all along the way, and by no more than it says too little.
TEST_P(WayClearances, NothingComesCloserOnTheWay) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell =
      robot::loadCell(GetParam(), process, {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}});
  const collision::CellCollision collision(cell, process);
  const plan::ToolPlan plan = tower();
  const collision::GrowingPart part(plan, 0.45, {});
  const collision::WayClearance ways(collision, part);
  const std::size_t before = plan.waypointCount();
  constexpr double kCap = 200.0;
  const auto at = [&](const JointVector& q) {
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    return collision.clearanceToPart(frames, part, before, collision.clearance(frames, kCap));
  };
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int between = 0;
  for (int n = 0; n < 90; ++n) {
    const double reach = n % 3 == 0 ? 0.3 : n % 3 == 1 ? 1.5 : 3.0; // rad
    JointVector from = cell.home(), to;
    for (Eigen::Index j = 0; j < cell.armDof(); ++j)
      from[j] += 0.5 * share(engine);
    to = from;
    for (Eigen::Index j = 0; j < cell.armDof(); ++j)
      to[j] += reach * share(engine);
    const double ends = std::min(at(from), at(to));
    double least = ends;
    constexpr int kSamples = 300;
    for (int k = 1; k < kSamples; ++k)
      least = std::min(least, at(from + static_cast<double>(k) / kSamples * (to - from)));
    if (least <= 0.5)
      continue; // met: there is no clearance to be told
    between += least < ends - 0.01;
    const double reported = ways.along(from, to, before, ends);
    EXPECT_LE(reported, least + 1e-6) << GetParam() << " " << n;
    // Samples are no closer to the truth than what moves between them.
    EXPECT_GE(reported, least - collision::kWayExactMm - 0.5 * reach) << GetParam() << " " << n;
  }
  EXPECT_GT(between, 0) << "motions whose least distance is at neither end";
}

INSTANTIATE_TEST_SUITE_P(Cells, WayClearances,
                         testing::Values("ur5-fixed", "ur5-moving", "irb2400-moving"));
