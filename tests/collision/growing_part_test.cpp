#include "collision/growing_part.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/random_shapes.h"
#include "collision/same_segments.h"
#include "collision/shape_distance.h"
#include "helpers/shapes.h"
#include "plan/waypoints.h"
#include "platform/rod_shape.h"
#include "process/process.h"
#include "voxel/voxel_grid.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <utility>

using namespace voluta;
using collision::GrowingPart;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

void addPath(plan::ToolPlan& plan, const std::vector<Vector3d>& points, const Vector3d& direction,
             float width = 1.2f, float height = 0.8f) {
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.count = points.size();
  for (const Vector3d& p : points) {
    plan.position.push_back(p);
    plan.direction.push_back(direction.normalized());
    plan.widthMm.push_back(width);
    plan.heightMm.push_back(height);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back(path);
}

plan::ToolPlan randomBeads(unsigned seed, int paths) {
  test::RandomShapes random(seed);
  plan::ToolPlan plan;
  for (int n = 0; n < paths; ++n) {
    const Vector3d start = random.point(6.0);
    const Vector3d direction = random.point(1.0).normalized();
    std::vector<Vector3d> points{start};
    for (int i = 0; i < 5; ++i) {
      const Vector3d step = random.point(1.5); // across the direction, like the steps between beads
      points.push_back(points.back() + step - step.dot(direction) * direction);
    }
    addPath(plan, points, direction, static_cast<float>(random.number(1.0, 2.0)),
            static_cast<float>(random.number(0.4, 1.0)));
  }
  return plan;
}

// Some of its paths are left out, others added between them; some beads are moved, thickened or
// divided.
plan::ToolPlan edited(const plan::ToolPlan& plan, unsigned seed) {
  test::RandomShapes random(seed);
  const plan::ToolPlan more = randomBeads(seed + 1000, 4);
  plan::ToolPlan out;
  const auto addWhole = [&](const plan::ToolPlan& of, plan::ToolPath path, bool edits) {
    const std::size_t from = path.first, count = path.count;
    path.first = out.waypointCount();
    for (std::size_t i = from; i < from + count; ++i) {
      if (edits && i > from && random.number(0.0, 1.0) < 0.15) {
        plan::appendWaypoint(out, of, i);
        out.position.back() = 0.5 * (of.position[i - 1] + of.position[i]);
      }
      plan::appendWaypoint(out, of, i);
      if (edits && random.number(0.0, 1.0) < 0.1)
        out.position.back() += random.point(0.3);
      if (edits && random.number(0.0, 1.0) < 0.1)
        out.heightMm.back() *= 1.3f;
    }
    path.count = out.waypointCount() - path.first;
    out.paths.push_back(path);
  };
  std::size_t next = 0;
  for (const plan::ToolPath& path : plan.paths) {
    if (next < more.paths.size() && random.number(0.0, 1.0) < 0.15)
      addWhole(more, more.paths[next++], false);
    if (random.number(0.0, 1.0) < 0.9)
      addWhole(plan, path, random.number(0.0, 1.0) < 0.5);
  }
  return out;
}

// Is the point in the swept section? By walking along the bead in small steps, a check that
// shares nothing with the depositor's projection.
bool inBead(const plan::ToolPlan& plan, std::size_t i, const Vector3d& p, double slack) {
  for (int s = 0; s <= 300; ++s) {
    const double t = s / 300.0;
    const Vector3d d = plan.direction[i];
    const double h = plan.heightMm[i], w = plan.widthMm[i];
    const Vector3d c =
        (1 - t) * plan.position[i] + t * plan.position[i + 1] - 0.5 * h * d; // middle of section
    const double z = (p - c).dot(d), side = (p - c - z * d).norm();
    if (side <= 0.5 * (w - h)) {
      if (std::abs(z) <= 0.5 * h + slack)
        return true;
    } else if (std::hypot(side - 0.5 * (w - h), z) <= 0.5 * h + slack) {
      return true;
    }
  }
  return false;
}

std::vector<std::pair<Vector3d, std::uint32_t>> filledCells(const GrowingPart& part) {
  std::vector<std::pair<Vector3d, std::uint32_t>> cells;
  for (std::size_t c = 0; c < part.grid().cellCount(); ++c)
    if (part.filledAt(c) != GrowingPart::kNeverFilled) {
      const Eigen::Vector3i ijk = part.grid().cell(c);
      cells.emplace_back(part.grid().centre(ijk.x(), ijk.y(), ijk.z()), part.filledAt(c));
    }
  return cells;
}

} // namespace

// A prime in the air falls beside the plate; one on the plate, and a skirt that is no prime, stay.
TEST(GrowingPart, APrimeThatFallsIsNoPartOfIt) {
  plan::ToolPlan plan;
  addPath(plan, {{-10, -24, 10}, {10, -24, 10}}, Vector3d::UnitZ());
  addPath(plan, {{-10, 0, 0.8}, {10, 0, 0.8}}, Vector3d::UnitZ());
  plan.paths[0].kind = plan::PathKind::Skirt;
  EXPECT_TRUE(plan.isPrimeInAir());
  GrowingPart part(plan, 0.3, {});
  EXPECT_FALSE(part.holds({0, -24, 9.6}, plan.waypointCount()));
  EXPECT_TRUE(part.holds({0, 0, 0.4}, plan.waypointCount()));

  std::swap(plan.paths[0].kind, plan.paths[1].kind);
  EXPECT_FALSE(plan.isPrimeInAir());
  EXPECT_TRUE(GrowingPart(plan, 0.3, {}).holds({0, -24, 9.6}, plan.waypointCount()));

  plan.paths[0].kind = plan::PathKind::Skirt;
  plan.position[0].z() = plan.position[1].z() = 0.8;
  EXPECT_FALSE(plan.isPrimeInAir());
  EXPECT_TRUE(GrowingPart(plan, 0.3, {}).holds({0, -24, 0.4}, plan.waypointCount()));
}

TEST(GrowingPart, EmptyPlan) {
  const GrowingPart part(plan::ToolPlan{}, 0.5, {});
  const robot::Capsule ball{Vector3d::Zero(), Vector3d::Zero(), 5};
  EXPECT_FALSE(part.touches(ball, Isometry3d::Identity(), 100, 10));
  EXPECT_DOUBLE_EQ(part.distance(ball, Isometry3d::Identity(), 7.5, 10), 7.5);
}

// A straight bead of 40 mm: its volume in cells is area x length plus two rounded ends.
TEST(GrowingPart, VolumeOfAStraightBead) {
  plan::ToolPlan plan;
  std::vector<Vector3d> points;
  for (int i = 0; i <= 40; ++i)
    points.emplace_back(i, 0.3, 0.8);
  addPath(plan, points, Vector3d::UnitZ());
  const GrowingPart part(plan, 0.0437, {});
  const double cell = std::pow(0.0437, 3);
  const double section = 1.2 * 0.8 - (1 - base::kPi / 4) * 0.64;
  // Ends: the section turned about its middle line (Pappus): a disc of r = 0.2 and a half torus.
  const double ends = base::kPi * 0.04 * 0.8 +
                      base::kPi * 0.16 / 2 * 2 * base::kPi * (0.2 + 4 * 0.4 / (3 * base::kPi));
  EXPECT_NEAR(static_cast<double>(filledCells(part).size()) * cell, section * 40 + ends,
              0.01 * section * 40);
}

TEST(GrowingPart, FillIndicesAgainstBruteForce) {
  const plan::ToolPlan plan = randomBeads(7, 6);
  const GrowingPart part(plan, 0.3, {});
  int checked = 0;
  for (std::size_t c = 0; c < part.grid().cellCount(); c += 11) {
    const Eigen::Vector3i ijk = part.grid().cell(c);
    const Vector3d p = part.grid().centre(ijk.x(), ijk.y(), ijk.z());
    std::uint32_t surely = GrowingPart::kNeverFilled, perhaps = surely;
    for (const plan::ToolPath& path : plan.paths)
      for (std::size_t i = path.first; i + 1 < path.first + path.count; ++i) {
        const auto at = static_cast<std::uint32_t>(i + 1);
        if (inBead(plan, i, p, 1e-3))
          perhaps = std::min(perhaps, at);
        if (inBead(plan, i, p, -1e-3))
          surely = std::min(surely, at);
      }
    EXPECT_GE(part.filledAt(c), perhaps);
    EXPECT_LE(part.filledAt(c), surely);
    checked += surely != GrowingPart::kNeverFilled;
  }
  EXPECT_GT(checked, 50);
}

TEST(GrowingPart, TouchesAndDistanceAgainstBruteForce) {
  const plan::ToolPlan plan = randomBeads(8, 20);
  const GrowingPart part(plan, 0.4, {});
  const auto cells = filledCells(part);
  ASSERT_GT(cells.size(), 1000u);
  test::RandomShapes random(9);
  int touching = 0;
  for (int n = 0; n < 600; ++n) {
    const robot::Shape shape = random.shape(n, random.number(0.3, 4.0));
    const Isometry3d pose = random.pose(n % 3 == 0 ? 20.0 : 10.0);
    const double margin = random.number(-0.5, 2.0), cap = random.number(0.5, 30.0);
    const auto before = static_cast<std::size_t>(random.number(0.0, 125.0));
    double minimum = std::numeric_limits<double>::infinity();
    for (const auto& [centre, time] : cells)
      if (time < before)
        minimum = std::min(minimum, collision::signedDistance(shape, pose.inverse() * centre));
    if (std::abs(minimum - margin) > 1e-9) {
      EXPECT_EQ(part.touches(shape, pose, margin, before), minimum <= margin) << n;
    }
    EXPECT_NEAR(part.distance(shape, pose, cap, before), std::clamp(minimum, 0.0, cap), 1e-9) << n;
    touching += minimum <= margin;
  }
  EXPECT_GT(touching, 50);
}

// Above all that is filled in time there is nothing to meet, at the very edge of it too.
TEST(GrowingPart, DistinguishesShapesJustAboveAndJustInFilledCells) {
  const plan::ToolPlan plan = randomBeads(12, 20);
  const GrowingPart part(plan, 0.4, {});
  const auto cells = filledCells(part);
  test::RandomShapes random(13);
  int touching = 0, clear = 0;
  for (int n = 0; n < 400; ++n) {
    const robot::Shape shape = random.shape(n, random.number(0.3, 4.0));
    Isometry3d pose = random.pose(4.0);
    const double margin = random.number(-0.2, 1.0);
    const auto before = static_cast<std::size_t>(random.number(1.0, 125.0));
    double top = -std::numeric_limits<double>::infinity();
    for (const auto& [centre, time] : cells)
      if (time < before)
        top = std::max(top, centre.z());
    const double lowest = pose.translation().z() -
                          collision::support(shape, pose.linear().transpose() * -Vector3d::UnitZ());
    pose.translation().z() += top - lowest + margin + random.number(-2.0, 0.1);
    double minimum = std::numeric_limits<double>::infinity();
    for (const auto& [centre, time] : cells)
      if (time < before)
        minimum = std::min(minimum, collision::signedDistance(shape, pose.inverse() * centre));
    if (std::abs(minimum - margin) < 1e-9)
      continue;
    EXPECT_EQ(part.touches(shape, pose, margin, before), minimum <= margin) << n;
    (minimum <= margin ? touching : clear) += 1;
  }
  EXPECT_GT(touching, 5);
  EXPECT_GT(clear, 100);
}

TEST(GrowingPart, SameForAnyNumberOfThreads) {
  const plan::ToolPlan plan = randomBeads(10, 900);
  const GrowingPart one(plan, 0.3, {});
  const GrowingPart two(plan, 0.3, base::RunContext(base::CancelToken(), 2));
  ASSERT_EQ(one.grid().cellCount(), two.grid().cellCount());
  for (std::size_t c = 0; c < one.grid().cellCount(); ++c)
    ASSERT_EQ(one.filledAt(c), two.filledAt(c));
}

TEST(GrowingPart, ThinLayersGetFinerCells) {
  plan::ToolPlan plan;
  addPath(plan, {{0, 0, 0.8}, {10, 0, 0.8}}, Vector3d::UnitZ());
  process::Process p; // 0.8 x 1.2 mm
  EXPECT_EQ(collision::growingPitch(plan, process::Tooling(p)), 0.25 * p.beadWidthMm);
  p.layerHeightMm = 0.25;
  EXPECT_EQ(collision::growingPitch(plan, process::Tooling(p)), 0.125);
  // A part too large for cells so fine has coarser ones.
  addPath(plan, {{0, 0, 0.8}, {400, 400, 400}}, Vector3d::UnitZ());
  EXPECT_GT(collision::growingPitch(plan, process::Tooling(p)), 0.7);
}

TEST(GrowingPart, TheFinestToolOfThePathsDecidesTheCells) {
  process::Tool coarse, fine;
  fine.process.layerHeightMm = 0.2;
  const process::Tooling tooling({coarse, fine});
  plan::ToolPlan plan;
  addPath(plan, {{0, 0, 0.8}, {10, 0, 0.8}}, Vector3d::UnitZ());
  addPath(plan, {{0, 5, 0.8}, {10, 5, 0.8}}, Vector3d::UnitZ());
  const double usual = collision::growingPitch(plan, process::Tooling(coarse.process));
  EXPECT_EQ(collision::growingPitch(plan, tooling), usual); // no path uses the other one
  plan.paths.back().tool = 1;
  EXPECT_EQ(collision::growingPitch(plan, tooling), 0.1);
  plan.paths.back().tool = 2;
  EXPECT_THROW(collision::growingPitch(plan, tooling), base::Error);
  plan.paths.clear();
  EXPECT_EQ(collision::growingPitch(plan, tooling), usual);
}

TEST(GrowingPart, Cancel) {
  const base::CancelToken cancel;
  cancel.cancel();
  const plan::ToolPlan plan = randomBeads(11, 3);
  EXPECT_THROW(GrowingPart(plan, 0.3, base::RunContext(cancel, 1)), base::Cancelled);
}

// The head over each waypoint of a solid block that has just been printed.
TEST(GrowingPart, HeadOverItsOwnBeadsTouchesNothing) {
  plan::ToolPlan plan;
  std::vector<Vector3d> points;
  for (int i = 0; i < 6000; ++i) {
    const int ring = i / 2000, line = i % 2000 / 50, x = i % 50;
    points.emplace_back(line % 2 ? 49 - x : x, 1.1 * line, 0.8 * (ring + 1));
  }
  addPath(plan, points, Vector3d::UnitZ());
  const GrowingPart part(plan, 0.45, {});
  const robot::Frustum tip{{0, 0, 0.4}, {0, 0, 12.4}, 0.5, 5.6};
  const robot::Frustum body{{0, 0, 12.4}, {0, 0, 45.4}, 9.6, 9.6};
  for (std::size_t w = 0; w < points.size(); w += 10) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = points[w];
    ASSERT_FALSE(part.touches(tip, pose, 0.0, w)) << w;
    ASSERT_FALSE(part.touches(body, pose, 0.0, w)) << w;
  }
}

TEST(GrowingPart, RodAndBodyAreThereFromTheStart) {
  platform::PlatformSolid platform;
  platform.rod = platform::straightRod(5.0, 40.0);
  plan::ToolPlan plan;
  addPath(plan, {{-5, 0, 2.75}, {5, 0, 2.75}}, Vector3d::UnitZ(), 0.7f, 0.25f);
  const GrowingPart part(plan, 0.125, {}, collision::groundCells(platform, plan, 0.125, {}));
  const robot::Shape pin = robot::Capsule{Vector3d::Zero(), Vector3d(0, 0, 1), 0.5};
  const auto at = [](double x, double z) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = Vector3d(x, 0, z);
    return pose;
  };
  // Beyond the bead, on the rod's surface at z = 2.5.
  EXPECT_TRUE(part.touches(pin, at(15, 2.8), 0.0, 0));
  EXPECT_FALSE(part.touches(pin, at(15, 3.2), 0.0, 0));
  EXPECT_FALSE(part.touches(pin, at(25, 0.0), 0.0, 0)) << "beyond the rod's end";
  EXPECT_NEAR(part.distance(pin, at(15, 4.0), 10.0, 0), 1.0, 0.125);
  // On the bead: no contact before it is deposited.
  EXPECT_FALSE(part.touches(pin, at(0, 3.1), 0.0, 1));
  EXPECT_TRUE(part.touches(pin, at(0, 3.1), 0.0, 2));
  // A head whose foot is flush with the ground is no gouge; deeper than half a cell is.
  const collision::Revolved foot({{Vector3d(0, 0, 0), Vector3d(0, 0, 5), 0.4, 0.4}});
  EXPECT_FALSE(part.headTouches(foot, at(15, 2.46), 0.0, 0));
  EXPECT_TRUE(part.headTouches(foot, at(15, 2.25), 0.0, 0));
}

// A body that is put in after the first of two beads.
TEST(GrowingPart, AnInsertIsThereFromItsLayerOn) {
  plan::ToolPlan plan;
  addPath(plan, {{-5, 0, 0.25}, {0, 0, 0.25}, {5, 0, 0.25}}, Vector3d::UnitZ(), 0.7f, 0.25f);
  addPath(plan, {{-5, 0, 0.5}, {5, 0, 0.5}}, Vector3d::UnitZ(), 0.7f, 0.25f);
  plan.paths[1].layer = 1;
  plan.inserts.push_back(
      {"pin", 0, 1, std::make_shared<geometry::TriangleMesh>(test::box({8, -1, 0}, {10, 1, 6}))});
  EXPECT_EQ(plan.firstAfter(plan.inserts[0]), 3u);
  const GrowingPart part(plan, 0.125, {},
                         collision::groundCells(platform::PlatformSolid(), plan, 0.125, {}));
  const robot::Shape ball = robot::Capsule{Vector3d::Zero(), Vector3d(0, 0, 0.1), 0.5};
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(9, 0, 4);
  for (std::size_t before = 0; before < 6; ++before)
    EXPECT_EQ(part.touches(ball, pose, 0.0, before), before >= 3) << before;
  plan.inserts[0].layer = 2; // nothing is printed after it
  EXPECT_EQ(plan.firstAfter(plan.inserts[0]), plan.waypointCount());
  EXPECT_EQ(collision::groundCells(platform::PlatformSolid(), plan, 0.125, {}), nullptr);
}

// Cells taken over from another plan's part and newly filled cells together are the part, cell by
// cell, and most segments are found again.
TEST(GrowingPart, GrowsOnFromAnotherPlansPart) {
  std::size_t filled = 0, kept = 0, all = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const plan::ToolPlan was = randomBeads(seed, 25), plan = edited(was, seed);
    const GrowingPart before(was, 0.25, {});
    const GrowingPart grown(plan, before, was, {}), fresh(plan, 0.25, {});
    ASSERT_EQ(grown.grid().size, fresh.grid().size);
    EXPECT_EQ(grown.grid().origin, fresh.grid().origin);
    for (std::size_t cell = 0; cell < fresh.grid().cellCount(); ++cell) {
      ASSERT_EQ(grown.filledAt(cell), fresh.filledAt(cell)) << seed;
      filled += fresh.filledAt(cell) != GrowingPart::kNeverFilled ? 1 : 0;
    }
    std::vector<std::uint32_t> segments, its;
    for (std::uint32_t i = 0; i + 1 < plan.waypointCount(); ++i)
      segments.push_back(i);
    for (std::uint32_t i = 0; i + 1 < was.waypointCount(); ++i)
      its.push_back(i);
    const auto same = collision::sameSegments(plan, segments, was, its, {});
    std::uint32_t last = 0;
    for (std::size_t s = 0; s < its.size(); ++s) {
      if (same[s] == collision::kNoSegment)
        continue;
      EXPECT_GE(same[s], last);
      last = same[s] + 1;
      EXPECT_EQ(plan.position[same[s]], was.position[s]);
      EXPECT_EQ(plan.position[same[s] + 1], was.position[s + 1]);
      EXPECT_EQ(plan.heightMm[same[s] + 1], was.heightMm[s + 1]);
      ++kept;
    }
    all += its.size();
  }
  EXPECT_GT(filled, 100'000u);
  EXPECT_GT(kept, all / 2);
}

// Of the same plan, all is there; of one that has nothing of it, nothing is.
TEST(GrowingPart, GrowsOnFromAllOrNothing) {
  const plan::ToolPlan was = randomBeads(3, 25), other = randomBeads(77, 25), none;
  const GrowingPart before(was, 0.25, {});
  for (const plan::ToolPlan* plan : {&was, &other, &none}) {
    const GrowingPart grown(*plan, before, was, {}), fresh(*plan, 0.25, {});
    ASSERT_EQ(grown.grid().cellCount(), fresh.grid().cellCount());
    for (std::size_t cell = 0; cell < fresh.grid().cellCount(); ++cell)
      ASSERT_EQ(grown.filledAt(cell), fresh.filledAt(cell));
  }
  const GrowingPart nothing(none, 0.25, {}), grown(was, nothing, none, {});
  for (std::size_t cell = 0; cell < before.grid().cellCount(); ++cell)
    ASSERT_EQ(grown.filledAt(cell), before.filledAt(cell));
}
