// contour_report: levels of fields in closed form, cut by marching cubes with cleaning (as
// extractLevels and cleanSurface) and by dual contouring (Ju et al. 2002, as Dai 2020, 3.4.5, uses
// it), on the same LevelField: triangles, their angles, distance to the true level, time.
#include "base/stopwatch.h"
#include "base/units.h"
#include "curved/cell_contour.h"
#include "curved/extraction.h"
#include "layers/clean_surface.h"
#include "layers/synthetic.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

using namespace voluta;
using Eigen::Vector3d;

namespace {

// One level by dual contouring: in each cell the point that fits the tangent planes at its crossed
// edges best, kept in the cell; a quadrilateral round each crossed edge of the grid.
class DualContour {
public:
  DualContour(const curved::LevelField& field, double iso) : field_(field), iso_(iso) {}

  geometry::TriangleMesh run() {
    const Eigen::Vector3i size = field_.grid().size;
    for (int k = -1; k < size.z(); ++k)
      for (int j = -1; j < size.y(); ++j)
        for (int i = -1; i < size.x(); ++i)
          addVertex(i, j, k);
    for (const auto& [key, vertex] : vertexOf_)
      addQuads(key);
    return std::move(mesh_);
  }

private:
  using Key = std::array<int, 3>;

  double height(int node) const {
    const double h = field_.value(node) - iso_;
    return h == 0.0 ? -1e-9 : h;
  }

  void addVertex(int i, int j, int k) {
    const auto cell = field_.cell(i, j, k);
    if (!cell)
      return;
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Vector3d b = Vector3d::Zero(), middle = Vector3d::Zero();
    std::vector<std::pair<Vector3d, Vector3d>> planes;
    for (const curved::CubeEdge& e : curved::cubeEdges()) {
      const int from = cell->nodes[static_cast<std::size_t>(e.from)],
                to = cell->nodes[static_cast<std::size_t>(e.to)];
      const double u = height(from), v = height(to);
      if ((u < 0.0) == (v < 0.0))
        continue;
      const double t = u / (u - v);
      const auto corner = [&](int c) {
        return field_.grid().centre(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
      };
      planes.emplace_back(
          (1.0 - t) * corner(e.from) + t * corner(e.to),
          ((1.0 - t) * field_.gradient(from) + t * field_.gradient(to)).normalized());
      middle += planes.back().first;
    }
    if (planes.empty())
      return;
    middle /= static_cast<double>(planes.size());
    for (const auto& [p, n] : planes) {
      a += n * n.transpose();
      b += n * n.dot(p - middle);
    }
    a += 0.02 * Eigen::Matrix3d::Identity();
    const double half = 0.5 * field_.grid().pitch;
    const Vector3d low = field_.grid().centre(i, j, k), centre = low + Vector3d::Constant(half);
    Vector3d x = middle + a.ldlt().solve(b);
    x = centre + (x - centre).cwiseMax(-half).cwiseMin(half);
    vertexOf_[{i, j, k}] = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(x);
  }

  // The three edges of the grid at the cell's greatest corner, each with the four cells round it.
  void addQuads(const Key& key) {
    const auto cell = field_.cell(key[0], key[1], key[2]);
    for (int axis = 0; axis < 3; ++axis) {
      const double u = height(cell->nodes[static_cast<std::size_t>(7 & ~(1 << axis))]),
                   v = height(cell->nodes[7]);
      if ((u < 0.0) == (v < 0.0))
        continue;
      std::array<int, 4> ring;
      bool whole = true;
      for (int c = 0; c < 4; ++c) {
        Key k = key;
        k[static_cast<std::size_t>((axis + 1) % 3)] += c == 1 || c == 2;
        k[static_cast<std::size_t>((axis + 2) % 3)] += c >= 2;
        const auto found = vertexOf_.find(k);
        whole &= found != vertexOf_.end();
        if (whole)
          ring[static_cast<std::size_t>(c)] = found->second;
      }
      if (!whole)
        continue;
      if (u > 0.0)
        std::swap(ring[1], ring[3]);
      const auto& p = mesh_.vertices;
      const auto at = [&](int c) {
        return p[static_cast<std::size_t>(ring[static_cast<std::size_t>(c)])];
      };
      if ((at(0) - at(2)).norm() < (at(1) - at(3)).norm()) {
        mesh_.triangles.push_back({ring[0], ring[1], ring[2]});
        mesh_.triangles.push_back({ring[0], ring[2], ring[3]});
      } else {
        mesh_.triangles.push_back({ring[1], ring[2], ring[3]});
        mesh_.triangles.push_back({ring[1], ring[3], ring[0]});
      }
    }
  }

  const curved::LevelField& field_;
  double iso_;
  geometry::TriangleMesh mesh_;
  std::map<Key, int> vertexOf_;
};

struct Tally {
  std::size_t triangles = 0, sharp = 0, points = 0, notManifold = 0;
  double sum = 0.0, maximum = 0.0, seconds = 0.0;

  // Triangles wholly inside the part are judged, by their corners and middles.
  void add(const geometry::TriangleMesh& m, const test::FieldFunction& field, double iso,
           double halfWidth, double top) {
    const auto isIn = [&](const Vector3d& p) {
      return p.head<2>().cwiseAbs().maxCoeff() < halfWidth && p.z() > 0.0 && p.z() < top;
    };
    const auto off = [&](const Vector3d& p) {
      const double h = 1e-5;
      Vector3d g;
      for (int axis = 0; axis < 3; ++axis)
        g[axis] =
            (field(p + h * Vector3d::Unit(axis)) - field(p - h * Vector3d::Unit(axis))) / (2 * h);
      const double d = std::abs(field(p) - iso) / g.norm();
      sum += d;
      maximum = std::max(maximum, d);
      ++points;
    };
    std::map<std::pair<int, int>, int> directed;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      const Vector3d a = m.corner(t, 0), b = m.corner(t, 1), c = m.corner(t, 2);
      for (std::size_t k = 0; k < 3; ++k)
        notManifold += ++directed[{m.triangles[t][k], m.triangles[t][(k + 1) % 3]}] > 1;
      if (!isIn(a) || !isIn(b) || !isIn(c))
        continue;
      const auto angle = [](const Vector3d& u, const Vector3d& v) {
        return base::radiansToDegrees(std::atan2(u.cross(v).norm(), u.dot(v)));
      };
      const double minimum =
          std::min({angle(b - a, c - a), angle(a - b, c - b), angle(a - c, b - c)});
      ++triangles;
      sharp += minimum < 15.0;
      for (const Vector3d& p : {a, b, c, Vector3d((a + b + c) / 3.0)})
        off(p);
    }
  }
  void print(const char* name) const {
    std::printf(
        "  %-22s %7zu triangles, %.4f below 15 degrees, off the level %.4f mm mean, %.4f most, "
        "%zu edges not manifold, %.2f s\n",
        name, triangles, static_cast<double>(sharp) / static_cast<double>(triangles),
        sum / static_cast<double>(points), maximum, notManifold, seconds);
  }
};

} // namespace

int main() {
  constexpr double kPitch = 0.8, kHalf = 20.0, kTop = 40.0;
  const auto part = test::box({-kHalf, -kHalf, 0}, {kHalf, kHalf, kTop});
  const std::vector<std::pair<const char*, test::FieldFunction>> fields = {
      {"ball", [](const Vector3d& p) { return (p - Vector3d(3, 2, -15)).norm() - 14.0; }},
      {"waves",
       [](const Vector3d& p) { return p.z() + 1.5 * std::sin(p.x() / 4) * std::cos(p.y() / 5); }},
      {"roof", [](const Vector3d& p) { return p.z() + 0.5 * std::abs(p.x() - 0.3); }}};
  for (const auto& [name, function] : fields) {
    const auto d = test::decompositionOf(part, kPitch, function);
    const curved::LevelField field(d, {});
    Tally raw, cleaned, dual;
    base::Stopwatch clock;
    std::vector<curved::RawLevel> levels = curved::extractLevels(field, kPitch, {});
    raw.seconds = clock.seconds();
    for (const auto& level : levels)
      if (level.level > 0)
        raw.add(level.surface, function, (level.level + 0.5) * kPitch, kHalf - 1, kTop - 1);
    clock = {};
    layers::CleanOptions clean;
    clean.shortEdgeMm = 0.3 * kPitch;
    for (auto& level : levels)
      layers::cleanSurface(level, clean, {});
    cleaned.seconds = raw.seconds + clock.seconds();
    for (const auto& level : levels)
      if (level.level > 0)
        cleaned.add(level.surface, function, (level.level + 0.5) * kPitch, kHalf - 1, kTop - 1);
    for (const auto& level : levels) {
      if (level.level == 0)
        continue;
      const double iso = (level.level + 0.5) * kPitch;
      clock = {};
      const geometry::TriangleMesh mesh = DualContour(field, iso).run();
      dual.seconds += clock.seconds();
      dual.add(mesh, function, iso, kHalf - 1, kTop - 1);
    }
    std::printf("%s, %zu voxels\n", name, d.voxels);
    raw.print("marching cubes");
    cleaned.print("marching and cleaned");
    dual.print("dual contouring");
  }
  return 0;
}
