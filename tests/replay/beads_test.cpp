// Beads by hand: volumes, envelopes, coverage, support. No robot.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/append_mesh.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"
#include "process/bead_model.h"
#include "replay/bead_coverage.h"
#include "replay/beads.h"
#include "replay/bridged_spans.h"
#include "replay/depositor.h"
#include "replay/printed_part.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;
constexpr double pi = base::kPi;

const base::RunContext kOne;
constexpr double kPitch = 0.3;

// A bead along points, cut into pieces of half a millimetre; volume by the section.
void addBead(std::vector<BeadPiece>& pieces, const std::vector<Vector3d>& points, double width,
             double height, double flow = 1.0, const Vector3d& up = Vector3d::UnitZ()) {
  const std::uint32_t run = pieces.empty() ? 1 : pieces.back().run + 1;
  double runMm = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vector3d step = points[k] - points[k - 1];
    const int cuts = std::max(1, static_cast<int>(std::ceil(step.norm() / 0.5 - 1e-9)));
    for (int c = 0; c < cuts; ++c) {
      BeadPiece p;
      p.from = points[k - 1] + step * c / cuts;
      p.to = points[k - 1] + step * (c + 1) / cuts;
      p.fromDirection = p.toDirection = up;
      p.fromHeightMm = p.toHeightMm = static_cast<float>(height);
      p.volumeMm3 =
          static_cast<float>(flow * process::beadArea(width, height) * step.norm() / cuts);
      p.runMm = static_cast<float>(runMm += step.norm() / cuts);
      p.run = run;
      p.motion = static_cast<std::uint32_t>(pieces.size());
      pieces.push_back(p);
    }
  }
}

BeadGrid lay(const std::vector<BeadPiece>& pieces, const Vector3d& low, const Vector3d& high,
             const base::RunContext& ctx = kOne) {
  return depositBeads(gridOver(low, high, kPitch, 50'000'000), pieces, DepositOptions{}, ctx);
}

double filled(const BeadGrid& beads) {
  return std::accumulate(beads.fill.begin(), beads.fill.end(), 0.0) * std::pow(beads.grid.pitch, 3);
}

TEST(Depositor, AStraightWallHasItsHandCalculatedVolume) {
  std::vector<BeadPiece> pieces;
  for (int k = 1; k <= 10; ++k)
    addBead(pieces, {{0.13, 0.07, 0.8 * k}, {50.13, 0.07, 0.8 * k}}, 1.2, 0.8);
  const BeadGrid beads = lay(pieces, {-3, -3, -1}, {54, 3, 10});
  const double resolved = 10 * 50.0 * (1.2 * 0.8 - (1 - pi / 4) * 0.64);
  EXPECT_NEAR(filled(beads), resolved, 0.01 * resolved);
  EXPECT_NEAR(beads.excessMm3, 0.0, 0.001 * resolved);
  // In its envelope, except for cells that reach out of it.
  double outside = 0.0;
  for (std::size_t c = 0; c < beads.fill.size(); ++c) {
    const Eigen::Vector3i i = beads.grid.cell(c);
    const Vector3d p = beads.grid.centre(i.x(), i.y(), i.z());
    if (std::abs(p.y() - 0.07) > 0.6 + 0.16 || p.z() < -0.16 || p.z() > 8.16 || p.x() < -0.05 ||
        p.x() > 50.3)
      outside += beads.fill[c];
  }
  EXPECT_LT(outside * std::pow(kPitch, 3), 0.002 * resolved);
}

TEST(Depositor, ANarrowBendLeavesNoWedgesOpen) {
  const double radius = 2.0;
  std::vector<Vector3d> ring;
  for (int k = 0; k <= 24; ++k)
    ring.emplace_back(radius * std::cos(k * pi / 12), radius * std::sin(k * pi / 12), 0.8);
  std::vector<BeadPiece> pieces;
  addBead(pieces, ring, 1.2, 0.8);
  const BeadGrid beads = lay(pieces, {-4, -4, 0}, {4, 4, 1.2});
  // Well inside the ring, all round, on the inside of the bend as on its outside.
  for (const double off : {-0.25, 0.25}) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t c = 0; c < beads.fill.size(); ++c) {
      const Eigen::Vector3i i = beads.grid.cell(c);
      const Vector3d p = beads.grid.centre(i.x(), i.y(), i.z());
      if (std::abs(p.head<2>().norm() - radius - off) < 0.1 && std::abs(p.z() - 0.45) < 0.1) {
        sum += static_cast<double>(beads.fill[c]);
        ++count;
      }
    }
    EXPECT_GT(count, 10);
    EXPECT_GT(sum / count, 0.97) << off;
  }
  EXPECT_NEAR(filled(beads) + beads.excessMm3, beads.depositedMm3, 1e-3);
}

TEST(Depositor, ACylinderOfTwentyRings) {
  std::vector<BeadPiece> pieces;
  const double radius = 15.0;
  for (int k = 1; k <= 20; ++k) {
    std::vector<Vector3d> ring;
    for (int a = 0; a <= 360; a += 2)
      ring.emplace_back(radius * std::cos(a * pi / 180), radius * std::sin(a * pi / 180), 0.8 * k);
    addBead(pieces, ring, 1.4, 0.8);
  }
  const BeadGrid beads = lay(pieces, {-18, -18, -1}, {18, 18, 18});
  const double resolved = 20 * 2 * pi * radius * process::beadArea(1.4, 0.8);
  EXPECT_NEAR(filled(beads), resolved, 0.01 * resolved);
  EXPECT_LT(beads.excessMm3, 0.002 * resolved);
}

// Lines at the hatch that the bead model gives fill a box without gaps.
std::vector<BeadPiece> solidBox(double side, int lines, int layers, double height,
                                double flow = 1.0, int leaveOutLine = -1) {
  std::vector<BeadPiece> pieces;
  const double hatch = side / lines, width = process::widthOfHatch(hatch, height);
  for (int k = 0; k < layers; ++k)
    for (int l = 0; l < lines; ++l) {
      if (l == leaveOutLine)
        continue;
      const double y = (l + 0.5) * hatch, z = (k + 1) * height;
      const bool back = l % 2 != 0;
      addBead(pieces, {{back ? side : 0, y, z}, {back ? 0 : side, y, z}}, width, height, flow);
    }
  return pieces;
}

constexpr SurfaceBands kBands{.outsideMm = 0.3, .notchMm = 0.4};

struct Judged {
  double covered, mass, overfill, excess;
};
Judged judge(const std::vector<BeadPiece>& pieces, const geometry::TriangleMesh& part,
             const Vector3d& low, const Vector3d& high) {
  const BeadGrid beads = lay(pieces, low, high);
  const geometry::MeshQuery query(part);
  const PartCells cells = partCells(part, query, beads.grid, kOne);
  const Coverage c = measureCoverage(beads, cells, query, kBands, kOne);
  return {c.coveredFraction, beads.depositedMm3 / cells.volumeMm3, c.outsideMm3 / cells.volumeMm3,
          beads.excessMm3 / cells.volumeMm3};
}

// A small box without beads beside a large one that is full: 0.8 % of both, all of the small one.
TEST(Coverage, OfEachItemIsItsOwn) {
  auto part = test::box({0, 0, 0}, {10, 10, 10});
  const std::vector<std::size_t> firstTriangle{0, part.triangles.size()};
  geometry::appendMesh(part, test::box({14, 0, 0}, {16, 2, 2}));
  const geometry::MeshQuery query(part);
  BeadGrid beads;
  beads.grid = gridOver({-3, -3, -3}, {19, 13, 13}, 0.25, 10'000'000);
  beads.fill = base::ZeroedArray<float>(beads.grid.cellCount());
  const PartCells cells = partCells(part, query, beads.grid, kOne);
  const ItemFinder items(part, query, firstTriangle, 1.0);
  for (std::size_t c = 0; c < beads.fill.size(); ++c) {
    const Eigen::Vector3i cell = beads.grid.cell(c);
    const Vector3d at = beads.grid.centre(cell.x(), cell.y(), cell.z());
    if (at.x() < 12)
      beads.fill[c] = static_cast<float>(cells.share[c]) / 255.0f;
  }
  const Coverage c = measureCoverage(beads, cells, query, kBands, kOne, items);
  ASSERT_EQ(c.items.size(), 2u);
  EXPECT_NEAR(c.items[0].coveredFraction, 1.0, 1e-6);
  EXPECT_NEAR(c.items[1].coveredFraction, 0.0, 1e-6);
  EXPECT_NEAR(c.coveredFraction, 1000.0 / 1008.0, 1e-6);
  EXPECT_GT(c.items[1].worstGap.x(), 14.0);
}

// A box filled but for one block of a millimetre, and as much material half a bead beyond it: each
// is measured by its volume, at any size of the cells.
TEST(Coverage, MissingAndExcessMaterialAreVolumes) {
  const auto part = test::box({0, 0, 0}, {9, 9, 9});
  const geometry::MeshQuery query(part);
  for (const double pitch : {0.25, 0.5}) {
    BeadGrid beads;
    beads.grid = gridOver({-3, -3, -3}, {12, 12, 12}, pitch, 10'000'000);
    beads.fill = base::ZeroedArray<float>(beads.grid.cellCount());
    const PartCells cells = partCells(part, query, beads.grid, kOne);
    const auto isIn = [](const Vector3d& p, const Vector3d& low, const Vector3d& high) {
      return (p.array() > low.array()).all() && (p.array() < high.array()).all();
    };
    for (std::size_t c = 0; c < beads.fill.size(); ++c) {
      const Eigen::Vector3i cell = beads.grid.cell(c);
      const Vector3d at = beads.grid.centre(cell.x(), cell.y(), cell.z());
      const bool missing = isIn(at, {3, 4, 5}, {4, 5, 6});
      const bool outside = isIn(at, {10, 4, 4}, {11, 5, 5});
      beads.fill[c] = outside ? 0.5f : missing ? 0.0f : static_cast<float>(cells.share[c]) / 255.0f;
    }
    const Coverage c = measureCoverage(beads, cells, query, kBands, kOne);
    EXPECT_NEAR(c.coveredFraction, 1.0 - 1.0 / 729.0, 1e-6) << pitch;
    EXPECT_NEAR(c.worstGapMm3, 1.0, 1e-6) << pitch;
    EXPECT_LT((c.worstGap - Vector3d(3.5, 4.5, 5.5)).cwiseAbs().maxCoeff(), 1e-6)
        << "where it is, not the middle of a box about it, which may lie outside the part";
    EXPECT_NEAR(c.outsideMm3, 0.5, 1e-6) << pitch;
  }
}

TEST(Coverage, ASolidBoxIsCovered) {
  const auto part = test::box({0, 0, 0}, {20, 20, 8});
  const Judged j = judge(solidBox(20, 19, 10, 0.8), part, {-2.1, -2.2, -1}, {22, 22, 10});
  EXPECT_GE(j.covered, 0.985);
  EXPECT_NEAR(j.mass, 1.0, 0.003);
  EXPECT_LT(j.overfill, 0.002);
  EXPECT_LT(j.excess, 0.005);
}

TEST(Coverage, AMissingStripIsMissed) {
  const auto part = test::box({0, 0, 0}, {20, 20, 8});
  const Judged whole = judge(solidBox(20, 19, 10, 0.8), part, {-2, -2, -1}, {22, 22, 10});
  const Judged gap = judge(solidBox(20, 19, 10, 0.8, 1.0, 9), part, {-2, -2, -1}, {22, 22, 10});
  EXPECT_NEAR(whole.covered - gap.covered, 1.0 / 19, 0.01);
  EXPECT_NEAR(whole.mass - gap.mass, 1.0 / 19, 0.001);
}

// The round sides of the beads bulge out of a thin wall, and leave notches of the same volume.
TEST(Coverage, AThinWallIsCoveredByTheShareOfItsMaterial) {
  for (const double wall : {1.0, 1.2, 1.5, 1.8, 2.0, 2.4, 3.0, 3.6}) {
    SCOPED_TRACE(wall);
    const auto part = test::box({0, 0, 0}, {30, wall, 8});
    const int lines = std::max(1, static_cast<int>(std::lround(wall / 1.2)));
    const auto covered = [&](double flow, int missingLayer) {
      std::vector<BeadPiece> pieces;
      for (int k = 0; k < 10; ++k)
        for (int l = 0; l < lines && k != missingLayer; ++l) {
          const double y = (l + 0.5) * wall / lines, z = 0.8 * (k + 1);
          addBead(pieces, {{0, y, z}, {30, y, z}}, process::widthOfHatch(wall / lines, 0.8), 0.8,
                  flow);
        }
      return judge(pieces, part, {-2, -2, -1}, {32, wall + 2, 9}).covered;
    };
    // Where a second bead displaces material of the first, some of it moves outwards.
    const double whole = covered(1.0, -1);
    EXPECT_GT(whole, lines == 1 ? 0.985 : 0.975);
    EXPECT_LT(whole, 1.0001);
    EXPECT_NEAR(covered(0.9, -1), 0.9, 0.012);
    EXPECT_NEAR(covered(0.8, -1), 0.8, 0.012);
    EXPECT_NEAR(covered(1.0, 5), 0.9 * whole, 0.006);
  }
}

// Material that bulges out does not fill a gap inside.
TEST(Coverage, AGapBetweenWallsStaysAGap) {
  const auto part = test::box({0, 0, 0}, {30, 4, 8});
  std::vector<BeadPiece> pieces;
  for (int k = 0; k < 10; ++k)
    for (const double y : {0.3, 1.3, 2.7, 3.7}) // Instead of 0.5, 1.5, 2.5, 3.5
      addBead(pieces, {{0, y, 0.8 * (k + 1)}, {30, y, 0.8 * (k + 1)}},
              process::widthOfHatch(1.0, 0.8), 0.8);
  EXPECT_NEAR(judge(pieces, part, {-2, -2, -1}, {32, 6, 9}).covered, 0.9, 0.015);
}

TEST(Coverage, TooMuchFlowIsExcessOrOutside) {
  const auto part = test::box({0, 0, 0}, {20, 20, 8});
  const Judged j = judge(solidBox(20, 19, 10, 0.8, 1.3), part, {-3, -3, -1}, {23, 23, 12});
  EXPECT_NEAR(j.mass, 1.3, 0.01);
  EXPECT_GT(j.overfill + j.excess, 0.2);
}

TEST(Coverage, PartCellsHoldThePartsVolume) {
  const auto ball = test::sphere({0.1, 0.2, 10}, 10, 32);
  const geometry::MeshQuery query(ball);
  const auto grid = gridOver({-12, -12, -1}, {12, 12, 22}, kPitch, 50'000'000);
  const PartCells cells = partCells(ball, query, grid, kOne);
  double volume = 0.0;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
    volume += ball.corner(t, 0).dot(ball.corner(t, 1).cross(ball.corner(t, 2))) / 6.0;
  EXPECT_NEAR(cells.volumeMm3, volume, 0.002 * volume);
}

TEST(Depositor, MaterialIsNeverLost) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<BeadPiece> pieces;
  for (int k = 0; k < 120; ++k) {
    const Vector3d a(12 * u(random), 12 * u(random), 1 + 4 * u(random));
    const Vector3d b = a + 6.0 * Vector3d(u(random) - 0.5, u(random) - 0.5, 0.3 * u(random));
    const Vector3d up = Vector3d(u(random) - 0.5, u(random) - 0.5, 1).normalized();
    addBead(pieces, {a, b}, 1.0 + u(random), 0.4 + 0.6 * u(random), 0.2 + 2 * u(random), up);
  }
  const BeadGrid beads = lay(pieces, {-3, -3, -2}, {15, 15, 9});
  EXPECT_GT(beads.excessMm3, 0.0);
  EXPECT_NEAR((filled(beads) + beads.excessMm3) / beads.depositedMm3, 1.0, 1e-6);
  for (const float f : beads.fill) {
    EXPECT_GE(f, 0.0f);
    EXPECT_LE(f, 1.0f);
  }
  const BeadGrid again = lay(pieces, {-3, -3, -2}, {15, 15, 9}, base::RunContext({}, 2));
  EXPECT_TRUE(beads.fill == again.fill);
  EXPECT_TRUE(beads.filler == again.filler);
  EXPECT_EQ(beads.excessMm3, again.excessMm3);
}

TEST(Depositor, BeadsOnTopOfEachOtherAreExcess) {
  std::vector<BeadPiece> pieces;
  addBead(pieces, {{0, 0, 0.8}, {20, 0, 0.8}}, 1.2, 0.8);
  addBead(pieces, {{0, 0, 0.8}, {20, 0, 0.8}}, 1.2, 0.8);
  const BeadGrid beads = lay(pieces, {-3, -3, -1}, {23, 3, 3});
  // Room for it: the corners of the rectangle and a quarter of a width to either side.
  const double area = process::beadArea(1.2, 0.8), room = 1.5 * 1.2 * 0.8 - area;
  EXPECT_NEAR(beads.excessMm3, 20 * (area - room), 0.15 * 20 * area);
}

TEST(Depositor, StopsWhenCancelled) {
  base::CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(
      lay(solidBox(20, 19, 1, 0.8), {-2, -2, -1}, {22, 22, 3}, base::RunContext(cancel, 2)),
      base::Cancelled);
}

double unsupported(const std::vector<BeadPiece>& pieces, double slackZ = 0.0) {
  const BeadGrid beads = lay(pieces, {-3, -3, -1}, {33, 33, 20 + slackZ});
  const PrintedPart printed(beads, pieces);
  const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
  const GroundProbe platform(plate);
  const SupportedBeads s = findSupport(pieces, printed, platform, kOne);
  return s.unsupportedMm / s.lengthMm;
}

TEST(Support, WallIsSupportedAndBeadInTheAirIsNot) {
  std::vector<BeadPiece> wall, air;
  for (int k = 1; k <= 8; ++k)
    addBead(wall, {{0, 5, 0.8 * k}, {30, 5, 0.8 * k}}, 1.2, 0.8);
  EXPECT_EQ(unsupported(wall), 0.0);
  addBead(air, {{0, 5, 6.0}, {30, 5, 6.0}}, 1.2, 0.8);
  EXPECT_EQ(unsupported(air), 1.0);
}

// A wall whose layers are offset by some of their width: the rest of the width is carried.
SupportedBeads stepping(double offsetMm) {
  std::vector<BeadPiece> pieces;
  for (int k = 1; k <= 6; ++k)
    addBead(pieces, {{0, 5 + offsetMm * k, 0.8 * k}, {30, 5 + offsetMm * k, 0.8 * k}}, 1.2, 0.8);
  const BeadGrid beads = lay(pieces, {-3, -3, -1}, {33, 33, 20});
  const PrintedPart printed(beads, pieces);
  const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
  return findSupport(pieces, printed, GroundProbe(plate), kOne);
}

TEST(Support, CarriedOnLessThanHalfIsMeasuredApart) {
  EXPECT_EQ(stepping(0.0).halfCarriedMm, 0.0);
  EXPECT_EQ(stepping(0.3).halfCarriedMm, 0.0);
  // All but the first layer, which is on the plate.
  EXPECT_NEAR(stepping(0.9).halfCarriedMm, 5.0 * 30.0, 1.0);
  EXPECT_EQ(stepping(0.9).longestUnsupportedMm, 0.0) << "a quarter of it is carried";
  EXPECT_NEAR(stepping(2.0).longestUnsupportedMm, 30.0, 0.1);
}

// Of one bead, without a break: two that follow each other in the air count each by itself.
TEST(Support, TheLongestStretchIsOfOneBead) {
  const auto found = [](const std::vector<double>& lengths) {
    std::vector<BeadPiece> pieces;
    for (std::size_t k = 0; k < lengths.size(); ++k)
      addBead(pieces, {{0, 5.0 + 4.0 * k, 6.0}, {lengths[k], 5.0 + 4.0 * k, 6.0}}, 1.2, 0.8);
    const BeadGrid beads = lay(pieces, {-3, -3, -1}, {33, 33, 20});
    const PrintedPart printed(beads, pieces);
    const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
    return findSupport(pieces, printed, GroundProbe(plate), kOne);
  };
  for (const double first : {0.5, 1.0, 1.5, 10.0}) {
    EXPECT_NEAR(found({first}).longestUnsupportedMm, first, 1e-9);
    EXPECT_EQ(found({first}).longestFrom, 0u);
    EXPECT_NEAR(found({first, 4.0, 2.0}).longestUnsupportedMm, std::max(first, 4.0), 1e-9);
  }
  EXPECT_EQ(found({10.0, 4.0}).longestFrom, 0u);
  EXPECT_EQ(found({1.0, 4.0}).longestFrom, 2u); // pieces are half a millimetre long
  // Two piers: the span between them, less the ends that the piers carry.
  std::vector<BeadPiece> bridge;
  for (const double x : {0.0, 20.0})
    addBead(bridge, {{x, 5, 0.8}, {x + 10, 5, 0.8}}, 1.2, 0.8);
  addBead(bridge, {{0, 5, 1.6}, {30, 5, 1.6}}, 1.2, 0.8);
  const BeadGrid beads = lay(bridge, {-3, -3, -1}, {33, 33, 20});
  const PrintedPart printed(beads, bridge);
  const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
  const SupportedBeads s = findSupport(bridge, printed, GroundProbe(plate), kOne);
  EXPECT_NEAR(s.longestUnsupportedMm, 9.5, 1.0);
  EXPECT_NEAR(bridge[s.longestFrom].from.x(), 10.0, 1.0);
}

// A bead over piers of sparse infill, in a part that is `widthMm` wide across it. Its last
// `beyondMm` are over none.
double overPiers(double gapMm, double beyondMm, double widthMm, double bridgeMm) {
  std::vector<BeadPiece> pieces;
  const double end = 5.0 + gapMm;
  for (const double x : {0.0, end})
    for (const double z : {0.8, 1.6})
      addBead(pieces, {{x, 5, z}, {x + 5, 5, z}}, 1.2, 0.8);
  addBead(pieces, {{0, 5, 2.4}, {end + 5.0 + beyondMm, 5, 2.4}}, 1.2, 0.8);
  const BeadGrid beads = lay(pieces, {-3, -3, -1}, {43, 33, 20});
  const PrintedPart printed(beads, pieces);
  const platform::PlatformSolid plate{{-1, -1}, {41, -1}, {41, 31}, {-1, 31}};
  const geometry::TriangleMesh part =
      test::box({-1, 5 - 0.5 * widthMm, 0}, {41, 5 + 0.5 * widthMm, 4});
  const Bridging bridging{[&](const BeadPiece&) { return bridgeMm; }, geometry::MeshQuery(part)};
  return findSupport(pieces, printed, GroundProbe(plate), kOne, &bridging).unsupportedMm;
}

TEST(BridgedSpans, AreBridgedOnlyBetweenSupportedEnds) {
  EXPECT_EQ(overPiers(5.0, 0.0, 8.0, 6.0), 0.0);
  EXPECT_NEAR(overPiers(9.0, 0.0, 8.0, 6.0), 8.0, 1.5) << "longer than the material bridges";
  EXPECT_EQ(overPiers(9.0, 0.0, 8.0, 10.0), 0.0);
  EXPECT_EQ(overPiers(5.0, 1.5, 8.0, 6.0), 0.0) << "an end no longer than the bead is wide";
  EXPECT_NEAR(overPiers(5.0, 4.5, 8.0, 6.0), 4.0, 1.0) << "an end that nothing holds";
}

// For every position of the cells, neighbours in a layer do not carry each other over a hollow.
TEST(BridgedSpans, NeighboursOfTheSameLayerCarryNothing) {
  for (const double z : {6.0, 6.1, 6.15, 6.2, 6.25, 6.3}) {
    SCOPED_TRACE(z);
    std::vector<BeadPiece> pieces;
    for (int line = 0; line < 8; ++line)
      addBead(pieces, {{0, 5 + 1.03 * line, z}, {30, 5 + 1.03 * line, z}}, 1.2, 0.8);
    const BeadGrid beads = lay(pieces, {-3, -3, -1}, {33, 33, 20});
    const PrintedPart printed(beads, pieces);
    const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
    const geometry::TriangleMesh part = test::box({-1, 0, 0}, {31, 20, 10});
    const Bridging bridging{[](const BeadPiece&) { return 6.0; }, geometry::MeshQuery(part)};
    const SupportedBeads s = findSupport(pieces, printed, GroundProbe(plate), kOne, &bridging);
    EXPECT_NEAR(s.unsupportedMm, s.lengthMm, 1e-6);
  }
}

// The unsupported length of a bead along `path`, over two piers with 10 mm between them.
double overTwoPiers(const std::vector<Eigen::Vector3d>& path, double bridgeMm) {
  std::vector<BeadPiece> pieces;
  for (const double x : {0.0, 20.0})
    for (int line = 0; line < 10; ++line)
      addBead(pieces, {{x, 1.0 + line, 0.8}, {x + 10, 1.0 + line, 0.8}}, 1.2, 0.8);
  addBead(pieces, path, 1.2, 0.8);
  const BeadGrid beads = lay(pieces, {-3, -3, -1}, {33, 33, 20});
  const PrintedPart printed(beads, pieces);
  const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
  const Bridging bridging{[&](const BeadPiece&) { return bridgeMm; }};
  return findSupport(pieces, printed, GroundProbe(plate), kOne, &bridging).unsupportedMm;
}

// Also in the open: straight, between two holds, and no longer than the material bridges.
TEST(BridgedSpans, InTheOpenAreStraightBetweenTwoHolds) {
  EXPECT_EQ(overTwoPiers({{2, 5, 1.6}, {28, 5, 1.6}}, 11.0), 0.0);
  EXPECT_NEAR(overTwoPiers({{2, 5, 1.6}, {28, 5, 1.6}}, 8.0), 9.5, 1.0) << "too long";
  EXPECT_NEAR(overTwoPiers({{2, 5, 1.6}, {14, 5, 1.6}}, 11.0), 3.7, 1.0) << "an end in the air";
  EXPECT_NEAR(overTwoPiers({{2, 4, 1.6}, {12, 4, 1.6}, {12, 6, 1.6}, {2, 6, 1.6}}, 20.0), 5.6, 1.5)
      << "a turn in the air";
  EXPECT_GT(overTwoPiers({{2, 3, 1.6}, {15, 8, 1.6}, {28, 3, 1.6}}, 20.0), 9.0)
      << "a bend in the air";
}

// For every position of the cells, a thin bead is carried by material a twentieth of its height
// below it, and not by material more than half of it below, or beside it.
TEST(Support, CellsDoNotDecideTheSupportOfAThinBead) {
  constexpr double kWidth = 1.2, kHeight = 0.5, kLower = 0.6;
  const platform::PlatformSolid plate{{-1, -1}, {31, -1}, {31, 31}, {-1, 31}};
  const auto found = [&](double gapMm, double offsetMm, double shiftMm, double leanRad) {
    const Eigen::Vector3d up(0.0, std::sin(leanRad), std::cos(leanRad)),
        side(0.0, -std::cos(leanRad), std::sin(leanRad));
    std::vector<BeadPiece> pieces;
    const auto add = [&](double height, const Eigen::Vector3d& off) {
      const std::size_t first = pieces.size();
      const Eigen::Vector3d from(0.0, 10.0, 6.0 + shiftMm);
      addBead(pieces, {from + off, from + Eigen::Vector3d(20.0, 0.0, 0.0) + off}, kWidth, height);
      for (std::size_t p = first; p < pieces.size(); ++p)
        pieces[p].fromDirection = pieces[p].toDirection = up;
    };
    add(kLower, Eigen::Vector3d::Zero());
    add(kHeight, (kHeight + gapMm) * up + offsetMm * side);
    const std::size_t half = pieces.size() / 2;
    const BeadGrid beads = lay(pieces, {-3, 0, 0}, {23, 20, 12});
    const SupportedBeads s =
        findSupport(pieces, PrintedPart(beads, pieces), GroundProbe(plate), kOne);
    // The lower one is unsupported from end to end; of the upper, the length without any support.
    return s.unsupported.size() > half ? 1.0 : s.halfCarriedMm / 20.0 - 1.0;
  };
  for (int k = 0; k < 12; ++k)
    for (const double lean : {0.0, 0.4}) {
      SCOPED_TRACE(testing::Message() << k << " " << lean);
      const double shift = 0.025 * k;
      EXPECT_EQ(found(0.0, 0.0, shift, lean), 0.0);
      EXPECT_EQ(found(0.05 * kHeight, 0.0, shift, lean), 0.0);
      EXPECT_EQ(found(0.15 * kHeight, 0.0, shift, lean), 0.0);
      EXPECT_EQ(found(0.8 * kHeight, 0.0, shift, lean), 1.0);
      EXPECT_EQ(found(0.05 * kHeight, 1.3 * kWidth, shift, lean), 1.0);
    }
}

TEST(Support, ANeighbourInTheSameLayerIsNone) {
  std::vector<BeadPiece> pieces;
  addBead(pieces, {{0, 5, 6.0}, {30, 5, 6.0}}, 1.2, 0.8);
  addBead(pieces,
          {{0, 5 + process::hatchOf(1.2, 0.8), 6.0}, {30, 5 + process::hatchOf(1.2, 0.8), 6.0}},
          1.2, 0.8);
  EXPECT_GT(unsupported(pieces), 0.95);
}

TEST(Support, LeansByHalfAWidthAndOverhangsNoMore) {
  std::vector<BeadPiece> lean, over;
  for (int k = 1; k <= 10; ++k) {
    addBead(lean, {{0, 5 + 0.5 * k, 0.8 * k}, {30, 5 + 0.5 * k, 0.8 * k}}, 1.2, 0.8);
    addBead(over, {{0, 5 + 2.0 * k, 0.8 * k}, {30, 5 + 2.0 * k, 0.8 * k}}, 1.2, 0.8);
  }
  EXPECT_LT(unsupported(lean), 0.01);
  EXPECT_NEAR(unsupported(over), 0.9, 0.01);
}

TEST(Support, ALongBridgeCountsByItsShare) {
  std::vector<BeadPiece> pieces;
  for (int k = 1; k <= 3; ++k)
    for (const double x : {0.0, 20.0})
      addBead(pieces, {{x, 5, 0.8 * k}, {x + 10, 5, 0.8 * k}}, 1.2, 0.8);
  addBead(pieces, {{0, 5, 3.2}, {30, 5, 3.2}}, 1.2, 0.8);
  EXPECT_NEAR(unsupported(pieces), 10.0 / 90.0, 0.02);
}

} // namespace
} // namespace voluta::replay
