#include "layers/stack_query.h"

#include "base/index.h"
#include "base/parallel.h"
#include "geometry/measures.h"

#include <algorithm>

namespace voluta::layers {

namespace {

using base::at;

} // namespace

StackQuery::StackQuery(const std::vector<Patch>& patches,
                       const std::vector<Eigen::AlignedBox3d>& around, double reachMm,
                       const base::RunContext& ctx)
    : boxes_(patches.size()), queries_(patches.size()) {
  base::parallelChunks(ctx, patches.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      boxes_[p] = geometry::bounds(patches[p].surface);
      Eigen::AlignedBox3d wide = boxes_[p];
      wide.min().array() -= reachMm;
      wide.max().array() += reachMm;
      if (std::any_of(around.begin(), around.end(),
                      [&](const Eigen::AlignedBox3d& box) { return wide.intersects(box); }))
        queries_[p] = std::make_unique<const geometry::MeshQuery>(patches[p].surface,
                                                                  geometry::MeshQuery::Of::Surface);
    }
  });
}

std::vector<int> StackQuery::near(const Eigen::AlignedBox3d& box, int first, int end) const {
  std::vector<int> found;
  for (int p = first; p < end; ++p)
    if (queries_[at(p)] != nullptr && boxes_[at(p)].intersects(box))
      found.push_back(p);
  return found;
}

StackQuery::Place StackQuery::closest(const std::vector<int>& patches, const Eigen::Vector3d& p,
                                      double reachMm) const {
  Place best;
  best.distance = reachMm;
  for (const int patch : patches) {
    if (boxes_[at(patch)].squaredExteriorDistance(p) > best.distance * best.distance)
      continue;
    const geometry::MeshQuery::Closest found = query(patch).closest(p, best.distance);
    if (found.triangle >= 0 && (best.patch < 0 || found.distance < best.distance))
      best = {patch, found.triangle, found.point, found.distance};
  }
  return best;
}

void StackQuery::hits(const std::vector<int>& patches, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b, std::vector<Place>& out) const {
  thread_local std::vector<geometry::MeshQuery::Hit> found;
  out.clear();
  Eigen::AlignedBox3d box(a);
  box.extend(b);
  const double length = (b - a).norm();
  for (const int patch : patches) {
    if (!boxes_[at(patch)].intersects(box))
      continue;
    query(patch).hits(a, b, found);
    for (const auto& hit : found)
      out.push_back({patch, hit.triangle, a + hit.t * (b - a), hit.t * length});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Place& x, const Place& y) { return x.distance < y.distance; });
}

} // namespace voluta::layers
