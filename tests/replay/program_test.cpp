// Whole programs through the verdict: sound ones pass, damaged ones are found at their line.
#include "base/run_context.h"
#include "base/units.h"
#include "program/dialect.h"
#include "replay/scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene();
  return s;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

struct Text {
  std::string name;
  std::vector<std::string> lines;
};
Text textOf(const std::string& format) {
  const test::Scene& s = scene();
  const plan::Program program =
      program::writeProgram(format, {s.plan, s.trajectory, s.cell, s.process, "box"});
  return {program.files.at(0).name, linesOf(program.files.at(0).text)};
}

Verification verify(const std::string& format, const Text& text, const test::Scene& s,
                    const base::RunContext& ctx = {}) {
  std::string joined;
  for (const std::string& line : text.lines)
    joined += line + "\n";
  const plan::ReadProgram read = program::readProgram(format, {{text.name, joined}}, s.process);
  return replayProgram({read, s.plan, s.trajectory, s.cell, s.process, s.part, s.platform},
                       ReplayThresholds{}, ctx);
}

// Line (1-based) of each trajectory point.
std::vector<std::size_t> motionLines(const std::string& format, const Text& text) {
  std::string joined;
  for (const std::string& line : text.lines)
    joined += line + "\n";
  std::vector<std::size_t> lines;
  for (const auto& m : program::readProgram(format, {{text.name, joined}}, scene().process).motions)
    lines.push_back(m.line);
  return lines;
}

class EachDialect : public ::testing::TestWithParam<std::string> {
protected:
  // Points in the middle of a bead, at five places of the print.
  static std::vector<std::size_t> places() {
    const test::Scene& s = scene();
    std::vector<std::size_t> result;
    for (const double share : {0.05, 0.3, 0.5, 0.7, 0.93}) {
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
        << told(v);
  }
  // Every finding about the text is at that line or the next motion's.
  using Damage = std::function<std::size_t(Text&, std::size_t line, std::size_t point)>;
  void damageFivePlaces(const Damage& damage) {
    const Text whole = textOf(GetParam());
    const std::vector<std::size_t> lines = motionLines(GetParam(), whole);
    ASSERT_EQ(lines.size(), scene().trajectory.pointCount());
    for (const std::size_t point : places()) {
      Text text = whole;
      const std::size_t at = damage(text, lines[point], point);
      SCOPED_TRACE(GetParam() + " line " + std::to_string(at) + ": " +
                   (at <= text.lines.size() ? text.lines[at - 1] : ""));
      expectNamed(verify(GetParam(), text, scene()), at);
    }
  }
};

// Replaces the number behind `key` by f(number).
void change(std::string& line, const std::string& key, const std::function<double(double)>& f) {
  const std::size_t at = line.find(key);
  ASSERT_NE(at, std::string::npos) << key << " in " << line;
  std::size_t used = 0;
  const double value = std::stod(line.substr(at + key.size()), &used);
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.7f", f(value));
  line = line.substr(0, at + key.size()) + buffer + line.substr(at + key.size() + used);
}
void changeField(std::string& line, std::size_t field, const std::function<double(double)>& f) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < field; ++k)
    at = line.find(',', at) + 1;
  std::string head = line.substr(0, at), tail = line.substr(line.find(',', at));
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.7f", f(std::stod(line.substr(at))));
  line = head + buffer + tail;
}

TEST_P(EachDialect, TheUndamagedProgramPasses) {
  const Verification v = verify(GetParam(), textOf(GetParam()), scene());
  EXPECT_TRUE(v.passed) << told(v);
  EXPECT_TRUE(v.findings.empty()) << told(v);
  EXPECT_GE(v.coveredFraction, 0.98);
  EXPECT_NEAR(v.massRatio, 1.0, 0.005);
  EXPECT_LT(v.maxDeviationMm, 0.03);
  EXPECT_EQ(v.unsupportedFraction, 0.0);
  EXPECT_EQ(v.armChecked, GetParam() != "gcode-extended");
  EXPECT_EQ(v.places.size(), v.findings.size());
}

TEST_P(EachDialect, AMovedWaypoint) {
  damageFivePlaces([&](Text& text, std::size_t line, std::size_t) {
    std::string& l = text.lines[line - 1];
    if (GetParam() == "urscript")
      change(l, "movel(p[", [](double x) { return x + 0.002; });
    else if (GetParam() == "rapid")
      change(l, "MoveL [[", [](double x) { return x + 2.0; });
    else if (GetParam() == "csv") // 2 mm at a lever of some 600 mm
      changeField(l, 1, [](double x) { return x + 0.25; });
    else
      change(l, " X", [](double x) { return x + 2.0; });
    return line;
  });
}

TEST_P(EachDialect, TenWaypointsDeleted) {
  damageFivePlaces([&](Text& text, std::size_t line, std::size_t) {
    // Ten lines with motions; outputs and comments between them stay.
    const std::vector<std::size_t> lines = motionLines(GetParam(), text);
    auto it = std::find(lines.begin(), lines.end(), line);
    std::vector<std::size_t> gone(it, it + 10);
    for (auto g = gone.rbegin(); g != gone.rend(); ++g)
      text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(*g - 1));
    // The place is the line of the motion that follows the gap.
    const std::vector<std::size_t> left = motionLines(GetParam(), text);
    return *std::lower_bound(left.begin(), left.end(), line);
  });
}

TEST_P(EachDialect, TwoWaypointsSwapped) {
  damageFivePlaces([&](Text& text, std::size_t line, std::size_t) {
    const std::vector<std::size_t> lines = motionLines(GetParam(), text);
    const std::size_t next = *(std::find(lines.begin(), lines.end(), line) + 1);
    std::swap(text.lines[line - 1], text.lines[next - 1]);
    return line;
  });
}

TEST_P(EachDialect, OneSpeedTimesTen) {
  damageFivePlaces([&](Text& text, std::size_t line, std::size_t point) {
    std::string& l = text.lines[line - 1];
    const auto tenfold = [](double x) { return 10 * x; };
    if (GetParam() == "urscript") {
      if (l.find(",v=") != std::string::npos)
        change(l, ",v=", tenfold);
      else
        change(l, ",t=", [](double x) { return x / 10; });
    } else if (GetParam() == "rapid") {
      if (l.find("\\T:=") == std::string::npos)
        change(l, "]],[", tenfold);
      else
        change(l, "\\T:=", [](double x) { return x / 10; });
    } else if (GetParam() == "csv") {
      const double dt = scene().trajectory.timeS[point] - scene().trajectory.timeS[point - 1];
      changeField(l, 0, [&](double x) { return x - 0.9 * dt; });
    } else {
      change(l, " F", tenfold);
    }
    return line;
  });
}

TEST_P(EachDialect, TheExtruderLeftOnOverATravel) {
  damageFivePlaces([&](Text& text, std::size_t line, std::size_t) {
    if (GetParam() == "urscript" || GetParam() == "rapid") {
      const bool urscript = GetParam() == "urscript";
      const char* off = urscript ? "digital_out(0,False)" : "SetDO doExtruder,0;";
      for (std::size_t l = line; l < text.lines.size(); ++l)
        if (text.lines[l].find(off) != std::string::npos) {
          text.lines[l] = urscript ? "  set_standard_digital_out(0,True)" : "SetDO doExtruder,1;\r";
          return l + 1;
        }
      return std::size_t{0};
    }
    const std::vector<std::size_t> lines = motionLines(GetParam(), text);
    auto it = std::find(lines.begin(), lines.end(), line);
    std::size_t point = static_cast<std::size_t>(it - lines.begin());
    while (scene().trajectory.move[point] == plan::MoveKind::Print)
      ++point;
    std::string& travel = text.lines[lines[point] - 1];
    if (GetParam() == "csv") {
      changeField(travel, 7, [](double x) { return x + 2.0; });
    } else {
      const std::string& before = text.lines[lines[point - 1] - 1];
      const double e = std::stod(before.substr(before.find(" E") + 2));
      travel += " E" + std::to_string(e + 0.8);
    }
    return lines[point];
  });
}

TEST_P(EachDialect, AFileCutShort) {
  damageFivePlaces([](Text& text, std::size_t line, std::size_t) {
    text.lines.resize(line);
    return line;
  });
  // In the middle of a line, and only the end's last line missing.
  Text text = textOf(GetParam());
  const std::vector<std::size_t> lines = motionLines(GetParam(), text);
  text.lines.resize(lines[100]);
  text.lines.back() = text.lines.back().substr(0, 15);
  expectNamed(verify(GetParam(), text, scene()), lines[100]);
  text = textOf(GetParam());
  text.lines.pop_back();
  EXPECT_FALSE(verify(GetParam(), text, scene()).passed);
  text.lines.clear();
  EXPECT_FALSE(verify(GetParam(), text, scene()).passed);
}

TEST_P(EachDialect, ThreadsDoNotMatter) {
  const Text text = textOf(GetParam());
  const Verification a = verify(GetParam(), text, scene());
  const Verification b = verify(GetParam(), text, scene(), base::RunContext({}, 2));
  EXPECT_EQ(told(a), told(b));
  EXPECT_EQ(a.coveredFraction, b.coveredFraction);
  EXPECT_EQ(a.maxDeviationMm, b.maxDeviationMm);
}

INSTANTIATE_TEST_SUITE_P(Replay, EachDialect,
                         ::testing::Values("urscript", "gcode-extended", "rapid", "csv"),
                         [](const auto& i) {
                           return std::regex_replace(i.param, std::regex("-"), "_");
                         });

// ---- what a program can do wrong though its text is as planned

Verification replayPlan(const test::Scene& s, const std::string& format = "csv") {
  const plan::Program program =
      program::writeProgram(format, {s.plan, s.trajectory, s.cell, s.process, "box"});
  const plan::ReadProgram read = program::readProgram(format, program.files, s.process);
  return replayProgram({read, s.plan, s.trajectory, s.cell, s.process, s.part, s.platform},
                       ReplayThresholds{}, base::RunContext());
}

bool hasKind(const Verification& v, const std::string& kind) {
  return std::any_of(v.findings.begin(), v.findings.end(),
                     [&](const plan::Finding& f) { return f.kind == kind; });
}

TEST(Replay, AHeadDrivenIntoThePrintCollides) {
  test::Scene s = test::boxScene();
  // At the end, down into the block and out again.
  test::addPath(s.plan, {{0, 0, 0.9}, {2, 0, 0.9}}, 1.2, 0.8, 20, 9);
  s.trajectory = test::walk(s.plan, s.cell, s.process, 6.0);
  const Verification v = replayPlan(s);
  EXPECT_GE(v.collisions, 1u) << told(v);
  const auto it = std::find_if(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
    return f.reason.find("head and printed part") != std::string::npos;
  });
  ASSERT_NE(it, v.findings.end()) << told(v);
  ASSERT_TRUE(it->where.has_value());
  EXPECT_LT((*it->where - Eigen::Vector3d(0, 0, 2)).norm(), 4.0);
}

TEST(Replay, ATipBelowThePlateCollides) {
  test::Scene s = test::boxScene(1);
  test::addPath(s.plan, {{-2, 0, -3.0}, {2, 0, -3.0}}, 1.2, 0.8, 20, 1);
  s.trajectory = test::walk(s.plan, s.cell, s.process, 6.0);
  const Verification v = replayPlan(s);
  EXPECT_TRUE(std::any_of(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
    return f.kind == "collision" && f.reason.find("platform") != std::string::npos;
  })) << told(v);
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
  const plan::Program program =
      program::writeProgram("csv", {s.plan, s.trajectory, s.cell, s.process, "box"});
  plan::ReadProgram read = program::readProgram("csv", program.files, s.process);
  // The same nozzle, a whole turn of the last joint later.
  for (std::size_t m = 40; m < read.motions.size(); ++m)
    read.motions[m].joints[5] += read.motions[m].joints[5] > 0 ? -2 * base::kPi : 2 * base::kPi;
  const Verification v =
      replayProgram({read, s.plan, s.trajectory, s.cell, s.process, s.part, s.platform},
                    ReplayThresholds{}, base::RunContext());
  EXPECT_TRUE(hasKind(v, "otherConfiguration")) << told(v);
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
  EXPECT_GE(v.coveredFraction, 0.97);
}

// Layers much lower than beads are wide: cells by the width alone would hide what is beneath.
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
  EXPECT_TRUE(v.passed) << told(v);
  EXPECT_LT(v.unsupportedFraction, 0.001);
  EXPECT_LE(v.pitchMm, 0.5 * p.layerHeightMm);
}

TEST_P(ThinLayers, CellsGoByTheLayersThatAreThere) {
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
  EXPECT_TRUE(hasKind(v, "unsupported")) << told(v);
  EXPECT_NEAR(v.unsupportedFraction, p.layerHeightMm / kTall, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Heights, ThinLayers, ::testing::Values(0.25, 0.2));

TEST(Replay, TheUsualProcessKeepsItsCells) {
  test::Scene s = test::boxScene(1);
  EXPECT_EQ(replayPlan(s).pitchMm, 0.25 * s.process.beadWidthMm);
}

TEST(Replay, CancelsAndRefusesBrokenInput) {
  const test::Scene& s = scene();
  const plan::Program program =
      program::writeProgram("csv", {s.plan, s.trajectory, s.cell, s.process, "box"});
  const plan::ReadProgram read = program::readProgram("csv", program.files, s.process);
  base::CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(replayProgram({read, s.plan, s.trajectory, s.cell, s.process, s.part, s.platform},
                             ReplayThresholds{}, base::RunContext(cancel, 1)),
               base::Cancelled);
  const geometry::TriangleMesh nothing;
  EXPECT_THROW(replayProgram({read, s.plan, s.trajectory, s.cell, s.process, nothing, s.platform},
                             ReplayThresholds{}, base::RunContext()),
               base::Error);
}

} // namespace
} // namespace voluta::replay
