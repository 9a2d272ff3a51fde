// Spirals: closed beads of layers joined to one bead of rising height.
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "toolpath/order/spiral.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace {

using namespace voluta;
using Eigen::Vector3d;
using plan::FindingKind;

constexpr double kHeight = 0.8, kWidth = 1.2;

struct Ring {
  double radius = 15.0, z = 0.0; // z: of the tips
  double begin = 0.0;            // angle [rad]
  bool backwards = false;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double wave = 0.0; // amplitude of three lobes
};

void append(toolpath::Assembled& to, const Ring& ring, int layer) {
  constexpr int kPoints = 90;
  plan::ToolPath path;
  path.first = to.plan.waypointCount();
  path.count = kPoints + 1;
  path.layer = path.patch = layer;
  path.closed = true;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kPoints) / kPoints,
                 a = ring.begin + (ring.backwards ? -angle : angle),
                 r = ring.radius + ring.wave * std::cos(3 * a);
    to.plan.position.emplace_back(ring.centre.x() + r * std::cos(a),
                                  ring.centre.y() + r * std::sin(a), ring.z);
    to.plan.direction.push_back(Vector3d::UnitZ());
    to.clearDirection.push_back(Vector3d::UnitZ());
    to.plan.widthMm.push_back(static_cast<float>(kWidth));
    to.plan.heightMm.push_back(static_cast<float>(kHeight));
    to.plan.speedMmPerS.push_back(20.0f);
  }
  to.plan.paths.push_back(path);
}

toolpath::Assembled tube(int layers) {
  toolpath::Assembled all;
  for (int k = 0; k < layers; ++k)
    append(all, {.z = (k + 1) * kHeight}, k);
  return all;
}

double volumeOf(const plan::ToolPlan& plan) {
  double mm3 = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      mm3 += process::beadVolume(process::beadArea(plan.widthMm[i - 1], plan.heightMm[i - 1]),
                                 process::beadArea(plan.widthMm[i], plan.heightMm[i]),
                                 (plan.position[i] - plan.position[i - 1]).norm());
  return mm3;
}

TEST(Spiral, ATubeIsOneHelixOnALevelTurnAndUnderALevelTurn) {
  constexpr int kLayers = 10;
  toolpath::Assembled spiral = tube(kLayers);
  EXPECT_EQ(toolpath::joinSpiral(spiral, 3), std::nullopt);
  const plan::ToolPlan& plan = spiral.plan;
  ASSERT_EQ(plan.paths.size(), 1u);
  EXPECT_FALSE(plan.paths.front().closed);
  EXPECT_EQ(plan.paths.front().count, plan.waypointCount());
  EXPECT_EQ(spiral.clearDirection.size(), plan.waypointCount());
  double turned = 0.0; // in turns
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    const Vector3d& p = plan.position[i];
    if (i > 0) {
      const Vector3d& before = plan.position[i - 1];
      turned +=
          std::atan2(before.x() * p.y() - before.y() * p.x(), before.head<2>().dot(p.head<2>())) /
          (2 * std::numbers::pi);
    }
    EXPECT_NEAR(p.z() / kHeight, std::clamp(turned, 1.0, 1.0 * kLayers), 1e-6);
    EXPECT_NEAR(p.head<2>().norm(), 15.0, 1e-6);
    const double gap = turned <= 1.0             ? 1.0 // on the plate
                       : turned <= 2.0           ? turned - 1.0
                       : turned <= 1.0 * kLayers ? 1.0
                                                 : kLayers + 1.0 - turned;
    if (std::abs(turned - 1.0) > 1e-6) {
      EXPECT_NEAR(plan.heightMm[i] / kHeight, std::max(gap, 0.1), 1e-5) << turned;
    }
  }
  EXPECT_NEAR(turned, kLayers + 0.9, 0.02);
}

TEST(Spiral, BeginsAboveTheBottomAndEndsBelowTwoTowers) {
  toolpath::Assembled all;
  for (int k = 0; k < 12; ++k) {
    append(all, {.z = (k + 1) * kHeight}, k);
    if (k < 3 || k >= 9)
      append(all, {.radius = 5.0, .z = (k + 1) * kHeight, .centre = {40.0, 0.0}}, k);
  }
  const double volume = volumeOf(all.plan);
  const std::optional<plan::Finding> finding = toolpath::joinSpiral(all, 3);
  EXPECT_EQ(all.plan.paths.size(), 6u + 1u + 6u);
  EXPECT_EQ(all.plan.paths[6].layer, 3);
  EXPECT_NEAR(volumeOf(all.plan), volume, 0.02 * volume);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->kind, FindingKind::SpiralEnds);
  EXPECT_FALSE(finding->blocking);
  EXPECT_NEAR(finding->where->z(), 10 * kHeight, 1e-6);
}

TEST(Spiral, ReportsAPartWithoutALoop) {
  toolpath::Assembled towers;
  for (int k = 0; k < 8; ++k)
    for (const double x : {-20.0, 20.0})
      append(towers, {.radius = 8.0, .z = (k + 1) * kHeight, .centre = {x, 0.0}}, k);
  const std::size_t paths = towers.plan.paths.size();
  const std::optional<plan::Finding> finding = toolpath::joinSpiral(towers, 3);
  EXPECT_EQ(towers.plan.paths.size(), paths);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->kind, FindingKind::SpiralEnds);
}

TEST(Spiral, InfillOfOneClosedBeadIsNoTurn) {
  toolpath::Assembled all = tube(8);
  for (int k = 0; k < 3; ++k)
    all.plan.paths[static_cast<std::size_t>(k)].kind = plan::PathKind::Infill;
  EXPECT_EQ(toolpath::joinSpiral(all, 3), std::nullopt);
  EXPECT_EQ(all.plan.paths.size(), 3u + 1u);
}

TEST(Spiral, EndsWhereALoopIsNotAboveTheLoopBefore) {
  toolpath::Assembled all;
  for (int k = 0; k < 8; ++k)
    append(all, {.radius = k < 4 ? 15.0 : 8.0, .z = (k + 1) * kHeight}, k);
  const std::optional<plan::Finding> finding = toolpath::joinSpiral(all, 0);
  EXPECT_EQ(all.plan.paths.size(), 2u) << "another spiral begins there";
  EXPECT_EQ(all.plan.paths[1].layer, 4);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->kind, FindingKind::SpiralInterrupted);
}

// Loops that drift, grow and change their outline, begun anywhere and in either direction.
TEST(Spiral, RandomStacksKeepTheirVolumeAndRiseSteadily) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int run = 0; run < 200; ++run) {
    toolpath::Assembled all;
    Ring ring{.radius = 18.0, .wave = 2.0};
    const int layers = 3 + static_cast<int>(8 * std::abs(unit(random)));
    for (int k = 0; k < layers; ++k) {
      ring.z += kHeight;
      ring.begin = 4 * unit(random);
      ring.backwards = unit(random) < 0.0;
      ring.radius += 0.3 * unit(random);
      ring.wave += 0.2 * unit(random);
      ring.centre += Eigen::Vector2d(0.2 * unit(random), 0.2 * unit(random));
      append(all, ring, k);
    }
    const double volume = volumeOf(all.plan);
    EXPECT_EQ(toolpath::joinSpiral(all, 0), std::nullopt) << run;
    ASSERT_EQ(all.plan.paths.size(), 1u) << run;
    EXPECT_NEAR(volumeOf(all.plan), volume, 0.03 * volume) << run;
    for (std::size_t i = 1; i < all.plan.waypointCount(); ++i) {
      const Vector3d step = all.plan.position[i] - all.plan.position[i - 1];
      EXPECT_GE(step.z(), -1e-6) << run;
      EXPECT_LT(step.norm(), 3.0) << run;
    }
  }
}

TEST(Spiral, KeepsTheOuterWallsAboveTheBottom) {
  layers::LayerStack stack;
  stack.patches.resize(5);
  std::vector<toolpath::PatchCover> covers(5);
  const auto bead = [](plan::PathKind kind, int ring, bool closed) {
    toolpath::Bead b{{}, kind, ring, closed};
    for (const double x : {0.0, 10.0, 0.0})
      b.points.push_back({{x, 0, 0}, Vector3d::UnitZ(), Vector3d::UnitZ(), kWidth, kHeight});
    return b;
  };
  for (std::size_t k = 0; k < 5; ++k) {
    stack.patches[k].layer = static_cast<int>(k);
    covers[k].beads = {bead(plan::PathKind::Wall, 0, true), bead(plan::PathKind::Infill, 0, false)};
    covers[k].beadVolumeMm3 = 2 * 20 * process::beadArea(kWidth, kHeight);
  }
  covers[4].beads.erase(covers[4].beads.begin()); // no wall: everything stays
  stack.patches[3].group = layers::kSupportGroup;
  const std::vector<plan::FillIntent> fill = toolpath::keepOuterWalls(stack, 2, false, covers);
  EXPECT_EQ(covers[1].beads.size(), 2u);
  EXPECT_EQ(covers[2].beads.size(), 1u);
  EXPECT_EQ(covers[3].beads.size(), 2u);
  EXPECT_EQ(covers[4].beads.size(), 1u);
  EXPECT_NEAR(fill.at(0).openMm3, 20 * process::beadArea(kWidth, kHeight), 1e-9);
}

// A square plate, and the closed wall half a bead inside it, with round corners.
layers::Patch plate(const Eigen::Vector2d& low, double size, int layer) {
  layers::Patch patch;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
    patch.surface.vertices.emplace_back(low.x() + size * x, low.y() + size * y, 0.0);
  patch.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  patch.layer = layer;
  return patch;
}
toolpath::Bead wallIn(const Eigen::Vector2d& low, double size) {
  toolpath::Bead bead{{}, plan::PathKind::Wall, 0, true};
  constexpr double kRound = 0.4;
  const double inner = size - kWidth - 2.0 * kRound;
  constexpr int kCorner = 4, kSide = 12;
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2d middle = low + Eigen::Vector2d::Constant(0.5 * kWidth + kRound) +
                                   inner * Eigen::Vector2d(corner == 1 || corner == 2, corner > 1);
    for (int k = 0; k <= kCorner; ++k) {
      const double a = 0.5 * std::numbers::pi * (corner + 2 + static_cast<double>(k) / kCorner);
      const Eigen::Vector2d p = middle + kRound * Eigen::Vector2d(std::cos(a), std::sin(a));
      bead.points.push_back(
          {{p.x(), p.y(), 0}, Vector3d::UnitZ(), Vector3d::UnitZ(), kWidth, kHeight});
    }
    const double a = 0.5 * std::numbers::pi * (corner + 3);
    const Eigen::Vector2d along(-std::sin(a), std::cos(a));
    for (int k = 1; k < kSide; ++k) {
      toolpath::BeadPoint next = bead.points.back();
      next.middle.head<2>() += inner / kSide * along;
      bead.points.push_back(next);
    }
  }
  bead.points.push_back(bead.points.front());
  return bead;
}

double lengthOf(const toolpath::Bead& bead) {
  double length = 0.0;
  for (std::size_t i = 1; i < bead.points.size(); ++i)
    length += (bead.points[i].middle - bead.points[i - 1].middle).norm();
  return length;
}

// Two towers that touch at a corner or along a side are one loop, whatever the rounding; apart,
// they are two.
TEST(Spiral, GoesOnWhereContoursTouch) {
  for (const auto& [other, touches] : {std::pair{Eigen::Vector2d(20.001, 20.0), true},
                                       {Eigen::Vector2d(20.0, 20.0), true},
                                       {Eigen::Vector2d(20.001, 6.0), true},
                                       {Eigen::Vector2d(20.5, 6.0), false},
                                       {Eigen::Vector2d(20.4, 20.4), false}}) {
    layers::LayerStack stack;
    stack.patches = {plate({0, 0}, 20.0, 0), plate(other, 20.0, 0)};
    std::vector<toolpath::PatchCover> covers(2);
    covers[0].beads = {wallIn({0, 0}, 20.0)};
    covers[1].beads = {wallIn(other, 20.0)};
    const double apart = lengthOf(covers[0].beads[0]) + lengthOf(covers[1].beads[0]);
    toolpath::keepOuterWalls(stack, 0, false, covers);
    EXPECT_EQ(covers[0].beads.size() + covers[1].beads.size(), touches ? 1u : 2u) << other;
    if (!touches || covers[0].beads.empty())
      continue;
    const toolpath::Bead& joined = covers[0].beads.front();
    EXPECT_TRUE(joined.closed);
    EXPECT_NEAR(lengthOf(joined), apart, 2.5 * kWidth) << "as long as both";
    for (std::size_t i = 1; i < joined.points.size(); ++i)
      EXPECT_LT((joined.points[i].middle - joined.points[i - 1].middle).norm(), 2.5 * kWidth);
    EXPECT_LT((joined.points.front().middle - joined.points.back().middle).norm(), 1e-9);
  }
}

TEST(Spiral, TakesTheOuterContourAloneOnRequest) {
  layers::LayerStack stack;
  stack.patches = {plate({0, 0}, 20.0, 0), plate({0, 0}, 20.0, 1), plate({30, 0}, 5.0, 1)};
  std::vector<toolpath::PatchCover> covers(3);
  covers[0].beads = {wallIn({0, 0}, 20.0)};
  covers[1].beads = {wallIn({5, 5}, 10.0), wallIn({0, 0}, 20.0)}; // a hole
  covers[2].beads = {wallIn({30, 0}, 5.0)};
  const double outer = lengthOf(covers[0].beads.front());
  toolpath::keepOuterWalls(stack, 0, true, covers);
  ASSERT_EQ(covers[0].beads.size(), 1u);
  ASSERT_EQ(covers[1].beads.size(), 1u);
  EXPECT_NEAR(lengthOf(covers[1].beads.front()), outer, 1e-9);
  EXPECT_TRUE(covers[2].beads.empty()) << "a second tower of that layer";
}

} // namespace
