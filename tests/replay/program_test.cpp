// Whole programs through the verdict: sound ones pass, damaged ones are found at their line.
#include "base/run_context.h"
#include "base/units.h"
#include "helpers/all_seeds.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <regex>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}

test::ProgramText textOf(const std::string& format) {
  const test::Scene& s = scene();
  return test::textOf(program::writeProgram(
      format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"}));
}

Verification verify(const test::ProgramText& text, const base::RunContext& ctx = {}) {
  const test::Scene& s = scene();
  return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                        process::Tooling(s.process), s.part, s.platform},
                       ReplayThresholds{}, ctx);
}

// Line (1-based) of each trajectory point.
std::vector<std::size_t> motionLines(const test::ProgramText& text) {
  std::vector<std::size_t> lines;
  for (const auto& m : test::read(text, scene().process).motions)
    lines.push_back(m.line);
  return lines;
}

class EachDialect : public ::testing::TestWithParam<std::string> {
protected:
  // Points in the middle of a bead, at two or five places of the print.
  static std::vector<std::size_t> places() {
    const test::Scene& s = scene();
    std::vector<std::size_t> result;
    const std::vector<double> shares =
        test::allSeeds() ? std::vector{0.05, 0.3, 0.5, 0.7, 0.93} : std::vector{0.05, 0.7};
    for (const double share : shares) {
      const auto path = static_cast<std::size_t>(share * static_cast<double>(s.plan.paths.size()));
      const std::size_t waypoint = s.plan.paths[path].first + 5;
      result.push_back(static_cast<std::size_t>(
          std::find(s.trajectory.waypoint.begin(), s.trajectory.waypoint.end(), waypoint) -
          s.trajectory.waypoint.begin()));
    }
    return result;
  }

  void expectNamed(const Verification& v, std::size_t line) {
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(std::any_of(v.places.begin(), v.places.end(),
                            [&](TextPlace p) { return p.line + 1 >= line && p.line <= line + 1; }))
        << "line " << line << "\n"
        << findingsText(v);
  }
  // Streams of joints write some travels in pieces.
  static std::size_t motionTo(std::size_t point, const plan::ReadProgram& program) {
    const plan::Trajectory& t = scene().trajectory;
    std::size_t m = point;
    while (program.beadsByJoints && m + 1 < program.motions.size() &&
           !std::equal(program.motions[m].joints.begin(), program.motions[m].joints.end(),
                       t.at(point), [](double a, double b) { return std::abs(a - b) < 1e-6; }))
      ++m;
    return m;
  }
  // Every finding about the text is at the line that `damage` gives or the next motion's.
  using Damage = std::function<std::optional<std::size_t>(test::ProgramText&, std::size_t motion)>;
  void damagePlaces(const Damage& damage) {
    const test::ProgramText whole = textOf(GetParam());
    const plan::ReadProgram program = test::read(whole, scene().process);
    if (!program.beadsByJoints) {
      ASSERT_EQ(program.motions.size(), scene().trajectory.pointCount());
    }
    for (const std::size_t point : places()) {
      test::ProgramText text = whole;
      const std::optional<std::size_t> at = damage(text, motionTo(point, program));
      ASSERT_TRUE(at) << GetParam() << " point " << point;
      SCOPED_TRACE(GetParam() + " line " + std::to_string(*at) + ": " +
                   (*at <= text.lines.size() ? text.lines[*at - 1] : ""));
      expectNamed(verify(text), *at);
    }
  }
};

TEST_P(EachDialect, TheUndamagedProgramPasses) {
  const test::ProgramText text = textOf(GetParam());
  const Verification v = verify(text);
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_TRUE(v.findings.empty()) << findingsText(v);
  EXPECT_GE(v.coveredFraction, 0.98);
  EXPECT_NEAR(v.massRatio, 1.0, 0.01); // ramps from and to rest take their time
  EXPECT_LT(v.maxDeviationMm, 0.03);
  EXPECT_EQ(v.unsupportedFraction, 0.0);
  const plan::ReadProgram program = test::read(text, scene().process);
  EXPECT_EQ(v.armChecked, program.motions.front().target != plan::TargetKind::ToolPoint);
  EXPECT_EQ(v.places.size(), v.findings.size());
}

TEST_P(EachDialect, AMovedWaypoint) {
  damagePlaces([](test::ProgramText& text, std::size_t point) {
    return test::moveTarget(text, point, scene().process);
  });
}

TEST_P(EachDialect, TenWaypointsDeleted) {
  damagePlaces([](test::ProgramText& text, std::size_t point) {
    // Ten lines with motions; outputs and comments between them stay.
    const std::vector<std::size_t> lines = motionLines(text);
    const std::size_t first = lines[point];
    for (std::size_t n = point + 10; n-- > point;)
      text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(lines[n] - 1));
    // The place is the line of the motion that follows the gap.
    const std::vector<std::size_t> remaining = motionLines(text);
    return *std::lower_bound(remaining.begin(), remaining.end(), first);
  });
}

TEST_P(EachDialect, TwoWaypointsSwapped) {
  damagePlaces([](test::ProgramText& text, std::size_t point) {
    const std::vector<std::size_t> lines = motionLines(text);
    std::swap(text.lines[lines[point] - 1], text.lines[lines[point + 1] - 1]);
    return lines[point];
  });
}

TEST_P(EachDialect, OneSpeedTimesTen) {
  damagePlaces([](test::ProgramText& text, std::size_t point) {
    return test::tenfoldSpeed(text, point, scene().process);
  });
}

TEST_P(EachDialect, TheExtruderLeftOnOverATravel) {
  damagePlaces([](test::ProgramText& text, std::size_t point) {
    return test::extrudeOverTravel(text, point, scene().process);
  });
}

TEST_P(EachDialect, AFileCutShort) {
  damagePlaces([](test::ProgramText& text, std::size_t point) {
    const std::size_t line = motionLines(text)[point];
    text.lines.resize(line);
    return line;
  });
  // In the middle of a line, and only the end's last line missing.
  test::ProgramText text = textOf(GetParam());
  const std::vector<std::size_t> lines = motionLines(text);
  text.lines.resize(lines[100]);
  text.lines.back() = text.lines.back().substr(0, 15);
  expectNamed(verify(text), lines[100]);
  text = textOf(GetParam());
  text.lines.pop_back();
  EXPECT_FALSE(verify(text).passed);
  text.lines.clear();
  EXPECT_FALSE(verify(text).passed);
}

TEST_P(EachDialect, ThreadsDoNotMatter) {
  const test::ProgramText text = textOf(GetParam());
  const Verification a = verify(text);
  const Verification b = verify(text, base::RunContext({}, 2));
  EXPECT_EQ(findingsText(a), findingsText(b));
  EXPECT_EQ(a.coveredFraction, b.coveredFraction);
  EXPECT_EQ(a.maxDeviationMm, b.maxDeviationMm);
}

INSTANTIATE_TEST_SUITE_P(Replay, EachDialect, ::testing::ValuesIn(test::idsFor("urscript")),
                         [](const auto& i) {
                           return std::regex_replace(i.param, std::regex("-"), "_");
                         });

// ---- faults of a program although its text is as planned

Verification replayPlan(const test::Scene& s, const std::string& format = "csv",
                        const ReplayThresholds& thresholds = {}) {
  const plan::Program program = program::writeProgram(
      format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  const plan::ReadProgram read =
      program::readProgram(format, program.files, process::Tooling(s.process));
  return replayProgram(
      {read, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
      thresholds, base::RunContext());
}

bool hasKind(const Verification& v, const std::string& kind) {
  return std::any_of(v.findings.begin(), v.findings.end(),
                     [&](const plan::Finding& f) { return voluta::plan::reportId(f) == kind; });
}

TEST(Replay, AHeadDrivenIntoThePrintCollides) {
  test::Scene s = test::boxScene();
  // At the end, down into the block and out again.
  test::addPath(s.plan, {{0, 0, 0.9}, {2, 0, 0.9}}, 1.2, 0.8, 20, 9);
  s.trajectory = test::walk(s.plan, s.cell, s.process, 6.0);
  const Verification v = replayPlan(s);
  EXPECT_GE(v.collisions, 1u) << findingsText(v);
  const auto it = std::find_if(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
    return voluta::plan::englishReason(f).find("head and printed part") != std::string::npos;
  });
  ASSERT_NE(it, v.findings.end()) << findingsText(v);
  ASSERT_TRUE(it->where.has_value());
  EXPECT_LT((*it->where - Eigen::Vector3d(0, 0, 2)).norm(), 4.0);
}

TEST(Replay, ATipBelowThePlateCollides) {
  test::Scene s = test::boxScene(1);
  test::addPath(s.plan, {{-2, 0, -3.0}, {2, 0, -3.0}}, 1.2, 0.8, 20, 1);
  s.trajectory = test::walk(s.plan, s.cell, s.process, 6.0);
  const Verification v = replayPlan(s);
  EXPECT_TRUE(std::any_of(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
    return voluta::plan::reportId(f) == "collision" &&
           voluta::plan::englishReason(f).find("platform") != std::string::npos;
  })) << findingsText(v);
}

TEST(Replay, TooFastAJointIsALimitViolation) {
  test::Scene s = test::boxScene(1);
  for (double& t : s.trajectory.timeS)
    t *= 0.02;
  const Verification v = replayPlan(s);
  EXPECT_GE(v.limitViolations, 1u);
  EXPECT_TRUE(hasKind(v, "limit"));
  EXPECT_FALSE(v.passed);
}

TEST(Replay, AnotherConfigurationIsFound) {
  test::Scene s = test::boxScene(1);
  const plan::Program program = program::writeProgram(
      "csv", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  plan::ReadProgram read = program::readProgram("csv", program.files, process::Tooling(s.process));
  // The same nozzle, a whole turn of the last joint later.
  for (std::size_t m = 40; m < read.motions.size(); ++m)
    read.motions[m].joints[5] += read.motions[m].joints[5] > 0 ? -2 * base::kPi : 2 * base::kPi;
  const Verification v = replayProgram(
      {read, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
      ReplayThresholds{}, base::RunContext());
  EXPECT_TRUE(hasKind(v, "otherConfiguration")) << findingsText(v);
  EXPECT_FALSE(v.passed);
}

TEST(Replay, APrintInMidAirIsUnsupported) {
  test::Scene s = test::boxScene(2);
  s.plan = test::boxPlan(12.0, 11, 1, s.process, 9.6);
  s.part = test::box({-6, -6, 9.6}, {6, 6, 10.4});
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  const Verification v = replayPlan(s);
  EXPECT_NEAR(v.unsupportedFraction, 1.0, 1e-9);
  EXPECT_TRUE(hasKind(v, "unsupported"));
  EXPECT_TRUE(hasKind(v, "longBridge"));
  EXPECT_GT(v.longestUnsupportedMm, s.process.bridgeMm);
  EXPECT_GE(v.coveredFraction, 0.97);
}

// Found where a process bridges less than the longest of the unsupported beads, and only there.
TEST(Replay, ABridgeIsAsLongAsTheProcessLays) {
  test::Scene s = test::boxScene(2);
  s.plan = test::boxPlan(12.0, 11, 1, s.process, 9.6);
  s.part = test::box({-6, -6, 9.6}, {6, 6, 10.4});
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  const double longest = replayPlan(s).longestUnsupportedMm;
  for (const double more : {-0.5, 0.5}) {
    s.process.bridgeMm = longest + more;
    const Verification v = replayPlan(s);
    EXPECT_DOUBLE_EQ(v.longestUnsupportedMm, longest);
    EXPECT_EQ(hasKind(v, "longBridge"), more < 0.0);
  }
}

// Beyond five times what the process bridges, unless a larger share was allowed.
TEST(Replay, ABeadThatHangsFarCountsWhateverItsShare) {
  test::Scene s = test::boxScene(8);
  const double top = s.plan.position.back().z();
  test::addPath(s.plan, {{-6, 0, top + 4}, {6, 0, top + 4}}, 1.2, 0.8, 20, 9);
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  for (const auto& [bridgeMm, allowed] : {std::pair(2.0, 0.02), {4.0, 0.02}, {2.0, 0.05}}) {
    s.process.bridgeMm = bridgeMm;
    ReplayThresholds thresholds;
    thresholds.unsupportedMax = allowed;
    const Verification v = replayPlan(s, "csv", thresholds);
    EXPECT_LT(v.unsupportedFraction, 0.02);
    EXPECT_NEAR(v.longestUnsupportedMm, 12.0, 0.5);
    EXPECT_EQ(hasKind(v, "unsupported"), bridgeMm == 2.0 && allowed == 0.02);
    EXPECT_TRUE(hasKind(v, "longBridge"));
  }
}

// Layers much lower than beads are wide: cells by the width alone would hide the layer below.
class ThinLayers : public ::testing::TestWithParam<double> {
protected:
  static constexpr double kSide = 16.0, kTall = 3.0;
  static process::Process thinProcess() {
    test::usesSourceTreeResources();
    process::Process p = process::loadProcess("fdm-0.35");
    p.layerHeightMm = GetParam();
    return p;
  }
  // `lift`: of the topmost layer, mm.
  static test::Scene boxOf(const process::Process& p, double lift) {
    robot::Cell cell = robot::loadCell("ur5-fixed", p, test::squarePlatform(kSide));
    const int layers = static_cast<int>(std::lround(kTall / p.layerHeightMm));
    const int lines =
        static_cast<int>(std::lround(kSide / process::hatchOf(p.beadWidthMm, p.layerHeightMm)));
    plan::ToolPlan plan = test::boxPlan(kSide, lines, layers, p);
    for (const plan::ToolPath& path : plan.paths)
      if (path.layer == layers - 1)
        for (std::size_t w = path.first; w < path.first + path.count; ++w)
          plan.position[w].z() += lift;
    const double half = 0.5 * kSide;
    geometry::TriangleMesh part =
        test::box({-half, -half, 0}, {half, half, layers * p.layerHeightMm});
    plan::Trajectory trajectory = test::walk(plan, cell, p);
    return {p,
            std::move(cell),
            std::move(part),
            std::move(plan),
            std::move(trajectory),
            test::squarePlatform(kSide)};
  }
};

TEST_P(ThinLayers, ASolidBoxPasses) {
  const process::Process p = thinProcess();
  const Verification v = replayPlan(boxOf(p, 0.0));
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_LT(v.unsupportedFraction, 0.001);
  EXPECT_LE(v.pitchMm, 0.5 * p.layerHeightMm);
}

TEST_P(ThinLayers, CellsAreSizedByTheActualLayers) {
  test::Scene s = boxOf(thinProcess(), 0.0);
  s.process.layerHeightMm = 0.35;
  const Verification v = replayPlan(s);
  EXPECT_LE(v.pitchMm, 0.5 * GetParam() + 1e-6);
  EXPECT_LT(v.unsupportedFraction, 0.001);
}

TEST_P(ThinLayers, ALayerThatFloatsIsFound) {
  const process::Process p = thinProcess();
  const Verification v = replayPlan(boxOf(p, p.layerHeightMm));
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(hasKind(v, "unsupported")) << findingsText(v);
  EXPECT_NEAR(v.unsupportedFraction, p.layerHeightMm / kTall, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Heights, ThinLayers, ::testing::Values(0.25, 0.2));

TEST(Replay, TheUsualProcessKeepsItsCells) {
  test::Scene s = test::boxScene(1);
  EXPECT_EQ(replayPlan(s).pitchMm, 0.25 * s.process.beadWidthMm);
}

TEST(Replay, AProgramWithoutMotionsIsOneFindingThatCountsThePoints) {
  const test::Scene& s = scene();
  plan::ReadProgram nothing;
  nothing.format = "csv";
  nothing.complete = true;
  const Verification v = replayProgram(
      {nothing, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform}, {},
      {});
  EXPECT_FALSE(v.passed);
  const auto found =
      std::ranges::find(v.findings, plan::FindingKind::NoMotions, &plan::Finding::kind);
  ASSERT_NE(found, v.findings.end()) << findingsText(v);
  EXPECT_EQ(found->count, s.trajectory.pointCount());
  const TextPlace place = v.places[static_cast<std::size_t>(found - v.findings.begin())];
  EXPECT_EQ(place.file, 0u);
  EXPECT_EQ(place.line, 1u);
  EXPECT_EQ(v.coveredFraction, 0.0);
}

TEST(Replay, MaterialOfSupportsAndSkirtsIsNotThePart) {
  for (const plan::PathKind kind :
       {plan::PathKind::Support, plan::PathKind::Skirt, plan::PathKind::Prime}) {
    test::Scene s = test::boxScene(1);
    for (plan::ToolPath& path : s.plan.paths)
      path.kind = kind;
    const Verification v = replayPlan(s);
    EXPECT_EQ(v.depositedMm3, 0.0);
    EXPECT_GT(v.supportMm3, 100.0);
    EXPECT_LT(v.coveredFraction, 1e-6);
  }
}

TEST(Replay, CancelsAndRefusesBrokenInput) {
  const test::Scene& s = scene();
  const plan::Program program = program::writeProgram(
      "csv", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  const plan::ReadProgram read =
      program::readProgram("csv", program.files, process::Tooling(s.process));
  base::CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(replayProgram({read, s.plan, s.trajectory, s.cell, process::Tooling(s.process),
                              s.part, s.platform},
                             ReplayThresholds{}, base::RunContext(cancel, 1)),
               base::Cancelled);
  const geometry::TriangleMesh nothing;
  EXPECT_THROW(replayProgram({read, s.plan, s.trajectory, s.cell, process::Tooling(s.process),
                              nothing, s.platform},
                             ReplayThresholds{}, base::RunContext()),
               base::Error);
}

} // namespace
} // namespace voluta::replay
