// Programs with fewer points and with arcs: their deviation from the whole plan, and edits of their
// arcs.
#include "geometry/triangle_queries.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "replay/replay_scene.h"
#include "replay/replay_steps.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <regex>
#include <string>

namespace voluta::replay {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kToleranceMm = 0.02;

// Beads in short steps on the plate of a box: circles, or lines and bends at random.
plan::ToolPlan ringPlan(const process::Process& p) {
  plan::ToolPlan plan;
  for (const double radius : {5.0, 9.0, 14.0}) {
    std::vector<Vector3d> corners;
    const int n = static_cast<int>(std::lround(2.0 * base::kPi * radius / 0.6));
    for (int i = 0; i <= n; ++i) {
      const double a = 2.0 * base::kPi * i / n;
      corners.emplace_back(radius * std::cos(a), radius * std::sin(a), p.layerHeightMm);
    }
    test::addPath(plan, corners, p.beadWidthMm, p.layerHeightMm, p.speedMmPerS, 0);
  }
  return plan;
}

plan::ToolPlan wanderingPlan(const process::Process& p, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  plan::ToolPlan plan;
  double heading = 6.3 * unit(random);
  Vector3d at(0, 0, p.layerHeightMm);
  std::vector<Vector3d> corners = {at};
  for (int piece = 0; piece < 6; ++piece) {
    const double bend = unit(random) < 0.4 ? 0.0 : 0.2 * (unit(random) - 0.5);
    for (int i = 0; i < 15; ++i) {
      heading += bend + (at.head<2>().norm() > 15.0 ? 0.1 : 0.0);
      at += Vector3d(std::cos(heading), std::sin(heading), 0.0);
      corners.push_back(at);
    }
  }
  test::addPath(plan, corners, p.beadWidthMm, p.layerHeightMm, p.speedMmPerS, 0);
  return plan;
}

// A plan, written with options.
class Written {
public:
  Written(const plan::ToolPlan& plan, const std::string& format, double resolutionMm, bool arcs)
      : scene_(test::boxScene(1)), plan_(plan),
        trajectory_(test::walk(plan, scene_.cell, scene_.process)), format_(format) {
    if (resolutionMm > 0.0)
      options_.own["programResolutionMm"] = resolutionMm;
    if (arcs)
      options_.own["arcFitting"] = true;
    const process::Tooling tooling(scene_.process);
    program::ProgramInput input{plan_, trajectory_, scene_.cell, tooling, "ring", options_};
    points_ = program::pointsFor(format, input);
    program::ProgramInput merged{plan_,   *points_.trajectory, scene_.cell, tooling, "ring",
                                 options_};
    merged.arcs = points_.arcs;
    files = program::writeProgram(format, merged).files;
  }

  std::size_t allPoints() const { return trajectory_.pointCount(); }
  std::size_t points() const { return points_.trajectory->pointCount(); }
  std::size_t arcs() const { return points_.arcs.size(); }
  plan::ReadProgram read(const std::vector<plan::ProgramFile>& text) const {
    return program::readProgram(format_, text, process::Tooling(scene_.process));
  }
  Verification compare(const std::vector<plan::ProgramFile>& text) const {
    ReplayInput input{read(text),
                      plan_,
                      *points_.trajectory,
                      scene_.cell,
                      process::Tooling(scene_.process),
                      scene_.part,
                      scene_.platform};
    input.whole = {&trajectory_, points_.pointOf};
    return compareProgram(input, {}, {}).verdict;
  }

  std::vector<plan::ProgramFile> files;

private:
  test::Scene scene_;
  plan::ToolPlan plan_;
  plan::Trajectory trajectory_;
  std::string format_;
  program::ProgramOptions options_;
  program::MergedPoints points_;
};

// Differences from the plan. A foreign program states poses only, so that the arm may begin in
// another configuration.
std::size_t differences(const Verification& v) {
  return static_cast<std::size_t>(std::ranges::count_if(v.findings, [](const plan::Finding& f) {
    return f.kind != plan::FindingKind::OtherConfiguration;
  }));
}

class ArcPrograms : public ::testing::TestWithParam<std::string> {};

TEST_P(ArcPrograms, ringsTakeFewMotionsWithinTheTolerance) {
  test::usesSourceTreeResources();
  const plan::ToolPlan plan = ringPlan(process::loadProcess("fdm-1.0"));
  const Written lines(plan, GetParam(), kToleranceMm, false), arcs(plan, GetParam(), 0.0, true),
      both(plan, GetParam(), kToleranceMm, true);
  EXPECT_EQ(lines.arcs(), 0u);
  EXPECT_EQ(arcs.arcs(), 6u); // two a ring
  EXPECT_LE(arcs.points(), arcs.allPoints() / 5);
  EXPECT_LE(both.points(), arcs.points());
  EXPECT_LE(lines.points(), lines.allPoints());
  for (const Written* w : {&lines, &arcs, &both}) {
    const Verification v = w->compare(w->files);
    EXPECT_EQ(differences(v), 0u);
    EXPECT_LE(v.maxDeviationMm, kToleranceMm + 1e-3);
    EXPECT_LE(v.flowErrorFraction, 0.05); // from rest, which the plan ignores
  }
}

TEST_P(ArcPrograms, linesKeepTheirEndsOnly) {
  test::usesSourceTreeResources();
  constexpr std::size_t kLines = 11;
  const Written w(test::boxPlan(12.0, kLines, 1, process::loadProcess("fdm-1.0")), GetParam(),
                  kToleranceMm, true);
  // The lift, the start, the end and the next lift of each.
  EXPECT_EQ(w.points(), 4 * kLines);
  EXPECT_EQ(w.arcs(), 0u);
  const Verification v = w.compare(w.files);
  EXPECT_EQ(differences(v), 0u);
  EXPECT_LE(v.maxDeviationMm, kToleranceMm); // of the travels' blends
}

TEST_P(ArcPrograms, wanderingBeadsStayWithinTheTolerance) {
  test::usesSourceTreeResources();
  const process::Process process = process::loadProcess("fdm-1.0");
  for (unsigned seed = 0; seed < 25; ++seed) {
    const Written w(wanderingPlan(process, seed), GetParam(), kToleranceMm, true);
    const Verification v = w.compare(w.files);
    EXPECT_EQ(differences(v), 0u);
    EXPECT_LE(v.maxDeviationMm, 2.0 * kToleranceMm) << seed; // with the blends of its corners
    EXPECT_LT(w.points(), w.allPoints() / 2) << seed;
  }
}

double ofText(const std::string& format) {
  return format == "urscript" ? 1000.0 : 1.0;
}

std::regex arcIn(const std::string& format) {
  if (format == "urscript")
    return std::regex(R"((movec\(p\[)([-\d.]+),([-\d.]+))");
  if (format == "rapid")
    return std::regex(R"(((?:MoveC|TriggC) \[\[)([-\d.]+),([-\d.]+))");
  if (format == "krl")
    return std::regex(R"((CIRC \{X )([-\d.]+),Y ([-\d.]+))");
  return std::regex(R"((G[23] X.* I)([-\d.]+) J([-\d.]+))");
}

// Changes an arc of the text by at least 0.15 mm: its via point (or centre), radius or sense.
std::string edited(const std::string& text, const std::string& format, std::mt19937_64& random) {
  const std::regex pattern = arcIn(format);
  std::vector<std::smatch> arcs(std::sregex_iterator(text.begin(), text.end(), pattern), {});
  const std::smatch& arc = arcs[random() % arcs.size()];
  const auto at = static_cast<std::size_t>(arc.position());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double x = std::stod(arc[2]), y = std::stod(arc[3]), unitMm = ofText(format);
  const bool centre = format == "gcode";
  const int kind = static_cast<int>(random() % 3);
  std::string head = arc[1];
  Vector2d moved(x, y);
  const double away = (0.15 + 2.0 * unit(random)) * (unit(random) < 0.5 ? 1.0 : -1.0) / unitMm;
  if (kind == 0 && centre)
    head[1] = head[1] == '2' ? '3' : '2';
  else if (centre)
    moved = kind == 1 ? Vector2d(x + away, y) : Vector2d((1.0 + away / 5.0) * moved);
  else
    moved += kind == 0   ? Vector2d(away, 0.0)
             : kind == 1 ? Vector2d(0.0, away)
                         : Vector2d(away, away);
  const std::string between = format == "krl" ? ",Y " : centre ? " J" : ",";
  return text.substr(0, at) + head + std::to_string(moved.x()) + between +
         std::to_string(moved.y()) + text.substr(at + arc.str().size());
}

// A via point moved along the circle changes nothing.
bool isSamePath(const Written& w, const std::vector<plan::ProgramFile>& text) {
  const plan::ReadProgram before = w.read(w.files), after = w.read(text);
  if (!after.defects.empty() || before.motions.size() != after.motions.size())
    return false;
  double maximum = 0.0;
  for (std::size_t m = 0; m < before.motions.size(); ++m)
    for (const plan::NozzlePoint& p : after.motions[m].viaPoints) {
      const std::vector<plan::NozzlePoint>& old = before.motions[m].viaPoints;
      double minimum = old.empty() ? 1e9 : (p.position - old.front().position).norm();
      for (std::size_t i = 1; i < old.size(); ++i)
        minimum = std::min(
            minimum, geometry::distanceToSegment(p.position, old[i - 1].position, old[i].position));
      maximum = std::max(maximum, minimum);
    }
  return maximum < ReplayThresholds{}.deviationMaxMm + 0.01; // with the chords' sagitta
}

TEST_P(ArcPrograms, fortyEditsOfArcsAreRefused) {
  test::usesSourceTreeResources();
  const Written w(ringPlan(process::loadProcess("fdm-1.0")), GetParam(), kToleranceMm, true);
  std::mt19937_64 random(40);
  const ReplayThresholds limits;
  int refused = 0, harmless = 0;
  while (refused < 40 && harmless < 100) {
    std::vector<plan::ProgramFile> files = w.files;
    const auto file = std::ranges::find_if(files, [&](const plan::ProgramFile& f) {
      return std::regex_search(f.text, arcIn(GetParam()));
    });
    ASSERT_NE(file, files.end());
    file->text = edited(file->text, GetParam(), random);
    const Verification v = w.compare(files);
    if (differences(v) > 0 || v.maxDeviationMm > limits.deviationMaxMm) {
      ++refused;
      continue;
    }
    ++harmless;
    EXPECT_TRUE(isSamePath(w, files)) << v.maxDeviationMm;
  }
  EXPECT_EQ(refused, 40);
}

INSTANTIATE_TEST_SUITE_P(Replay, ArcPrograms,
                         ::testing::Values("urscript", "rapid", "krl", "gcode"),
                         [](const auto& each) { return each.param; });

} // namespace
} // namespace voluta::replay
