#include "toolpath/order/island_order.h"

#include "toolpath/order/travel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kPlaneMm = 0.01;        // distance of the vertices of a plane from it
constexpr double kParallel = 1.0 - 1e-9; // cosine between the directions of a plane
constexpr std::size_t kOutline = 24;     // points that represent a patch

struct LayerPlane {
  Vector3d normal, through;
  bool contains(const layers::Patch& patch) const {
    return std::ranges::all_of(patch.direction,
                               [&](const Vector3d& d) { return normal.dot(d) >= kParallel; }) &&
           std::ranges::all_of(patch.surface.vertices, [&](const Vector3d& v) {
             return std::abs(normal.dot(v - through)) <= kPlaneMm;
           });
  }
};

bool areOfOneLayer(const layers::Patch& a, const layers::Patch& b) {
  return a.layer == b.layer && a.item == b.item && a.group == b.group && a.tool == b.tool;
}

Vector3d middleOf(const layers::Patch& patch) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : patch.surface.vertices)
    box.extend(v);
  return box.center();
}

// Returns the patches in the order of the visits to one closed stop for each of them.
std::vector<std::size_t> visited(const std::vector<Stop>& stops,
                                 std::span<const StopGroup> groups) {
  std::vector<std::size_t> order;
  for (const Visit& visit : visitShortly(stops, groups, Vector3d::Zero()))
    order.push_back(visit.stop);
  return order;
}
} // namespace

std::vector<IslandRun> islandRuns(const layers::LayerStack& stack) {
  std::vector<IslandRun> runs;
  const std::vector<layers::Patch>& patches = stack.patches;
  for (std::size_t first = 0; first < patches.size();) {
    std::size_t end = first + 1;
    const layers::Patch& begin = patches[first];
    if (end < patches.size() && areOfOneLayer(begin, patches[end]) && !begin.surface.empty()) {
      const LayerPlane plane{begin.direction.front(), begin.surface.vertices.front()};
      if (plane.contains(begin))
        while (end < patches.size() && areOfOneLayer(begin, patches[end]) &&
               plane.contains(patches[end]))
          ++end;
    }
    runs.push_back({first, end});
    first = end;
  }
  return runs;
}

std::vector<std::vector<std::size_t>> islandOrders(const layers::LayerStack& stack) {
  const std::vector<IslandRun> runs = islandRuns(stack);
  if (std::ranges::all_of(runs, [](const IslandRun& run) { return run.end - run.first == 1; }))
    return {};
  std::vector<StopGroup> groups;
  std::vector<Stop> middles, outlines;
  for (const IslandRun& run : runs) {
    StopGroup& stopGroup = groups.emplace_back();
    for (std::size_t p = run.first; p < run.end; ++p) {
      stopGroup.push_back(p);
      const std::vector<Vector3d>& vertices = stack.patches[p].surface.vertices;
      middles.push_back({{Vector3d::Zero()}, true});
      outlines.push_back(middles.back());
      if (vertices.empty())
        continue;
      middles.back().ends.front() = middleOf(stack.patches[p]);
      outlines.back().ends.clear();
      const std::size_t stride = std::max<std::size_t>(1, vertices.size() / kOutline);
      for (std::size_t v = 0; v < vertices.size(); v += stride)
        outlines.back().ends.push_back(vertices[v]);
    }
  }
  return {visited(middles, groups), visited(outlines, groups)};
}

std::vector<std::size_t> orderAsBelow(const layers::LayerStack& stack) {
  std::vector<std::size_t> order;
  std::vector<Vector3d> below; // the middles of the islands of the run before, in their order
  for (const IslandRun& run : islandRuns(stack)) {
    std::vector<std::pair<std::size_t, std::size_t>> islands; // by the index of the one below
    for (std::size_t p = run.first; p < run.end; ++p) {
      const Vector3d middle = middleOf(stack.patches[p]);
      const auto nearest = std::ranges::min_element(
          below, {}, [&](const Vector3d& m) { return (m - middle).norm(); });
      islands.emplace_back(static_cast<std::size_t>(nearest - below.begin()), p);
    }
    std::ranges::sort(islands);
    below.clear();
    for (const auto& [index, patch] : islands) {
      order.push_back(patch);
      below.push_back(middleOf(stack.patches[patch]));
    }
  }
  return order;
}

} // namespace voluta::toolpath
