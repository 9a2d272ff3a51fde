#include "elastic/elastic_solve.h"

#include "base/error.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::elastic {

namespace {
using Eigen::Vector3d;
using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double kTolerance = 1e-5; // of the forces that are out of balance
constexpr int kMostSteps = 20000;
constexpr double kCancelled = 1e-9; // of the forces on a corner

// Checks for cancellation at every step of the solver.
class CheckedDiagonal : public Eigen::DiagonalPreconditioner<double> {
public:
  void setContext(const base::RunContext& ctx) { ctx_ = &ctx; }

  template <typename Rhs> auto solve(const Eigen::MatrixBase<Rhs>& right) const {
    if (ctx_)
      ctx_->checkpoint();
    return Eigen::DiagonalPreconditioner<double>::solve(right);
  }

private:
  const base::RunContext* ctx_ = nullptr;
};

// Nodes at the corners of the solid cells, numbered where they move.
class Nodes {
public:
  explicit Nodes(const LoadCase& load)
      : load_(load), size_(load.grid.size + Eigen::Vector3i::Ones()),
        number_(static_cast<std::size_t>(size_.prod()), kNone) {
    for (std::size_t c = 0; c < load.share.size(); ++c)
      if (load.isSolid(c))
        for (const std::size_t node : of(c))
          number_[node] = 0;
    for (const std::size_t c : load.held)
      for (const std::size_t node : of(c))
        number_[node] = kHeld;
    for (int& number : number_)
      if (number == 0)
        number = count_++;
  }

  int count() const { return count_; }
  // Returns the number of a corner; negative if it does not move.
  int number(std::size_t node) const { return number_[node]; }

  std::array<std::size_t, 8> of(std::size_t cell) const {
    const Eigen::Vector3i at = load_.grid.cell(cell);
    std::array<std::size_t, 8> nodes{};
    for (int n = 0; n < 8; ++n) {
      const auto x = static_cast<std::size_t>(at.x() + (n & 1)),
                 y = static_cast<std::size_t>(at.y() + (n >> 1 & 1)),
                 z = static_cast<std::size_t>(at.z() + (n >> 2));
      nodes[static_cast<std::size_t>(n)] =
          x + static_cast<std::size_t>(size_.x()) * (y + static_cast<std::size_t>(size_.y()) * z);
    }
    return nodes;
  }

private:
  static constexpr int kNone = -1, kHeld = -2;

  const LoadCase& load_;
  Eigen::Vector3i size_;
  std::vector<int> number_;
  int count_ = 0;
};

Sparse assembled(const LoadCase& load, const Nodes& nodes, const std::vector<Stiffness6>& material,
                 const base::RunContext& ctx) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t c = 0; c < load.share.size(); ++c) {
    if (!load.isSolid(c))
      continue;
    if (c % 256 == 0)
      ctx.checkpoint();
    const CubeMatrix cube =
        static_cast<double>(load.share[c]) * cubeStiffness(material[c], load.grid.pitch);
    const std::array<std::size_t, 8> corners = nodes.of(c);
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) {
        const int a = nodes.number(corners[static_cast<std::size_t>(i / 3)]),
                  b = nodes.number(corners[static_cast<std::size_t>(j / 3)]);
        if (a >= 0 && b >= 0)
          entries.emplace_back(3 * a + i % 3, 3 * b + j % 3, cube(i, j));
      }
  }
  Sparse matrix(3 * nodes.count(), 3 * nodes.count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Shares each force between the corners of its cells that move, by how many of the cells a corner
// belongs to and how much they are filled.
Eigen::VectorXd rightSide(const LoadCase& load, const Nodes& nodes) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * nodes.count());
  Eigen::VectorXd sizes = right;
  for (const CellForce& force : load.forces) {
    double filled = 0.0; // of the corners that move
    for (const std::size_t c : force.cells)
      for (const std::size_t node : nodes.of(c))
        filled += nodes.number(node) >= 0 ? static_cast<double>(load.share[c]) : 0.0;
    if (filled <= 0.0)
      throw base::Error(base::ErrorCode::Usage, "a force acts only where the part is held"_text, {},
                        "move the region with the force away from the one that holds"_text);
    for (const std::size_t c : force.cells)
      for (const std::size_t node : nodes.of(c))
        if (const int a = nodes.number(node); a >= 0) {
          const Vector3d part = static_cast<double>(load.share[c]) / filled * force.newton;
          right.segment<3>(3 * a) += part;
          sizes.segment<3>(3 * a) += part.cwiseAbs();
        }
  }
  // Forces that cancel each other leave no rounding behind, which would look like a load.
  return (right.array().abs() > kCancelled * sizes.array()).select(right, 0.0);
}

std::optional<Eigen::VectorXd> equilibrium(const Sparse& matrix, const Eigen::VectorXd& right,
                                           const base::RunContext& ctx) {
  if (!matrix.coeffs().allFinite())
    return std::nullopt;
  Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper, CheckedDiagonal> solver;
  solver.preconditioner().setContext(ctx);
  solver.compute(matrix);
  solver.setTolerance(kTolerance);
  solver.setMaxIterations(kMostSteps);
  Eigen::VectorXd moves = solver.solve(right);
  if (solver.info() != Eigen::Success || !moves.allFinite())
    return std::nullopt;
  return moves;
}
} // namespace

std::optional<ElasticState> foundEquilibrium(const LoadCase& load, const CellMaterial& material,
                                             const base::RunContext& ctx) {
  const Nodes nodes(load);
  std::vector<Stiffness6> stiffness(load.share.size(), Stiffness6::Zero());
  for (std::size_t c = 0; c < stiffness.size(); ++c)
    if (load.isSolid(c))
      stiffness[c] = material(c);
  const Eigen::VectorXd right = rightSide(load, nodes);
  const std::optional<Eigen::VectorXd> found =
      equilibrium(assembled(load, nodes, stiffness, ctx), right, ctx);
  if (!found)
    return std::nullopt;
  const Eigen::VectorXd& moves = *found;
  ElasticState state{std::vector<Tensor6>(load.share.size(), Tensor6::Zero()),
                     std::vector<Tensor6>(load.share.size(), Tensor6::Zero()), right.dot(moves)};
  for (std::size_t c = 0; c < load.share.size(); ++c) {
    if (!load.isSolid(c))
      continue;
    CubeVector cube = CubeVector::Zero();
    const std::array<std::size_t, 8> corners = nodes.of(c);
    for (std::size_t n = 0; n < corners.size(); ++n)
      if (const int a = nodes.number(corners[n]); a >= 0)
        cube.segment<3>(static_cast<Eigen::Index>(3 * n)) = moves.segment<3>(3 * a);
    state.strain[c] = centreStrain(cube, load.grid.pitch);
    state.stress[c] = stiffness[c] * state.strain[c];
  }
  return state;
}

ElasticState solved(const LoadCase& load, const CellMaterial& material,
                    const base::RunContext& ctx) {
  std::optional<ElasticState> state = foundEquilibrium(load, material, ctx);
  if (!state)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "found no equilibrium of the part under its load"_text, {},
                      "hold the part in more places"_text);
  return std::move(*state);
}

} // namespace voluta::elastic
