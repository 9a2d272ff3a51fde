// Painting of a part's surface: by a brush, or face by face. A painted surface is an open mesh of
// separate triangles.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

namespace voluta::regions {

// A sphere, in the coordinates of the mesh.
struct Brush {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 1.0; // > 0
};

// A rectangle of the screen: what is seen between four rays from the eye, in their order around it.
struct SeenThrough {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  std::array<Eigen::Vector3d, 4> corners = {}; // directions
};

// The surface of a part that does not change. Every query is const and safe from many threads.
class PaintableSurface {
public:
  explicit PaintableSurface(std::shared_ptr<const geometry::TriangleMesh> part);

  // Returns the surface within the brush, as far as it is connected with the point nearest to its
  // middle. Triangles at its edge are divided, down to a quarter of its radius.
  geometry::TriangleMesh within(const Brush& brush) const;
  // Returns the surface that is seen from the eye, in front of all else. Triangles at an edge that
  // hides others are divided down to `finest`.
  geometry::TriangleMesh seen(const SeenThrough& through, double finest) const;
  // Returns the triangles that continue from the one nearest to a place, without an edge at which
  // the surface turns by more than an angle [rad].
  geometry::TriangleMesh facesFrom(const Eigen::Vector3d& place, double angleRad) const;

private:
  template <typename Enters> std::vector<int> connected(int first, const Enters& enters) const;

  std::shared_ptr<const geometry::TriangleMesh> part_;
  geometry::MeshQuery query_;
  std::vector<std::array<int, 3>> neighbours_; // across each side; -1: none, or several
};

// Return the painted surface with more, which lies on the same part, or without it.
geometry::TriangleMesh withPaint(const geometry::TriangleMesh& painted,
                                 const geometry::TriangleMesh& more);
geometry::TriangleMesh withoutPaint(const geometry::TriangleMesh& painted,
                                    const geometry::TriangleMesh& less);
// As those; triangles that are covered in part are divided, with sides down to `finest`.
geometry::TriangleMesh withPaint(const geometry::TriangleMesh& painted,
                                 const geometry::TriangleMesh& more, double finest);
geometry::TriangleMesh withoutPaint(const geometry::TriangleMesh& painted,
                                    const geometry::TriangleMesh& less, double finest);
// Returns the length of the sides of triangles at a brush's edge.
double finestOf(const Brush& brush);
// Returns the painted surface outside a brush.
geometry::TriangleMesh withoutPaint(const geometry::TriangleMesh& painted, const Brush& brush);

} // namespace voluta::regions
