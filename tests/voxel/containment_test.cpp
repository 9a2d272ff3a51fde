#include "voxel/containment.h"

#include "geometry/formats/mesh_reader.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "voxel/solid_voxels.h"

#include <gtest/gtest.h>

#include <string>

namespace voluta::voxel {
namespace {

using geometry::TriangleMesh;

void expectContained(const TriangleMesh& mesh, const SolidVoxels& voxels) {
  const test::Containment found = test::checkContainment(mesh, voxels, 20'000, 5);
  EXPECT_EQ(found.surface, 20'000u);
  // A facet on the boundary of two cells may graze the empty one.
  EXPECT_LE(found.deepestMm, kGrazeShare * voxels.grid.pitch);
  EXPECT_GT(found.inside, 500u);
  EXPECT_EQ(found.insideOutside, 0u);
  EXPECT_GT(found.far, 500u);
  EXPECT_EQ(found.farInCells, 0u);
}

class OfModel : public ::testing::TestWithParam<const char*> {};

TEST_P(OfModel, NoPartIsOutsideItsCells) {
  VOLUTA_MODEL_OR_SKIP(file, GetParam());
  const TriangleMesh mesh = geometry::readMesh(file).mesh;
  for (const double pitch : {0.9, 2.3}) {
    const base::RunContext two(base::CancelToken{}, 2);
    const SolidVoxels voxels = solidVoxels(mesh, pitch, two);
    expectContained(mesh, voxels);
    EXPECT_EQ(voxels.solid, solidVoxels(mesh, pitch, base::RunContext{}).solid);
  }
}

INSTANTIATE_TEST_SUITE_P(Containment, OfModel,
                         ::testing::Values("bunny_7k.stl", "hollow_kitten_3mm.stl",
                                           "armadillo_29k.stl", "fandisk.stl", "chair.stl",
                                           "synthetic_candelabra.stl"));

TriangleMesh shellAndBall() {
  TriangleMesh mesh = test::sphere({0, 0, 10}, 10.0);
  test::append(mesh, test::sphere({0, 0, 10}, 8.0), true);
  test::append(mesh, test::sphere({0, 0, 10}, 3.0));
  return mesh;
}

TEST(Containment, CavitiesAndSeveralComponentsAreKept) {
  const TriangleMesh mesh = shellAndBall();
  expectContained(mesh, solidVoxels(mesh, 0.5, base::RunContext{}));
}

TEST(Containment, FaultsInTheCellsAreCaught) {
  const TriangleMesh mesh = shellAndBall();
  const SolidVoxels sound = solidVoxels(mesh, 0.5, base::RunContext{});
  const auto at = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3i c = sound.grid.cellOf(p);
    return sound.grid.index(c.x(), c.y(), c.z());
  };
  const auto block = [&](SolidVoxels v, const Eigen::Vector3d& p, std::uint8_t value) {
    for (int n = 0; n < 27; ++n)
      v.solid[at(p + 0.5 * Eigen::Vector3d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1))] = value;
    return test::checkContainment(mesh, v, 40'000, 5);
  };
  const test::Containment dented = block(sound, {9.5, 0, 10}, 0);
  EXPECT_GT(dented.surfaceOutside, 0u);
  EXPECT_GT(dented.deepestMm, 0.05);
  EXPECT_GT(block(sound, {0, 0, 10}, 0).insideOutside, 0u);
  EXPECT_GT(block(sound, {0, 5.5, 10}, 1).farInCells, 0u);
}

} // namespace
} // namespace voluta::voxel
