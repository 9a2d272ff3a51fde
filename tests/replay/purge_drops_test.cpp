// Primes and purges that fall on the print, on the workpiece or on the plate.
#include "geometry/drop.h"
#include "plan/finding_kinds.h"
#include "platform/rod_shape.h"
#include "replay/event_programs.h"
#include "replay/purge_drops.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

using Eigen::AlignedBox3d, Eigen::Vector3d;

TEST(Drop, HitsBoxesBelowIt) {
  const AlignedBox3d box(Vector3d(-1, -2, 0), Vector3d(1, 2, 3));
  const Vector3d down = -Vector3d::UnitZ();
  EXPECT_TRUE(geometry::dropMeets({0, 0, 100}, down, box));
  EXPECT_TRUE(geometry::dropMeets({0, 0, 1}, down, box)) << "from within";
  EXPECT_TRUE(geometry::dropMeets({1, 2, 9}, down, box)) << "at its corner";
  EXPECT_FALSE(geometry::dropMeets({1.01, 0, 100}, down, box));
  EXPECT_FALSE(geometry::dropMeets({0, 0, -1}, down, box)) << "from below";
  EXPECT_TRUE(geometry::dropMeets({11, 0, 12}, {-1, 0, -1}, box)) << "a plate that is tilted";
  EXPECT_FALSE(geometry::dropMeets({16, 0, 12}, {-1, 0, -1}, box));
  EXPECT_FALSE(geometry::dropMeets({0, 0, 9}, down, AlignedBox3d()));
  EXPECT_TRUE(geometry::widened(AlignedBox3d(), 5.0).isEmpty());
  EXPECT_TRUE(geometry::dropMeets({5, 0, 9}, down, geometry::widened(box, 5.0)));
}

TEST(Drop, TargetsLeaveOutWasteAndHaveTheRod) {
  plan::ToolPlan plan = test::boxPlan(12.0, 11, 2, process::loadProcess("fdm-1.0"));
  platform::PlatformSolid rod;
  rod.rod = platform::straightRod(20.0, 200.0);
  const DropTargets targets = dropTargets(plan, rod);
  EXPECT_NEAR(targets.print.max().x(), 6.0, 1e-9);
  EXPECT_TRUE(
      targets.workpiece.isApprox(AlignedBox3d(Vector3d(-100, -10, -10), Vector3d(100, 10, 10))));
  EXPECT_TRUE(targets.plate.isEmpty());
  for (plan::ToolPath& path : plan.paths)
    path.kind = plan::PathKind::Prime;
  EXPECT_TRUE(dropTargets(plan, rod).print.isEmpty());
}

class PurgeDrops : public EventPrograms {
protected:
  // The point at which the first path is left behind.
  std::size_t travel() const {
    std::size_t i = 1;
    const auto& move = scene_.trajectory.move;
    while (!(move[i] == plan::MoveKind::Print && move[i + 1] != plan::MoveKind::Print))
      ++i;
    return i + 3;
  }
  static std::size_t count(const Verification& v, plan::FindingKind kind) {
    return static_cast<std::size_t>(std::ranges::count(v.findings, kind, &plan::Finding::kind));
  }
};

TEST_F(PurgeDrops, APrimeAbovePartIsRefused) {
  for (const char* format : {"urscript", "gcode-extended", "krl"}) {
    SCOPED_TRACE(format);
    const Verification beside = verify(read(test::textOf(programFor(format))));
    EXPECT_TRUE(beside.passed) << findingsText(beside);
    EXPECT_EQ(count(beside, plan::FindingKind::PurgeOnPart), 0u);
    // The same on a large plate.
    const platform::PlatformSolid small = std::exchange(scene_.platform, test::squarePlatform(200));
    const Verification onPlate = verify(read(test::textOf(programFor(format))));
    EXPECT_TRUE(onPlate.passed) << findingsText(onPlate);
    EXPECT_EQ(count(onPlate, plan::FindingKind::PurgeOnPlate), 1u);
    scene_.platform = small;
  }
  // The arm begins above the first waypoint.
  const auto dof = static_cast<std::ptrdiff_t>(scene_.trajectory.dof);
  std::vector<double>& joints = scene_.trajectory.joints;
  std::copy(joints.begin() + dof, joints.begin() + 2 * dof, joints.begin());
  for (const char* format : {"urscript", "krl"}) {
    const plan::ReadProgram program = read(test::textOf(programFor(format)));
    const Verification v = verify(program);
    EXPECT_FALSE(v.passed);
    ASSERT_EQ(count(v, plan::FindingKind::PurgeOnPart), 1u) << findingsText(v);
    const auto at =
        std::ranges::find(v.findings, plan::FindingKind::PurgeOnPart, &plan::Finding::kind);
    const auto prime = std::ranges::find_if(
        program.pauses, [](const plan::ProgramPause& p) { return p.volumeMm3 > 1.0; });
    EXPECT_EQ(v.places[static_cast<std::size_t>(at - v.findings.begin())].line, prime->line);
  }
}

TEST_F(PurgeDrops, APlannedPurgeAbovePartIsRefused) {
  scene_.trajectory.events = {
      {.point = travel(), .kind = plan::EventKind::Purge, .seconds = 4.0, .volumeMm3 = 50.0}};
  const Verification above = verify(read(test::textOf(programFor("urscript"))));
  EXPECT_FALSE(above.passed);
  EXPECT_EQ(count(above, plan::FindingKind::PurgeOnPart), 1u) << findingsText(above);
  test::moveSideways(scene_.trajectory, scene_.cell, travel() - 1);
  const Verification beside = verify(read(test::textOf(programFor("urscript"))));
  EXPECT_EQ(count(beside, plan::FindingKind::PurgeOnPart), 0u) << findingsText(beside);
}

// A purge before the first bead replaces the prime, in every dialect that can state one.
TEST_F(PurgeDrops, PurgeReplacesThePrime) {
  const double mm3 = process::primeFlow(scene_.process) * scene_.process.primeS;
  scene_.trajectory.events = {{.point = 1,
                               .kind = plan::EventKind::Purge,
                               .seconds = scene_.process.primeS,
                               .volumeMm3 = mm3}};
  for (const program::Dialect& dialect : test::dialectsFor("urscript")) {
    if (!dialect.tiltsNozzle)
      continue;
    SCOPED_TRACE(dialect.id);
    const Verification v = verify(read(test::textOf(programFor(dialect.id))));
    EXPECT_TRUE(v.passed) << findingsText(v);
  }
}

} // namespace
} // namespace voluta::replay
