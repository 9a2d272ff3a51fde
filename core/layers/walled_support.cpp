#include "layers/walled_support.h"

#include "base/index.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace voluta::layers {

namespace {
using Eigen::Vector3d;

// Returns the volume of a patch's triangles within a hollow [mm3].
double volumeWithin(const Patch& patch, const geometry::MeshQuery& hollow) {
  double sum = 0.0;
  for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
    Vector3d middle = Vector3d::Zero();
    double thickness = 0.0;
    for (int k = 0; k < 3; ++k) {
      middle += patch.surface.corner(t, k) / 3.0;
      const auto v =
          static_cast<std::size_t>(patch.surface.triangles[t][static_cast<std::size_t>(k)]);
      thickness += patch.thicknessMm[v] / 3.0;
    }
    if (hollow.inside(middle))
      sum += thickness * geometry::triangleArea(patch.surface, t);
  }
  return sum;
}

// Returns the surfaces of the closed hollows, facing outward.
std::vector<geometry::TriangleMesh> hollowsOf(const geometry::TriangleMesh& part) {
  std::vector<geometry::TriangleMesh> hollows;
  const geometry::Components shells = geometry::components(part);
  for (int shell = 0; shell < shells.count; ++shell) {
    std::vector<bool> keep(part.triangles.size());
    for (std::size_t t = 0; t < keep.size(); ++t)
      keep[t] = shells.ofTriangle[t] == shell;
    geometry::TriangleMesh hollow = geometry::subMesh(part, keep);
    if (geometry::volume(hollow) >= 0.0)
      continue;
    for (auto& triangle : hollow.triangles)
      std::swap(triangle[1], triangle[2]);
    hollows.push_back(std::move(hollow));
  }
  return hollows;
}

// Returns the finding about the support of a plan; nullopt if none of it is in a hollow. `within`:
// returns the volume in a hollow.
template <typename Within>
std::optional<plan::Finding> findingOf(const geometry::TriangleMesh& part, const Within& within) {
  double whole = 0.0, maximum = 0.0;
  Vector3d at = Vector3d::Zero();
  for (const geometry::TriangleMesh& hollow : hollowsOf(part)) {
    const double volume = within(geometry::MeshQuery(hollow));
    whole += volume;
    if (volume > maximum) {
      maximum = volume;
      at = geometry::bounds(hollow).center();
    }
  }
  if (whole <= 0.0)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::WalledSupport, {{"volume", base::mm3(whole)}}, at);
}

} // namespace

std::optional<plan::Finding> walledSupport(const LayerStack& stack,
                                           const geometry::TriangleMesh& part) {
  if (std::ranges::none_of(stack.patches, [](const Patch& p) { return p.group == kSupportGroup; }))
    return std::nullopt;
  return findingOf(part, [&](const geometry::MeshQuery& hollow) {
    double volume = 0.0;
    for (const Patch& patch : stack.patches)
      if (patch.group == kSupportGroup)
        volume += volumeWithin(patch, hollow);
    return volume;
  });
}

std::optional<plan::Finding> walledSupport(const plan::ToolPlan& plan, const LayerStack& stack,
                                           const geometry::TriangleMesh& part) {
  const auto isUnderRim = [&](const plan::ToolPath& path) {
    return path.kind == plan::PathKind::Support && path.patch >= 0 &&
           stack.patches[base::at(path.patch)].group != kSupportGroup;
  };
  if (std::ranges::none_of(plan.paths, isUnderRim))
    return std::nullopt;
  return findingOf(part, [&](const geometry::MeshQuery& hollow) {
    double volume = 0.0;
    for (const plan::ToolPath& path : plan.paths)
      for (std::size_t i = path.first; isUnderRim(path) && i + 1 < path.first + path.count; ++i)
        if (hollow.inside(0.5 * (plan.position[i] + plan.position[i + 1])))
          volume += static_cast<double>(plan.widthMm[i] * plan.heightMm[i]) *
                    (plan.position[i + 1] - plan.position[i]).norm();
    return volume;
  });
}

} // namespace voluta::layers
