// Figures of beads under a load: closed forms of bars, and an arch against tetrahedra of the test's
// own, with the order of Dai's specimens (PU, CU, CR; fig. 5.8).
#include "elastic/bead_stiffness.h"
#include "elastic/deposited.h"
#include "elastic/elastic_solve.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"

#include "helpers/shapes.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>

namespace voluta::elastic {
namespace {

using Eigen::Vector3d;
using plan::PathKind;

// Softer across than PLA, so that directions show.
const process::Elasticity kSoftAcross{3000.0, 1000.0, 400.0, 0.3};
constexpr double kHatch = 1.0, kHigh = 0.75;
constexpr std::size_t kCells = 5000, kFew = 300;

process::Tooling tooling(const process::Elasticity& elasticity) {
  process::Process plastic, tape;
  plastic.material.elasticity = tape.material.elasticity = elasticity;
  tape.tape = process::Tape{.fibreMPa = 200000.0, .fibreShare = 0.3};
  return process::Tooling(std::vector<process::Tool>{{plastic}, {tape}});
}

// Beads through points, each at the top of its layer.
class Beads {
public:
  void add(const std::vector<Vector3d>& points, const std::function<Vector3d(const Vector3d&)>& up,
           PathKind kind = PathKind::Infill, int tool = 0, double widthMm = kHatch,
           double heightMm = kHigh) {
    plan_.paths.push_back(
        {.first = plan_.position.size(), .count = points.size(), .kind = kind, .tool = tool});
    for (const Vector3d& p : points) {
      plan_.position.push_back(p);
      plan_.direction.push_back(up(p));
      plan_.widthMm.push_back(static_cast<float>(process::widthOfHatch(widthMm, heightMm)));
      plan_.heightMm.push_back(static_cast<float>(heightMm));
      plan_.speedMmPerS.push_back(20.0F);
    }
  }

  const plan::ToolPlan& plan() const { return plan_; }

private:
  plan::ToolPlan plan_;
};

Vector3d upright(const Vector3d&) {
  return Vector3d::UnitZ();
}

// Beads that fill a box from the origin, along x or y.
Beads filledBox(const Vector3d& size, bool alongX) {
  Beads beads;
  for (double z = kHigh; z < size.z() + 1e-9; z += kHigh)
    for (double at = 0.5 * kHatch; at < (alongX ? size.y() : size.x()); at += kHatch)
      beads.add(alongX ? std::vector<Vector3d>{{0, at, z}, {size.x(), at, z}}
                       : std::vector<Vector3d>{{at, 0, z}, {at, size.y(), z}},
                upright);
  return beads;
}

LoadCase heldBox(const Vector3d& size, const Vector3d& newton, std::size_t cells = kCells) {
  const std::array holds{test::box({-1, -1, -1}, {2, size.y() + 1, size.z() + 1})};
  const std::array forces{BodyForce{
      test::box({size.x() - 1, -1, -1}, {size.x() + 1, size.y() + 1, size.z() + 1}), newton}};
  return loadCase(test::box({0, 0, 0}, size), holds, forces, cells, {});
}

plan::LoadStatistics figuresOf(const Beads& beads, const LoadCase& load) {
  const Stiffness6 any = isotropicStiffness(1000.0, 0.33);
  const PrincipalStress principal(load, solved(load, [&](std::size_t) { return any; }, {}));
  return loadFigures(beads.plan(), 0, tooling(kSoftAcross), load, principal, {}).figures;
}

LoadFigures judged(const Beads& beads, const LoadCase& load, const process::Tooling& tools) {
  const Stiffness6 any = isotropicStiffness(1000.0, 0.33);
  const PrincipalStress principal(load, solved(load, [&](std::size_t) { return any; }, {}));
  return loadFigures(beads.plan(), 0, tools, load, principal, {});
}

// Expects that stiffness and tensions are unknown, and a finding that says why.
void expectUnknown(const LoadFigures& load, const std::string& why) {
  for (const double figure :
       {load.figures.stiffnessNPerMm, load.figures.acrossBeadsMPa, load.figures.acrossLayersMPa})
    EXPECT_TRUE(std::isnan(figure)) << figure;
  ASSERT_TRUE(load.unknown);
  EXPECT_FALSE(load.unknown->blocking);
  const std::string reason = plan::englishReason(*load.unknown);
  EXPECT_NE(reason.find(why), std::string::npos) << reason;
  EXPECT_FALSE(plan::englishRemedy(*load.unknown).empty());
}

TEST(DepositedBeads, StretchByTheirModulus) {
  const Vector3d size(40, 8, 7.5);
  const LoadCase load = heldBox(size, {60, 0, 0});
  const double closed = 60.0 / (size.x() - 3.0); // by modulus
  const plan::LoadStatistics along = figuresOf(filledBox(size, true), load),
                             across = figuresOf(filledBox(size, false), load);
  EXPECT_NEAR(along.stiffnessNPerMm, kSoftAcross.alongMPa * closed, 0.03 * 3000.0 * closed);
  EXPECT_NEAR(across.stiffnessNPerMm, kSoftAcross.acrossMPa * closed, 0.07 * 1000.0 * closed);
  EXPECT_EQ(along.alignedFraction, 1.0);
  EXPECT_LT(across.alignedFraction, 0.1);
  EXPECT_NEAR(across.angleMeanDeg, 90.0, 5.0);
  // The bonds of beads across carry the whole stress, 1 MPa; those of beads along nearly none.
  EXPECT_NEAR(across.acrossBeadsMPa, 1.0, 0.25);
  EXPECT_LT(along.acrossBeadsMPa, 0.3);
}

TEST(DepositedBeads, WithTapesFollowTheLawOfMixture) {
  const Vector3d size(160, 10, 7.5); // forces need some length to enter the tapes
  const LoadCase load = heldBox(size, {60, 0, 0});
  Beads beads = filledBox(size, true);
  constexpr double kTapeMm = 0.08;
  for (const double z : {2.0, 4.25, 6.0})
    for (const double y : {2.5, 7.5})
      beads.add({{0, y, z}, {size.x(), y, z}}, upright, PathKind::Tape, 1, 5.0, kTapeMm);
  const double tapeMPa = 0.3 * 200000.0 + 0.7 * kSoftAcross.alongMPa;
  // Tapes lie in beads that state their full height: both are in the cell, by their volumes.
  const double plastic = 75.0, tapes = 3.0 * 10.0 * kTapeMm;
  const double mean = (plastic * kSoftAcross.alongMPa + tapes * tapeMPa) / (plastic + tapes);
  const double closed = mean * 75.0 / (size.x() - 3.0);
  EXPECT_NEAR(figuresOf(beads, load).stiffnessNPerMm, closed, 0.06 * closed);
}

TEST(DepositedBeads, WithoutKnownElasticityStateAlignmentAlone) {
  const Vector3d size(40, 8, 7.5);
  process::Process unknown;
  unknown.material.label = "Putty";
  unknown.material.elasticity.reset();
  const LoadFigures load =
      judged(filledBox(size, true), heldBox(size, {60, 0, 0}, kFew), process::Tooling(unknown));
  EXPECT_EQ(load.figures.alignedFraction, 1.0);
  EXPECT_EQ(load.figures.infillAlignedFraction, 1.0);
  expectUnknown(load, "material Putty states no elasticity");
}

TEST(DepositedBeads, WithATapeOfUnknownFibreHaveNoStiffness) {
  const Vector3d size(40, 8, 7.5);
  Beads beads = filledBox(size, true);
  beads.add({{0, 4, 4}, {size.x(), 4, 4}}, upright, PathKind::Tape, 1, 5.0, 0.08);
  process::Process plastic, tape;
  tape.tape = process::Tape{.fibreMPa = 0.0, .fibreShare = 0.0};
  tape.id = "ribbon";
  expectUnknown(judged(beads, heldBox(size, {60, 0, 0}, kFew),
                       process::Tooling(std::vector<process::Tool>{{plastic}, {tape}})),
                "tape ribbon");
}

TEST(DepositedBeads, HaveNoFiguresUnderForcesThatCancel) {
  const Vector3d size(40, 8, 7.5);
  LoadCase load = heldBox(size, {60, 0, 0}, kFew);
  load.forces.push_back(load.forces.front());
  load.forces.back().newton *= -1.0;
  const LoadFigures figures = judged(filledBox(size, true), load, tooling(kSoftAcross));
  EXPECT_EQ(figures.figures.forceN, 120.0);
  EXPECT_TRUE(std::isnan(figures.figures.alignedFraction)) << "no stress has no direction";
  EXPECT_TRUE(std::isnan(figures.figures.angleMeanDeg));
  expectUnknown(figures, "no bead is under stress");
}

TEST(DepositedBeads, WithoutAnEquilibriumHaveNoStiffness) {
  const Vector3d size(40, 8, 7.5);
  process::Elasticity broken = kSoftAcross;
  broken.acrossMPa = std::nan("");
  const LoadFigures figures =
      judged(filledBox(size, true), heldBox(size, {60, 0, 0}, kFew), tooling(broken));
  EXPECT_EQ(figures.figures.alignedFraction, 1.0);
  expectUnknown(figures, "no equilibrium");
}

TEST(DepositedBeads, OfWallsAloneHaveNoAlignedInfill) {
  const Vector3d size(40, 8, 7.5);
  Beads beads;
  for (double z = kHigh; z < size.z() + 1e-9; z += kHigh)
    beads.add({{0, 4, z}, {size.x(), 4, z}}, upright, PathKind::Wall);
  const plan::LoadStatistics figures = figuresOf(beads, heldBox(size, {60, 0, 0}, kFew));
  EXPECT_EQ(figures.alignedFraction, 1.0);
  EXPECT_TRUE(std::isnan(figures.infillAlignedFraction));
}

// An arch in the plane x, z about the origin, one end held, the other pushed up.
constexpr double kInner = 40.0, kOuter = 46.0, kHalf = 1.0, kWide = 10.0, kHeldFrom = 0.9,
                 kPushedFrom = 0.9, kTapeInner = 1.5, kTapeOuter = 4.5;

Vector3d onArch(double radius, double angle, double y) {
  return {radius * std::sin(angle), y, radius * std::cos(angle)};
}
Vector3d outward(const Vector3d& p) {
  return Vector3d(p.x(), 0, p.z()).normalized();
}

geometry::TriangleMesh archBody(double from, double to) {
  geometry::TriangleMesh mesh;
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i)
    for (int n = 0; n < 4; ++n) {
      const double angle = from + (to - from) * i / kSteps;
      mesh.vertices.push_back(
          onArch((n & 1) != 0 ? kOuter : kInner, angle, (n & 2) != 0 ? kWide : 0.0));
    }
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  quad(0, 1, 3, 2);
  for (int i = 0; i < kSteps; ++i) {
    const int a = 4 * i, b = a + 4;
    quad(a + 0, b + 0, b + 1, a + 1);
    quad(a + 1, b + 1, b + 3, a + 3);
    quad(a + 3, b + 3, b + 2, a + 2);
    quad(a + 2, b + 2, b + 0, a + 0);
  }
  const int last = 4 * kSteps;
  quad(last + 2, last + 3, last + 1, last + 0);
  return test::facingOutward(mesh);
}

enum class Case { PU, CU, CR }; // planar, curved, curved with tapes

Beads archBeads(Case made) {
  Beads beads;
  if (made == Case::PU) {
    for (double z = kInner * std::cos(kHalf) + kHigh; z < kOuter; z += kHigh) {
      const double middle = z - 0.5 * kHigh;
      const double outer =
          std::min(std::sqrt(kOuter * kOuter - middle * middle), middle * std::tan(kHalf));
      const double inner = middle < kInner ? std::sqrt(kInner * kInner - middle * middle) : 0.0;
      for (double y = 0.5 * kHatch; y < kWide && inner < outer; y += kHatch) {
        if (inner <= 0.0)
          beads.add({{-outer, y, z}, {outer, y, z}}, upright);
        else
          for (const double side : {-1.0, 1.0})
            beads.add({{side * inner, y, z}, {side * outer, y, z}}, upright);
      }
    }
    return beads;
  }
  const auto arc = [](double radius, double y) {
    std::vector<Vector3d> points;
    for (int i = 0; i <= 120; ++i)
      points.push_back(onArch(radius, kHalf * (i / 60.0 - 1.0), y));
    return points;
  };
  for (double r = kInner + kHigh; r < kOuter + 1e-9; r += kHigh)
    for (double y = 0.5 * kHatch; y < kWide; y += kHatch)
      beads.add(arc(r, y), outward);
  if (made == Case::CR)
    for (const double r : {kTapeInner, kTapeOuter})
      for (const double y : {2.5, 7.5})
        beads.add(arc(kInner + r, y), outward, PathKind::Tape, 1, 5.0, 0.08);
  return beads;
}

// The same arch as tetrahedra that follow it, of linear functions; materials as tensors.
class TetrahedralArch {
public:
  explicit TetrahedralArch(Case made) : made_(made) { assemble(); }

  double stiffness() const {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix_);
    const Eigen::VectorXd moves = solver.solve(force_);
    return 1.0 / force_.dot(moves);
  }

private:
  static constexpr int kAngles = 96, kRadii = 10, kAcross = 4;
  using Tensor4 = std::array<double, 81>;

  static std::size_t entry(int i, int j, int k, int l) {
    return static_cast<std::size_t>(((i * 3 + j) * 3 + k) * 3 + l);
  }

  // Transversely isotropic (Spencer 1984): five constants about an axis a.
  static Tensor4 tensorOf(const process::Elasticity& e, const Vector3d& a) {
    const double nt = e.poisson, n = e.acrossMPa / e.alongMPa;
    const double m = 1.0 - nt - 2.0 * n * nt * nt;
    const double shearAcross = e.acrossMPa / (2.0 * (1.0 + nt));
    const double c11 = e.alongMPa * (1.0 - nt) / m, c12 = e.acrossMPa * nt / m;
    const double c23 = e.acrossMPa * (nt + n * nt * nt) / ((1.0 + nt) * m);
    const double lambda = c23, mu = shearAcross, alpha = c12 - c23,
                 beta = c11 + c23 + 2.0 * shearAcross - 2.0 * c12 - 4.0 * e.shearMPa;
    Tensor4 c{};
    const auto d = [](int i, int j) { return i == j ? 1.0 : 0.0; };
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            c[entry(i, j, k, l)] =
                lambda * d(i, j) * d(k, l) + mu * (d(i, k) * d(j, l) + d(i, l) * d(j, k)) +
                alpha * (d(i, j) * a[k] * a[l] + a[i] * a[j] * d(k, l)) +
                (e.shearMPa - mu) * (a[i] * a[k] * d(j, l) + a[i] * a[l] * d(j, k) +
                                     a[j] * a[k] * d(i, l) + a[j] * a[l] * d(i, k)) +
                beta * a[i] * a[j] * a[k] * a[l];
    return c;
  }

  Tensor4 materialAt(const Vector3d& p) const {
    const Vector3d along =
        made_ == Case::PU ? Vector3d::UnitX() : outward(p).cross(Vector3d::UnitY());
    process::Elasticity e = kSoftAcross;
    Tensor4 c = tensorOf(e, along);
    if (made_ != Case::CR)
      return c;
    // Tapes, 0.08 mm each, spread over the row of elements that contains them.
    const double depth = std::hypot(p.x(), p.z()) - kInner, row = (kOuter - kInner) / kRadii;
    for (const double at : {kTapeInner - 0.04, kTapeOuter - 0.04})
      if (std::floor(depth / row) == std::floor(at / row)) {
        const double share = 0.08 / row;
        e.alongMPa = (1.0 - share) * e.alongMPa + share * (0.3 * 200000.0 + 0.7 * e.alongMPa);
        c = tensorOf(e, along);
      }
    return c;
  }

  int node(int i, int j, int k) const { return (i * (kRadii + 1) + j) * (kAcross + 1) + k; }

  void assemble() {
    constexpr int kNodes = (kAngles + 1) * (kRadii + 1) * (kAcross + 1);
    std::vector<Vector3d> place(kNodes);
    std::vector<char> isHeld(kNodes, 0), isPushed(kNodes, 0);
    int pushed = 0;
    for (int i = 0; i <= kAngles; ++i)
      for (int j = 0; j <= kRadii; ++j)
        for (int k = 0; k <= kAcross; ++k) {
          const double angle = kHalf * (2.0 * i / kAngles - 1.0);
          const auto n = static_cast<std::size_t>(node(i, j, k));
          place[n] = onArch(kInner + (kOuter - kInner) * j / kRadii, angle, kWide * k / kAcross);
          isHeld[n] = angle < 1e-9 - kHeldFrom;
          isPushed[n] = angle > kPushedFrom - 1e-9;
          pushed += isPushed[n] != 0 ? 1 : 0;
        }
    std::vector<Eigen::Triplet<double>> entries;
    constexpr int kCorners[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                    {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    for (int i = 0; i < kAngles; ++i)
      for (int j = 0; j < kRadii; ++j)
        for (int k = 0; k < kAcross; ++k)
          for (const auto& corners : kCorners) {
            std::array<int, 4> tet{};
            for (std::size_t c = 0; c < 4; ++c)
              tet[c] = node(i + (corners[c] & 1), j + (corners[c] >> 1 & 1), k + (corners[c] >> 2));
            addTetrahedron(tet, place, isHeld, entries);
          }
    for (int n = 0; n < 3 * kNodes; ++n)
      if (isHeld[static_cast<std::size_t>(n / 3)])
        entries.emplace_back(n, n, 1.0);
    matrix_.resize(3 * kNodes, 3 * kNodes);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    force_ = Eigen::VectorXd::Zero(3 * kNodes);
    for (int n = 0; n < kNodes; ++n)
      if (isPushed[static_cast<std::size_t>(n)])
        force_[3 * n + 2] = 1.0 / pushed;
  }

  void addTetrahedron(const std::array<int, 4>& tet, const std::vector<Vector3d>& place,
                      const std::vector<char>& isHeld,
                      std::vector<Eigen::Triplet<double>>& entries) const {
    Eigen::Matrix4d corners;
    Vector3d middle = Vector3d::Zero();
    for (int c = 0; c < 4; ++c) {
      const Vector3d& p = place[static_cast<std::size_t>(tet[static_cast<std::size_t>(c)])];
      corners.row(c) << 1.0, p.x(), p.y(), p.z();
      middle += 0.25 * p;
    }
    const double volume = std::abs(corners.determinant()) / 6.0;
    const Eigen::Matrix4d functions = corners.inverse(); // rows 1..3: gradients
    const Tensor4 c = materialAt(middle);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k) {
            const int from = tet[static_cast<std::size_t>(a)],
                      to = tet[static_cast<std::size_t>(b)];
            if (isHeld[static_cast<std::size_t>(from)] || isHeld[static_cast<std::size_t>(to)])
              continue;
            double sum = 0.0;
            for (int j = 0; j < 3; ++j)
              for (int l = 0; l < 3; ++l)
                sum += functions(1 + j, a) * c[entry(i, j, k, l)] * functions(1 + l, b);
            entries.emplace_back(3 * from + i, 3 * to + k, volume * sum);
          }
  }

  Case made_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd force_;
};

TEST(DepositedBeads, OfArchesAgreeWithTetrahedraAndKeepTheOrderOfDai) {
  const geometry::TriangleMesh arch = archBody(-kHalf, kHalf);
  const std::array holds{archBody(-kHalf - 0.1, -kHeldFrom)};
  const std::array forces{BodyForce{archBody(kPushedFrom, kHalf + 0.1), {0, 0, 1}}};
  const LoadCase load = loadCase(arch, holds, forces, kCells, {});
  std::array<double, 3> own{}, tetrahedra{};
  std::array<plan::LoadStatistics, 3> figures{};
  for (const Case made : {Case::PU, Case::CU, Case::CR}) {
    const auto i = static_cast<std::size_t>(made);
    figures[i] = figuresOf(archBeads(made), load);
    own[i] = figures[i].stiffnessNPerMm;
    tetrahedra[i] = TetrahedralArch(made).stiffness();
    RecordProperty("own" + std::to_string(i), std::to_string(own[i]));
    EXPECT_NEAR(own[i], tetrahedra[i], 0.12 * tetrahedra[i]) << i;
  }
  EXPECT_LT(1.05 * own[0], own[1]);
  EXPECT_LT(1.05 * own[1], own[2]);
  EXPECT_NEAR(own[1] / own[0], tetrahedra[1] / tetrahedra[0], 0.1 * tetrahedra[1] / tetrahedra[0]);
  EXPECT_NEAR(own[2] / own[1], tetrahedra[2] / tetrahedra[1], 0.1 * tetrahedra[2] / tetrahedra[1]);
  // Delamination: planar layers carry more tension across, and curved beads run along the stress.
  EXPECT_GT(figures[0].acrossLayersMPa, 1.3 * figures[1].acrossLayersMPa);
  EXPECT_GT(figures[1].alignedFraction, 1.3 * figures[0].alignedFraction);
}

} // namespace
} // namespace voluta::elastic
