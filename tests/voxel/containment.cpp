#include "voxel/containment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace voluta::test {

namespace {

using Vector = Eigen::Vector3d;

// Whether p, or any point within `reach` of it along the axes, is in a solid cell.
bool solidNear(const voxel::SolidVoxels& v, const Vector& p, double reach) {
  const Vector low = (p - v.grid.origin).array() - reach,
               high = (p - v.grid.origin).array() + reach;
  for (int k = static_cast<int>(std::floor(low.z() / v.grid.pitch));
       k <= static_cast<int>(std::floor(high.z() / v.grid.pitch)); ++k)
    for (int j = static_cast<int>(std::floor(low.y() / v.grid.pitch));
         j <= static_cast<int>(std::floor(high.y() / v.grid.pitch)); ++j)
      for (int i = static_cast<int>(std::floor(low.x() / v.grid.pitch));
           i <= static_cast<int>(std::floor(high.x() / v.grid.pitch)); ++i)
        if (i >= 0 && j >= 0 && k >= 0 && i < v.grid.size.x() && j < v.grid.size.y() &&
            k < v.grid.size.z() &&
            v.solid[static_cast<std::size_t>(i) +
                    static_cast<std::size_t>(v.grid.size.x()) *
                        (static_cast<std::size_t>(j) + static_cast<std::size_t>(v.grid.size.y()) *
                                                           static_cast<std::size_t>(k))] != 0)
          return true;
  return false;
}

// The facets seen along a direction, sorted into the squares of a board across it.
class Board {
public:
  Board(const geometry::TriangleMesh& mesh, const Vector& direction) : mesh_(mesh) {
    w_ = direction.normalized();
    u_ = w_.unitOrthogonal();
    v_ = w_.cross(u_);
    low_.setConstant(std::numeric_limits<double>::infinity());
    Eigen::Array2d high = -low_;
    flat_.reserve(mesh.vertices.size());
    for (const Vector& p : mesh.vertices) {
      flat_.emplace_back(u_.dot(p), v_.dot(p), w_.dot(p));
      low_ = low_.min(flat_.back().head<2>().array());
      high = high.max(flat_.back().head<2>().array());
    }
    side_ = std::max(1e-9, (high - low_).maxCoeff() / kSquares * 1.0001);
    squares_.resize(kSquares * kSquares);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [first, last] = span(t);
      for (int b = first.y(); b <= last.y(); ++b)
        for (int a = first.x(); a <= last.x(); ++a)
          squares_[static_cast<std::size_t>(b * kSquares + a)].push_back(t);
    }
  }

  bool odd(const Vector& p) const {
    const Vector q(u_.dot(p), v_.dot(p), w_.dot(p));
    const Eigen::Array2i at = square(q);
    if ((at < 0).any() || (at >= kSquares).any())
      return false;
    int crossings = 0;
    for (const std::size_t t : squares_[static_cast<std::size_t>(at.y() * kSquares + at.x())]) {
      const Vector &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
      const auto area = [](const Vector& x, const Vector& y, const Vector& z) {
        return (y.x() - x.x()) * (z.y() - x.y()) - (z.x() - x.x()) * (y.y() - x.y());
      };
      const double all = area(a, b, c), wa = area(q, b, c), wb = area(a, q, c), wc = area(a, b, q);
      if (all == 0.0 || wa * all < 0.0 || wb * all < 0.0 || wc * all < 0.0)
        continue;
      crossings += (wa * a.z() + wb * b.z() + wc * c.z()) / all > q.z();
    }
    return crossings % 2 == 1;
  }

private:
  static constexpr int kSquares = 128;
  const Vector& corner(std::size_t t, std::size_t c) const {
    return flat_[static_cast<std::size_t>(mesh_.triangles[t][c])];
  }
  Eigen::Array2i square(const Vector& q) const {
    return ((q.head<2>().array() - low_) / side_).floor().cast<int>();
  }
  std::pair<Eigen::Array2i, Eigen::Array2i> span(std::size_t t) const {
    const Vector low = corner(t, 0).cwiseMin(corner(t, 1)).cwiseMin(corner(t, 2));
    const Vector high = corner(t, 0).cwiseMax(corner(t, 1)).cwiseMax(corner(t, 2));
    return {square(low).max(0), square(high).min(kSquares - 1)};
  }

  const geometry::TriangleMesh& mesh_;
  Vector u_, v_, w_;
  Eigen::Array2d low_;
  double side_ = 1.0;
  std::vector<Vector> flat_;
  std::vector<std::vector<std::size_t>> squares_;
};

// Facets by the blocks of space that they touch, for "is the surface within reach of p".
class Neighbourhood {
public:
  Neighbourhood(const geometry::TriangleMesh& mesh, double reach) : mesh_(mesh), reach_(reach) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Eigen::AlignedBox3d box = boxOf(t);
      const std::array<int, 3> first = block(box.min()), last = block(box.max());
      for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
          for (int i = first[0]; i <= last[0]; ++i)
            blocks_[{i, j, k}].push_back(t);
    }
  }
  // May return true for a surface that is a little further; never false for one within reach.
  bool near(const Vector& p) const {
    const auto found = blocks_.find(block(p));
    return found != blocks_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](std::size_t t) { return boxOf(t).squaredExteriorDistance(p) <= 0.0; });
  }

private:
  Eigen::AlignedBox3d boxOf(std::size_t t) const {
    Eigen::AlignedBox3d box;
    for (int c = 0; c < 3; ++c)
      box.extend(mesh_.corner(t, c));
    const Vector margin = Vector::Constant(reach_);
    return {box.min() - margin, box.max() + margin};
  }
  std::array<int, 3> block(const Vector& p) const {
    const Eigen::Array3i at = (p / (4.0 * reach_)).array().floor().cast<int>();
    return {at.x(), at.y(), at.z()};
  }

  const geometry::TriangleMesh& mesh_;
  double reach_;
  std::map<std::array<int, 3>, std::vector<std::size_t>> blocks_;
};

} // namespace

Containment checkContainment(const geometry::TriangleMesh& mesh, const voxel::SolidVoxels& voxels,
                             std::size_t samples, unsigned seed) {
  Containment found;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<double> area;
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    area.push_back((b - a).cross(c - a).norm());
    box.extend(a).extend(b).extend(c);
  }
  std::discrete_distribution<std::size_t> pick(area.begin(), area.end());
  for (std::size_t s = 0; s < samples; ++s) {
    const std::size_t t = pick(random);
    const double root = std::sqrt(unit(random)), along = unit(random);
    const Vector p = (1.0 - root) * mesh.corner(t, 0) + root * (1.0 - along) * mesh.corner(t, 1) +
                     root * along * mesh.corner(t, 2);
    ++found.surface;
    double depth = 0.0;
    for (const double reach : {0.0, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0})
      if (!solidNear(voxels, p, reach * voxels.grid.pitch))
        depth = reach * voxels.grid.pitch;
    const bool out = !solidNear(voxels, p, 0.0);
    found.surfaceOutside += out && depth > 0.0;
    found.deepestMm = std::max(found.deepestMm, depth);
  }

  const Board boards[3] = {
      {mesh, {0.31, 0.17, 0.93}}, {mesh, {0.83, -0.41, 0.37}}, {mesh, {-0.29, 0.88, 0.38}}};
  const Neighbourhood surface(mesh, std::sqrt(3.0) * voxels.grid.pitch);
  const double margin = 2.5 * voxels.grid.pitch;
  for (std::size_t s = 0; s < samples; ++s) {
    Vector p;
    for (int a = 0; a < 3; ++a)
      p[a] = box.min()[a] - margin + (box.sizes()[a] + 2.0 * margin) * unit(random);
    const int odd = boards[0].odd(p) + boards[1].odd(p) + boards[2].odd(p);
    if (odd == 3) {
      ++found.inside;
      found.insideOutside += !solidNear(voxels, p, 0.0);
    } else if (odd == 0 && !surface.near(p)) {
      ++found.far;
      found.farInCells += solidNear(voxels, p, 0.0);
    }
  }
  return found;
}

} // namespace voluta::test
