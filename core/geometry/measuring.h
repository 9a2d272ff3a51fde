// Measures of a part at points that are clicked on it: the corner, edge or face there, its radius,
// the wall behind it, and distance and angle between two of them.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/round_fit.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace voluta::geometry {

struct MeasuredPoint {
  enum class On { Corner, Edge, Face } on = On::Face;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // unit: along the edge; out of the face
  std::optional<RoundShape> round;                     // of the edge or the face
  std::optional<double> wallMm; // of a face: material straight behind it; none: an open mesh
};

struct MeasuredPair {
  double distanceMm = 0.0;
  Eigen::Vector3d alongAxesMm = Eigen::Vector3d::Zero(); // from the first to the second
  // Between two faces inside or outside the material, [0, pi): 0 if they are parallel; between two
  // edges, or an edge and a face, [0, pi/2]. None for corners.
  std::optional<double> angleRad;
  std::optional<double> planesMm; // distance of two parallel faces
};

MeasuredPair measuredPair(const MeasuredPoint& from, const MeasuredPoint& to);

// The mesh prepared for points. Safe from several threads at once.
class Measuring {
public:
  explicit Measuring(TriangleMesh mesh);

  // Returns the measures at the surface's nearest place to `point`. A corner, or else an edge,
  // within `snapMm` of it replaces the place. Edges are where facets meet at more than 20 degrees;
  // corners are where edges end or bend by more. A face or an edge is round if at least three
  // facets or sides in succession lie on one cylinder, sphere or circle. Precondition: the mesh is
  // not empty.
  MeasuredPoint at(const Eigen::Vector3d& point, double snapMm) const;

private:
  struct Edge {
    int from = 0, to = 0;
  };

  const Eigen::Vector3d& vertex(int index) const;
  void findEdges();
  void findCorners();
  std::optional<MeasuredPoint> snapped(const Eigen::Vector3d& point, double snapMm) const;
  std::optional<double> wallMm(const Eigen::Vector3d& point, int triangle) const;
  std::optional<RoundShape> roundEdge(int edge) const;
  std::vector<Eigen::Vector3d> chainOf(int edge, int fromVertex, int via) const;
  std::optional<RoundShape> roundFace(int triangle) const;
  std::vector<int> flatAround(int triangle) const;
  template <class Fits> std::vector<int> grown(int triangle, const Fits& fits) const;
  bool isCurvedStep(int from, int to) const;

  TriangleMesh mesh_;
  MeshQuery query_;
  double diagonalMm_ = 0.0;
  std::vector<Eigen::Vector3d> normals_;       // unit, of each triangle; zero: degenerate
  std::vector<std::array<int, 3>> neighbours_; // across each side; -1: none or several
  std::vector<Edge> edges_;                    // where facets meet at an angle, or end
  std::vector<std::vector<int>> edgesAt_;      // of each vertex
  std::vector<int> corners_;                   // vertices
};

} // namespace voluta::geometry
