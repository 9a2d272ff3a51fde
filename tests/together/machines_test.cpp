// Conflicts of two arms against dense samples of their motions.
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "robot/body.h"
#include "robot/cell.h"
#include "robot/robot_model.h"
#include "together/poses.h"
#include "together/together.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::together {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kClearanceMm = 15.0;

plan::ToolPlan oneBead() {
  plan::ToolPlan plan;
  for (int k = 0; k <= 20; ++k) {
    plan.position.emplace_back(60.0 + k, 0.0, 0.8);
    plan.direction.push_back(Vector3d::UnitZ());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(0.8f);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back({.first = 0, .count = 21});
  return plan;
}

// A UR5 that moves at random about its pose at home.
struct Arm {
  explicit Arm(unsigned seed, const Isometry3d& place)
      : process(process::loadProcess("fdm-1.0")),
        cell(std::make_shared<robot::Cell>(robot::loadCell(
            "ur5-moving", process, {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}))),
        plan(std::make_shared<plan::ToolPlan>(oneBead())),
        machine{cell,
                std::make_shared<collision::CellCollision>(*cell, process),
                plan,
                std::make_shared<plan::Trajectory>(randomMotion(seed)),
                std::make_shared<collision::GrowingPart>(*plan, 0.6, base::RunContext()),
                place} {
    for (std::size_t i = 0; i < machine.trajectory->pointCount(); ++i)
      rests.point.push_back(i);
    rests.filledFrom.assign(rests.point.size(), 0);
  }

  plan::Trajectory randomMotion(unsigned seed) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-0.6, 0.6), base(-1.2, 1.2);
    plan::Trajectory t;
    t.dof = cell->dof();
    for (int i = 0; i < 5; ++i) {
      robot::JointVector q = cell->home();
      for (Eigen::Index k = 0; k < q.size(); ++k)
        q[k] += k == 0 ? base(random) : angle(random);
      t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
      t.timeS.push_back(i);
      t.move.push_back(plan::MoveKind::Joint);
      t.waypoint.push_back(plan::kNoWaypoint);
      t.extrudedMm3.push_back(0.0);
    }
    return t;
  }

  std::vector<Frames> samples(std::size_t segment) const {
    std::vector<Frames> all;
    visitPoses(machine, segment, segment + 1, 20.0,
               [&](const Frames& frames) { all.push_back(frames); });
    return all;
  }

  process::Process process;
  std::shared_ptr<const robot::Cell> cell;
  std::shared_ptr<const plan::ToolPlan> plan;
  PlacedMotion machine;
  Rests rests;
};

double minDistance(const Arm& a, const std::vector<Frames>& as, const Arm& b,
                   const std::vector<Frames>& bs, double capMm) {
  double minimum = capMm;
  for (std::size_t i = 0; i < a.cell->bodies().size(); ++i)
    for (std::size_t j = 0; j < b.cell->bodies().size(); ++j) {
      const robot::Body &one = a.cell->bodies()[i], &other = b.cell->bodies()[j];
      if (!isMoved(*a.cell, one) || !isMoved(*b.cell, other))
        continue;
      for (const Frames& f : as)
        for (const Frames& g : bs)
          minimum =
              std::min(minimum, a.machine.collision->distanceToOther(
                                    static_cast<int>(i), f[static_cast<std::size_t>(one.frame)],
                                    *b.machine.collision, static_cast<int>(j),
                                    g[static_cast<std::size_t>(other.frame)], minimum));
    }
  return minimum;
}

Isometry3d opposite(double apartMm) {
  Isometry3d place = Isometry3d::Identity();
  place.translation() = Vector3d(apartMm, 0.0, 0.0);
  place.rotate(Eigen::AngleAxisd(M_PI, Vector3d::UnitZ()));
  return place;
}

TEST(Machines, CloseSegmentsConflict) {
  // Beyond the clearance: two cells, the steps of both, steps of the samples, the eroded head.
  const double slackMm = std::sqrt(3.0) * kSweptCellMm + 4.0 + 20.0 + 1.0;
  std::size_t near = 0, far = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const Arm a(2 * seed, Isometry3d::Identity()), b(2 * seed + 1, opposite(1050.0));
    const FoundConflicts found =
        conflictsOf(a.machine, a.rests, b.machine, b.rests, {kClearanceMm, {}}, {});
    for (std::size_t i = 0; i < a.rests.segments(); ++i)
      for (std::size_t j = 0; j < b.rests.segments(); ++j) {
        const double mm = minDistance(a, a.samples(i), b, b.samples(j), 100.0);
        const bool conflict = found.table.moving.at(i, j);
        EXPECT_TRUE(conflict || mm >= kClearanceMm) << mm;
        EXPECT_TRUE(!conflict || mm < kClearanceMm + slackMm) << mm;
        if (conflict && found.table.aRests.at(i, j))
          ++near;
        (conflict ? near : far) += 1;
        EXPECT_TRUE(conflict || (!found.table.aRests.at(i, j) && !found.table.bRests.at(i, j)));
      }
  }
  EXPECT_GT(near, 20u);
  EXPECT_GT(far, 20u);
}

TEST(Machines, FarApartTheyNeedNoMarks) {
  const Arm a(1, Isometry3d::Identity()), b(2, opposite(4000.0));
  const Plan plan = planTogether(std::array{a.machine, b.machine}, {}, {});
  ASSERT_TRUE(plan.order);
  EXPECT_TRUE(plan.order->meetings.empty());
}

TEST(Machines, OnTopOfEachOtherThereIsAnObstruction) {
  const Arm a(1, Isometry3d::Identity()), b(1, Isometry3d::Identity());
  const Plan plan = planTogether(std::array{a.machine, b.machine}, {}, {});
  EXPECT_FALSE(plan.order);
  ASSERT_TRUE(plan.obstruction);
}

// The nozzle of the one is where the other's bead is: it may come there only before the bead.
TEST(Machines, PrintedMaterialCountsFromItsTimeOn) {
  const Arm a(1, Isometry3d::Identity());
  Arm b(1, Isometry3d::Identity());
  // Puts the second machine so that the tip of the first one's home is below the middle of its
  // bead.
  const Frames frames = framesAt(a.machine, 0);
  const Vector3d tip = frames[static_cast<std::size_t>(a.cell->toolFrame())].translation();
  const Vector3d bead =
      framesAt(b.machine, 0)[static_cast<std::size_t>(b.cell->workFrame())] * Vector3d(70, 0, -0.5);
  Isometry3d place = Isometry3d::Identity();
  place.translation() = tip - bead;
  PlacedMotion moved = b.machine;
  moved.shared_T_world = place;
  const StaticConflicts found = staticConflicts(a.machine, a.rests, moved, {}, {});
  EXPECT_NE(found.restMeets.front(), kNever);
  EXPECT_GT(found.restMeets.front(), 0u);
  EXPECT_LE(found.restMeets.front(), 21u);
  EXPECT_LE(found.segmentMeets.front(), found.restMeets.front());
}

} // namespace
} // namespace voluta::together
