#include "pipeline/printed_mesh.h"

#include "build3mf/bead_cells.h"
#include "geometry/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::pipeline {

using Eigen::Vector3d;

namespace {

// Soft limit for the faces of the mesh file.
constexpr double kMaxFaces = 4e5;

double pitchFor(const plan::ToolPlan& plan, const process::Process& process) {
  Eigen::AlignedBox3d box;
  for (const plan::ToolPath& path : plan.paths)
    if (!plan::isWaste(path.kind))
      for (std::size_t i = path.first; i < path.first + path.count; ++i)
        box.extend(plan.position[i]);
  const Vector3d size = box.isEmpty() ? Vector3d::Zero().eval() : box.sizes();
  const double area =
      // surface of its bounding box
      2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  return std::max(0.5 * process.layerHeightMm, std::sqrt(area / kMaxFaces));
}

// Fills voids between beads, i.e. shells that face inwards with a volume up to `maxMm3`. Larger
// ones are cavities of the part.
geometry::TriangleMesh withoutPores(const geometry::TriangleMesh& mesh, double maxMm3) {
  const geometry::Components shells = geometry::components(mesh);
  std::vector<double> volume(static_cast<std::size_t>(shells.count), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) -> const Vector3d& {
      return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
    };
    volume[static_cast<std::size_t>(shells.ofTriangle[t])] +=
        corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  std::vector<bool> keep(mesh.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    const double enclosed = volume[static_cast<std::size_t>(shells.ofTriangle[t])];
    keep[t] = enclosed > 0.0 || -enclosed > maxMm3;
  }
  return geometry::subMesh(mesh, keep);
}

// Moves every vertex by `share` of the distance to the mean of its neighbours.
void relax(geometry::TriangleMesh& mesh, double share) {
  std::vector<Vector3d> sum(mesh.vertices.size(), Vector3d::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)]);
      sum[from] +=
          mesh.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>((k + 1) % 3)])];
      ++count[from];
    }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (count[v] > 0)
      mesh.vertices[v] += share * (sum[v] / count[v] - mesh.vertices[v]);
}

} // namespace

geometry::TriangleMesh printedSolid(const plan::ToolPlan& plan, const process::Process& process,
                                    const base::RunContext& ctx) {
  const double bead = process.beadWidthMm * process.beadWidthMm * process.layerHeightMm;
  constexpr double kPoreBeads = 8.0; // two bead widths in both directions, two layers high
  geometry::TriangleMesh solid =
      withoutPores(build3mf::solidOfBeads(plan, pitchFor(plan, process), ctx), kPoreBeads * bead);
  // Taubin (1995): the second step undoes the shrinkage of the first.
  constexpr double kSmooth = 0.5, kSwell = -0.53;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    ctx.checkpoint();
    relax(solid, kSmooth);
    relax(solid, kSwell);
  }
  return solid;
}

} // namespace voluta::pipeline
