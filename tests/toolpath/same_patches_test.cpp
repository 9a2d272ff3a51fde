// Layers of the same shape.
#include "base/run_context.h"
#include "geometry/polygon_paths.h"
#include "patch_shapes.h"
#include "toolpath/plane/plane_patch.h"
#include "toolpath/plane/same_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace voluta::toolpath {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

// `seed`: of points on the straight edges, as triangles of a mesh leave them.
layers::Patch layerAt(int layer, const test::Loop& loop, unsigned seed, double heightMm = 0.8,
                      const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity()) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.2, 0.8);
  ClipperLib::Path path;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    path.push_back(geometry::pathPoint(a));
    const double t = share(random);
    path.push_back(geometry::pathPoint((1.0 - t) * a + t * b));
  }
  std::ranges::rotate(path, path.begin() + static_cast<std::ptrdiff_t>(seed % path.size()));
  PlanePatch plane;
  plane.outline = {path};
  plane.direction = plane.clearDirection = rotation * Vector3d::UnitZ();
  plane.plane_R_work =
      Eigen::Quaterniond::FromTwoVectors(plane.direction, Vector3d::UnitZ()).toRotationMatrix();
  plane.heightMm = 0.4 + 0.8 * layer;
  plane.thicknessMm = heightMm;
  layers::Patch like;
  like.layer = layer;
  return patchOver({path}, plane, like).value();
}

std::vector<SameShape> sameOf(const std::vector<layers::Patch>& patches,
                              std::vector<std::vector<double>> choices = {}) {
  choices.resize(patches.size());
  std::vector<const layers::Patch*> all;
  for (const layers::Patch& patch : patches)
    all.push_back(&patch);
  return sameShapes(all, choices, base::RunContext());
}

TEST(SamePatches, LayersOfAPrismAreMovedCopies) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 0).normalized()));
  for (const Eigen::Quaterniond& rotation : {Eigen::Quaterniond::Identity(), turn}) {
    std::vector<layers::Patch> patches;
    for (int layer = 0; layer < 5; ++layer)
      patches.push_back(
          layerAt(layer, test::ell(20, 7), 1U + static_cast<unsigned>(layer), 0.8, rotation));
    const std::vector<SameShape> same = sameOf(patches);
    for (int layer = 0; layer < 5; ++layer) {
      EXPECT_EQ(same[static_cast<std::size_t>(layer)].patch, 0U);
      EXPECT_LT(
          (same[static_cast<std::size_t>(layer)].shiftMm - rotation * Vector3d(0, 0, 0.8 * layer))
              .norm(),
          1e-9);
    }
  }
}

TEST(SamePatches, AnyDifferenceMatters) {
  const test::Loop loop = test::rectangle(20, 10);
  std::vector<layers::Patch> patches{
      layerAt(0, loop, 1), layerAt(1, loop, 2, 0.7), layerAt(2, test::rectangle(20.002, 10), 3),
      layerAt(3, loop, 4), layerAt(4, loop, 5),      layerAt(5, loop, 6),
      layerAt(6, loop, 7), layerAt(7, loop, 8)};
  patches[3].group = 1;
  patches[4].tool = 1;
  patches[5].clearDirection.assign(patches[5].direction.size(), Vector3d::UnitX());
  patches[6].direction.front() = Vector3d(0.0, 0.1, 1.0).normalized(); // no plane layer
  std::vector<std::vector<double>> choices(patches.size());
  choices[7] = {1.0};
  const std::vector<SameShape> same = sameOf(patches, choices);
  for (std::size_t i = 0; i < same.size(); ++i) {
    EXPECT_EQ(same[i].patch, i);
    EXPECT_TRUE(same[i].shiftMm.isZero());
  }
}

TEST(SamePatches, RandomRectanglesFindTheirFirst) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> size(1, 4);
  std::vector<layers::Patch> patches;
  std::vector<int> drawn;
  for (int layer = 0; layer < 40; ++layer) {
    drawn.push_back(size(random));
    patches.push_back(
        layerAt(layer, test::rectangle(5.0 + drawn.back(), 8.0), static_cast<unsigned>(layer)));
  }
  const std::vector<SameShape> same = sameOf(patches);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    EXPECT_EQ(same[i].patch,
              static_cast<std::size_t>(std::ranges::find(drawn, drawn[i]) - drawn.begin()));
}

} // namespace
} // namespace voluta::toolpath
