// A program that lays the beads of one that was judged before is lent them; any other is not.
#include "program/dialect.h"
#include "replay/run.h"
#include "replay/scene.h"
#include "replay/verification.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}

plan::ReadProgram boxProgram() {
  const test::Scene& s = scene();
  const plan::Program written =
      program::writeProgram("gcode-extended", {s.plan, s.trajectory, s.cell, s.process, "box"});
  return program::readProgram("gcode-extended", written.files, s.process);
}

// Is a program lent the beads of boxProgram after this change?
bool isLent(const std::function<void(plan::ReadProgram&)>& change) {
  const test::Scene& s = scene();
  JudgedRuns judged;
  for (const bool changed : {false, true}) {
    plan::ReadProgram program = boxProgram();
    if (changed)
      change(program);
    replayProgram({program, s.plan, s.trajectory, s.cell, s.process, s.part, s.platform}, {}, {},
                  &judged);
  }
  return judged.size() == 2 && judged[0]->laid == judged[1]->laid;
}

// The motion in the middle of those that do, or do not, lay something.
std::size_t middleOf(const plan::ReadProgram& program, bool extruding) {
  std::vector<std::size_t> found;
  for (std::size_t m = 1; m + 1 < program.motions.size(); ++m)
    if (program.motions[m].extruding == extruding)
      found.push_back(m);
  return found[found.size() / 2];
}

plan::ProgramMotion& bead(plan::ReadProgram& program) {
  return program.motions[middleOf(program, true)];
}

} // namespace

TEST(JudgedRuns, TheSameBeadsAreLent) {
  EXPECT_TRUE(isLent([](plan::ReadProgram&) {}));
  EXPECT_TRUE(isLent([](plan::ReadProgram& p) { bead(p).position.y() += 1e-3; }));
  EXPECT_TRUE(isLent([](plan::ReadProgram& p) { bead(p).volumeMm3 *= 1.0 + 5e-4; }));
}

TEST(JudgedRuns, AWayBetweenBeadsMayBeAnother) {
  EXPECT_TRUE(
      isLent([](plan::ReadProgram& p) { p.motions[middleOf(p, false)].position.z() += 2.0; }));
}

TEST(JudgedRuns, OtherMaterialIsNot) {
  for (const double times : {0.0, 0.9, 0.998, 1.002, 1.1, 3.0})
    EXPECT_FALSE(isLent([&](plan::ReadProgram& p) { bead(p).volumeMm3 *= times; })) << times;
  EXPECT_FALSE(isLent([](plan::ReadProgram& p) {
    bead(p).extruding = false;
    bead(p).volumeMm3 = 0.0;
  }));
}

TEST(JudgedRuns, ABeadMoreIsNot) {
  EXPECT_FALSE(isLent([](plan::ReadProgram& p) {
    plan::ProgramMotion& travel = p.motions[middleOf(p, false)];
    travel.extruding = true;
    travel.volumeMm3 = 1.0;
  }));
  EXPECT_FALSE(isLent([](plan::ReadProgram& p) {
    plan::ProgramMotion more = bead(p);
    more.position.z() += 5.0;
    p.motions.insert(p.motions.begin() + static_cast<std::ptrdiff_t>(middleOf(p, true)) + 1, more);
  }));
}

TEST(JudgedRuns, ABeadLessIsNot) {
  EXPECT_FALSE(isLent([](plan::ReadProgram& p) {
    p.motions.erase(p.motions.begin() + static_cast<std::ptrdiff_t>(middleOf(p, true)));
  }));
}

TEST(JudgedRuns, BeadsElsewhereAreNot) {
  EXPECT_FALSE(isLent([](plan::ReadProgram& p) { bead(p).position.y() += 1.0; }));
  // Each by less than a single one may be, all together by more than they may.
  EXPECT_FALSE(isLent([](plan::ReadProgram& p) {
    for (plan::ProgramMotion& m : p.motions)
      if (m.extruding)
        m.position.x() += 0.1;
  }));
}

} // namespace voluta::replay
