// Surfaces that enclose nothing are not closed in silence; holes in solids still are.
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/repair/repair.h"
#include "helpers/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

// A grid over [0, size]^2 with the height of a function.
template <typename Height> TriangleMesh sheet(double size, int cells, const Height& height) {
  TriangleMesh m;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double x = size * i / cells, y = size * j / cells;
      m.vertices.emplace_back(x, y, height(x, y));
    }
  const auto at = [&](int i, int j) { return j * (cells + 1) + i; };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return m;
}

TriangleMesh flatSheet(double size = 20.0) {
  return sheet(size, 8, [](double, double) { return 0.0; });
}

// Both sides of every triangle, on the same vertices.
TriangleMesh doubleSided(TriangleMesh m) {
  const std::size_t count = m.triangles.size();
  for (std::size_t t = 0; t < count; ++t)
    m.triangles.push_back({m.triangles[t][0], m.triangles[t][2], m.triangles[t][1]});
  return m;
}

// The part of a mesh whose triangles are below a height.
TriangleMesh below(const TriangleMesh& mesh, double z) {
  std::vector<bool> keep;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    keep.push_back((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)).z() / 3.0 < z);
  return subMesh(mesh, keep);
}

std::string firstLine(const RepairResult& result) {
  return result.remains.empty() ? std::string() : base::english(result.remains.front());
}

TEST(OpenSurface, ABowlWithoutThicknessIsNotFilled) {
  const TriangleMesh bowl = below(test::sphere({0, 0, 0}, 20.0), 0.0);
  const RepairResult kept = repair(bowl);
  ASSERT_TRUE(kept.open);
  EXPECT_EQ(kept.open->rims, 1u);
  EXPECT_EQ(kept.mesh.triangles.size(), bowl.triangles.size());
  EXPECT_THAT(firstLine(kept), HasSubstr("open surface: it ends at 1 rim"));
  const RepairResult closed = repair(bowl, {}, OpenSurfaces::Close);
  EXPECT_FALSE(closed.open);
  EXPECT_TRUE(closed.diagnosis.watertight);
  EXPECT_NEAR(closed.diagnosis.volumeMm3, 2.0 / 3.0 * base::kPi * 8000.0, 300.0);
}

TEST(OpenSurface, EveryKindOfSurfaceThatEndsIsFound) {
  TriangleMesh tube = test::box({0, 0, 0}, {20, 20, 60});
  tube.triangles.erase(tube.triangles.begin(), tube.triangles.begin() + 4); // bottom and top
  TriangleMesh cup = test::box({0, 0, 0}, {20, 20, 60});
  cup.triangles.erase(cup.triangles.begin() + 2, cup.triangles.begin() + 4); // top
  const TriangleMesh hills =
      sheet(40.0, 20, [](double x, double y) { return 3.0 * std::sin(x / 4) * std::cos(y / 5); });
  for (const auto& [name, mesh] :
       {std::pair("tube", tube), std::pair("cup", cup), std::pair("hills", hills)}) {
    const RepairResult kept = repair(mesh);
    ASSERT_TRUE(kept.open) << name;
    EXPECT_TRUE(kept.open->hasOpenRims()) << name;
    EXPECT_EQ(kept.mesh.triangles.size(), mesh.triangles.size()) << name;
  }
}

TEST(OpenSurface, HolesInASolidAreClosed) {
  std::mt19937 random(7);
  const TriangleMesh ball = test::sphere({0, 0, 0}, 20.0);
  for (int run = 0; run < 50; ++run) {
    TriangleMesh m = ball;
    for (int hole = 0; hole < 5; ++hole)
      m.triangles.erase(m.triangles.begin() +
                        static_cast<std::ptrdiff_t>(random() % m.triangles.size()));
    const RepairResult mended = repair(m);
    EXPECT_FALSE(mended.open) << run;
    EXPECT_TRUE(mended.diagnosis.watertight) << run;
    EXPECT_NEAR(mended.diagnosis.volumeMm3 / volume(ball), 1.0, 0.01) << run;
  }
}

TEST(SheetModel, NothingIsDroppedInSilence) {
  // Walls of a house, both sides of each, and one small solid: 18 of 12,756 in the part that found
  // this.
  TriangleMesh m = doubleSided(flatSheet(100.0));
  test::append(m, doubleSided(sheet(100.0, 8, [](double x, double) { return 5.0 + 0.2 * x; })));
  const std::size_t sheets = m.triangles.size();
  test::append(m, test::box({40, 40, 1}, {44, 44, 4}));
  const RepairResult kept = repair(m);
  ASSERT_TRUE(kept.open);
  EXPECT_TRUE(kept.open->isSheetModel());
  EXPECT_EQ(kept.open->sheetTriangles, sheets);
  EXPECT_EQ(kept.mesh.triangles.size(), m.triangles.size());
  EXPECT_THAT(firstLine(kept), HasSubstr("sheet model: "));
  EXPECT_THAT(base::english(kept.repairs),
              ::testing::Not(::testing::Contains(HasSubstr("duplicate triangle"))))
      << "both sides of a sheet are no repeats";
  const RepairResult closed = repair(m, {}, OpenSurfaces::Close);
  EXPECT_EQ(closed.mesh.triangles.size(), 12u);
  EXPECT_THAT(base::english(closed.repairs),
              ::testing::Contains(HasSubstr("triangles of sheets without volume")));
}

TEST(SheetModel, KeptSheetsAreNotListedAsDropped) {
  // A cup, open by its rim, and a stray sheet beside it.
  TriangleMesh cup = test::box({0, 0, 0}, {50, 50, 50});
  cup.triangles.erase(cup.triangles.begin() + 2, cup.triangles.begin() + 4); // top
  TriangleMesh stray = doubleSided(flatSheet(2.0));
  for (Vector3d& v : stray.vertices)
    v += Vector3d(80, 0, 0);
  test::append(cup, stray);
  const RepairResult kept = repair(cup);
  ASSERT_TRUE(kept.open);
  EXPECT_FALSE(kept.open->isSheetModel());
  EXPECT_EQ(kept.mesh.triangles.size(), cup.triangles.size());
  EXPECT_THAT(base::english(kept.repairs),
              ::testing::Not(::testing::Contains(HasSubstr("sheets without volume"))));
  EXPECT_THAT(base::english(repair(cup, {}, OpenSurfaces::Close).repairs),
              ::testing::Contains(HasSubstr("sheets without volume")));
}

TEST(SheetModel, ASheetAloneIsOne) {
  for (const TriangleMesh& m : {flatSheet(), doubleSided(flatSheet())}) {
    const RepairResult kept = repair(m);
    ASSERT_TRUE(kept.open);
    EXPECT_TRUE(kept.open->isSheetModel());
    EXPECT_EQ(kept.mesh.triangles.size(), m.triangles.size());
  }
}

TEST(SheetModel, StraySheetBesideASolidIsRemoved) {
  TriangleMesh m = test::sphere({0, 0, 0}, 50.0);
  test::append(m, doubleSided(flatSheet(2.0)));
  const RepairResult mended = repair(m);
  EXPECT_FALSE(mended.open);
  EXPECT_TRUE(mended.diagnosis.clean());
}

TEST(Thickened, ASheetBecomesAPlateOfThatWidth) {
  constexpr double kSize = 20.0, kWall = 2.0;
  // The plate, and half a cylinder along its rim.
  const double expected = kSize * kSize * kWall + 4.0 * kSize * base::kPi * kWall * kWall / 8.0;
  for (const TriangleMesh& m : {flatSheet(kSize), doubleSided(flatSheet(kSize))}) {
    const TriangleMesh plate = thickened(m, kWall, {});
    const Diagnosis d = diagnose(plate);
    EXPECT_TRUE(d.watertight);
    EXPECT_EQ(d.selfIntersections.count, 0u);
    EXPECT_NEAR(d.volumeMm3 / expected, 1.0, 0.06); // the rim has few sides
    EXPECT_NEAR(d.boundsMm.sizes().z(), kWall, 0.02);
  }
}

TEST(Thickened, SolidsStayAsTheyAre) {
  TriangleMesh m = flatSheet();
  test::append(m, test::box({5, 5, -4}, {10, 10, 4}));
  const TriangleMesh both = thickened(m, 2.0, {});
  const Diagnosis d = diagnose(both);
  EXPECT_TRUE(d.watertight);
  EXPECT_EQ(d.components, 1);
  EXPECT_NEAR(d.boundsMm.sizes().z(), 8.0, 1e-9);
  EXPECT_EQ(d.selfIntersections.count, 0u);
}

TEST(Thickened, ABowlStaysOpen) {
  const TriangleMesh bowl = below(test::sphere({0, 0, 0}, 20.0), 0.0);
  const Diagnosis d = diagnose(thickened(bowl, 2.0, {}));
  EXPECT_TRUE(d.watertight);
  EXPECT_NEAR(d.volumeMm3, 2.0 * area(bowl), 0.1 * 2.0 * area(bowl));
}

} // namespace
} // namespace voluta::geometry
