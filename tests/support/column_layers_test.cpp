// The layers of columns: measured against their cells and the part's surface.
#include "support/column_layers.h"

#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "curved/voxel_shapes.h"
#include "geometry/measures.h"
#include "support/supports.h"
#include "voxel/voxel_object.h"

#include <gtest/gtest.h>

namespace voluta::support {
namespace {

const base::RunContext kQuiet;
constexpr double kPitch = 1.0;

struct Grown {
  geometry::TriangleMesh mesh; // of the part, z = 0 is the plate
  curved::Decomposition d;
};

// The part as a mesh with its underside lifted by `gap` except on the plate, grown with its
// supports.
Grown grownWithSupports(const voxel::SolidVoxels& part, double gap) {
  Grown g;
  voxel::VoxelObject object;
  object.size = part.grid.size;
  object.solid = part.solid;
  g.mesh = voxel::surfaceOf(object);
  for (Eigen::Vector3d& v : g.mesh.vertices) {
    v = part.grid.origin + part.grid.pitch * v;
    if (v.z() > 0.5 && v.z() < 10.0)
      v.z() += gap;
  }
  const std::vector<Eigen::Vector2d> platform = curved::platformFit(part, 0.0);
  const Supports s = supportsFor(part, platform, {}, kQuiet);
  g.d = curved::decompose(s.solid, platform, {}, kQuiet);
  g.d.support = s.support;
  return g;
}

// A beam on two posts with a tooth down to z = 8 between them.
voxel::SolidVoxels toothPart() {
  return test::voxelPart(
      24, 6, 19,
      [](int i, int j, int k) {
        return i < 4 || i >= 20 || k >= 16 ||
               ((i == 11 || i == 12) && (j == 2 || j == 3) && k >= 8);
      },
      kPitch);
}

double volumeOf(const std::vector<curved::SupportPatch>& slices) {
  double volume = 0.0;
  for (const curved::SupportPatch& s : slices)
    volume += geometry::area(s.patch.surface) * s.patch.thicknessMm[0];
  return volume;
}

TEST(ColumnLayers, FillTheColumnFromThePlateToThePart) {
  constexpr double kGap = 0.3;
  const Grown g = grownWithSupports(toothPart(), kGap);
  const auto slices = columnLayers(g.d, g.mesh, {}, kQuiet);
  ASSERT_EQ(slices.size(), 10u); // 8.3 mm at about 0.8
  double z = 0.0, level = -1.0;
  for (const curved::SupportPatch& s : slices) {
    const double thickness = s.patch.thicknessMm[0];
    EXPECT_GE(thickness, 0.4);
    EXPECT_LE(thickness, 1.0);
    EXPECT_EQ(s.patch.group, layers::kSupportGroup);
    for (const Eigen::Vector3d& v : s.patch.surface.vertices)
      EXPECT_NEAR(v.z(), z + 0.5 * thickness, 1e-9);
    z += thickness;
    EXPECT_GT(s.levelMm, level);
    level = s.levelMm;
    EXPECT_NEAR(geometry::area(s.patch.surface), 1.2 * 1.2, 1e-9); // a bead wide
    for (std::size_t t = 0; t < s.patch.surface.triangles.size(); ++t)
      EXPECT_GT(geometry::triangleNormal(s.patch.surface, t).z(), 0.99);
  }
  EXPECT_NEAR(z, 8.0 + kGap, 1e-6);
  EXPECT_NEAR(volumeOf(slices), 1.44 * (8.0 + kGap), 1e-6);
}

TEST(ColumnLayers, AreAsWideAsTheVoxelWhereThatIsWider) {
  const Grown g = grownWithSupports(toothPart(), 0.0);
  ColumnLayerOptions fine;
  fine.beadWidthMm = 0.5;
  const auto slices = columnLayers(g.d, g.mesh, fine, kQuiet);
  EXPECT_NEAR(volumeOf(slices), 8.0 * kPitch * kPitch, 1e-6);
}

TEST(ColumnLayers, SlicesOfASlantedColumnOverlap) {
  const voxel::SolidVoxels part = test::voxelPart(
      18, 5, 20, [](int i, int, int k) { return (i < 8 && k < 2) || (i >= 13 && k >= 12); });
  const Grown g = grownWithSupports(part, 0.0);
  const auto slices = columnLayers(g.d, g.mesh, {}, kQuiet);
  ASSERT_GT(slices.size(), 8u);
  for (std::size_t n = 1; n < slices.size(); ++n) {
    const Eigen::AlignedBox3d upper = geometry::bounds(slices[n].patch.surface),
                              lower = geometry::bounds(slices[n - 1].patch.surface);
    EXPECT_LT(std::max(upper.min().x(), lower.min().x()) + 0.9,
              std::min(upper.max().x(), lower.max().x()));
  }
}

TEST(ColumnLayers, ArePrintedBeforeTheTeethTheyCarryAndAreNotThePart) {
  const Grown g = grownWithSupports(toothPart(), 0.0);
  const auto slices = columnLayers(g.d, g.mesh, {}, kQuiet);
  const curved::LayersResult with = curved::curvedLayers(g.d, g.mesh, {}, kQuiet, slices);
  const auto isColumn = [](const layers::Patch& p) { return p.group == layers::kSupportGroup; };
  EXPECT_EQ(static_cast<std::size_t>(
                std::count_if(with.stack.patches.begin(), with.stack.patches.end(), isColumn)),
            slices.size());
  EXPECT_NEAR(with.volumeMm3, geometry::volume(g.mesh), 0.01 * geometry::volume(g.mesh));
  EXPECT_EQ(with.unsupportedPatches, 0u);
  std::size_t lastColumn = 0, firstTooth = with.stack.patches.size();
  for (std::size_t p = 0; p < with.stack.patches.size(); ++p) {
    const layers::Patch& patch = with.stack.patches[p];
    if (patch.group == layers::kSupportGroup) {
      lastColumn = p;
      continue;
    }
    const Eigen::AlignedBox3d box = geometry::bounds(patch.surface);
    if (box.min().x() > 10.0 && box.max().x() < 14.0 && box.min().z() < 9.0)
      firstTooth = std::min(firstTooth, p);
  }
  EXPECT_LT(lastColumn, firstTooth);
  EXPECT_LT(firstTooth, with.stack.patches.size());
}

TEST(ColumnLayers, NoneWhereThereIsNoSupport) {
  const voxel::SolidVoxels part = test::boxPart(6, 6, 6);
  const curved::Decomposition d =
      curved::decompose(part, curved::platformFit(part, 0.0), {}, kQuiet);
  EXPECT_TRUE(columnLayers(d, {}, {}, kQuiet).empty());
}

} // namespace
} // namespace voluta::support
