#include "replay/item_finder.h"

#include <algorithm>
#include <limits>

namespace voluta::replay {

ItemFinder::ItemFinder(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
                       std::span<const std::size_t> firstTriangle, double marginMm)
    : query_(&query), firstTriangle_(firstTriangle),
      boxes_(std::max<std::size_t>(firstTriangle.size(), 1)) {
  if (boxes_.size() == 1)
    return;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const std::size_t end =
        i + 1 < firstTriangle.size() ? firstTriangle[i + 1] : part.triangles.size();
    for (std::size_t t = firstTriangle[i]; t < end; ++t)
      for (int c = 0; c < 3; ++c)
        boxes_[i].extend(part.corner(t, c));
    boxes_[i].min().array() -= marginMm;
    boxes_[i].max().array() += marginMm;
  }
}

std::size_t ItemFinder::amongSeveral(const Eigen::Vector3d& place) const {
  std::size_t inside = 0, found = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    if (boxes_[i].contains(place)) {
      ++inside;
      found = i;
    }
  if (inside == 1)
    return found;
  const int triangle = query_->closest(place, std::numeric_limits<double>::infinity()).triangle;
  const auto after = std::upper_bound(firstTriangle_.begin(), firstTriangle_.end(),
                                      static_cast<std::size_t>(std::max(triangle, 0)));
  return static_cast<std::size_t>(after - firstTriangle_.begin()) - 1;
}

} // namespace voluta::replay
