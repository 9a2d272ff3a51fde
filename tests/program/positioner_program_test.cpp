// A plate that two axes tilt and turn, in every language that can state their positions.
#include "program_defects.h"
#include "program_fixture.h"
#include "read_programs.h"

#include "base/units.h"
#include "program/dialect.h"

namespace voluta::program {
namespace {

class Positioner : public test::ReadPrograms {};

TEST_F(Positioner, isReadBackWhereItWas) {
  usePositioner();
  appendRandomOnPositioner(3, 200);
  for (const char* format : {"rapid", "krl", "csv", "gcode-extended"}) {
    const plan::Program written = writeProgram(format, input());
    plan::ReadProgram back = readProgram(format, written.files, process::Tooling(process_));
    EXPECT_TRUE(back.complete) << format;
    for (const auto& d : back.defects)
      ADD_FAILURE() << format << ":" << d.line << ": " << base::english(d.reason);
    dropPieces(back);
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount()) << format;
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      expectTarget(back, i);
      const plan::ProgramMotion& m = back.motions[i];
      const robot::JointVector q = jointsAt(i);
      if (m.target == plan::TargetKind::Joints) {
        ASSERT_EQ(m.joints.size(), 8u) << format;
        EXPECT_LE((Eigen::Map<const Eigen::VectorXd>(m.joints.data(), 8) - q).norm(),
                  2e-6); // degrees with four decimals
      } else if (m.target != plan::TargetKind::ToolPoint) {
        ASSERT_EQ(m.target, plan::TargetKind::UnitPose) << format;
        ASSERT_EQ(m.externals.size(), 2u) << format;
        EXPECT_NEAR(m.externals[0], q[6], 1e-6);
        EXPECT_NEAR(m.externals[1], q[7], 1e-6);
      }
    }
  }
}

// The plate's own frame is the unit's: z is the last axis, with no frame in between.
TEST_F(Positioner, isOneMechanicalUnitInRapid) {
  usePositioner();
  appendRandomOnPositioner(3, 60);
  const std::string text = writeProgram("rapid", input()).files[0].text;
  EXPECT_NE(text.find("ActUnit STN1;"), std::string::npos);
  EXPECT_NE(text.find("PERS wobjdata wTable:=[FALSE,FALSE,\"STN1\",[[0,0,0],[1,0,0,0]],"
                      "[[0,0,0],[1,0,0,0]]];"),
            std::string::npos)
      << text.substr(0, 3000);
  EXPECT_NE(text.find("tilt is eax_a, turn is eax_b"), std::string::npos);
  EXPECT_NE(text.find("[[500,0,120],[1,0,0,0]]"), std::string::npos) << "where it is at 0";
}

// A table of the cell's own below an upright nozzle: its place comes from the cell, B and C are its
// axes.
TEST_F(Positioner, isTheTableOfGcodeWithBAndC) {
  platform::PlatformSolid plate;
  plate.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  cell_.emplace(robot::loadCell("five-axis", process_, plate));
  std::mt19937_64 random(8);
  std::normal_distribution<double> step(0.0, 1.0);
  std::vector<double> q{20, -10, 200, 0, 0.3, 1.0};
  append(plan::MoveKind::Joint, q, 1.0, 0.0);
  for (int i = 0; i < 100; ++i) {
    for (std::size_t j = 0; j < q.size(); ++j)
      q[j] += j < 3 ? step(random) : j == 3 ? 0.0 : 0.02 * step(random);
    append(plan::MoveKind::Linear, q, 0.5, 0.0);
  }
  const plan::Program written = writeProgram("gcode-bc", input());
  EXPECT_NE(written.files[0].text.find("plate over the tilt axis, mm: X0 Z20"), std::string::npos);
  plan::ReadProgram back = readProgram("gcode-bc", written.files, process::Tooling(process_));
  EXPECT_TRUE(back.complete);
  for (const auto& d : back.defects)
    ADD_FAILURE() << d.line << ": " << base::english(d.reason);
  dropPieces(back);
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  for (std::size_t i = 0; i < back.motions.size(); ++i)
    expectTarget(back, i);
}

TEST_F(Positioner, isRefusedByDialectsWithoutExternalAxes) {
  usePositioner();
  appendRandomOnPositioner(3, 60);
  for (const Dialect& d : dialects())
    if (!d.supportsExternalAxes) {
      EXPECT_THROW(writeProgram(d.id, input()), base::Error) << d.id;
    }
}

} // namespace
} // namespace voluta::program
