#include "toolpath/infill/across_field.h"

#include "base/error.h"
#include "base/index.h"
#include "geometry/symmetric_axes.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Sparse = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<Sparse>;

constexpr double kSmoothHatches = 2.0;
constexpr double kLeastWeight = 1e-3; // of directions that matter nothing
constexpr int kRescalings = 3;
constexpr double kMostScale = 8.0;

// Linear functions on the triangles of a surface.
class TriangleGradients {
public:
  explicit TriangleGradients(const PatchSurface& s) : s_(s), hats_(s.triangles.size()) {
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
      const double area = s.triangleArea[t];
      for (int i = 0; i < 3 && area > 0.0; ++i) {
        const Vector3d opposite = corner(t, (i + 2) % 3) - corner(t, (i + 1) % 3);
        hats_[t][at(i)] = s.triangleNormal[t].cross(opposite) / (2.0 * area);
      }
    }
  }

  Vector3d of(const Eigen::VectorXd& u, std::size_t t) const {
    Vector3d gradient = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      gradient += u[s_.triangles[t][at(i)]] * hats_[t][at(i)];
    return gradient;
  }

  // Adds to the right side the divergence of a vector of that triangle, times its area and weight.
  void addDivergence(std::size_t t, const Vector3d& vector, double weight,
                     Eigen::VectorXd& right) const {
    for (int i = 0; i < 3; ++i)
      right[s_.triangles[t][at(i)]] += weight * s_.triangleArea[t] * hats_[t][at(i)].dot(vector);
  }

  // Returns the weighted stiffness of the triangles plus a diagonal.
  Sparse stiffness(const std::vector<double>& weight, const Eigen::VectorXd& diagonal) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * s_.triangles.size() + s_.position.size());
    for (std::size_t t = 0; t < s_.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          entries.emplace_back(s_.triangles[t][at(i)], s_.triangles[t][at(j)],
                               weight[t] * s_.triangleArea[t] *
                                   hats_[t][at(i)].dot(hats_[t][at(j)]));
    for (Eigen::Index v = 0; v < diagonal.size(); ++v)
      entries.emplace_back(v, v, diagonal[v]);
    Sparse matrix(diagonal.size(), diagonal.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

private:
  const Vector3d& corner(std::size_t t, int i) const {
    return s_.position[at(s_.triangles[t][at(i)])];
  }

  const PatchSurface& s_;
  std::vector<std::array<Vector3d, 3>> hats_;
};

Eigen::VectorXd vertexAreas(const PatchSurface& s) {
  Eigen::VectorXd area =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(s.position.size()), 1e-12);
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (const int v : s.triangles[t])
      area[v] += s.triangleArea[t] / 3.0;
  return area;
}

void factorize(Cholesky& solver, const Sparse& matrix) {
  solver.compute(matrix);
  base::require(solver.info() == Eigen::Success, "acrossField: a positive definite matrix");
}

// How one direction within the surface differs from all others: strength and axis.
struct Strand {
  Vector3d along = Vector3d::Zero(); // unit; zero where none differs
  double clarity = 0.0;
};
Strand strandIn(const Matrix3d& dyads, const Vector3d& normal) {
  const Matrix3d flat = Matrix3d::Identity() - normal * normal.transpose();
  const auto [values, axes] = geometry::symmetricAxes(Matrix3d(flat * dyads * flat));
  // The least eigenvalue is that of the normal, 0.
  const Vector3d along = flat * axes.col(2);
  return values[2] > 0.0 && along.norm() > 1e-6 ? Strand{along.normalized(), values[2] - values[1]}
                                                : Strand{};
}

// Returns the field's dyads per vertex, of unit mean clarity, with those of weak ones replaced by
// their surroundings.
std::vector<Matrix3d> smoothDyads(const InfillRegion& r, const TriangleGradients& gradients,
                                  const base::RunContext& ctx) {
  constexpr std::array<std::pair<int, int>, 6> kEntries{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  const PatchSurface& s = r.surface;
  const auto n = static_cast<Eigen::Index>(s.position.size());
  const Eigen::VectorXd area = vertexAreas(s);
  Eigen::MatrixXd dyads(n, 6);
  Eigen::VectorXd clarity(n);
  double sum = 0.0;
  for (Eigen::Index v = 0; v < n; ++v) {
    if (v % 1024 == 0)
      ctx.checkpoint();
    const auto i = static_cast<std::size_t>(v);
    const Strand strand = strandIn((*r.strands)(s.position[i]), s.normal[i]);
    const Matrix3d dyad = strand.along * strand.along.transpose();
    for (Eigen::Index k = 0; k < 6; ++k)
      dyads(v, k) =
          dyad(kEntries[at(static_cast<int>(k))].first, kEntries[at(static_cast<int>(k))].second);
    clarity[v] = strand.clarity;
    sum += area[v] * strand.clarity;
  }
  const double mean = sum > 0.0 ? sum / area.sum() : 1.0;
  Eigen::VectorXd own(n);
  for (Eigen::Index v = 0; v < n; ++v)
    own[v] = area[v] * std::clamp(clarity[v] / mean, kLeastWeight, 1.0);
  const double reach = kSmoothHatches * meanHatchMm(r);
  Cholesky solver;
  factorize(solver,
            gradients.stiffness(std::vector<double>(s.triangles.size(), reach * reach), own));
  const Eigen::MatrixXd smooth = solver.solve(own.asDiagonal() * dyads);
  std::vector<Matrix3d> result(s.position.size());
  for (std::size_t v = 0; v < result.size(); ++v)
    for (std::size_t k = 0; k < kEntries.size(); ++k) {
      const auto [i, j] = kEntries[k];
      result[v](i, j) = result[v](j, i) =
          smooth(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k));
    }
  return result;
}

// Returns the triangles beside each edge's side: -1 at the boundary.
std::vector<std::array<int, 3>> neighbours(const PatchSurface& s) {
  std::map<std::pair<int, int>, std::pair<int, int>> open;
  std::vector<std::array<int, 3>> beside(s.triangles.size(), {-1, -1, -1});
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = s.triangles[at(t)][at(i)], b = s.triangles[at(t)][at((i + 1) % 3)];
      const auto found = open.find(std::minmax(a, b));
      if (found == open.end()) {
        open.emplace(std::minmax(a, b), std::pair{t, i});
        continue;
      }
      const auto [other, side] = found->second;
      beside[at(t)][at(i)] = other;
      beside[at(other)][at(side)] = t;
      open.erase(found);
    }
  return beside;
}

// Gives the directions signs that agree between neighbours, the clearest triangles first.
void comb(const PatchSurface& s, const std::vector<double>& clarity, std::vector<Vector3d>& along) {
  const std::vector<std::array<int, 3>> beside = neighbours(s);
  std::vector<char> isDone(along.size(), 0);
  using Next = std::pair<double, int>;
  std::priority_queue<Next> next;
  std::vector<int> seeds(along.size());
  for (std::size_t t = 0; t < seeds.size(); ++t)
    seeds[t] = static_cast<int>(t);
  std::ranges::stable_sort(seeds, std::greater(), [&](int t) { return clarity[at(t)]; });
  for (const int seed : seeds) {
    if (isDone[at(seed)])
      continue;
    isDone[at(seed)] = 1;
    next.emplace(clarity[at(seed)], seed);
    while (!next.empty()) {
      const int t = next.top().second;
      next.pop();
      for (const int other : beside[at(t)]) {
        if (other < 0 || isDone[at(other)])
          continue;
        isDone[at(other)] = 1;
        if (along[at(t)].dot(along[at(other)]) < 0.0)
          along[at(other)] = -along[at(other)];
        next.emplace(clarity[at(other)], other);
      }
    }
  }
}

} // namespace

double meanHatchMm(const InfillRegion& region) {
  double sum = 0.0;
  for (const double mm : region.hatchMm)
    sum += mm;
  return sum / static_cast<double>(region.hatchMm.size());
}

AcrossField acrossField(const InfillRegion& r, const base::RunContext& ctx) {
  const PatchSurface& s = r.surface;
  const TriangleGradients gradients(s);
  const std::vector<Matrix3d> dyads = smoothDyads(r, gradients, ctx);
  ctx.checkpoint();
  std::vector<Vector3d> across(s.triangles.size());
  std::vector<double> clarity(s.triangles.size());
  for (std::size_t t = 0; t < across.size(); ++t) {
    const auto& corners = s.triangles[t];
    const Strand strand = strandIn(
        dyads[at(corners[0])] + dyads[at(corners[1])] + dyads[at(corners[2])], s.triangleNormal[t]);
    across[t] = strand.along;
    clarity[t] = std::max(kLeastWeight, strand.clarity / 3.0);
  }
  comb(s, clarity, across);
  for (std::size_t t = 0; t < across.size(); ++t)
    across[t] = s.triangleNormal[t].cross(across[t]);
  const Eigen::VectorXd area = vertexAreas(s);
  Cholesky solver;
  factorize(solver, gradients.stiffness(clarity, 1e-9 * area));
  Eigen::VectorXd u;
  std::vector<double> scale(across.size(), 1.0);
  for (int pass = 0; pass <= kRescalings; ++pass) {
    ctx.checkpoint();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(area.size());
    for (std::size_t t = 0; t < across.size(); ++t)
      gradients.addDivergence(t, scale[t] * across[t], clarity[t], right);
    u = solver.solve(right);
    for (std::size_t t = 0; t < scale.size(); ++t)
      scale[t] = std::clamp(gradients.of(u, t).dot(across[t]), 1.0 / kMostScale, kMostScale);
  }
  AcrossField field{std::vector<double>(u.data(), u.data() + u.size()),
                    std::vector<double>(s.position.size(), 0.0)};
  for (std::size_t t = 0; t < across.size(); ++t)
    field.followed +=
        s.triangleArea[t] / s.areaMm2 * std::clamp(gradients.of(u, t).dot(across[t]), 0.0, 1.0);
  for (std::size_t t = 0; t < across.size(); ++t)
    for (const int v : s.triangles[t])
      field.gradient[at(v)] += s.triangleArea[t] / (3.0 * area[v]) * gradients.of(u, t).norm();
  return field;
}

} // namespace voluta::toolpath
