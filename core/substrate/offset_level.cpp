// offsetLevel: marching tetrahedra near the level. Vertices are found along the grid's edges, where
// they cannot pass each other: the surface does not fold in a valley, whose two sides would pull
// vertices apart.
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "substrate/levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

namespace voluta::substrate {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// Cells per side of a block, which is tested as a whole first.
constexpr int kBlock = 8;
constexpr int kMaxRounds = 60;
constexpr double kOnLevelMm = 1e-11;
constexpr double kCrease = 0.94; // Cosine of 20 degrees

// The six tetrahedra around a cube's diagonal (Kuhn): neighbouring cubes agree on their faces.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

} // namespace

// Signed distances at a grid's points, computed block by block on first use.
class OffsetLevels::Grid {
public:
  Grid(GroundDistance ground, const Eigen::AlignedBox3d& box, double pitch)
      : ground_(std::move(ground)), low_(box.min()), pitch_(pitch) {
    for (int k = 0; k < 3; ++k)
      size_[k] = std::max(1, static_cast<int>(std::ceil(box.sizes()[k] / pitch)));
    blocks_ = (size_.array() + kBlock - 1) / kBlock;
    entries_ = std::vector<Entry>(static_cast<std::size_t>(blocks_.prod()));
  }

  const GroundDistance& ground() const { return ground_; }
  const Vector3i& size() const { return size_; } // In cells
  std::size_t blocks() const { return entries_.size(); }
  Vector3i firstCell(std::size_t b) const {
    const int i = static_cast<int>(b);
    return kBlock * Vector3i(i % blocks_.x(), i / blocks_.x() % blocks_.y(),
                             i / (blocks_.x() * blocks_.y()));
  }
  Vector3d point(const Vector3i& at) const { return low_ + pitch_ * at.cast<double>(); }

  // Returns the distances at the corners of a block's cells, x varying fastest; nullptr if the
  // level does not pass through the block.
  const std::vector<double>* valuesNear(std::size_t b, double distanceMm) {
    Entry& entry = entries_[b];
    const Vector3i first = firstCell(b);
    std::call_once(entry.seen, [&] {
      entry.middleMm = ground_.unsignedMm(point(first) + Vector3d::Constant(0.5 * kBlock * pitch_));
    });
    const double reach = 0.5 * std::sqrt(3.0) * kBlock * pitch_;
    if (std::abs(entry.middleMm - distanceMm) > reach)
      return nullptr;
    std::call_once(entry.sampled, [&] {
      entry.values.reserve((kBlock + 1) * (kBlock + 1) * (kBlock + 1));
      for (int z = 0; z <= kBlock; ++z)
        for (int y = 0; y <= kBlock; ++y)
          for (int x = 0; x <= kBlock; ++x)
            entry.values.push_back(ground_.signedMm(point(first + Vector3i(x, y, z))));
    });
    return &entry.values;
  }

private:
  struct Entry {
    std::once_flag seen, sampled;
    double middleMm = 0.0; // Distance at the block's middle
    std::vector<double> values;
  };

  GroundDistance ground_;
  Vector3d low_;
  double pitch_;
  Vector3i size_, blocks_;
  std::vector<Entry> entries_;
};

namespace {

template <typename Grid> class Marcher {
public:
  Marcher(Grid& grid, double distanceMm) : grid_(grid), distance_(distanceMm) {}

  // Triangles face away from the ground.
  layers::LevelSurface run(const base::RunContext& ctx) {
    std::vector<const std::vector<double>*> values(grid_.blocks());
    base::parallelChunks(ctx, values.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        values[b] = grid_.valuesNear(b, distance_);
    });
    for (std::size_t b = 0; b < values.size(); ++b)
      if (values[b])
        march(grid_.firstCell(b), *values[b]);
    s_.surface.vertices.resize(crossings_.size());
    s_.direction.resize(crossings_.size());
    base::parallelChunks(ctx, crossings_.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        putOnLevel(crossings_[v], s_.surface.vertices[v], s_.direction[v]);
    });
    return std::move(s_);
  }

private:
  Vector3d point(const Vector3i& at) const { return grid_.point(at); }

  std::uint64_t key(const Vector3i& at) const {
    const auto nx = static_cast<std::uint64_t>(grid_.size().x() + kBlock + 1),
               ny = static_cast<std::uint64_t>(grid_.size().y() + kBlock + 1);
    return (static_cast<std::uint64_t>(at.z()) * ny + static_cast<std::uint64_t>(at.y())) * nx +
           static_cast<std::uint64_t>(at.x());
  }

  struct Corner {
    Vector3i at = Vector3i::Zero();
    double value = 0.0;
  };
  struct Crossing {
    Corner from, to;
  };

  // Newton steps along the edge, as long as they stay within the bracket.
  void putOnLevel(const Crossing& crossing, Vector3d& p, Vector3d& direction) const {
    const Vector3d a = point(crossing.from.at), step = point(crossing.to.at) - a;
    double low = 0.0, high = 1.0;
    double t = crossing.from.value / (crossing.from.value - crossing.to.value);
    for (int round = 0; round < kMaxRounds; ++round) {
      p = a + t * step;
      const Vector3d out = p - grid_.ground().nearest(p);
      const double far = out.norm();
      // Closer than the level, the side does not matter: both are below it.
      const bool inside = far >= distance_ && grid_.ground().isInside(p);
      const double value = (inside ? -far : far) - distance_;
      direction = out / far;
      if (std::abs(value) <= kOnLevelMm)
        break;
      ((value < 0.0) == (crossing.from.value < 0.0) ? low : high) = t;
      const double slope = (inside ? -1.0 : 1.0) * direction.dot(step);
      t -= value / slope;
      if (!(t > low && t < high))
        t = 0.5 * (low + high);
    }
  }

  int vertexOn(const Corner& a, const Corner& b) {
    const std::uint64_t ka = key(a.at), kb = key(b.at);
    const Corner &from = ka < kb ? a : b, &to = ka < kb ? b : a;
    const auto edge = std::make_pair(std::min(ka, kb), std::max(ka, kb));
    const auto [entry, isNew] = vertexOf_.try_emplace(edge, static_cast<int>(crossings_.size()));
    if (isNew)
      crossings_.push_back({from, to});
    return entry->second;
  }

  void march(const Vector3i& first, const std::vector<double>& values) {
    for (int z = first.z(); z < std::min(first.z() + kBlock, grid_.size().z()); ++z)
      for (int y = first.y(); y < std::min(first.y() + kBlock, grid_.size().y()); ++y)
        for (int x = first.x(); x < std::min(first.x() + kBlock, grid_.size().x()); ++x) {
          std::array<Corner, 8> corners;
          for (int c = 0; c < 8; ++c) {
            const Vector3i at = Vector3i(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
            const Vector3i in = at - first;
            corners[static_cast<std::size_t>(c)] = {
                at, values[static_cast<std::size_t>(
                        (in.z() * (kBlock + 1) + in.y()) * (kBlock + 1) + in.x())] -
                        distance_};
          }
          for (const auto& t : kTetrahedra)
            cut({corners[static_cast<std::size_t>(t[0])], corners[static_cast<std::size_t>(t[1])],
                 corners[static_cast<std::size_t>(t[2])], corners[static_cast<std::size_t>(t[3])]});
        }
  }

  void cut(const std::array<Corner, 4>& t) {
    std::array<std::size_t, 4> below{}, above{};
    std::size_t belows = 0, aboves = 0;
    for (std::size_t k = 0; k < 4; ++k)
      (t[k].value < 0.0 ? below[belows++] : above[aboves++]) = k;
    if (belows == 0 || aboves == 0)
      return;
    const auto on = [&](std::size_t a, std::size_t b) { return vertexOn(t[a], t[b]); };
    const Vector3d up = point(t[above[0]].at) - point(t[below[0]].at);
    if (belows == 1)
      add(on(below[0], above[0]), on(below[0], above[1]), on(below[0], above[2]), up);
    else if (aboves == 1)
      add(on(below[0], above[0]), on(below[1], above[0]), on(below[2], above[0]), up);
    else {
      const int a = on(below[0], above[0]), b = on(below[0], above[1]), c = on(below[1], above[1]),
                d = on(below[1], above[0]);
      add(a, b, c, up);
      add(a, c, d, up);
    }
  }

  // The orientation follows from the edges' midpoints: the edges are crossed in the same order
  // anywhere.
  void add(int a, int b, int c, const Vector3d& up) {
    const auto p = [&](int v) -> Vector3d {
      const Crossing& crossing = crossings_[static_cast<std::size_t>(v)];
      return 0.5 * (point(crossing.from.at) + point(crossing.to.at));
    };
    const Vector3d normal = (p(b) - p(a)).cross(p(c) - p(a));
    if (normal.dot(up) < 0.0)
      std::swap(b, c);
    s_.surface.triangles.push_back({a, b, c});
  }

  struct EdgeHash {
    std::size_t operator()(const std::pair<std::uint64_t, std::uint64_t>& e) const {
      return static_cast<std::size_t>(e.first * 0x9E3779B97F4A7C15ull ^ (e.second << 1));
    }
  };

  Grid& grid_;
  double distance_;
  std::vector<Crossing> crossings_; // One per vertex
  layers::LevelSurface s_;
  std::unordered_map<std::pair<std::uint64_t, std::uint64_t>, int, EdgeHash> vertexOf_;
};

} // namespace

OffsetLevels::OffsetLevels(GroundDistance ground, const Eigen::AlignedBox3d& box, double edgeMm) {
  base::require(edgeMm > 0.0 && !box.isEmpty(), "an offset of positive lengths and a box");
  grid_ = std::make_shared<Grid>(std::move(ground), box, edgeMm);
}

layers::LevelSurface OffsetLevels::at(double distanceMm, double thicknessMm,
                                      const base::RunContext& ctx) const {
  base::require(distanceMm > 0.0 && thicknessMm > 0.0, "an offset of positive lengths");
  layers::LevelSurface s = Marcher<Grid>(*grid_, distanceMm).run(ctx);
  s.thicknessMm.assign(s.direction.size(), thicknessMm);
  const std::vector<Vector3d> normals = geometry::vertexNormals(s.surface);
  // In a crease two points are nearest.
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (normals[v].dot(s.direction[v]) < kCrease && normals[v].squaredNorm() > 0.0)
      s.direction[v] = normals[v];
  s.clearDirection = s.direction;
  return s;
}

layers::LevelSurface offsetLevel(const GroundDistance& ground, double distanceMm,
                                 double thicknessMm, const Eigen::AlignedBox3d& box, double edgeMm,
                                 const base::RunContext& ctx) {
  return OffsetLevels(ground, box, edgeMm).at(distanceMm, thicknessMm, ctx);
}

} // namespace voluta::substrate
