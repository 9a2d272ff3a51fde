#include "voxel/column_parity.h"

#include "base/parallel.h"
#include "geometry/append_mesh.h"
#include "geometry/edges.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

namespace voluta::voxel {

namespace {

using Point = std::array<double, 3>;

Point toPoint(const Eigen::Vector3d& v) {
  // Adding zero turns -0 into +0, which would otherwise compare as another position.
  return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
}

// Signed crossing of the ray (x, y) + s (1, 0), s > 0, with the edge a -> b in the plane: +1 if the
// edge goes up, -1 if it goes down. Half-open in y, and the side is computed from the lower end, so
// that b -> a gives exactly the opposite.
int rayCrossing(const Point& a, const Point& b, double x, double y) {
  const bool aAbove = a[1] > y, bAbove = b[1] > y;
  if (aAbove == bAbove)
    return 0;
  const Point& low = bAbove ? a : b;
  const Point& high = bAbove ? b : a;
  const double side = (high[0] - low[0]) * (y - low[1]) - (x - low[0]) * (high[1] - low[1]);
  if (side <= 0.0)
    return 0;
  return bAbove ? 1 : -1;
}

struct Crossing {
  double z;
  int winding;
};

// Maps vertices of equal position to one: the lowest index of them.
std::vector<int> canonicalVertices(const geometry::TriangleMesh& mesh) {
  std::vector<int> order(mesh.vertices.size()), canonical(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int v) { return toPoint(mesh.vertices[static_cast<std::size_t>(v)]); };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const Point pa = at(a), pb = at(b);
    return pa != pb ? pa < pb : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    canonical[static_cast<std::size_t>(order[i])] =
        i > 0 && at(order[i]) == at(order[i - 1])
            ? canonical[static_cast<std::size_t>(order[i - 1])]
            : order[i];
  return canonical;
}

struct OpenEdge {
  int low, high, sign; // sign: how much more often the edge runs from low to high than back
};

std::vector<OpenEdge> openEdges(const geometry::TriangleMesh& mesh) {
  const std::vector<int> canonical = canonicalVertices(mesh);
  std::vector<OpenEdge> edges, open;
  edges.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles)
    for (std::size_t s = 0; s < 3; ++s) {
      const int a = canonical[static_cast<std::size_t>(t[s])];
      const int b = canonical[static_cast<std::size_t>(t[(s + 1) % 3])];
      if (a != b)
        edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end(), [](const OpenEdge& a, const OpenEdge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  for (std::size_t i = 0; i < edges.size();) {
    OpenEdge sum = edges[i];
    std::size_t j = i + 1;
    for (; j < edges.size() && edges[j].low == sum.low && edges[j].high == sum.high; ++j)
      sum.sign += edges[j].sign;
    if (sum.sign != 0)
      open.push_back(sum);
    i = j;
  }
  return open;
}

// Calls visit(index, i, j, k, winding) for every cell.
template <typename Visit>
void eachWinding(const geometry::TriangleMesh& mesh, const VoxelGrid& grid,
                 const base::RunContext& ctx, Visit&& visit) {
  const int nx = grid.size.x(), ny = grid.size.y(), nz = grid.size.z();
  const double pitch = grid.pitch;
  const auto column = [&](double value, int axis) {
    return (value - grid.origin[axis]) / pitch - 0.5;
  };

  // Triangles by the rows of columns they cover, so that rows can be processed separately.
  std::vector<std::vector<int>> ofRow(static_cast<std::size_t>(ny));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double low = mesh.corner(t, 0).y(), high = low;
    for (int c = 1; c < 3; ++c) {
      low = std::min(low, mesh.corner(t, c).y());
      high = std::max(high, mesh.corner(t, c).y());
    }
    const int first = std::max(0, static_cast<int>(std::floor(column(low, 1))));
    const int last = std::min(ny - 1, static_cast<int>(std::ceil(column(high, 1))));
    for (int j = first; j <= last; ++j)
      ofRow[static_cast<std::size_t>(j)].push_back(static_cast<int>(t));
  }

  const auto fillRow = [&](int j) {
    std::vector<std::vector<Crossing>> columns(static_cast<std::size_t>(nx));
    const double y = grid.centre(0, j, 0).y();
    for (const int triangle : ofRow[static_cast<std::size_t>(j)]) {
      const auto t = static_cast<std::size_t>(triangle);
      const Point p[3] = {toPoint(mesh.corner(t, 0)), toPoint(mesh.corner(t, 1)),
                          toPoint(mesh.corner(t, 2))};
      const auto [xLow, xHigh] = std::minmax({p[0][0], p[1][0], p[2][0]});
      const auto [zLow, zHigh] = std::minmax({p[0][2], p[1][2], p[2][2]});
      const int first = std::max(0, static_cast<int>(std::floor(column(xLow, 0))));
      const int last = std::min(nx - 1, static_cast<int>(std::ceil(column(xHigh, 0))));
      const double ux = p[1][0] - p[0][0], uy = p[1][1] - p[0][1], uz = p[1][2] - p[0][2];
      const double vx = p[2][0] - p[0][0], vy = p[2][1] - p[0][1], vz = p[2][2] - p[0][2];
      const double nX = uy * vz - uz * vy, nY = uz * vx - ux * vz, nZ = ux * vy - uy * vx;
      for (int i = first; i <= last; ++i) {
        const double x = grid.centre(i, j, 0).x();
        const int winding = rayCrossing(p[0], p[1], x, y) + rayCrossing(p[1], p[2], x, y) +
                            rayCrossing(p[2], p[0], x, y);
        if (winding == 0)
          continue;
        double z = nZ == 0.0 ? zLow : p[0][2] - (nX * (x - p[0][0]) + nY * (y - p[0][1])) / nZ;
        z = std::clamp(z, zLow, zHigh);
        columns[static_cast<std::size_t>(i)].push_back({z, winding});
      }
    }
    for (int i = 0; i < nx; ++i) {
      auto& crossings = columns[static_cast<std::size_t>(i)];
      std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return a.z != b.z ? a.z < b.z : a.winding < b.winding;
      });
      int winding = 0;
      std::size_t next = 0;
      for (int k = 0; k < nz; ++k) {
        const double z = grid.centre(i, j, k).z();
        while (next < crossings.size() && crossings[next].z < z)
          winding += crossings[next++].winding;
        visit(grid.index(i, j, k), i, j, k, winding);
      }
    }
  };
  base::parallelChunks(ctx, static_cast<std::size_t>(ny), 4, [&](std::size_t b, std::size_t e) {
    for (std::size_t j = b; j < e; ++j)
      fillRow(static_cast<int>(j));
  });
}

} // namespace

geometry::TriangleMesh capsOf(const geometry::TriangleMesh& mesh) {
  const std::vector<OpenEdge> open = openEdges(mesh);
  geometry::TriangleMesh caps;
  if (open.empty())
    return caps;
  geometry::UnionFind groups(mesh.vertices.size());
  std::map<int, int> vertexOf; // Of caps
  for (const OpenEdge& edge : open) {
    groups.join(edge.low, edge.high);
    vertexOf[edge.low] = vertexOf[edge.high] = 0;
  }
  struct Fan {
    int hub;
    int corners;
  };
  std::map<int, Fan> fans;
  for (auto& [v, vertex] : vertexOf) {
    vertex = static_cast<int>(caps.vertices.size());
    caps.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  }
  for (const auto& [v, vertex] : vertexOf) {
    const auto [fan, fresh] =
        fans.try_emplace(groups.find(v), Fan{static_cast<int>(caps.vertices.size()), 0});
    if (fresh)
      caps.vertices.push_back(Eigen::Vector3d::Zero());
    caps.vertices[static_cast<std::size_t>(fan->second.hub)] +=
        mesh.vertices[static_cast<std::size_t>(v)];
    ++fan->second.corners;
  }
  for (const auto& [root, fan] : fans)
    caps.vertices[static_cast<std::size_t>(fan.hub)] /= fan.corners;
  for (const OpenEdge& edge : open) {
    const int hub = fans.at(groups.find(edge.low)).hub;
    const int low = vertexOf.at(edge.low), high = vertexOf.at(edge.high);
    for (int n = 0; n < std::abs(edge.sign); ++n)
      caps.triangles.push_back(edge.sign > 0 ? std::array<int, 3>{high, low, hub}
                                             : std::array<int, 3>{low, high, hub});
  }
  return caps;
}

void fillClosed(const geometry::TriangleMesh& mesh, const VoxelGrid& grid,
                std::vector<std::uint8_t>& solid, const base::RunContext& ctx) {
  eachWinding(mesh, grid, ctx, [&](std::size_t cell, int, int, int, int winding) {
    if (winding != 0)
      solid[cell] = 1;
  });
}

void fillOpen(const geometry::TriangleMesh& mesh, const geometry::TriangleMesh& caps,
              const VoxelGrid& grid, std::vector<std::uint8_t>& solid,
              const base::RunContext& ctx) {
  geometry::TriangleMesh whole = mesh;
  geometry::appendMesh(whole, caps);
  const geometry::MeshQuery query(caps);
  eachWinding(whole, grid, ctx, [&](std::size_t cell, int i, int j, int k, int winding) {
    if (!solid[cell] && std::abs(winding - query.windingNumber(grid.centre(i, j, k))) > 0.5)
      solid[cell] = 1;
  });
}

} // namespace voluta::voxel
