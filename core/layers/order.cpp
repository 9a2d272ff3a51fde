#include "layers/order.h"

#include "geometry/measures.h"

#include <algorithm>

namespace voluta::layers {

namespace {

Eigen::Vector3d centroid(const geometry::TriangleMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double a = geometry::triangleArea(mesh, t);
    sum += a / 3.0 * (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
    area += a;
  }
  return area > 0.0 ? Eigen::Vector3d(sum / area) : Eigen::Vector3d::Zero();
}

} // namespace

void orderForPrinting(LayerStack& stack) {
  std::stable_sort(stack.patches.begin(), stack.patches.end(),
                   [](const Patch& a, const Patch& b) { return a.layer < b.layer; });
  std::vector<Eigen::Vector3d> centre;
  for (const Patch& p : stack.patches)
    centre.push_back(centroid(p.surface));
  Eigen::Vector3d here = Eigen::Vector3d::Zero();
  for (std::size_t next = 0; next < stack.patches.size(); ++next) {
    std::size_t best = next;
    for (std::size_t k = next + 1;
         k < stack.patches.size() && stack.patches[k].layer == stack.patches[next].layer; ++k)
      if ((centre[k] - here).squaredNorm() < (centre[best] - here).squaredNorm())
        best = k;
    const auto from = static_cast<std::ptrdiff_t>(next), to = static_cast<std::ptrdiff_t>(best);
    std::rotate(stack.patches.begin() + from, stack.patches.begin() + to,
                stack.patches.begin() + to + 1);
    std::rotate(centre.begin() + from, centre.begin() + to, centre.begin() + to + 1);
    here = centre[next];
  }
  numberLayers(stack);
}

void numberLayers(LayerStack& stack) {
  stack.layerCount = 0;
  int given = 0;
  for (Patch& p : stack.patches) {
    if (stack.layerCount == 0 || p.layer != given)
      ++stack.layerCount;
    given = p.layer;
    p.layer = stack.layerCount - 1;
  }
}

} // namespace voluta::layers
