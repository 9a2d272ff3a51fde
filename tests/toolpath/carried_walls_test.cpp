#include "toolpath/unsupported/supported_walls.h"

#include "base/run_context.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "helpers/laid_beads.h"
#include "process/bead_model.h"
#include "replay/beads.h"
#include "replay/printed_part.h"
#include "replay/replay_ground.h"
#include "toolpath/order/assemble.h"
#include "toolpath/patch_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;
using test::Loop;

constexpr double kHeight = 0.8;

layers::LayerStack stackOf(const std::vector<std::vector<Loop>>& sections) {
  layers::LayerStack stack;
  for (const std::vector<Loop>& loops : sections) {
    const int k = stack.layerCount++;
    stack.patches.push_back(test::patchOver(loops, 0.8, [&](const Vector2d& p) {
      return Vector3d(p.x(), p.y(), (k + 0.5) * kHeight);
    }));
    stack.patches.back().layer = k;
  }
  return stack;
}

struct Covered {
  replay::SupportedBeads beads;
  double halfCarried = 0.0, volumeShare = 0.0;
};

// The stack's beads, with carried walls or the usual ones, on a plate that is large enough.
Covered coveredWith(const layers::LayerStack& stack, bool carriedWalls) {
  const process::Process process;
  const base::RunContext ctx;
  const auto widths = toolpath::carriedWallWidths(stack, process::Tooling(process), ctx);
  std::vector<toolpath::PatchCover> covers;
  double volume = 0.0, beadVolume = 0.0;
  for (std::size_t p = 0; p < stack.patches.size(); ++p) {
    covers.push_back(toolpath::coverPatch(stack.patches[p], process, {}, ctx,
                                          carriedWalls ? widths[p] : std::vector<double>{}));
    volume += covers.back().volumeMm3;
    beadVolume += covers.back().beadVolumeMm3;
  }
  const plan::ToolPlan plan = toolpath::assemble(stack, covers, process::Tooling(process)).plan;
  const std::vector<replay::BeadPiece> pieces = test::depositedBeads(plan);
  Vector3d low = plan.position.front(), high = low;
  for (const Vector3d& p : plan.position) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3d margin = Vector3d::Constant(process.beadWidthMaxMm);
  const replay::BeadGrid beads = replay::depositBeads(
      replay::gridOver(low - margin, high + margin, 0.25 * process.beadWidthMm, 48'000'000), pieces,
      {}, ctx);
  const replay::PrintedPart printed(beads, pieces);
  const platform::PlatformSolid plate{{-90, -90}, {90, -90}, {90, 90}, {-90, 90}};
  Covered out;
  out.beads = replay::findSupport(pieces, printed, replay::GroundProbe(plate), ctx);
  out.halfCarried = out.beads.halfCarriedMm / out.beads.lengthMm;
  out.volumeShare = beadVolume / volume;
  return out;
}

std::vector<char> carriedFrom(double offMm, double sampleMm) {
  std::vector<char> carried;
  for (int i = 0; (i + 0.5) * sampleMm < 2.3; ++i)
    carried.push_back((i + 0.5) * sampleMm >= offMm);
  return carried;
}

// A rim that reaches out by so much: of a bead w wide, w - off is carried.
TEST(CarriedWidth, IsTheMinimumOfWhichHalfIsCarried) {
  const process::Process process;
  const double sample = 0.01;
  for (double off = 0.0; off < 2.2; off += 0.05) {
    SCOPED_TRACE(off);
    const double width = toolpath::carriedWidth(carriedFrom(off, sample), sample, process);
    EXPECT_GE(width, process.beadWidthMm - 1e-9);
    EXPECT_LE(width, process.beadWidthMaxMm + 1e-9);
    if (off < 0.52)
      EXPECT_DOUBLE_EQ(width, process.beadWidthMm);
    else if (off < 0.86)
      EXPECT_NEAR((width - off) / width, 0.56, 0.02);
    else
      EXPECT_DOUBLE_EQ(width, process.beadWidthMaxMm);
  }
}

TEST(CarriedWidth, IsTheUsualOneWhereNothingIsBelow) {
  const process::Process process;
  EXPECT_DOUBLE_EQ(toolpath::carriedWidth(std::vector<char>(230, 0), 0.01, process),
                   process.beadWidthMm);
  EXPECT_DOUBLE_EQ(toolpath::carriedWidth({}, 0.01, process), process.beadWidthMm);
}

// Discs of which each reaches out over the one before by a closed-form amount.
TEST(CarriedWallWidths, AreThoseOfDiscsThatGrow) {
  const process::Process process;
  for (const double off : {0.0, 0.3, 0.6, 0.8, 1.3, 6.0}) {
    SCOPED_TRACE(off);
    const layers::LayerStack stack = stackOf({{test::circle(12.0)}, {test::circle(12.0 + off)}});
    const auto widths = toolpath::carriedWallWidths(stack, process::Tooling(process), {});
    for (const double w : widths[0])
      EXPECT_DOUBLE_EQ(w, process.beadWidthMm); // on the plate
    const double wanted = off == 6.0 ? process.beadWidthMm
                                     : toolpath::carriedWidth(carriedFrom(off, 0.1), 0.1, process);
    const geometry::TriangleMesh& mesh = stack.patches[1].surface;
    std::vector<char> isRim(mesh.vertices.size(), 0);
    const auto edges = geometry::sortedHalfEdges(mesh);
    geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
      if (e - b == 1)
        isRim[static_cast<std::size_t>(edges[b].low)] =
            isRim[static_cast<std::size_t>(edges[b].high)] = 1;
    });
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      EXPECT_NEAR(widths[1][v], isRim[v] ? wanted : process.beadWidthMm, 0.21);
  }
}

TEST(CarriedWallWidths, LeaveSupportsAndSeams) {
  layers::LayerStack stack = stackOf({{test::circle(12.0)}, {test::circle(12.8)}});
  layers::LayerStack seamed = stack;
  stack.patches[1].group = layers::kSupportGroup;
  seamed.patches[1].innerRim.assign(seamed.patches[1].surface.vertices.size(), 1);
  const process::Process process;
  for (const layers::LayerStack& each : {stack, seamed}) {
    const auto widths = toolpath::carriedWallWidths(each, process::Tooling(process), {});
    for (const double w : widths[1])
      EXPECT_DOUBLE_EQ(w, process.beadWidthMm);
  }
}

TEST(CarriedWallWidths, AndBeadsAreThoseOfThePatchsTool) {
  process::Tool first, second;
  second.process.beadWidthMm = 1.6;
  second.process.speedMmPerS = 3.0;
  const process::Tooling tooling({first, second});
  layers::LayerStack stack = stackOf({{test::circle(12.0)}, {test::circle(12.0)}});
  stack.patches[1].tool = 1;
  const auto widths = toolpath::carriedWallWidths(stack, tooling, {});
  for (std::size_t p = 0; p < 2; ++p)
    for (const double w : widths[p])
      EXPECT_DOUBLE_EQ(w, tooling.at(static_cast<int>(p)).process.beadWidthMm);
  std::vector<toolpath::PatchCover> covers;
  for (std::size_t p = 0; p < 2; ++p)
    covers.push_back(toolpath::coverPatch(
        stack.patches[p], tooling.at(stack.patches[p].tool).process, {}, {}, widths[p]));
  const plan::ToolPlan plan = toolpath::assemble(stack, covers, tooling).plan;
  for (const plan::ToolPath& path : plan.paths) {
    EXPECT_EQ(path.tool, path.patch);
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      EXPECT_EQ(plan.speedMmPerS[i] <= 3.0f, path.tool == 1);
  }
}

// A wall that is wider than the others keeps its width and its place, and the beads still tile.
TEST(CarriedWalls, WideWallsTile) {
  const process::Process process;
  for (const std::vector<Loop>& loops : {std::vector<Loop>{test::circle(15)},
                                         std::vector<Loop>{test::circle(15), test::circle(9, true)},
                                         std::vector<Loop>{test::ell(25, 9)}}) {
    const layers::Patch patch = test::patchOver(loops);
    const std::vector<double> width(patch.surface.vertices.size(), 1.8);
    const toolpath::PatchCover c = toolpath::coverPatch(patch, process, {}, {}, width);
    EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.985);
    EXPECT_LE(c.overlapMm2 / c.areaMm2, 0.06);
    EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.01);
    double sum = 0.0;
    std::size_t points = 0;
    for (const toolpath::Bead& b : c.beads)
      if (b.kind == plan::PathKind::Wall && b.ring == 0)
        for (const toolpath::BeadPoint& p : b.points) {
          sum += p.widthMm;
          ++points;
        }
    ASSERT_GT(points, 0u);
    EXPECT_NEAR(sum / static_cast<double>(points), 1.8, 0.1);
  }
}

// Where there is no room for them, they are no wider than there is room.
TEST(CarriedWalls, NarrowPlacesAreFilledAsWell) {
  for (double w = 1.4; w <= 6.01; w += 0.4) {
    SCOPED_TRACE(w);
    const layers::Patch strip = test::patchOver({test::rectangle(30, w)});
    const std::vector<double> width(strip.surface.vertices.size(), 2.0);
    const toolpath::PatchCover c = toolpath::coverPatch(strip, {}, {}, {}, width);
    EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.97);
    EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.02);
  }
}

// A cone whose wall leans by 60 degrees: every ring but the first reaches out by 1.39 mm, more than
// a usual bead is wide, and is unsupported all round.
TEST(CarriedWalls, RingsOfAConeThatLeansBy60DegreesAreCarried) {
  std::vector<std::vector<Loop>> sections;
  for (int k = 0; k < 5; ++k)
    sections.push_back({test::circle(8.0 + k * kHeight * std::tan(base::degreesToRadians(60.0)))});
  const layers::LayerStack stack = stackOf(sections);
  const Covered before = coveredWith(stack, false), after = coveredWith(stack, true);
  EXPECT_GT(before.beads.longestUnsupportedMm, 2.0 * base::kPi * 12.0);
  EXPECT_LT(after.beads.longestUnsupportedMm, process::Process{}.bridgeMm);
  EXPECT_LT(after.beads.unsupportedMm, 0.5 * before.beads.unsupportedMm);
  EXPECT_NEAR(after.volumeShare, 1.0, 0.01);
}

// An upside-down stair with steps of 0.75 mm, which carry less than half of usual walls.
TEST(CarriedWalls, StepsOfAStairAreCarriedOnHalf) {
  std::vector<std::vector<Loop>> sections;
  for (int k = 0; k < 6; ++k) {
    Loop step = test::rectangle(16.0, 14.0);
    step[1].x() += 0.75 * k;
    step[2].x() += 0.75 * k;
    sections.push_back({step});
  }
  const layers::LayerStack stack = stackOf(sections);
  const Covered before = coveredWith(stack, false), after = coveredWith(stack, true);
  EXPECT_GT(before.halfCarried, 0.03);
  EXPECT_LT(after.halfCarried, 0.25 * before.halfCarried);
  EXPECT_NEAR(after.volumeShare, 1.0, 0.01);
}

// A tube that widens: its outer wall reaches out, its inner one draws back.
TEST(CarriedWalls, ATubeThatWidensIsCarried) {
  std::vector<std::vector<Loop>> sections;
  for (int k = 0; k < 5; ++k)
    sections.push_back({test::circle(14.0 + 1.3 * k), test::circle(7.0 + 1.3 * k, true)});
  const layers::LayerStack stack = stackOf(sections);
  const Covered before = coveredWith(stack, false), after = coveredWith(stack, true);
  EXPECT_GT(before.beads.longestUnsupportedMm, 40.0);
  EXPECT_LT(after.beads.longestUnsupportedMm, process::Process{}.bridgeMm);
  EXPECT_NEAR(after.volumeShare, 1.0, 0.01);
}

} // namespace
