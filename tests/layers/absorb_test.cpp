// Absorbed slivers, by independent measures: which vertices rise, how far, and how much.
#include "helpers/flat_square.h"
#include "layers/absorb.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::layers {
namespace {

using Eigen::Vector3d;

Patch patchOf(LevelSurface s, int layer) {
  Patch p;
  p.surface = std::move(s.surface);
  p.thicknessMm = std::move(s.thicknessMm);
  p.direction = std::move(s.direction);
  p.layer = layer;
  return p;
}

Patch square(double half, double step, double z, double thickness, int layer) {
  return patchOf(test::flatSquare(half, step, z, thickness), layer);
}

// A third of the triangles around each vertex.
std::vector<double> shares(const geometry::TriangleMesh& mesh) {
  std::vector<double> area(mesh.vertices.size(), 0.0);
  for (const auto& t : mesh.triangles) {
    const Vector3d &a = mesh.vertices[static_cast<std::size_t>(t[0])],
                   &b = mesh.vertices[static_cast<std::size_t>(t[1])],
                   &c = mesh.vertices[static_cast<std::size_t>(t[2])];
    for (const int v : t)
      area[static_cast<std::size_t>(v)] += (b - a).cross(c - a).norm() / 6.0;
  }
  return area;
}

bool onRim(const Vector3d& p, double half) {
  return std::max(std::abs(p.x()), std::abs(p.y())) > half - 1e-9;
}

constexpr double kHalf = 0.4, kSliverMm = 0.5, kVolume = 4 * kHalf * kHalf * kSliverMm;
Patch sliverAt(double z) {
  return square(kHalf, 0.2, z, kSliverMm, 2);
}

} // namespace

TEST(AbsorbSlivers, PatchesUnderAndOverRiseEvenlyUntilTheyAreFull) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> thickness(0.66, 0.8);
  std::vector<Patch> patches{square(5, 0.25, 2.2, 0.7, 3), square(5, 0.25, 1.0, 0.7, 1)};
  for (Patch& patch : patches)
    for (double& t : patch.thicknessMm)
      t = thickness(random);
  const std::vector<Patch> before = patches;
  const AbsorbOptions options{0.8, 1.2, 0.0};
  const Absorbed a = absorbSlivers(patches, {sliverAt(1.6)}, options);
  EXPECT_EQ(a.merged, 1u);
  EXPECT_EQ(a.refused, 0u);
  EXPECT_TRUE(a.dropped.empty());

  double maximum = 0.0, taken = 0.0;
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t v = 0; v < patches[p].thicknessMm.size(); ++v)
      maximum = std::max(maximum, patches[p].thicknessMm[v] - before[p].thicknessMm[v]);
  std::size_t full = 0, free = 0;
  for (std::size_t p = 0; p < 2; ++p) {
    const std::vector<double> area = shares(before[p].surface);
    for (std::size_t v = 0; v < area.size(); ++v) {
      const Vector3d &from = before[p].surface.vertices[v], &to = patches[p].surface.vertices[v];
      const double rise = patches[p].thicknessMm[v] - before[p].thicknessMm[v];
      const double room = options.heightMaxMm - before[p].thicknessMm[v];
      const double lateral = std::max(std::abs(from.x()), std::abs(from.y()));
      if (rise == 0.0) {
        EXPECT_EQ(from, to);
        EXPECT_GT(lateral, kHalf) << "what the sliver lies on takes of it";
        continue;
      }
      EXPECT_LT(lateral, kHalf + 0.5 * options.beadWidthMm);
      EXPECT_NEAR(rise, std::min(room, maximum), 1e-12);
      // Its far side stays; patches under the sliver grow up, patches over it down.
      const double distance = p == 0 ? -0.5 * rise : 0.5 * rise;
      EXPECT_LT((to - from - Vector3d(0, 0, distance)).norm(), 1e-12);
      taken += rise * area[v];
      (rise < room - 1e-12 ? free : full)++;
    }
  }
  EXPECT_GT(full, 10u);
  EXPECT_GT(free, 10u);
  EXPECT_NEAR(taken, kVolume, 1e-9);
  EXPECT_NEAR(a.mergedVolumeMm3, kVolume, 1e-9);
}

// All available room is used, and the rest of the sliver has its share of the area.
TEST(AbsorbSlivers, VolumeWithoutRoomIsDropped) {
  for (const double roomMm : {0.02, 0.06}) {
    std::vector<Patch> patches{square(5, 0.25, 1.0, 0.7, 1)};
    const std::vector<Patch> before = patches;
    const Absorbed a = absorbSlivers(patches, {sliverAt(1.6)}, {0.7 + roomMm, 1.2, 0.0});
    const std::vector<double> area = shares(before[0].surface);
    double room = 0.0;
    for (std::size_t v = 0; v < area.size(); ++v)
      if (patches[0].thicknessMm[v] > before[0].thicknessMm[v]) {
        EXPECT_NEAR(patches[0].thicknessMm[v], 0.7 + roomMm, 1e-12);
        room += area[v] * roomMm;
      }
    EXPECT_NEAR(a.mergedVolumeMm3, room, 1e-9);
    ASSERT_EQ(a.dropped.size(), 1u);
    EXPECT_EQ(a.merged, 0u);
    EXPECT_NEAR(a.dropped[0].volumeMm3, kVolume - room, 1e-9);
    EXPECT_NEAR(a.dropped[0].areaMm2, (kVolume - room) / kSliverMm, 1e-9);
    EXPECT_LT((a.dropped[0].centre - Vector3d(0, 0, 1.6)).norm(), 1e-9);
    EXPECT_EQ(a.dropped[0].level, 2);
  }
}

// A sliver with room for a given share: refused where the required share is greater, merged where
// hardly anything remains.
TEST(AbsorbSlivers, AreRefusedMergedOrDroppedByTheShareThatFindsRoom) {
  const auto absorbed = [](double roomMm, double minShare, std::vector<Patch>& patches) {
    patches = {square(5, 0.25, 1.0, 0.7, 1)};
    return absorbSlivers(patches, {sliverAt(1.6)}, {0.7 + roomMm, 1.2, minShare});
  };
  std::vector<Patch> patches;
  const double area = absorbed(0.02, 0.0, patches).mergedVolumeMm3 / 0.02;
  for (const double share : {0.3, 0.6, 0.94, 0.96}) {
    SCOPED_TRACE(share);
    const double roomMm = share * kVolume / area;
    const Absorbed taken = absorbed(roomMm, share - 0.01, patches);
    EXPECT_EQ(taken.refused, 0u);
    EXPECT_NEAR(taken.mergedVolumeMm3, share * kVolume, 1e-9);
    EXPECT_EQ(taken.merged, share > 0.95 ? 1u : 0u);
    EXPECT_EQ(taken.dropped.size(), share > 0.95 ? 0u : 1u);

    const Absorbed refused = absorbed(roomMm, share + 0.01, patches);
    EXPECT_EQ(refused.refused, 1u);
    EXPECT_EQ(refused.merged + refused.dropped.size(), 0u);
    EXPECT_EQ(refused.mergedVolumeMm3, 0.0);
    for (const double t : patches[0].thicknessMm)
      EXPECT_EQ(t, 0.7);
  }
}

TEST(AbsorbSlivers, OnlyPatchesDirectlyUnderOrOverTakePart) {
  const auto takes = [](Patch patch) {
    std::vector<Patch> patches{std::move(patch)};
    const std::vector<double> before = patches[0].thicknessMm;
    const Absorbed a = absorbSlivers(patches, {sliverAt(1.6)}, {1.0, 1.2, 0.0});
    EXPECT_EQ(a.mergedVolumeMm3 > 0.0, patches[0].thicknessMm != before);
    return a.mergedVolumeMm3 > 0.0;
  };
  EXPECT_TRUE(takes(square(5, 0.25, 1.0, 0.7, 1)));
  EXPECT_TRUE(takes(square(5, 0.25, 2.2, 0.7, 3)));
  EXPECT_FALSE(takes(square(5, 0.25, 1.0, 0.7, 2))) << "its own layer";
  EXPECT_FALSE(takes(square(5, 0.25, 1.0, 0.7, 3))) << "below, but laid later";
  EXPECT_FALSE(takes(square(5, 0.25, 0.2, 0.7, 1))) << "one layer is between";
  EXPECT_FALSE(takes(square(5, 0.25, 1.0, 1.0, 1))) << "full";
  EXPECT_FALSE(takes(square(0.6, 1.2, 1.0, 0.7, 1))) << "has no inner vertices";
  Patch support = square(5, 0.25, 1.0, 0.7, 1);
  support.group = kSupportGroup;
  EXPECT_FALSE(takes(support));
  Patch away = square(5, 0.25, 1.0, 0.7, 1);
  for (Vector3d& d : away.direction)
    d = -d;
  EXPECT_FALSE(takes(away));
  // The square's rim at x = 5 + shift; the sliver's is at -0.4, and half a bead is 0.6.
  for (const double gap : {0.1, 0.9}) {
    Patch beside = square(5, 0.25, 1.0, 0.7, 1);
    for (Vector3d& p : beside.surface.vertices)
      p.x() -= 5.0 + kHalf + gap;
    EXPECT_EQ(takes(beside), gap < 0.6) << gap;
  }
}

TEST(AbsorbSlivers, RimsStayOnThePart) {
  std::vector<Patch> patches{square(0.5, 0.25, 1.0, 0.7, 1)};
  const Patch before = patches[0];
  absorbSlivers(patches, {sliverAt(1.6)}, {1.0, 1.2, 0.0});
  for (std::size_t v = 0; v < before.thicknessMm.size(); ++v)
    EXPECT_EQ(patches[0].thicknessMm[v] == before.thicknessMm[v],
              onRim(before.surface.vertices[v], 0.5));
}

} // namespace voluta::layers
