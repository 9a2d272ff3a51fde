// The bead that fills the nozzle before the part begins is waste: it is not the part, it may be
// unsupported, and a program with it does not prime at rest. Retracted filament gives the same
// print.
#include "program/dialect.h"
#include "program/extruder.h"
#include "replay/beads.h"
#include "replay/beside_motion.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

// The box with a bead of 20 mm before it, 18 mm beside the plate and 10 mm above it.
test::Scene primedScene() {
  test::Scene s = test::boxScene(1);
  plan::ToolPlan plan;
  test::addPath(plan, {{-10, -24, 10}, {10, -24, 10}}, s.process.beadWidthMm,
                s.process.layerHeightMm, s.process.speedMmPerS, 0);
  plan.paths[0].kind = plan::PathKind::Prime;
  const std::size_t count = plan.waypointCount();
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(plan.position, s.plan.position);
  append(plan.direction, s.plan.direction);
  append(plan.widthMm, s.plan.widthMm);
  append(plan.heightMm, s.plan.heightMm);
  append(plan.speedMmPerS, s.plan.speedMmPerS);
  for (plan::ToolPath path : s.plan.paths) {
    path.first += count;
    plan.paths.push_back(path);
  }
  s.plan = plan;
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  return s;
}

Verification verify(const test::Scene& s, const plan::ReadProgram& read) {
  return replayProgram(
      {read, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
      ReplayThresholds{}, {});
}

TEST(Waste, IsNotThePartAndNeedsNoSupport) {
  const test::Scene s = primedScene();
  EXPECT_EQ(plannedPrimeMm3(s.plan, s.trajectory, s.process), 0.0);
  const double waste = 20.0 * process::beadArea(s.process.beadWidthMm, s.process.layerHeightMm);
  for (const program::Dialect& d : test::dialectsFor("urscript")) {
    SCOPED_TRACE(d.id);
    const plan::Program program = program::writeProgram(
        d.id, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
    const plan::ReadProgram read =
        program::readProgram(d.id, program.files, process::Tooling(s.process));
    double standing = 0.0;
    for (const plan::ProgramPause& pause : read.pauses)
      standing += pause.volumeMm3;
    EXPECT_EQ(standing, 0.0);
    const Verification v = verify(s, read);
    EXPECT_TRUE(v.passed) << findingsText(v);
    EXPECT_NEAR(v.massRatio, 1.0, 0.01);
    EXPECT_NEAR(v.supportMm3, waste, 0.01 * waste);
    EXPECT_EQ(v.unsupportedFraction, 0.0);
  }
}

// It falls beside the plate: the head may be where it was deposited, and nothing rests on it.
TEST(Waste, IsNotThereWhereItFalls) {
  const test::Scene s = primedScene();
  std::vector<BeadPiece> pieces(3);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    BeadPiece& piece = pieces[p];
    piece.from = {static_cast<double>(p), -24, 10};
    piece.to = piece.from + Eigen::Vector3d::UnitX();
    piece.fromDirection = piece.toDirection = Eigen::Vector3d::UnitZ();
    piece.fromHeightMm = piece.toHeightMm = 0.8f;
    piece.run = p < 2 ? 0 : 1;
    piece.waste = p < 2;
  }
  const GroundProbe ground(s.platform);
  std::vector<BeadPiece> left = pieces;
  dropFallen(left, ground);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left.front().run, 1u);
  // On the plate it stays, and so do pieces that are not waste.
  left = pieces;
  for (BeadPiece& piece : left)
    piece.from.y() = piece.to.y() = 0.0, piece.from.z() = piece.to.z() = 0.8;
  dropFallen(left, ground);
  EXPECT_EQ(left.size(), 3u);
  left = pieces;
  left.front().waste = left[1].waste = false;
  dropFallen(left, ground);
  EXPECT_EQ(left.size(), 3u);
}

// The same bead as a part of the print is unsupported.
TEST(Waste, BeadThatIsNotWasteIsUnsupported) {
  test::Scene s = primedScene();
  s.plan.paths[0].kind = plan::PathKind::Support;
  const plan::Program program = program::writeProgram(
      "urscript", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  const Verification v =
      verify(s, program::readProgram("urscript", program.files, process::Tooling(s.process)));
  EXPECT_FALSE(v.passed);
  EXPECT_GT(v.unsupportedFraction, 0.05);
}

TEST(DrawnBack, GivesTheSamePrint) {
  test::Scene s = test::boxScene(1);
  s.process.retractMm = 1.5;
  for (const program::Dialect& d : test::dialectsFor("urscript"))
    for (const char* extruder : {"outputs", "castelli-serial", "e-stream", "external-axis"}) {
      const bool own = d.extruders.empty();
      if (own ? extruder != std::string("outputs")
              : std::ranges::find(d.extruders, extruder) == d.extruders.end())
        continue;
      SCOPED_TRACE(std::string(d.id) + " with " + extruder);
      program::ProgramInput in{s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"};
      if (!own)
        in.options.own["extruder"] = std::string(extruder);
      const plan::Program program = program::writeProgram(d.id, in);
      const plan::ReadProgram read =
          program::readProgram(d.id, program.files, process::Tooling(s.process));
      const Verification v = verify(s, read);
      EXPECT_TRUE(v.passed) << findingsText(v);
      EXPECT_NEAR(v.massRatio, 1.0, 0.01);

      // A return that is lost is found; an amount that runs on (E) brings it with the next bead.
      const std::string word = extruder[0] == 'c'                    ? "\"G30n\""
                               : std::string("e-stream") == extruder ? " 0.150000 1.50000\n"
                                                                     : "";
      if (word.empty())
        continue;
      auto files = program.files;
      std::string& text = files.back().text;
      const std::size_t at = text.find(word);
      ASSERT_NE(at, std::string::npos) << text.substr(0, 3000);
      const std::size_t begin = text.rfind('\n', at) + 1;
      text.erase(begin, text.find('\n', at) + 1 - begin);
      EXPECT_FALSE(
          verify(s, program::readProgram(d.id, files, process::Tooling(s.process))).passed);
    }
}

// The nozzle moves back over its bead before it lifts, in every format: nothing more is deposited,
// and a missing wipe is found at its place.
TEST(Wipe, IsAMotionThatLaysNothing) {
  test::Scene s = test::boxScene(1);
  s.trajectory = test::walk(s.plan, s.cell, s.process, 3.0, 3.0);
  s.process.retractMm = 1.5;
  const auto wipe = std::ranges::find(s.trajectory.move, plan::MoveKind::Wipe);
  ASSERT_NE(wipe, s.trajectory.move.end());
  const auto first = static_cast<std::size_t>(wipe - s.trajectory.move.begin());
  EXPECT_EQ(s.trajectory.move[first - 1], plan::MoveKind::Print);
  EXPECT_EQ(s.trajectory.move[first + 2], plan::MoveKind::Wipe);
  EXPECT_EQ(s.trajectory.move[first + 3], plan::MoveKind::Linear);
  for (const program::Dialect& d : test::dialectsFor("urscript")) {
    SCOPED_TRACE(d.id);
    const plan::Program program = program::writeProgram(
        d.id, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
    const plan::ReadProgram read =
        program::readProgram(d.id, program.files, process::Tooling(s.process));
    const Verification v = verify(s, read);
    EXPECT_TRUE(v.passed) << findingsText(v);
    EXPECT_NEAR(v.massRatio, 1.0, 0.01);
    std::size_t motion = 0;
    while (motion < v.pointOf.size() && v.pointOf[motion] != first + 1)
      ++motion;
    ASSERT_LT(motion, read.motions.size());
    // Drawn back before it, where the format can.
    const auto drawn = std::ranges::find_if(read.pauses, [](const plan::ProgramPause& p) {
      return p.volumeMm3 == 0.0 && p.durationS > 0.0;
    });
    if (drawn != read.pauses.end()) {
      EXPECT_EQ(v.pointOf[drawn->before], first);
    }
    auto files = program.files;
    std::string& text = files[read.motions[motion].file].text;
    const std::size_t line = read.motions[motion].line;
    std::size_t begin = 0;
    for (std::size_t l = 1; l < line; ++l)
      begin = text.find('\n', begin) + 1;
    text.erase(begin, text.find('\n', begin) + 1 - begin);
    const Verification without =
        verify(s, program::readProgram(d.id, files, process::Tooling(s.process)));
    EXPECT_FALSE(without.passed);
    EXPECT_TRUE(std::ranges::any_of(without.places, [&](const TextPlace& p) {
      return p.line + 1 >= line && p.line <= line + 1;
    })) << findingsText(without);
  }
}

} // namespace
} // namespace voluta::replay
