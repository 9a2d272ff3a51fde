// Parts milled out of a block: material left, material missing, and programs with a tool change.
#include "milling/cut_verdict.h"
#include "milling/drop_cutter.h"
#include "milling/mill_passes.h"
#include "milling/mill_program.h"
#include "milling/stock.h"

#include "base/error.h"
#include "base/units.h"
#include "helpers/shapes.h"
#include "plan/finding_kinds.h"
#include "program/gcode/gcode_milling.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <tuple>

namespace voluta::milling {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const base::RunContext kOne;
constexpr double kRadius = 8.0;

// A hemisphere on z = 0.
geometry::TriangleMesh hemisphere(double radius, int rings, int sides) {
  geometry::TriangleMesh m;
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < sides; ++k) {
      const double up = 0.5 * base::kPi * r / rings, angle = base::kTwoPi * k / sides;
      m.vertices.emplace_back(radius * std::cos(up) * std::cos(angle),
                              radius * std::cos(up) * std::sin(angle), radius * std::sin(up));
    }
  const int top = static_cast<int>(m.vertices.size());
  m.vertices.emplace_back(0, 0, radius);
  m.vertices.emplace_back(0, 0, 0);
  for (int k = 0; k < sides; ++k) {
    const int next = (k + 1) % sides;
    for (int r = 0; r + 1 < rings; ++r) {
      const int a = r * sides + k, b = r * sides + next;
      m.triangles.push_back({a, b, b + sides});
      m.triangles.push_back({a, b + sides, a + sides});
    }
    m.triangles.push_back({(rings - 1) * sides + k, (rings - 1) * sides + next, top});
    m.triangles.push_back({next, k, top + 1});
  }
  return m;
}

MillRule ruleFor(const char* material) {
  MillRule rule;
  rule.data = *cuttingDataFor(material);
  return rule;
}

struct Milled {
  MillPlan plan;
  std::string text;
};

const Milled& dome() {
  static const Milled kMilled = [] {
    const MillRule rule = ruleFor("hard-plastic");
    Milled milled;
    milled.plan = planMilling(hemisphere(kRadius, 60, 160), rule, kOne);
    milled.text = writeMilling(milled.plan, rule, "dome (1)");
    return milled;
  }();
  return kMilled;
}

CutVerdict judged(const std::string& text) {
  return judgeCuts(program::readMillingGcode(text), dome().plan, ruleFor("hard-plastic"), kOne);
}

std::string firstOf(const CutVerdict& verdict) {
  return verdict.findings.empty() ? "" : plan::englishReason(verdict.findings.front());
}

TEST(MilledPart, AHemispherePasses) {
  const CutVerdict v = judged(dome().text);
  EXPECT_TRUE(v.passed) << firstOf(v);
  EXPECT_LT(v.deepestMm, kGougeMm);
  EXPECT_GT(v.seconds, 60.0);
}

// Along the meridian across the lines, ridges are at most 5 % higher than between two circles.
TEST(MilledPart, RidgesAreThoseOfTheory) {
  const MillRule rule = ruleFor("hard-plastic");
  const double radius = kRadius, step = rule.distanceMm(), r = rule.cutter.radiusMm();
  Stock stock(dome().plan.block, 0.05);
  Vector3d at = Vector3d::Zero();
  bool isKnown = false;
  for (const MillMove& move : dome().plan.sides[0].moves) {
    const Vector3d from = isKnown ? at : move.to;
    // Only the middle is looked at.
    if (std::min(std::abs(from.x()), std::abs(move.to.x())) < 2.0 || from.x() * move.to.x() < 0.0)
      stock.cut(rule.cutter, from, move.to);
    at = move.to;
    isKnown = true;
  }
  const CellGrid& grid = stock.grid();
  const double reach = (radius + r) * std::sin(base::degreesToRadians(60.0));
  double y = dome().plan.block.max().y() - r;
  int ridges = 0;
  for (; y - step > -reach; y -= step) {
    if (y > reach)
      continue;
    const double theory = ridgeOnSphereMm(r, radius, y - step, step);
    double highest = 0.0;
    for (int j = 0; j < grid.countY; ++j) {
      const std::size_t cell = grid.index(static_cast<int>((0.0 - grid.low.x()) / grid.pitchMm), j);
      const Vector2d middle = grid.middle(static_cast<int>((0.0 - grid.low.x()) / grid.pitchMm), j);
      const Vector3d p(middle.x(), middle.y(), stock.highAt(cell));
      const double centre = std::atan2(p.y(), p.z());
      if (centre < std::asin(y / (radius + r)) && centre > std::asin((y - step) / (radius + r)))
        highest = std::max(highest, p.norm() - radius);
    }
    EXPECT_LT(highest, 1.05 * theory + 0.002) << y;
    EXPECT_GT(highest, 0.9 * theory - 0.01) << y;
    ++ridges;
  }
  EXPECT_GT(ridges, 6);
}

TEST(MilledPart, RemovedVolumeEqualsTheSweptVolume) {
  Stock stock({Vector3d(-10, -10, 0), Vector3d(10, 10, 10)}, 0.05);
  const Cutter cutter{4.0, 1};
  const double before = stock.volumeMm3();
  // A groove 3 mm deep: a half disc of radius 2 and 1 mm above it, and round ends.
  const double removed = stock.cut(cutter, {-5, 0, 7}, {5, 0, 7});
  const double ends = 2.0 / 3.0 * base::kPi * 8.0 + base::kPi * 4.0;
  EXPECT_NEAR(removed, 10.0 * (base::kPi * 2.0 + 4.0) + ends, 0.01 * removed);
  EXPECT_NEAR(before - stock.volumeMm3(), removed, 1e-6);
  EXPECT_NEAR(stock.turned().volumeMm3(), stock.volumeMm3(), 1e-6);
}

TEST(MilledPart, TheCutterTouchesASphere) {
  const HeightMap map =
      heightMap(hemisphere(12.0, 90, 240), gridOver({-14, -14}, {14, 14}, 0.1), kOne);
  const Cutter cutter;
  for (const double x : {0.0, 3.0, 6.0, 9.0}) {
    const double reach = 12.0 + cutter.radiusMm();
    EXPECT_NEAR(dropHeight(map, cutter, {x, 0.3}),
                std::sqrt(reach * reach - x * x - 0.09) - cutter.radiusMm(), 0.02);
  }
  EXPECT_EQ(dropHeight(map, cutter, {13.9, 13.9}), HeightMap::kNone);
}

// A program with one change is refused, or the part is as before.
TEST(MilledPart, HarmfulChangesAreRefused) {
  std::vector<std::string> lines;
  std::istringstream in(dome().text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  const auto with = [&](std::size_t at, const std::string& line) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
      text += (i == at ? line : lines[i]) + "\n";
    return text;
  };
  const auto lineOf = [&](const std::string& start) {
    return static_cast<std::size_t>(
        std::ranges::find_if(lines, [&](const std::string& l) { return l.starts_with(start); }) -
        lines.begin());
  };
  EXPECT_FALSE(judged(with(lineOf("F"), "F600")).passed) << "another feed";
  EXPECT_FALSE(judged(with(lineOf("S8500"), "S8500")).passed) << "the spindle is at rest";
  EXPECT_FALSE(judged(with(lineOf("M30"), "")).passed) << "no end";
  EXPECT_FALSE(judged(with(lineOf("G0 A180"), "")).passed) << "not turned";
  EXPECT_FALSE(judged(with(lineOf("G21"), "G20")).passed) << "inches";
  EXPECT_FALSE(judged(with(lineOf("G54"), "hello")).passed);
  std::mt19937 random(2);
  int cuts = 0;
  while (cuts < 12) {
    const std::size_t at = random() % lines.size();
    if (!lines[at].starts_with("G1 ") || lines[at].find("Z") == std::string::npos)
      continue;
    const std::string deeper = lines[at].substr(0, lines[at].find("Z")) + "Z-40.000";
    EXPECT_FALSE(judged(with(at, deeper)).passed) << lines[at];
    ++cuts;
  }
}

// Beside a wall the ball's height jumps: a motion that leads up it on a slope cuts into it.
TEST(MilledPart, WallsAreNotCut) {
  geometry::TriangleMesh posts = test::box({-9, -6, 0}, {9, 6, 3});
  test::append(posts, test::box({-3, -2.03, 3}, {4.07, 3, 14}));
  for (const double degrees : {0.0, 17.0, 60.0}) {
    geometry::TriangleMesh part = posts;
    const Eigen::AngleAxisd rotation(base::degreesToRadians(degrees), Vector3d::UnitZ());
    for (Vector3d& v : part.vertices)
      v = rotation * v;
    const MillRule rule = ruleFor("soft-plastic");
    const MillPlan plan = planMilling(part, rule, kOne);
    const CutVerdict v =
        judgeCuts(program::readMillingGcode(writeMilling(plan, rule, "posts")), plan, rule, kOne);
    EXPECT_TRUE(v.passed) << degrees << firstOf(v);
    EXPECT_LT(v.deepestMm, kGougeMm);
  }
}

// A motion is left out, or 0.2 mm higher or lower.
TEST(MilledPart, ChangedMotionsAreRefused) {
  std::vector<std::string> lines;
  std::istringstream in(dome().text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  std::mt19937 random(5);
  for (int changed = 0; changed < 24;) {
    const std::size_t at = random() % lines.size();
    const std::size_t height = lines[at].find(" Z");
    if (height == std::string::npos || lines[at].find(" X") == std::string::npos)
      continue;
    const double z = std::stod(lines[at].substr(height + 2));
    const double off = changed % 3 == 1 ? 0.2 : -0.2;
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (i != at)
        text += lines[i] + "\n";
      else if (changed % 3 > 0)
        text += lines[i].substr(0, height) + " Z" + std::to_string(z + off) + "\n";
    const CutVerdict v = judged(text);
    EXPECT_FALSE(v.passed) << lines[at] << ", change " << changed % 3;
    ASSERT_FALSE(v.findings.empty());
    EXPECT_NEAR(static_cast<double>(v.findings.front().program.line), static_cast<double>(at + 1),
                1.0);
    ++changed;
  }
}

// A refused motion names its line, the place on the part, and the motions that follow with the
// same.
TEST(MilledPart, RefusalsAreFindingsAtTheirPlaces) {
  using enum plan::FindingKind;
  const std::string& text = dome().text;
  const auto with = [&](const std::string& from, const std::string& to, std::size_t begin = 0) {
    std::string changed = text;
    const std::size_t at = changed.find(from, begin);
    EXPECT_NE(at, std::string::npos) << from;
    return changed.replace(at, from.size(), to);
  };
  const auto lineAt = [&](std::size_t at) {
    return static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1);
  };
  const auto findingIn = [](const CutVerdict& v, plan::FindingKind kind) {
    const auto found = std::ranges::find(v.findings, kind, &plan::Finding::kind);
    EXPECT_NE(found, v.findings.end()) << plan::rowOf(kind).id;
    return found == v.findings.end() ? plan::Finding() : *found;
  };
  // All motions of side B are in the coordinates of side A.
  const std::size_t sideB = text.find("G55");
  const plan::Finding side = findingIn(judged(with("G55", "G54", sideB)), OtherSide);
  EXPECT_EQ(side.program.line, lineAt(sideB) + 2);
  EXPECT_EQ(side.count, dome().plan.sides[1].moves.size());
  // A cut of side B becomes a rapid move: its place is that of side A's coordinates.
  const std::size_t cut = text.find("\nG1 ", text.find("\nG1 ", sideB) + 1) + 1;
  std::string changed = text;
  changed[cut + 1] = '0';
  const plan::Finding rapid = findingIn(judged(changed), RapidInBlock);
  EXPECT_EQ(rapid.program.line, lineAt(cut));
  ASSERT_TRUE(rapid.where && rapid.whenS);
  EXPECT_LT(dome().plan.block.exteriorDistance(*rapid.where), 0.01);
  EXPECT_LT(rapid.where->y(), 0.0) << "side B begins at the end that it sees as the upper";
  EXPECT_GT(*rapid.whenS, 60.0);
  EXPECT_TRUE(rapid.blocking);
  // The block
  const std::size_t turned = text.find("G0 A180"), home = text.rfind("G53", turned);
  EXPECT_EQ(findingIn(judged(with("G53 G0 Z0\n", "\n", home)), BlockTurnedBelow).program.line,
            lineAt(turned));
  EXPECT_EQ(findingIn(judged(with("A180", "A90")), BlockTurnedElsewhere).program.line,
            lineAt(turned));
  EXPECT_GT(findingIn(judged(with("F", "F1")), FeedChanged).count, 10u);
  EXPECT_GT(findingIn(judged(with("S8500", "S850")), SpindleChanged).count, 10u);
  const std::size_t last = text.rfind('\n', text.rfind(" X")) + 1;
  changed = text;
  changed.erase(last, text.find('\n', last) + 1 - last);
  const plan::Finding missing = findingIn(judged(changed), ProgramCutShort);
  EXPECT_EQ(missing.program.line, lineAt(last) - 1) << "the last motion that is left";
  EXPECT_EQ(plan::englishReason(missing).find("line "), 0u) << plan::englishReason(missing);
}

TEST(MilledPart, BadValuesAreRefusedInOneLine) {
  MillRule rule = ruleFor("soft-plastic");
  rule.acrossMm = 2.0;
  try {
    planMilling(test::box({0, 0, 0}, {5, 5, 5}), rule, kOne);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(error.what()).find("3.175"), std::string::npos) << error.what();
  }
  for (const auto& [pitchMm, lineMm, says] :
       {std::tuple(1e-9, 0.0, "--pitch of"), std::tuple(1e-4, 0.0, "--pitch of"),
        std::tuple(0.1, -1.0, "distances above 0")}) {
    rule = ruleFor("soft-plastic");
    rule.pitchMm = pitchMm;
    rule.lineMm = lineMm;
    try {
      planMilling(test::box({0, 0, 0}, {5, 5, 5}), rule, kOne);
      FAIL() << pitchMm;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ErrorCode::Usage);
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
}

} // namespace
} // namespace voluta::milling
