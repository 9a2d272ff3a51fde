#include "curved/rank_checker.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace voluta::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

// Hull of points added in groups. Coordinates in cells, z from the plate.
class Hull {
public:
  explicit Hull(const curved::Decomposition& d) {
    for (const Eigen::Vector2d& p : d.platform) {
      const Eigen::Vector2d q = (p - d.grid.origin.head<2>()) / d.grid.pitch;
      // As the plate's corners are given in sixteenths of a cell.
      points_.emplace_back(std::round(q.x() * 16.0) / 16.0, std::round(q.y() * 16.0) / 16.0, 0.0);
    }
  }

  void add(const std::vector<Eigen::Vector3d>& group) {
    for (const Eigen::Vector3d& p : group)
      if (planes_.empty() || depth(p) < 1e-9)
        points_.emplace_back(p.x(), p.y(), p.z());
    CGAL::Surface_mesh<Point> mesh;
    CGAL::convex_hull_3(points_.begin(), points_.end(), mesh);
    planes_.clear();
    points_.clear();
    for (const auto v : mesh.vertices())
      points_.push_back(mesh.point(v));
    for (const auto f : mesh.faces()) {
      Eigen::Vector3d c[3];
      int n = 0;
      for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
        const Point p = mesh.point(v);
        if (n < 3)
          c[n++] = {p.x(), p.y(), p.z()};
      }
      const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
      planes_.push_back({normal, normal.dot(c[0])});
    }
  }

  // Below the nearest facet's plane; negative outside; -1 where there is no hull.
  double depth(const Eigen::Vector3d& p) const {
    double minimum = planes_.empty() ? -1.0 : 1e9;
    for (const auto& [n, offset] : planes_) {
      minimum = std::min(minimum, offset - n.dot(p));
      if (minimum < 0.0)
        break;
    }
    return minimum;
  }

private:
  std::vector<Point> points_;
  std::vector<std::pair<Eigen::Vector3d, double>> planes_;
};

Eigen::Vector3d inCells(const curved::Decomposition& d, std::size_t at) {
  const Eigen::Vector3i c = d.grid.cell(at);
  const double plate = std::round(-d.grid.origin.z() / d.grid.pitch);
  return {c.x() + 0.5, c.y() + 0.5, c.z() + 0.5 - plate};
}

bool onPlatform(const curved::Decomposition& d, std::size_t at) {
  const Eigen::Vector3d p = inCells(d, at);
  if (std::abs(p.z() - 0.5) > 0.01)
    return false;
  const Eigen::Vector2d q = d.grid.origin.head<2>() + d.grid.pitch * p.head<2>();
  for (std::size_t i = 0; i < d.platform.size(); ++i) {
    const Eigen::Vector2d a = d.platform[i], b = d.platform[(i + 1) % d.platform.size()];
    if ((b - a).x() * (q - a).y() - (b - a).y() * (q - a).x() < -1e-6)
      return false;
  }
  return true;
}

template <typename Visit>
void eachNeighbour(const curved::Decomposition& d, std::size_t at, int maximum, Visit&& visit) {
  const Eigen::Vector3i c = d.grid.cell(at);
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int l1 = std::abs(dx) + std::abs(dy) + std::abs(dz);
        if (l1 > 0 && l1 <= maximum && d.grid.contains(c.x() + dx, c.y() + dy, c.z() + dz))
          visit(d.grid.index(c.x() + dx, c.y() + dy, c.z() + dz), Eigen::Vector3d(dx, dy, dz));
      }
}

} // namespace

RankVerdict checkRanks(const curved::Decomposition& d, const std::vector<std::uint8_t>& solid) {
  RankVerdict verdict;
  std::map<int, std::vector<std::size_t>> ranks;
  for (std::size_t at = 0; at < d.rank.size(); ++at) {
    verdict.wrongCells += (solid[at] != 0) != (d.rank[at] != 0) || d.rank[at] < -1;
    verdict.missed += d.rank[at] == -1;
    if (d.rank[at] > 0)
      ranks[d.rank[at]].push_back(at);
  }
  Hull hull(d);
  for (const auto& [rank, cells] : ranks) {
    std::vector<Eigen::Vector3d> group;
    for (const std::size_t at : cells) {
      ++verdict.printed;
      bool supported = onPlatform(d, at);
      eachNeighbour(d, at, 2, [&](std::size_t w, const Eigen::Vector3d&) {
        supported |= d.rank[w] > 0 && d.rank[w] < rank;
      });
      verdict.unsupported += !supported;
      group.push_back(inCells(d, at));
      const double depth = hull.depth(group.back());
      verdict.inside += depth > 1e-7;
      verdict.deepest = std::max(verdict.deepest, depth);
    }
    hull.add(group);
  }
  return verdict;
}

FieldVerdict checkField(const curved::Decomposition& d, double heightMm, double minMm,
                        double maxMm) {
  FieldVerdict verdict;
  std::map<int, std::vector<std::size_t>> levels;
  std::vector<double> thickness;
  const auto levelOf = [&](std::size_t at) {
    return static_cast<int>(std::floor(static_cast<double>(d.field[at]) / heightMm));
  };
  for (std::size_t at = 0; at < d.rank.size(); ++at) {
    if (d.rank[at] <= 0)
      continue;
    levels[levelOf(at)].push_back(at);
    Eigen::Matrix3d a = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    const auto sample = [&](const Eigen::Vector3d& step, double rise) {
      a += step * step.transpose();
      b += step * rise;
    };
    eachNeighbour(d, at, 3, [&](std::size_t w, const Eigen::Vector3d& step) {
      if (d.rank[w] > 0)
        sample(step, static_cast<double>(d.field[w]) - static_cast<double>(d.field[at]));
    });
    if (onPlatform(d, at))
      sample({0, 0, -0.5}, -static_cast<double>(d.field[at]));
    const double slope = a.ldlt().solve(b).norm() / d.grid.pitch;
    thickness.push_back(heightMm / std::max(1e-6, slope));
  }
  const auto n = static_cast<double>(thickness.size());
  std::sort(thickness.begin(), thickness.end());
  double sum = 0.0, squares = 0.0, in = 0.0;
  for (const double t : thickness) {
    in += t >= minMm && t <= maxMm;
    sum += std::min(t, 10.0);
    squares += std::min(t, 10.0) * std::min(t, 10.0);
  }
  verdict.within = in / n;
  verdict.mean = sum / n;
  verdict.deviation = std::sqrt(std::max(0.0, squares / n - verdict.mean * verdict.mean));
  verdict.p01 = thickness[static_cast<std::size_t>(0.01 * n)];
  verdict.p99 = thickness[static_cast<std::size_t>(0.99 * n)];
  verdict.levels = static_cast<int>(levels.size());

  Hull hull(d);
  std::vector<std::uint8_t> seen(d.rank.size(), 0);
  double deep = 0.0;
  for (const auto& [level, cells] : levels) {
    std::vector<Eigen::Vector3d> group;
    for (const std::size_t at : cells) {
      group.push_back(inCells(d, at));
      const double depth = hull.depth(group.back());
      deep += depth > 0.5;
      verdict.deepest = std::max(verdict.deepest, depth);
      if (seen[at])
        continue;
      // The connected piece of this level.
      std::vector<std::size_t> piece{at};
      seen[at] = 1;
      bool supported = false;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        supported |= onPlatform(d, piece[i]);
        eachNeighbour(d, piece[i], 2, [&](std::size_t w, const Eigen::Vector3d& step) {
          if (d.rank[w] <= 0)
            return;
          supported |= levelOf(w) < level;
          if (levelOf(w) == level && !seen[w] && step.lpNorm<1>() < 1.5) {
            seen[w] = 1;
            piece.push_back(w);
          }
        });
      }
      ++verdict.patches;
      if (!supported) {
        ++verdict.islands;
        verdict.islandVoxels += piece.size();
      }
    }
    hull.add(group);
  }
  verdict.inaccessible = deep / n;
  return verdict;
}

} // namespace voluta::test
