// Bodies that overlap and surfaces that cross themselves become one solid: no crossing is left, and
// its volume is that of the union.
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/repair/repair.h"
#include "helpers/all_seeds.h"
#include "helpers/bow_tie.h"
#include "helpers/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;

TriangleMesh turned(TriangleMesh mesh, const Eigen::Quaterniond& by, const Vector3d& to) {
  for (Vector3d& v : mesh.vertices)
    v = by * v + to;
  return mesh;
}

// A tube of `sides` about a helix, closed at its ends: where the pitch is less than its width it
// sweeps through itself.
TriangleMesh thread(double radius, double pitch, double tubeRadius, int turns,
                    int perRevolution = 32, int sides = 10) {
  TriangleMesh m;
  const int rings = turns * perRevolution;
  for (int i = 0; i <= rings; ++i) {
    const double a = 2.0 * base::kPi * i / perRevolution;
    const Vector3d out(std::cos(a), std::sin(a), 0.0);
    const Vector3d middle = radius * out + Vector3d(0, 0, pitch * i / perRevolution);
    for (int s = 0; s < sides; ++s) {
      const double b = 2.0 * base::kPi * s / sides;
      m.vertices.push_back(middle +
                           tubeRadius * (std::cos(b) * out + std::sin(b) * Vector3d::UnitZ()));
    }
  }
  const auto at = [&](int i, int s) { return i * sides + s % sides; };
  for (int i = 0; i < rings; ++i)
    for (int s = 0; s < sides; ++s) {
      m.triangles.push_back({at(i, s), at(i, s + 1), at(i + 1, s + 1)});
      m.triangles.push_back({at(i, s), at(i + 1, s + 1), at(i + 1, s)});
    }
  for (int s = 1; s + 1 < sides; ++s) {
    m.triangles.push_back({at(0, 0), at(0, s + 1), at(0, s)});
    m.triangles.push_back({at(rings, 0), at(rings, s), at(rings, s + 1)});
  }
  return test::facingOutward(m);
}

// Share of the box of `mesh` in which the winding number is 1 or more, times the box's volume.
double sampledVolume(const TriangleMesh& mesh, int samples) {
  const MeshQuery query(mesh);
  const Eigen::AlignedBox3d box = bounds(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> in(0.0, 1.0);
  int inside = 0;
  for (int i = 0; i < samples; ++i) {
    const Vector3d p =
        box.min() + box.sizes().cwiseProduct(Vector3d(in(random), in(random), in(random)));
    inside += query.inside(p) ? 1 : 0;
  }
  return box.volume() * inside / samples;
}

void expectUnited(const TriangleMesh& mesh, const std::string& what) {
  const RepairResult united = repair(mesh);
  EXPECT_TRUE(united.diagnosis.watertight) << what;
  EXPECT_EQ(united.diagnosis.selfIntersections.count, 0u) << what;
  EXPECT_FALSE(united.repairs.empty()) << what;
  constexpr int kSamples = 20000;
  const double sampled = sampledVolume(mesh, kSamples);
  const double box = united.diagnosis.boundsMm.volume();
  // Three standard deviations.
  EXPECT_NEAR(united.diagnosis.volumeMm3, sampled, 1.5 * box / std::sqrt(kSamples)) << what;
}

TEST(WindingUnion, ManyBalls) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(0.0, 60.0);
  TriangleMesh m;
  for (int i = 0; i < 30; ++i)
    test::append(m, test::sphere({in(random), in(random), in(random)}, 10.0, 8));
  expectUnited(m, "30 balls");
}

TEST(WindingUnion, BoxesInAndOutOfLine) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    TriangleMesh m;
    for (int i = 0; i < 6; ++i) {
      // On a grid, so that faces, edges and corners coincide.
      const Vector3d low(random() % 5, random() % 5, random() % 5);
      const Vector3d size(1 + random() % 3, 1 + random() % 3, 1 + random() % 3);
      test::append(m, test::box(low, low + size));
    }
    const RepairResult united = repair(m);
    EXPECT_TRUE(united.diagnosis.watertight) << seed;
    int cells = 0;
    const MeshQuery query(m);
    for (int x = 0; x < 8; ++x)
      for (int y = 0; y < 8; ++y)
        for (int z = 0; z < 8; ++z)
          cells += query.windingNumber({x + 0.5, y + 0.5, z + 0.5}) > 0.5;
    EXPECT_NEAR(united.diagnosis.volumeMm3, cells, 1e-6) << seed;
  }
}

TEST(WindingUnion, TurnedBoxes) {
  for (unsigned seed = 1; seed <= test::ofSeeds(3u, 10u); ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> in(-1.0, 1.0);
    TriangleMesh m;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Quaterniond rotation =
          Eigen::Quaterniond(in(random), in(random), in(random), in(random)).normalized();
      test::append(m, turned(test::box({-3, -4, -5}, {3, 4, 5}), rotation,
                             4.0 * Vector3d(in(random), in(random), in(random))));
    }
    expectUnited(m, "turned boxes " + std::to_string(seed));
  }
}

TEST(WindingUnion, AThreadThatSweepsThroughItself) {
  const TriangleMesh m = thread(10.0, 3.0, 2.0, 4);
  EXPECT_GT(diagnose(m).selfIntersections.count, 0u);
  const RepairResult united = repair(m);
  EXPECT_THAT(base::english(united.repairs),
              ::testing::Contains(::testing::HasSubstr("self-intersections of 1 component")));
  expectUnited(m, "thread");
}

TEST(WindingUnion, InvertedLobeIsNamedAndNotDropped) {
  const TriangleMesh m = test::bowTie({0, 0, 0}, 20.0, 12.0, 8.0, 5.0);
  const RepairResult result = repair(m);
  EXPECT_EQ(result.mesh.triangles, m.triangles);
  EXPECT_TRUE(result.repairs.empty());
  EXPECT_THAT(base::english(result.remains),
              ::testing::Contains(::testing::HasSubstr("30.8 % of the enclosed volume")));
  // Two bodies that overlap do not hide it.
  TriangleMesh more = test::box({0, 20, 0}, {20, 40, 20});
  test::append(more, test::box({10, 30, 10}, {30, 50, 30}));
  test::append(more, m);
  EXPECT_THAT(base::english(repair(more).remains),
              ::testing::Contains(::testing::HasSubstr("of the enclosed volume")));
}

TEST(WindingUnion, SmallInvertedLoopIsRemoved) {
  const RepairResult result = repair(test::bowTie({0, 0, 0}, 20.0, 12.0, 0.6, 5.0));
  EXPECT_TRUE(result.remains.empty());
  EXPECT_EQ(result.diagnosis.selfIntersections.count, 0u);
  EXPECT_NEAR(result.diagnosis.volumeMm3, 0.5 * 12.0 * (20.0 * 12.0 / 12.6) * 5.0, 1e-6);
}

TEST(WindingUnion, CavitiesStay) {
  TriangleMesh m = test::box({0, 0, 0}, {10, 10, 10});
  test::append(m, test::box({2, 2, 2}, {8, 8, 8}), true);
  test::append(m, test::box({5, 5, 5}, {15, 15, 15})); // fills an eighth of the cavity
  const RepairResult united = repair(m);
  EXPECT_TRUE(united.diagnosis.watertight);
  EXPECT_NEAR(united.diagnosis.volumeMm3, 1000 + 1000 - 125 - (216 - 27), 1e-6);
}

TEST(WindingUnion, EqualBodiesAreOne) {
  TriangleMesh m = test::sphere({0, 0, 0}, 10.0, 8);
  const double once = volume(m);
  test::append(m, test::sphere({0, 0, 0}, 10.0, 8));
  const RepairResult united = repair(m);
  EXPECT_TRUE(united.diagnosis.clean());
  EXPECT_NEAR(united.diagnosis.volumeMm3, once, 1e-9);
}

} // namespace
} // namespace voluta::geometry
