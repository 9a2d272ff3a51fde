// offsetLevel: marching tetrahedra where the level may pass. Vertices are found along the grid's
// edges, where they cannot pass each other: nothing folds in a valley, whose two sides would draw
// them apart.
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "substrate/levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace voluta::substrate {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// Cells a side of a block that is looked at as a whole first.
constexpr int kBlock = 8;
constexpr int kMostRounds = 60;
constexpr double kOnLevelMm = 1e-11;
constexpr double kCrease = 0.94; // cosine of 20 degrees

// A cube's six tetrahedra around its diagonal (Kuhn): neighbouring cubes agree on their faces.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marcher {
public:
  Marcher(const GroundDistance& ground, double distanceMm, const Eigen::AlignedBox3d& box,
          double pitch)
      : ground_(ground), distance_(distanceMm), low_(box.min()), pitch_(pitch) {
    for (int k = 0; k < 3; ++k)
      size_[k] = std::max(1, static_cast<int>(std::ceil(box.sizes()[k] / pitch)));
  }

  // Triangles face away from the ground.
  geometry::TriangleMesh run(const base::RunContext& ctx) {
    const Vector3i blocks = (size_.array() + kBlock - 1) / kBlock;
    const auto count = static_cast<std::size_t>(blocks.prod());
    std::vector<std::vector<double>> values(count); // at the block's corners; empty: far
    base::parallelChunks(ctx, count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        values[b] = sampled(blockAt(b, blocks));
    });
    for (std::size_t b = 0; b < count; ++b)
      if (!values[b].empty())
        march(blockAt(b, blocks), values[b]);
    mesh_.vertices.resize(crossings_.size());
    base::parallelChunks(ctx, crossings_.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        mesh_.vertices[v] = onLevel(crossings_[v]);
    });
    return std::move(mesh_);
  }

private:
  static Vector3i blockAt(std::size_t b, const Vector3i& blocks) {
    const int i = static_cast<int>(b);
    return kBlock *
           Vector3i(i % blocks.x(), i / blocks.x() % blocks.y(), i / (blocks.x() * blocks.y()));
  }
  Vector3d point(const Vector3i& at) const { return low_ + pitch_ * at.cast<double>(); }

  // Nearer than the level the side does not matter: either is below it.
  double signedDistance(const Vector3d& p) const {
    const double far = ground_.unsignedMm(p);
    return far < distance_ || !ground_.isInside(p) ? far : -far;
  }

  std::vector<double> sampled(const Vector3i& first) const {
    const Vector3d middle = point(first) + Vector3d::Constant(0.5 * kBlock * pitch_);
    const double reach = 0.5 * std::sqrt(3.0) * kBlock * pitch_;
    if (std::abs(ground_.unsignedMm(middle) - distance_) > reach)
      return {};
    std::vector<double> values;
    values.reserve((kBlock + 1) * (kBlock + 1) * (kBlock + 1));
    for (int z = 0; z <= kBlock; ++z)
      for (int y = 0; y <= kBlock; ++y)
        for (int x = 0; x <= kBlock; ++x)
          values.push_back(signedDistance(point(first + Vector3i(x, y, z))) - distance_);
    return values;
  }

  std::uint64_t key(const Vector3i& at) const {
    const auto nx = static_cast<std::uint64_t>(size_.x() + kBlock + 1),
               ny = static_cast<std::uint64_t>(size_.y() + kBlock + 1);
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

  // Regula falsi, the end that stays halved in weight (Dowell and Jarratt 1971).
  Vector3d onLevel(const Crossing& crossing) const {
    const Vector3d a = point(crossing.from.at), b = point(crossing.to.at);
    double low = 0.0, high = 1.0, atLow = crossing.from.value, atHigh = crossing.to.value;
    Vector3d p = a;
    for (int round = 0; round < kMostRounds; ++round) {
      const double t = low + (high - low) * atLow / (atLow - atHigh);
      p = (1.0 - t) * a + t * b;
      const double value = signedDistance(p) - distance_;
      if (std::abs(value) <= kOnLevelMm)
        break;
      if ((value < 0.0) == (atHigh < 0.0)) {
        atLow *= high < 1.0 || round > 0 ? 0.5 : 1.0;
        high = t;
        atHigh = value;
      } else {
        atHigh *= low > 0.0 || round > 0 ? 0.5 : 1.0;
        low = t;
        atLow = value;
      }
    }
    return p;
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
    for (int z = first.z(); z < std::min(first.z() + kBlock, size_.z()); ++z)
      for (int y = first.y(); y < std::min(first.y() + kBlock, size_.y()); ++y)
        for (int x = first.x(); x < std::min(first.x() + kBlock, size_.x()); ++x) {
          std::array<Corner, 8> corners;
          for (int c = 0; c < 8; ++c) {
            const Vector3i at = Vector3i(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
            const Vector3i in = at - first;
            corners[static_cast<std::size_t>(c)] = {
                at, values[static_cast<std::size_t>(
                        (in.z() * (kBlock + 1) + in.y()) * (kBlock + 1) + in.x())]};
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

  // Which way round is known from the edges' middles: they are crossed in the same order anywhere.
  void add(int a, int b, int c, const Vector3d& up) {
    const auto p = [&](int v) -> Vector3d {
      const Crossing& crossing = crossings_[static_cast<std::size_t>(v)];
      return 0.5 * (point(crossing.from.at) + point(crossing.to.at));
    };
    const Vector3d normal = (p(b) - p(a)).cross(p(c) - p(a));
    if (normal.dot(up) < 0.0)
      std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  struct EdgeHash {
    std::size_t operator()(const std::pair<std::uint64_t, std::uint64_t>& e) const {
      return static_cast<std::size_t>(e.first * 0x9E3779B97F4A7C15ull ^ (e.second << 1));
    }
  };

  const GroundDistance& ground_;
  double distance_;
  Vector3d low_;
  double pitch_;
  Vector3i size_;
  std::vector<Crossing> crossings_; // one a vertex
  geometry::TriangleMesh mesh_;
  std::unordered_map<std::pair<std::uint64_t, std::uint64_t>, int, EdgeHash> vertexOf_;
};

} // namespace

layers::LevelSurface offsetLevel(const GroundDistance& ground, double distanceMm,
                                 double thicknessMm, const Eigen::AlignedBox3d& box, double edgeMm,
                                 const base::RunContext& ctx) {
  base::require(distanceMm > 0.0 && thicknessMm > 0.0 && edgeMm > 0.0 && !box.isEmpty(),
                "an offset of positive lengths and a box");
  layers::LevelSurface s;
  s.surface = Marcher(ground, distanceMm, box, edgeMm).run(ctx);
  const std::size_t n = s.surface.vertices.size();
  s.thicknessMm.assign(n, thicknessMm);
  s.direction.resize(n);
  const std::vector<Vector3d> normals = geometry::vertexNormals(s.surface);
  base::parallelChunks(ctx, n, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vector3d& p = s.surface.vertices[v];
      s.direction[v] = ground.outward(p);
      // In a crease two places are nearest.
      if (normals[v].dot(s.direction[v]) < kCrease && normals[v].squaredNorm() > 0.0)
        s.direction[v] = normals[v];
    }
  });
  s.clearDirection = s.direction;
  return s;
}

} // namespace voluta::substrate
