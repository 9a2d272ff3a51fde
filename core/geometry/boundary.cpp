#include "geometry/boundary.h"

#include "geometry/edges.h"

#include <algorithm>
#include <map>

namespace voluta::geometry {

std::vector<std::vector<int>> boundaryLoops(const TriangleMesh& mesh) {
  std::multimap<int, int> next;
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    const HalfEdge& e = edges[begin];
    if (end - begin == 1 && e.low != e.high)
      next.emplace(e.forward ? e.high : e.low, e.forward ? e.low : e.high);
  });
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int> path{next.begin()->first};
    while (true) {
      const auto step = next.find(path.back());
      if (step == next.end())
        break;
      const int to = step->second;
      next.erase(step);
      const auto seen = std::find(path.begin(), path.end(), to);
      if (seen == path.end()) {
        path.push_back(to);
        continue;
      }
      std::vector<int> loop(seen, path.end());
      path.erase(seen + 1, path.end());
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
      if (loop.size() > 2)
        loops.push_back(std::move(loop));
    }
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

} // namespace voluta::geometry
