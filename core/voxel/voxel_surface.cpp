#include "base/error.h"
#include "geometry/edges.h"
#include "voxel/voxel_object.h"

#include <algorithm>
#include <array>

namespace voluta::voxel {

namespace {
using Cell = Eigen::Vector3i;

// A side of a solid cell that faces air.
struct Face {
  Cell cell;
  int axis; // Axis of its normal
  int sign;
};

// Returns the corners of a face in lattice points, counter-clockwise seen from outside.
std::array<Cell, 4> cornersOf(const Face& face) {
  const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
  Cell base = face.cell;
  base[face.axis] += face.sign > 0 ? 1 : 0;
  std::array<Cell, 4> corners{base, base, base, base};
  corners[1][u] += 1;
  corners[2][u] += 1;
  corners[2][v] += 1;
  corners[3][v] += 1;
  if (face.sign < 0)
    std::swap(corners[1], corners[3]);
  return corners;
}

std::vector<Face> boundaryFaces(const VoxelObject& object) {
  std::vector<Face> faces;
  for (int k = 0; k < object.size.z(); ++k)
    for (int j = 0; j < object.size.y(); ++j)
      for (int i = 0; i < object.size.x(); ++i) {
        if (!object.solidAt(i, j, k))
          continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int sign : {-1, 1}) {
            const Cell beside = Cell(i, j, k) + sign * Cell::Unit(axis);
            if (!object.solidAt(beside.x(), beside.y(), beside.z()))
              faces.push_back({{i, j, k}, axis, sign});
          }
      }
  return faces;
}

// One side of a face: corner c to corner c + 1.
struct Side {
  std::array<int, 4> edge; // Lower end and axis: equal for sides that coincide
  int face, side;
  bool forward; // Runs from the lower to the upper end
};

std::vector<Side> sidesOf(const std::vector<Face>& faces) {
  std::vector<Side> sides;
  sides.reserve(4 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::array<Cell, 4> corners = cornersOf(faces[f]);
    for (std::size_t s = 0; s < 4; ++s) {
      const Cell &a = corners[s], &b = corners[(s + 1) % 4];
      const Cell low = a.cwiseMin(b), along = (b - a).cwiseAbs();
      int axis = 0;
      along.maxCoeff(&axis);
      sides.push_back(
          {{low.z(), low.y(), low.x(), axis}, static_cast<int>(f), static_cast<int>(s), a == low});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.face < b.face;
  });
  return sides;
}

// Sets of corners (4 face + corner) that become one vertex.
using Corners = geometry::UnionFind;

int lowerCorner(const Side& s) {
  return 4 * s.face + (s.forward ? s.side : (s.side + 1) % 4);
}
int upperCorner(const Side& s) {
  return 4 * s.face + (s.forward ? (s.side + 1) % 4 : s.side);
}

// Joins the corners that become one vertex and returns the first side of each edge at which four
// faces meet, ordered so that the next side is of the same cell: two cells touch there, and the
// faces of each belong together.
std::vector<std::size_t> joinCorners(const std::vector<Face>& faces, std::vector<Side>& sides,
                                     Corners& corners) {
  std::vector<std::size_t> doubled;
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].edge == sides[begin].edge)
      ++end;
    if (end - begin == 4) {
      const auto cellOf = [&](std::size_t s) {
        return faces[static_cast<std::size_t>(sides[s].face)].cell;
      };
      for (std::size_t s = begin + 1; s < end; ++s)
        if (cellOf(s) == cellOf(begin))
          std::swap(sides[begin + 1], sides[s]);
      doubled.push_back(begin);
    }
    for (std::size_t s = begin; s < end; s += 2) {
      corners.join(lowerCorner(sides[s]), lowerCorner(sides[s + 1]));
      corners.join(upperCorner(sides[s]), upperCorner(sides[s + 1]));
    }
    begin = end;
  }
  return doubled;
}

// Adds the vertices; returns the vertex of each corner.
std::vector<int> addVertices(const std::vector<Face>& faces, Corners& corners,
                             geometry::TriangleMesh& mesh) {
  std::vector<int> vertexOf(4 * faces.size(), -1);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::array<Cell, 4> at = cornersOf(faces[f]);
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t corner = 4 * f + c;
      const auto root = static_cast<std::size_t>(corners.find(static_cast<int>(corner)));
      if (vertexOf[root] < 0) {
        vertexOf[root] = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(at[c].cast<double>());
      }
      vertexOf[corner] = vertexOf[root];
    }
  }
  return vertexOf;
}

// Adds a vertex in the middle of each doubled edge that shares both ends with another sheet's edge;
// returns the vertex of each side, -1: none.
std::vector<int> addMiddles(const std::vector<Side>& sides, const std::vector<std::size_t>& doubled,
                            const std::vector<int>& vertexOf, geometry::TriangleMesh& mesh) {
  std::vector<int> middleOf(vertexOf.size(), -1);
  for (const std::size_t first : doubled) {
    const Side *s = &sides[first], *other = &sides[first + 2];
    const auto vertex = [&](int corner) { return vertexOf[static_cast<std::size_t>(corner)]; };
    if (vertex(lowerCorner(*s)) != vertex(lowerCorner(*other)) ||
        vertex(upperCorner(*s)) != vertex(upperCorner(*other)))
      continue;
    for (std::size_t pair = 0; pair < 4; pair += 2) {
      const Eigen::Vector3d middle =
          0.5 * (mesh.vertices[static_cast<std::size_t>(vertex(lowerCorner(*s)))] +
                 mesh.vertices[static_cast<std::size_t>(vertex(upperCorner(*s)))]);
      for (std::size_t i = pair; i < pair + 2; ++i)
        middleOf[static_cast<std::size_t>(4 * s[i].face + s[i].side)] =
            static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(middle);
    }
  }
  return middleOf;
}

// Adds two triangles, or a fan about its centre if a side has a middle vertex. Four entries each.
void addFace(const int* v, const int* middle, geometry::TriangleMesh& mesh) {
  if (std::all_of(middle, middle + 4, [](int m) { return m < 0; })) {
    mesh.triangles.push_back({v[0], v[1], v[2]});
    mesh.triangles.push_back({v[0], v[2], v[3]});
    return;
  }
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::vector<int> around;
  for (std::size_t c = 0; c < 4; ++c) {
    centre += 0.25 * mesh.vertices[static_cast<std::size_t>(v[c])];
    around.push_back(v[c]);
    if (middle[c] >= 0)
      around.push_back(middle[c]);
  }
  const int hub = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(centre);
  for (std::size_t c = 0; c < around.size(); ++c)
    mesh.triangles.push_back({hub, around[c], around[(c + 1) % around.size()]});
}

} // namespace

geometry::TriangleMesh surfaceOf(const VoxelObject& object) {
  base::require(object.solid.size() == VoxelGrid{.size = object.size}.cellCount(),
                "surfaceOf: one entry a cell");
  const std::vector<Face> faces = boundaryFaces(object);
  base::require(faces.size() < (1u << 28), "surfaceOf: fewer than 2^28 faces");
  std::vector<Side> sides = sidesOf(faces);
  Corners corners(4 * faces.size());
  const std::vector<std::size_t> doubled = joinCorners(faces, sides, corners);
  geometry::TriangleMesh mesh;
  const std::vector<int> vertexOf = addVertices(faces, corners, mesh);
  const std::vector<int> middleOf = addMiddles(sides, doubled, vertexOf, mesh);
  for (std::size_t f = 0; f < faces.size(); ++f)
    addFace(&vertexOf[4 * f], &middleOf[4 * f], mesh);
  return mesh;
}

} // namespace voluta::voxel
