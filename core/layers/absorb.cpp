#include "layers/absorb.h"

#include "base/index.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace voluta::layers {

namespace {

constexpr double kHardly = 0.05;

using base::at;

// Data of a patch for repeated queries; created when a sliver first comes near it.
struct Host {
  std::vector<double> area; // a third of the triangles around each vertex; 0 on the boundary
};

Host hostOf(const Patch& patch) {
  Host host;
  const auto& mesh = patch.surface;
  host.area.assign(mesh.vertices.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int v : mesh.triangles[t])
      host.area[at(v)] += geometry::triangleArea(mesh, t) / 3.0;
  const auto edges = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
    if (e - b == 1)
      host.area[at(edges[b].low)] = host.area[at(edges[b].high)] = 0.0;
  });
  return host;
}

struct Sliver {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::Zero();
  double area = 0.0, volume = 0.0, thickness = 0.0;
};

Sliver measure(const Patch& piece) {
  Sliver c;
  const auto& mesh = piece.surface;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double a = geometry::triangleArea(mesh, t) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = mesh.triangles[t][k];
      c.area += a;
      c.volume += a * piece.thicknessMm[at(v)];
      c.centre += a * mesh.corner(t, static_cast<int>(k));
      c.direction += a * piece.direction[at(v)];
    }
  }
  if (c.area > 0.0) {
    c.centre /= c.area;
    c.thickness = c.volume / c.area;
  }
  return c;
}

// A vertex that absorbs part of a sliver, by growing towards it (side: +1 along its direction, -1
// against it).
struct Taker {
  std::size_t patch;
  int vertex;
  double side, capacity, area;
};

} // namespace

Absorbed absorbSlivers(std::vector<Patch>& patches, const std::vector<Patch>& slivers,
                       const AbsorbOptions& options) {
  Absorbed result;
  std::vector<Eigen::AlignedBox3d> boxes;
  if (!slivers.empty())
    for (const Patch& p : patches)
      boxes.push_back(geometry::bounds(p.surface));
  std::unordered_map<std::size_t, Host> hosts;
  const double reach = options.heightMaxMm, around = 0.5 * options.beadWidthMm;
  for (const Patch& piece : slivers) {
    const Sliver sliver = measure(piece);
    if (sliver.volume <= 0.0)
      continue;
    Eigen::AlignedBox3d box = geometry::bounds(piece.surface);
    box.min().array() -= reach + around;
    box.max().array() += reach + around;
    const geometry::MeshQuery query(piece.surface);
    std::vector<Taker> takers;
    double area = 0.0, roomFor = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (!boxes[p].intersects(box) || patches[p].layer == piece.layer ||
          patches[p].group == kSupportGroup)
        continue;
      const Patch& patch = patches[p];
      const auto [entry, isNew] = hosts.try_emplace(p);
      if (isNew)
        entry->second = hostOf(patch);
      const Host& host = entry->second;
      const double side = patch.layer < piece.layer ? 1.0 : -1.0;
      for (std::size_t v = 0; v < host.area.size(); ++v) {
        const double room = options.heightMaxMm - patch.thicknessMm[v];
        if (host.area[v] <= 0.0 || room <= 1e-3 || !box.contains(patch.surface.vertices[v]) ||
            patch.direction[v].dot(sliver.direction) <= 0.0)
          continue;
        const double apart = 0.5 * (patch.thicknessMm[v] + sliver.thickness);
        const Eigen::Vector3d facing =
            patch.surface.vertices[v] + side * apart * patch.direction[v];
        if (query.closest(facing, around).triangle < 0 ||
            query.closest(patch.surface.vertices[v]).distance > 1.25 * apart)
          continue;
        takers.push_back({p, static_cast<int>(v), side, room, host.area[v]});
        area += host.area[v];
        roomFor += host.area[v] * room;
      }
    }
    if (roomFor < options.minShare * sliver.volume) {
      ++result.refused;
      continue;
    }
    // All takers rise equally until the sliver is used up; full ones drop out.
    double remaining = sliver.volume;
    std::sort(takers.begin(), takers.end(), [](const Taker& a, const Taker& b) {
      return std::tie(a.capacity, a.patch, a.vertex) < std::tie(b.capacity, b.patch, b.vertex);
    });
    for (const Taker& t : takers) {
      const double rise = std::min(t.capacity, remaining / area);
      Patch& patch = patches[t.patch];
      patch.thicknessMm[at(t.vertex)] += rise;
      patch.surface.vertices[at(t.vertex)] += 0.5 * t.side * rise * patch.direction[at(t.vertex)];
      remaining -= rise * t.area;
      area -= t.area;
    }
    remaining = std::max(0.0, remaining);
    result.mergedVolumeMm3 += sliver.volume - remaining;
    if (remaining <= kHardly * sliver.volume)
      ++result.merged;
    else
      result.dropped.push_back(
          {sliver.centre, sliver.area * remaining / sliver.volume, remaining, piece.layer});
  }
  return result;
}

} // namespace voluta::layers
