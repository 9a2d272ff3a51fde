// Programs for a plate that slides under the nozzle, and for an arm that rides along past a plate.
#include "base/run_context.h"
#include "base/units.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "replay/executed_path.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace voluta::replay {
namespace {

constexpr double kFarMm = 120.0;

// The box, printed while the slide moves to 120 mm and back.
const test::Scene& slid(const std::string& cell) {
  static std::map<std::string, test::Scene> known;
  if (const auto made = known.find(cell); made != known.end())
    return made->second;
  const auto make = [&] {
    test::Scene s = test::boxScene(2, cell);
    plan::Trajectory& t = s.trajectory;
    std::vector<robot::JointVector> solutions;
    // Half a turn about the nozzle keeps the wrist from stretching.
    const Eigen::AngleAxisd about(base::kPi, Eigen::Vector3d::UnitZ());
    robot::JointVector near = s.cell.home();
    const std::size_t n = t.pointCount();
    for (std::size_t i = 0; i < n; ++i) {
      const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
      robot::JointVector there = near;
      there[6] = kFarMm * std::sin(base::kPi * static_cast<double>(i) / static_cast<double>(n - 1));
      s.cell.inverse(s.cell.work_T_tool(q) * about, there, solutions);
      base::require(!solutions.empty(), "scene: in reach");
      near =
          *std::min_element(solutions.begin(), solutions.end(), [&](const auto& a, const auto& b) {
            return (a - there).squaredNorm() < (b - there).squaredNorm();
          });
      std::copy(near.data(), near.data() + near.size(),
                t.joints.begin() + static_cast<std::ptrdiff_t>(i) * t.dof);
    }
    return s;
  };
  return known.emplace(cell, make()).first->second;
}

class Slide : public testing::TestWithParam<const char*> {
protected:
  static const test::Scene& slid() { return replay::slid(GetParam()); }

  static Verification replayed(const plan::ReadProgram& program) {
    const test::Scene& s = slid();
    return replayProgram(
        {program, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
        ReplayThresholds{}, base::RunContext());
  }

  static plan::ReadProgram programOf(const std::string& format) {
    const test::Scene& s = slid();
    const plan::Program written = program::writeProgram(
        format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
    return program::readProgram(format, written.files, process::Tooling(s.process));
  }
};

INSTANTIATE_TEST_SUITE_P(Cells, Slide, testing::Values("kr10-r1100-slide", "kr10-r1100-track"),
                         [](const auto& one) {
                           return std::string(one.param).substr(sizeof("kr10-r1100"));
                         });

} // namespace

TEST_P(Slide, ABoxPrintedOnItPasses) {
  for (const char* format : {"krl", "rapid", "csv"}) {
    const Verification v = replayed(programOf(format));
    EXPECT_TRUE(v.passed) << format << findingsText(v);
    EXPECT_TRUE(v.armChecked) << format;
    EXPECT_LE(v.maxDeviationMm, 0.02) << format;
    EXPECT_EQ(v.collisions, 0u) << format;
  }
}

// The slide is at its position in the text, in mm: as far as in the plan.
TEST_P(Slide, PositionEqualsTheTextInMm) {
  for (const char* format : {"krl", "rapid", "csv"}) {
    const ExecutedPath path = executeProgram(programOf(format), slid().cell, base::RunContext());
    EXPECT_TRUE(path.violations.empty()) << format;
    double maximum = 0.0;
    for (std::size_t m = 0; m < path.motionCount(); ++m)
      maximum = std::max(maximum, path.jointsAt(m)[6]);
    EXPECT_NEAR(maximum, kFarMm, 0.5) << format;
  }
}

TEST_P(Slide, AnOffsetOfAMillimetreIsFound) {
  for (const char* format : {"krl", "rapid"}) {
    plan::ReadProgram program = programOf(format);
    program.motions.at(60).externals.at(0) += base::degreesToRadians(1.0); // as texts have mm
    const Verification v = replayed(program);
    EXPECT_FALSE(v.passed) << format;
    EXPECT_TRUE(std::any_of(
        v.findings.begin(), v.findings.end(),
        [](const plan::Finding& f) { return plan::reportId(f) == "externalAxisMoved"; }))
        << format << findingsText(v);
  }
}

// The same numbers in a cell whose axis carries the other thing are another cell's.
TEST(SlideOfAnotherCell, IsNotTakenForThisOne) {
  for (const char* format : {"krl", "rapid"}) {
    const test::Scene &arm = slid("kr10-r1100-track"), &plate = slid("kr10-r1100-slide");
    const auto read = [&](const test::Scene& s) {
      return program::readProgram(
          format,
          program::writeProgram(format,
                                {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"})
              .files,
          process::Tooling(s.process));
    };
    const auto outOfReach = [](const ExecutedPath& path) {
      return std::any_of(path.violations.begin(), path.violations.end(),
                         [](const auto& v) { return v.kind == LimitKind::OutOfReach; });
    };
    EXPECT_TRUE(outOfReach(executeProgram(read(arm), plate.cell, base::RunContext()))) << format;
    EXPECT_FALSE(outOfReach(executeProgram(read(arm), arm.cell, base::RunContext()))) << format;
  }
}

} // namespace voluta::replay
