#include "scene/coarse_beads.h"

#include <algorithm>
#include <cmath>

namespace voluta::scene {

namespace {

// Of each level: how far waypoints may be beside the line along the first segment, in widths of the
// bead. On an arc, a quarter of it is the distance of the arc from the segment drawn.
constexpr double kBesideInWidths[] = {0.3, 1.0, 2.5};
// The bead between the ends of a segment changes steadily: colours and shape follow.
constexpr float kMaxChange = 0.25F;
constexpr double kMinCosine = 0.97;

bool isSimilar(float a, float b) {
  return std::abs(a - b) <= kMaxChange * std::max(std::abs(a), std::abs(b));
}

// Returns the last waypoint of a segment that begins at `from`, at most `last`.
std::size_t reachFrom(const plan::ToolPlan& plan, std::size_t from, std::size_t last,
                      double besideInWidths) {
  const Eigen::Vector3d& start = plan.position[from];
  const double beside = besideInWidths * double(plan.widthMm[from]);
  Eigen::Vector3d along = (plan.position[from + 1] - start).normalized();
  std::size_t to = from + 1;
  while (to < last) {
    const std::size_t next = to + 1;
    const Eigen::Vector3d step = plan.position[next] - start;
    const bool fits = step.dot(along) > 0.0 && step.cross(along).norm() <= beside &&
                      plan.direction[next].dot(plan.direction[from]) >= kMinCosine &&
                      isSimilar(plan.widthMm[next], plan.widthMm[from]) &&
                      isSimilar(plan.heightMm[next], plan.heightMm[from]) &&
                      isSimilar(plan.speedMmPerS[next], plan.speedMmPerS[from + 1]);
    if (!fits)
      break;
    to = next;
  }
  return to;
}

} // namespace

void addCoarseBeads(const plan::ToolPlan& plan, const std::vector<std::size_t>& order,
                    const std::vector<BeadSight>& sight, PathsDrawing& drawing,
                    MeshBuffers& buffers) {
  for (std::size_t k = 0; k < kBeadLevels; ++k) {
    std::vector<std::size_t>& start = drawing.coarse[k];
    auto path = order.begin();
    for (int layer = 0; layer < layerCount(drawing); ++layer) {
      const auto end = std::find_if(path, order.end(),
                                    [&](std::size_t p) { return plan.paths[p].layer != layer; });
      for (const BeadSight of : {BeadSight::Open, BeadSight::Enclosed, BeadSight::Buried}) {
        start.push_back(drawing.arrival.size());
        for (auto p = path; p != end; ++p) {
          const std::size_t first = plan.paths[*p].first, last = first + plan.paths[*p].count - 1;
          for (std::size_t from = first; from < last;) {
            if (sight[from + 1] != of) {
              ++from;
              continue;
            }
            std::size_t same = from + 1;
            while (same < last && sight[same + 1] == of)
              ++same;
            while (from < same) {
              const std::size_t to = reachFrom(plan, from, same, kBesideInWidths[k]);
              addBeadSegment(buffers, from, to);
              drawing.arrival.push_back(static_cast<std::uint32_t>(to));
              from = to;
            }
          }
        }
      }
      path = end;
    }
    start.push_back(drawing.arrival.size());
  }
}

} // namespace voluta::scene
