#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "robot/cell.h"
#include "toolpath/nozzle_directions.h"
#include "toolpath/order/assemble.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/path_vtp_writer.h"
#include "toolpath/plan_toolpaths.h"
#include "toolpath/unsupported/head_clearance.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;

process::Process testProcess() {
  process::Process p;
  p.head.sections = {{0, 0.9}, {12, 6}, {12, 10}, {45, 10}, {45, 22}, {110, 22}};
  return p;
}

robot::Cell testCell(double radiusMm = 30.0) {
  return robot::loadCell("ur5-fixed", testProcess(),
                         platform::PlatformSolid(test::circle(radiusMm)));
}

// A dome of `count` caps over a plate; directions lean up to 40 degrees more than the dome's, so
// that the head of a tilted nozzle would cut into the plate or into printed beads around.
layers::LayerStack dome(int count, double extraTilt) {
  layers::LayerStack stack;
  for (int k = 0; k < count; ++k) {
    const double r = 8 + 0.8 * k;
    layers::Patch p = test::patchOver({test::circle(1.2 * r)}, 0.8, test::onSphere(r));
    const double drop = 8 * std::cos(1.2) - 0.5;
    for (std::size_t v = 0; v < p.direction.size(); ++v) {
      Vector3d& x = p.surface.vertices[v];
      x.z() -= drop - 0.8;
      const Vector3d out = Vector3d(x.x(), x.y(), 0).normalized();
      p.clearDirection[v] = Vector3d::UnitZ();
      if (out.allFinite())
        p.direction[v] = (p.direction[v] + extraTilt * out).normalized();
    }
    p.layer = k;
    stack.patches.push_back(std::move(p));
  }
  stack.layerCount = count;
  return stack;
}

TEST(PlanToolpaths, KeepsThePlansContract) {
  const auto stack = dome(3, 0.0);
  toolpath::ToolpathOptions o;
  const auto r = toolpath::planToolpaths(stack, testCell(), process::Tooling(testProcess()), o,
                                         base::RunContext{});
  const plan::ToolPlan& p = r.plan;
  ASSERT_GT(p.waypointCount(), 1000u);
  ASSERT_EQ(p.direction.size(), p.waypointCount());
  ASSERT_EQ(p.widthMm.size(), p.waypointCount());
  std::size_t next = 0;
  int layer = 0;
  for (const plan::ToolPath& path : p.paths) {
    EXPECT_EQ(path.first, next);
    EXPECT_GE(path.count, 2u);
    EXPECT_GE(path.layer, layer);
    layer = path.layer;
    next += path.count;
    if (path.closed) {
      EXPECT_LT((p.position[path.first] - p.position[next - 1]).norm(), 1e-9);
    }
    for (std::size_t i = path.first; i < next; ++i) {
      EXPECT_NEAR(p.direction[i].norm(), 1.0, 1e-9);
      EXPECT_GE(p.widthMm[i], 1.0f - 1e-5f);
      EXPECT_LE(p.widthMm[i], 2.0f + 1e-5f);
      EXPECT_LE(p.heightMm[i], p.widthMm[i] + 1e-5f);
      if (i > path.first) {
        // Chords of a closed-form sphere; the tip's way is longer than the surface's.
        EXPECT_LT((p.position[i] - p.position[i - 1]).norm(), 1.15 * o.stepMm);
        const double angle = std::atan2(p.direction[i - 1].cross(p.direction[i]).norm(),
                                        p.direction[i - 1].dot(p.direction[i]));
        EXPECT_LE(base::radiansToDegrees(angle), o.maxBendDeg + 1e-6);
      }
    }
  }
  EXPECT_EQ(next, p.waypointCount());
  EXPECT_EQ(r.statistics.simpleRegions, 3u);
  EXPECT_NEAR(r.statistics.materialMm3 / r.statistics.layerVolumeMm3, 1.0, 0.01);
}

TEST(PlanToolpaths, SameForAnyNumberOfThreads) {
  const auto stack = dome(3, 0.6);
  const auto one = toolpath::planToolpaths(stack, testCell(), process::Tooling(testProcess()), {},
                                           base::RunContext{});
  const auto two = toolpath::planToolpaths(stack, testCell(), process::Tooling(testProcess()), {},
                                           base::RunContext(base::CancelToken{}, 2));
  EXPECT_EQ(toolpath::writeToolpathVtp(one.plan), toolpath::writeToolpathVtp(two.plan));
}

// The part passed on to the motion equals the part that the motion would grow.
TEST(PlanToolpaths, TheGrowingPartIsThePlans) {
  for (const double tilt : {0.0, 0.6}) {
    const auto r = toolpath::planToolpaths(dome(3, tilt), testCell(60),
                                           process::Tooling(testProcess()), {}, base::RunContext{});
    ASSERT_NE(r.grown, nullptr);
    const collision::GrowingPart anew(
        r.plan, collision::growingPitch(r.plan, process::Tooling(testProcess())), {});
    ASSERT_EQ(r.grown->grid().size, anew.grid().size);
    EXPECT_EQ(r.grown->grid().origin, anew.grid().origin);
    std::size_t others = 0;
    for (std::size_t c = 0; c < anew.grid().cellCount(); ++c)
      others += r.grown->filledAt(c) != anew.filledAt(c);
    EXPECT_EQ(others, 0u);
  }
}

TEST(PlanToolpaths, StayWithinTheFlowOfTheExtruder) {
  layers::LayerStack stack;
  layers::Patch p = test::patchOver({test::circle(12)}, 0.8);
  for (std::size_t v = 0; v < p.thicknessMm.size(); ++v)
    p.thicknessMm[v] = 0.45 + 0.5 * std::abs(std::sin(1.3 * p.surface.vertices[v].x()));
  stack.patches.push_back(std::move(p));
  stack.layerCount = 1;
  process::Process process = testProcess();
  process.maxFlowMm3PerS = 8.0;
  const plan::ToolPlan made =
      toolpath::planToolpaths(stack, testCell(), process::Tooling(process), {}, base::RunContext{})
          .plan;
  const auto section = [&](std::size_t i) {
    return process::beadArea(made.widthMm[i], made.heightMm[i]);
  };
  double maximum = 0.0;
  for (const plan::ToolPath& path : made.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      maximum = std::max(maximum, process::beadVolume(section(i - 1), section(i), 1.0) *
                                      static_cast<double>(made.speedMmPerS[i]));
  EXPECT_LE(maximum, process.maxFlowMm3PerS * (1.0 + 1e-6));
  EXPECT_GT(maximum, 0.9 * process.maxFlowMm3PerS);
}

TEST(PlanToolpaths, LeansAwayFromPlateAndPart) {
  const auto stack = dome(4, 1.0);
  const process::Process process = testProcess();
  toolpath::ToolpathOptions o;
  o.platform = test::circle(60);
  o.rimSupports = false;
  const auto r = toolpath::planToolpaths(stack, testCell(60), process::Tooling(process), o,
                                         base::RunContext{});
  EXPECT_EQ(r.statistics.gouges, 0u);
  for (const plan::Finding& f : r.findings)
    EXPECT_EQ(plan::reportId(f), "braced"); // the dome's caps reach out

  // By brute force over the cells' centres: none filled earlier is inside the head, and no point of
  // the head is below the plate's top.
  const plan::ToolPlan& p = r.plan;
  const collision::GrowingPart part(p, 0.8, base::RunContext{});
  const auto head = process::erodedHead(process.head, process.contactToleranceMm);
  std::size_t hits = 0, checked = 0;
  double lowest = 0.0;
  for (std::size_t i = 0; i < p.waypointCount(); i += 37) {
    ++checked;
    const Vector3d d = p.direction[i];
    for (std::size_t s = 0; s < head.sections.size(); ++s)
      lowest = std::min(lowest, p.position[i].z() + head.sections[s].zMm * d.z() -
                                    head.sections[s].radiusMm * std::sqrt(1 - d.z() * d.z()));
    for (std::size_t c = 0; c < part.grid().cellCount(); ++c) {
      // A slack of half a cell: the planner's grid is another one.
      if (part.filledAt(c) >= i)
        continue;
      const Eigen::Vector3i k = part.grid().cell(c);
      const Vector3d q = part.grid().centre(k.x(), k.y(), k.z()) - p.position[i];
      const double z = q.dot(d), lateral = (q - z * d).norm();
      for (std::size_t s = 1; s < head.sections.size(); ++s) {
        const auto &a = head.sections[s - 1], &b = head.sections[s];
        if (z <= a.zMm + 0.4 || z >= b.zMm)
          continue;
        if (lateral < a.radiusMm + (b.radiusMm - a.radiusMm) * (z - a.zMm) / (b.zMm - a.zMm) - 0.4)
          ++hits;
      }
    }
  }
  EXPECT_GT(checked, 50u);
  EXPECT_EQ(hits, 0u);
  EXPECT_GE(lowest, -1e-9);

  // And there was something to lean away from.
  const robot::Cell cell = testCell(60);
  const toolpath::HeadClearance clearance(cell, process);
  std::vector<toolpath::PatchCover> covers;
  for (const layers::Patch& patch : stack.patches)
    covers.push_back(toolpath::coverPatch(patch, process, o, base::RunContext{}));
  const auto raw = toolpath::assemble(stack, covers, process::Tooling(process));
  const collision::GrowingPart rawPart(raw.plan, 0.6, base::RunContext{});
  std::size_t gouges = 0;
  for (std::size_t i = 0; i < raw.plan.waypointCount(); ++i)
    gouges += !clearance.clears(rawPart, raw.plan.position[i], raw.plan.direction[i], i);
  EXPECT_GT(gouges, 0u);
}

// A bead at the bottom of a well that leans by 30 degrees: within 4.5 degrees of its axis, between
// the rings that are tried first, the head fits.
TEST(Directions, FindTheWayIntoAWellThatLeans) {
  const process::Process process = testProcess();
  const double radius = 9.6 + 1.0 + 45.0 * std::tan(base::degreesToRadians(4.5));
  for (const double azimuth : {15.0, 100.0, 231.0}) {
    const Vector3d side(std::cos(base::degreesToRadians(azimuth)),
                        std::sin(base::degreesToRadians(azimuth)), 0.0);
    const Vector3d axis = (0.5 * side + std::sqrt(0.75) * Vector3d::UnitZ()).normalized();
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u), bottom(0, 0, 40);
    plan::ToolPlan p;
    const auto add = [&](const Vector3d& at, const Vector3d& d, float width, float height) {
      p.position.push_back(at);
      p.direction.push_back(d);
      p.widthMm.push_back(width);
      p.heightMm.push_back(height);
      p.speedMmPerS.push_back(20.0f);
      ++p.paths.back().count;
    };
    for (int k = 0; k < 20; ++k) {
      p.paths.push_back({.first = p.waypointCount(), .count = 0, .layer = k});
      for (int i = 0; i <= 96; ++i)
        add(bottom + 2.0 * (k + 1) * axis +
                radius *
                    (std::cos(base::kTwoPi * i / 96) * u + std::sin(base::kTwoPi * i / 96) * v),
            axis, 2.0f, 2.0f);
    }
    const std::size_t first = p.waypointCount();
    p.paths.push_back({.first = first, .count = 0, .layer = 20});
    for (int i = 0; i <= 4; ++i)
      add(bottom + (0.25 * i - 0.5) * u, Vector3d::UnitZ(), 1.2f, 0.8f);
    const std::vector<Vector3d> clear(p.waypointCount(), Vector3d::UnitZ());
    const auto oriented = toolpath::orientDirections(
        p, clear, testCell(), process::Tooling(process), {}, base::RunContext{});
    EXPECT_EQ(oriented.gouges, 0u) << azimuth;
    // Beads that are at hand are the same as those that are deposited anew.
    const auto same = toolpath::orientDirections(
        p, clear, testCell(), process::Tooling(process), {}, base::RunContext{}, {},
        std::make_shared<const collision::GrowingPart>(
            p, collision::growingPitch(p, process::Tooling(process)), base::RunContext{}));
    EXPECT_EQ(same.plan.position, oriented.plan.position);
    EXPECT_EQ(same.plan.direction, oriented.plan.direction);
    for (std::size_t i = oriented.plan.paths.back().first; i < oriented.plan.waypointCount(); ++i)
      EXPECT_GT(oriented.plan.direction[i].dot(axis), std::cos(base::degreesToRadians(5.0)))
          << azimuth;
  }
}

TEST(PlanToolpaths, NoRoomForTheHeadIsAFinding) {
  // A disc at the bottom of a well, printed after its wall.
  layers::LayerStack stack;
  for (int k = 0; k < 40; ++k) {
    layers::Patch ring =
        test::patchOver({test::circle(5), test::circle(3, true)}, 1.0,
                        [&](const Vector2d& p) { return Vector3d(p.x(), p.y(), 0.4 + 0.8 * k); });
    ring.layer = k;
    stack.patches.push_back(std::move(ring));
  }
  stack.patches.push_back(test::patchOver({test::circle(2)}));
  stack.layerCount = 40;
  const auto r = toolpath::planToolpaths(stack, testCell(), process::Tooling(testProcess()), {},
                                         base::RunContext{});
  EXPECT_GT(r.statistics.gouges, 0u);
  ASSERT_EQ(r.findings.size(), 1u);
  EXPECT_EQ(voluta::plan::reportId(r.findings[0]), "gouge");
  ASSERT_TRUE(r.findings[0].where);
  EXPECT_LT(r.findings[0].where->head<2>().norm(), 2.5);
  EXPECT_NEAR(r.findings[0].where->z(), 0.8, 0.5);
}

TEST(PlanToolpaths, Cancels) {
  base::CancelToken token;
  token.cancel();
  EXPECT_THROW(toolpath::planToolpaths(dome(2, 0), testCell(), process::Tooling(testProcess()), {},
                                       base::RunContext(token, 2)),
               base::Cancelled);
}

TEST(PlanToolpaths, NothingInNothingOut) {
  const auto r = toolpath::planToolpaths({}, testCell(), process::Tooling(testProcess()), {},
                                         base::RunContext{});
  EXPECT_EQ(r.plan.waypointCount(), 0u);
  EXPECT_TRUE(r.findings.empty());
}

} // namespace
