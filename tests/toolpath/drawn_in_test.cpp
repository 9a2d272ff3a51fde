// Unsupported walls that are moved a little aside.
#include "collision/growing_part.h"
#include "toolpath/unsupported/inset_walls.h"

#include "one_pass.h"
#include "toolpath/unsupported/bridges.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using namespace voluta::test;
using Eigen::Vector3d;

namespace {

struct Drawn {
  std::vector<Vector3d> moves;
  std::size_t before = 0, after = 0; // unsupported waypoints
};

Drawn drawn(plan::ToolPlan plan) {
  const base::RunContext ctx;
  const double pitch = collision::growingPitch(plan, process::Tooling(kProcess));
  const auto ground = collision::groundCells(kPlate, plan, pitch, ctx);
  const auto unsupported = [&](const collision::GrowingPart& part) {
    const auto marks = toolpath::unsupportedWaypoints(plan, part, kPlate, ctx);
    return static_cast<std::size_t>(std::ranges::count(marks, 1));
  };
  Drawn result;
  const collision::GrowingPart part(plan, pitch, ctx, ground);
  result.before = unsupported(part);
  plan::ToolPlan after = afterPass("insetWalls", plan).plan;
  for (std::size_t i = 0; i < plan.waypointCount(); ++i)
    result.moves.emplace_back(after.position[i] - plan.position[i]);
  plan = std::move(after);
  result.after = unsupported(collision::GrowingPart(plan, pitch, ctx, ground));
  return result;
}

} // namespace

// A bead so far beside the one below that they just miss each other, on either side, near and far.
TEST(DrawnIn, UnsupportedWallMovesOverTheBeadBelow) {
  std::mt19937 engine(3);
  for (int n = 0; n < 60; ++n) {
    const double off = std::uniform_real_distribution<>(1.3, 1.5)(engine) * (n % 2 ? 1 : -1);
    plan::ToolPlan plan;
    addPath(plan, -15, 15, 0, 0.8, 0);
    addPath(plan, n % 3 ? -12 : 12, n % 3 ? 12 : -12, off, 1.6, 1);
    const Drawn result = drawn(plan);
    EXPECT_GT(result.before, 20u) << off;
    EXPECT_EQ(result.after, 0u) << off;
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      const bool above = i >= plan.paths[1].first;
      EXPECT_LE(result.moves[i].norm(), 0.5 * kProcess.beadWidthMm + 1e-9);
      EXPECT_EQ(result.moves[i].norm() > 0.0, above);
      EXPECT_LE(result.moves[i].y() * off, 0.0); // towards the bead below
      EXPECT_NEAR(result.moves[i].x(), 0.0, 1e-9);
      EXPECT_NEAR(result.moves[i].z(), 0.0, 1e-9);
    }
  }
}

TEST(DrawnIn, FarShortAndCarriedBeadsAndOtherKindsStay) {
  for (const char* which : {"far", "short", "infill", "support", "carried"}) {
    const std::string name = which;
    plan::ToolPlan plan;
    addPath(plan, -15, 15, 0, 0.8, 0);
    const double reach = name == "short" ? 1.4 : 12.0;
    addPath(plan, -reach, reach, name == "far" ? 2.4 : name == "carried" ? 0.6 : 1.35, 1.6, 1);
    if (name == "infill")
      plan.paths[1].kind = plan::PathKind::Infill;
    if (name == "support")
      plan.paths[1].kind = plan::PathKind::Support;
    for (const Vector3d& move : drawn(plan).moves)
      EXPECT_TRUE(move.isZero()) << name;
  }
}

// A stretch of a longer path: beside it, the path comes back to where it was, gently.
TEST(DrawnIn, TheWayThereIsGentle) {
  plan::ToolPlan plan;
  addPath(plan, -20, 0, 0, 0.8, 0);
  addPath(plan, 0, 20, -0.85, 0.8, 0);
  addPath(plan, -20, 20, 0.5, 1.6, 1); // carried up to x = 0, then beside
  const Drawn result = drawn(plan);
  EXPECT_GT(result.before, 10u);
  EXPECT_LT(result.after, 3u);
  for (std::size_t i = plan.paths[2].first + 1; i < plan.waypointCount(); ++i)
    EXPECT_LE((result.moves[i] - result.moves[i - 1]).norm(), 0.5);
  EXPECT_TRUE(result.moves[plan.paths[2].first].isZero());
}

// A ring about a smaller one: its ends stay together.
TEST(DrawnIn, ARingStaysClosed) {
  plan::ToolPlan plan;
  const auto addRing = [&](double radius, double z) {
    plan::ToolPath path;
    path.first = plan.waypointCount();
    path.closed = true;
    for (int k = 0; k <= 60; ++k) {
      const double a = 2.0 * 3.141592653589793 * (k % 60) / 60.0;
      plan.position.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
      plan.direction.emplace_back(Vector3d::UnitZ());
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(0.8f);
      plan.speedMmPerS.push_back(20.0f);
    }
    path.count = plan.waypointCount() - path.first;
    plan.paths.push_back(path);
  };
  addRing(10.0, 0.8);
  addRing(11.4, 1.6);
  const Drawn result = drawn(plan);
  EXPECT_GT(result.before, 50u);
  EXPECT_EQ(result.after, 0u);
  EXPECT_EQ(result.moves[plan.paths[1].first], result.moves.back());
  EXPECT_GT(result.moves.back().norm(), 0.0);
}
