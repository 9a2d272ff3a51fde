#include "planar/slicing/corrected_mesh.h"

#include "geometry/measures.h"
#include "geometry/symmetric_axes.h"
#include "geometry/triangle_queries.h"
#include "planar/slicing/section_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace voluta::planar {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

// Which contours of a solid's horizontal sections are holes.
class Contours {
public:
  explicit Contours(const geometry::TriangleMesh& mesh) : sections_(mesh, Vector3d::UnitZ()) {}

  // Returns whether the contour nearest to a point of the surface is that of a hole.
  bool isHole(const Vector3d& p) {
    constexpr double kStepMm = 0.05; // heights this near share a section
    const auto level = static_cast<long>(std::floor(p.z() / kStepMm));
    auto found = loops_.find(level);
    if (found == loops_.end())
      found = loops_.emplace(level, loopsOf(sections_.at(p.z()), frame_)).first;
    const Vector3d at = kPathUnits * Vector3d(frame_.across.dot(p), frame_.along.dot(p), 0.0);
    double minimum = std::numeric_limits<double>::infinity();
    bool hole = false;
    for (const ClipperLib::Path& loop : found->second)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const ClipperLib::IntPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
        const double d = geometry::distanceToSegment(
            at, {static_cast<double>(a.X), static_cast<double>(a.Y), 0.0},
            {static_cast<double>(b.X), static_cast<double>(b.Y), 0.0});
        if (d < minimum) {
          minimum = d;
          hole = !ClipperLib::Orientation(loop);
        }
      }
    return hole;
  }

private:
  Sections sections_;
  PlaneFrame frame_ = frameOf(Vector3d::UnitZ());
  std::map<long, ClipperLib::Paths> loops_;
};

// Offsets of the walls that meet at a vertex.
struct Walls {
  Eigen::Matrix2d normals = Eigen::Matrix2d::Zero();
  Vector2d offsets = Vector2d::Zero();

  void add(const Vector2d& normal, double offsetMm, double weight) {
    normals += weight * normal * normal.transpose();
    offsets += weight * offsetMm * normal;
  }
  // Returns the displacement that moves each wall by its offset. Walls at less than about 16
  // degrees to each other count as one.
  Vector2d displacement() const {
    constexpr double kOneWall = 0.02;
    const auto [values, axes] = geometry::symmetricAxes(normals);
    Vector2d sum = Vector2d::Zero();
    for (int k = 0; k < 2; ++k)
      if (values[k] > kOneWall * values[1])
        sum += axes.col(k) * axes.col(k).dot(offsets) / values[k];
    return sum;
  }
};
} // namespace

geometry::TriangleMesh correctedMesh(const geometry::TriangleMesh& mesh,
                                     const SizeCorrection& correction) {
  constexpr double kHorizontal = 0.05; // horizontal part of the normal of a floor or ceiling
  geometry::TriangleMesh out = mesh;
  const Vector2d centre = geometry::bounds(mesh).center().head<2>();
  const Eigen::Array2d factor(correction.scaleX, correction.scaleY);
  std::vector<Walls> walls(mesh.vertices.size());
  Contours contours(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d normal = geometry::triangleNormal(mesh, t);
    const double level = normal.head<2>().norm();
    if (level < kHorizontal)
      continue;
    Vector3d middle = Vector3d::Zero();
    for (const int v : mesh.triangles[t])
      middle += mesh.vertices[static_cast<std::size_t>(v)] / 3.0;
    // A hole's wall faces its axis: into the material is against its normal.
    const double offset = contours.isHole(middle) ? -correction.holeMm : correction.outlineMm;
    for (const int v : mesh.triangles[t])
      walls[static_cast<std::size_t>(v)].add(normal.head<2>() / level, offset,
                                             geometry::triangleArea(mesh, t));
  }
  for (std::size_t v = 0; v < out.vertices.size(); ++v) {
    const Vector2d from = mesh.vertices[v].head<2>() - centre;
    out.vertices[v].head<2>() = centre + (factor * from.array()).matrix();
    if (walls[v].normals.trace() > 0.0)
      out.vertices[v].head<2>() += walls[v].displacement();
  }
  return out;
}

} // namespace voluta::planar
