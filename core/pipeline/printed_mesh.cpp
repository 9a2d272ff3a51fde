#include "pipeline/printed_mesh.h"

#include "build3mf/bead_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::pipeline {

using Eigen::Vector3d;

namespace {

// Surface faces that a mesh file should not have many more of.
constexpr double kMostFaces = 4e5;

double pitchFor(const plan::ToolPlan& plan, const process::Process& process) {
  Eigen::AlignedBox3d box;
  for (const plan::ToolPath& path : plan.paths)
    if (!plan::isWaste(path.kind))
      for (std::size_t i = path.first; i < path.first + path.count; ++i)
        box.extend(plan.position[i]);
  const Vector3d size = box.isEmpty() ? Vector3d::Zero().eval() : box.sizes();
  const double area =
      2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()); // of its box
  return std::max(0.5 * process.layerHeightMm, std::sqrt(area / kMostFaces));
}

// Every vertex moves by `share` of the way to the mean of its neighbours.
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
  geometry::TriangleMesh solid = build3mf::solidOfBeads(plan, pitchFor(plan, process), ctx);
  // Taubin (1995): what the first step shrinks, the second swells again.
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
