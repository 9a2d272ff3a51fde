// Pieces that print without support: parts whose best number of pieces is worked out by hand, and
// checks of the results that are independent of the search.
#include "planar/search/beam_search.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "planar/hand_parts.h"
#include "planar/head_reach.h"
#include "planar/plan_checker.h"
#include "planar/plate_contact.h"
#include "process/process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace voluta::planar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::TriangleMesh;

constexpr double kDegree = base::degreesToRadians(1.0);

TriangleMesh tee() {
  return test::extruded(
      {{-4, 0}, {4, 0}, {4, 20}, {20, 20}, {20, 28}, {-20, 28}, {-20, 20}, {-4, 20}}, -4, 4);
}

// Arms that lean out by 60 degrees from upright.
TriangleMesh wye() {
  const double reach = 24.0, rise = reach / std::sqrt(3.0);
  return test::extruded({{-4, 0},
                         {4, 0},
                         {4, 16},
                         {4 + reach, 16 + rise},
                         {4 + reach, 24 + rise},
                         {0, 24 - 4 / std::sqrt(3.0)},
                         {-4 - reach, 24 + rise},
                         {-4 - reach, 16 + rise},
                         {-4, 16}},
                        -4, 4);
}

// A square cap on a square stem.
TriangleMesh mushroom() {
  TriangleMesh m;
  const double s = 5.0, c = 15.0;
  const auto square = [&](double r, double z) {
    const int first = static_cast<int>(m.vertices.size());
    for (const Vector2d& p : {Vector2d(-r, -r), Vector2d(r, -r), Vector2d(r, r), Vector2d(-r, r)})
      m.vertices.emplace_back(p.x(), p.y(), z);
    return first;
  };
  const std::array<int, 4> rings{square(s, 0.0), square(s, 20.0), square(c, 20.0), square(c, 28.0)};
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
    for (int j = 0; j < 4; ++j) {
      const int i = (j + 1) % 4;
      m.triangles.push_back({rings[k] + j, rings[k] + i, rings[k + 1] + i});
      m.triangles.push_back({rings[k] + j, rings[k + 1] + i, rings[k + 1] + j});
    }
  for (const auto& t : {std::array{0, 2, 1}, std::array{0, 3, 2}})
    m.triangles.push_back({t[0], t[1], t[2]});
  for (const auto& t : {std::array{0, 1, 2}, std::array{0, 2, 3}})
    m.triangles.push_back({rings[3] + t[0], rings[3] + t[1], rings[3] + t[2]});
  return m;
}

// A post, an arm to the side of it and a square drop below the arm.
TriangleMesh hanging() {
  return test::extruded(
      {{0, 0}, {10, 0}, {10, 40}, {30, 40}, {30, 20}, {40, 20}, {40, 50}, {0, 50}}, -5, 5);
}

PlanarOptions withHead() {
  PlanarOptions options;
  options.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
  return options;
}

// Solid angle of the triangle seen from p, signed (Van Oosterom and Strackee 1983).
double solidAngle(const TriangleMesh& m, std::size_t t, const Vector3d& p) {
  const Vector3d a = m.corner(t, 0) - p, b = m.corner(t, 1) - p, c = m.corner(t, 2) - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}
bool within(const TriangleMesh& m, const Vector3d& p) {
  double sum = 0.0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    sum += solidAngle(m, t, p);
  return sum > 2.0 * base::kPi;
}

// Points spread over a mesh, corners drawn in a little.
std::vector<Vector3d> spread(const TriangleMesh& m, double spacing) {
  std::vector<Vector3d> out;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const Vector3d &a = m.corner(t, 0), &b = m.corner(t, 1), &c = m.corner(t, 2);
    const int n = 1 + static_cast<int>(std::max((b - a).norm(), (c - a).norm()) / spacing);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vector3d q = a + (b - a) * i / n + (c - a) * j / n;
        out.push_back(q + 1e-3 * ((a + b + c) / 3.0 - q));
      }
  }
  return out;
}

// Invariants of pieces, whatever the search.
void check(const TriangleMesh& part, const PlanarDecomposition& d, const PlanarOptions& options,
           double spacing) {
  double volume = 0.0;
  for (const Piece& p : d.pieces) {
    EXPECT_TRUE(isClosed(p.solid.mesh));
    volume += geometry::volume(p.solid.mesh);
    for (const Vector3d& v : p.solid.mesh.vertices)
      EXPECT_GE(p.base.heightOf(v), -1e-3);
  }
  EXPECT_NEAR(volume, geometry::volume(part), 1e-6 * geometry::volume(part));
  ASSERT_FALSE(d.pieces.empty());
  for (std::size_t i = 0; i < d.pieces.size(); ++i) {
    const Piece& piece = d.pieces[i];
    EXPECT_EQ(piece.baseTag == kPlate, piece.under.empty());
    for (const int u : piece.under)
      EXPECT_LT(u, static_cast<int>(i));
    // Disjoint: no point well inside one is inside another, so no section passes through another
    // piece or its section (constraint I).
    for (std::size_t t = 0; t < piece.solid.mesh.triangles.size(); t += 7) {
      const Vector3d middle = (piece.solid.mesh.corner(t, 0) + piece.solid.mesh.corner(t, 1) +
                               piece.solid.mesh.corner(t, 2)) /
                              3.0;
      const Vector3d in = middle - 0.05 * geometry::triangleNormal(piece.solid.mesh, t);
      if (within(piece.solid.mesh, in)) {
        for (std::size_t j = 0; j < d.pieces.size(); ++j)
          EXPECT_TRUE(j == i || !within(d.pieces[j].solid.mesh, in));
      }
    }
    // The head at every point of the piece past all that is printed before it.
    std::size_t hit = 0, tips = 0;
    for (const Vector3d& tip : spread(piece.solid.mesh, spacing)) {
      ++tips;
      bool meets = false;
      for (std::size_t j = 0; j < i && !meets; ++j)
        for (const Vector3d& o : spread(d.pieces[j].solid.mesh, spacing)) {
          const double z = piece.base.normal.dot(o - tip);
          const double r = (o - tip - z * piece.base.normal).norm();
          if (z > 0.01 && r < test::headRadius(options.head, z) - 0.01) {
            meets = true;
            break;
          }
        }
      hit += meets;
    }
    EXPECT_LE(static_cast<double>(hit), 0.01 * static_cast<double>(tips));
  }
}

struct Shape {
  const char* name;
  TriangleMesh (*make)();
  int alphaDeg;
  // Worked out by hand, with all supports on the plate left as they are.
  std::size_t pieces; // a cut outwards at each side of the stem
  std::size_t
      minimum; // no direction is within 90 degrees + alpha of all faces if it were one piece
};
std::ostream& operator<<(std::ostream& out, const Shape& s) {
  return out << s.name;
}

class BeamShapes : public testing::TestWithParam<Shape> {};

TEST_P(BeamShapes, TheBestNumberOfPiecesAndNothingRisky) {
  const TriangleMesh part = GetParam().make();
  ASSERT_TRUE(isClosed(part));
  ASSERT_GT(geometry::volume(part), 0.0);
  PlanarOptions options = withHead();
  options.rule.overhangRad = GetParam().alphaDeg * kDegree;
  options.target = 1e-9;
  // Free to leave some of the part's base to later pieces, it needs no more of them.
  const PlanarDecomposition freely = beamDecompose(part, options, base::RunContext({}, 2));
  EXPECT_NEAR(freely.riskyMm2, 0.0, 1e-6);
  EXPECT_LE(freely.pieces.size(), GetParam().pieces);
  EXPECT_GE(freely.pieces.size(), 2u);
  EXPECT_EQ(freely.blockedPieces, 0u);
  check(part, freely, options, 1.5);
  options.keptContact = options.keptHull = 1.0;
  const PlanarDecomposition d = beamDecompose(part, options, base::RunContext({}, 2));
  EXPECT_GT(d.riskyBeforeMm2, 50.0);
  EXPECT_NEAR(d.riskyMm2, 0.0, 1e-6);
  EXPECT_LE(d.pieces.size(), GetParam().pieces);
  EXPECT_GE(d.pieces.size(), GetParam().minimum);
  EXPECT_EQ(d.blockedPieces, 0u);
  check(part, d, options, 1.5);
  const PlanarDecomposition again = beamDecompose(part, options, base::RunContext({}, 1));
  ASSERT_EQ(again.pieces.size(), d.pieces.size());
  for (std::size_t i = 0; i < d.pieces.size(); ++i) {
    EXPECT_EQ(again.pieces[i].solid.mesh.vertices, d.pieces[i].solid.mesh.vertices);
    EXPECT_EQ(again.pieces[i].solid.mesh.triangles, d.pieces[i].solid.mesh.triangles);
  }
}

INSTANTIATE_TEST_SUITE_P(Hand, BeamShapes,
                         testing::Values(Shape{"tee", tee, 30, 3, 3}, Shape{"wye", wye, 30, 3, 3},
                                         Shape{"mushroom", mushroom, 45, 5, 2},
                                         Shape{"hanging", hanging, 45, 2, 2}));

// A cone on its tip: its wall leans out by its half angle, so it is safe up to alpha.
TEST(RiskRule, AConeIsSafeUpToTheOverhangAngle) {
  for (int half = 10; half <= 80; half += 5) {
    const double height = 20.0, radius = height * std::tan(half * kDegree);
    Piece cone;
    cone.solid = tagged(test::turned({{0, 0}, {radius, height}, {0, height}}, 720));
    ASSERT_TRUE(isClosed(cone.solid.mesh));
    for (const int alpha : {32, 47, 62}) {
      RiskRule rule;
      rule.overhangRad = alpha * kDegree;
      const double wall = base::kPi * radius * std::hypot(radius, height);
      EXPECT_NEAR(riskyArea(cone, rule), half > alpha ? wall : 0.0, 1e-4 * wall)
          << half << " " << alpha;
    }
  }
}

// A head from the side at points far below the plate's rim: only the stem of the plate is in its
// way.
TEST(Platform, StemOfThePlateBlocksTheHead) {
  PlanarOptions options = withHead();
  const Piece piece = wholePart(test::box({-5, -5, 0}, {5, 5, 20}), options.rule);
  const HeadReach head(options.head);
  const std::vector<Vector3d> tips{{20, 0, -40}};
  const auto blocked = [&](const Vector3d& direction) {
    return head.blocked(tips, {withPlate({}, piece, options, 1.0)}, direction, -1e300);
  };
  EXPECT_FALSE(blocked(-Vector3d::UnitX()));
  options.platform.stem = {{-92, -5, 14, 14}};
  EXPECT_TRUE(blocked(-Vector3d::UnitX()));
  EXPECT_FALSE(blocked(Vector3d::UnitX()));
}

TEST(Platform, ThePlateIsTheGivenOneOrMadeForThePiece) {
  PlanarOptions options = withHead();
  const Piece piece = wholePart(test::box({-5, -4, 0}, {5, 4, 20}), options.rule);
  const auto reach = [&](const Vector2d& heading) {
    double maximum = -1e300;
    for (const Vector2d& p : plateOf({piece}, options))
      maximum = std::max(maximum, heading.dot(p));
    return maximum;
  };
  EXPECT_NEAR(reach({1, 0}), 5.0, 1e-9);
  EXPECT_NEAR(reach({0, -1}), 4.0, 1e-9);
  options.platform.marginMm = 3.0;
  EXPECT_GE(reach({1, 0}), 8.0 - 1e-9);
  EXPECT_LE(reach({1, 0}), 8.1);
  options.platform.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  EXPECT_NEAR(reach({1, 0}), 20.0, 1e-9);
}

TEST(Beam, AnOpenMeshIsRefused) {
  TriangleMesh open = tee();
  open.triangles.pop_back();
  EXPECT_THROW(beamDecompose(open, withHead(), base::RunContext({}, 1)), base::Error);
}

TEST(Beam, PrintablePartIsOnePiece) {
  const PlanarDecomposition d =
      beamDecompose(test::box({0, 0, 0}, {10, 12, 14}), withHead(), base::RunContext({}, 1));
  EXPECT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.riskyBeforeMm2, 0.0);
}

} // namespace
} // namespace voluta::planar
