#include "curved/layer_order.h"

#include "geometry/symmetric_axes.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <queue>
#include <unordered_map>
#include <utility>

namespace voluta::curved {

namespace {

using Voxel = std::vector<std::int32_t>::iterator;

Eigen::Vector3d cellOf(const VoxelGraph& graph, std::int32_t v) {
  const auto& c = graph.cell[static_cast<std::size_t>(v)];
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

// Partitions [first, last) into halves and returns the start of the second one, which is strictly
// between the two for 2 voxels or more.
Voxel halve(const VoxelGraph& graph, Voxel first, Voxel last) {
  const auto n = static_cast<double>(last - first);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Voxel v = first; v != last; ++v)
    mean += cellOf(graph, *v) / n;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (Voxel v = first; v != last; ++v) {
    const Eigen::Vector3d d = cellOf(graph, *v) - mean;
    spread += d * d.transpose();
  }
  Eigen::Vector3d axis = geometry::symmetricAxesFast(spread).axes.col(2);
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0.0)
    axis = -axis;
  const Voxel middle = std::stable_partition(
      first, last, [&](std::int32_t v) { return axis.dot(cellOf(graph, v) - mean) < 0.0; });
  return middle == first || middle == last ? first + (last - first) / 2 : middle;
}

void halveDown(const VoxelGraph& graph, Voxel first, Voxel last) {
  while (last - first > 1) {
    const Voxel middle = halve(graph, first, last);
    halveDown(graph, first, middle);
    first = middle;
  }
}

} // namespace

std::vector<std::int32_t> floodingOrder(const VoxelGraph& graph,
                                        const std::vector<std::int32_t>& layer) {
  // Ties are resolved in favour of the earlier voxel of the layer.
  using Entry = std::pair<float, std::size_t>;
  std::unordered_map<std::int32_t, std::size_t> place;
  for (std::size_t i = 0; i < layer.size(); ++i)
    place[layer[i]] = i;
  std::vector<std::uint8_t> done(layer.size(), 0);
  std::vector<std::int32_t> order;
  order.reserve(layer.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t source = 0; source < layer.size(); ++source) {
    if (done[source])
      continue;
    open.push({0.0f, source});
    while (!open.empty()) {
      const auto [distance, i] = open.top();
      open.pop();
      if (done[i])
        continue;
      done[i] = 1;
      order.push_back(layer[i]);
      const auto& neighbours = graph.neighbour[static_cast<std::size_t>(layer[i])];
      for (std::size_t s = 0; s < kNeighbours; ++s) {
        const auto at = neighbours[s] < 0 ? place.end() : place.find(neighbours[s]);
        if (at != place.end() && !done[at->second])
          open.push({distance + kNeighbourDistance[s], at->second});
      }
    }
  }
  return order;
}

std::vector<std::int32_t> halvingOrder(const VoxelGraph& graph,
                                       const std::vector<std::int32_t>& layer) {
  std::vector<std::int32_t> order = layer;
  halveDown(graph, order.begin(), order.end());
  return order;
}

} // namespace voluta::curved
