#include "robot/cell/checked_pairs.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace voluta::robot {

// Frames: base, links, flange, work, tool, on what each external axis moves.
int RigidGroups::of(int frame) const {
  if (frame > armDof + 3)
    return frame - 3; // behind the last link
  if (axes > 0 && frame == armDof + 2)
    return armDof + axes;
  if (frame == armDof + 1 || frame == (plateMoves ? armDof + 2 : armDof + 3))
    return armDof; // on the last link
  if (frame > armDof)
    return 0; // fixed to the world
  return frame;
}

std::vector<std::pair<int, int>> checkedPairs(const std::vector<Body>& bodies,
                                              const RigidGroups& groups,
                                              const std::vector<std::pair<int, int>>& neverMeet) {
  const auto at = [&](int body) -> const Body& { return bodies[static_cast<std::size_t>(body)]; };
  const auto isLink = [&](int body) { return at(body).role == BodyRole::Link; };
  const int count = static_cast<int>(bodies.size());
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) {
      const int apart = std::abs(groups.of(at(a).frame) - groups.of(at(b).frame));
      const bool neighbours = apart == 1 && isLink(a) && isLink(b);
      if (apart == 0 || neighbours ||
          std::find(neverMeet.begin(), neverMeet.end(), std::pair(a, b)) != neverMeet.end())
        continue;
      pairs.emplace_back(a, b);
    }
  return pairs;
}

std::vector<int> bodiesMovingAgainst(int frame, const std::vector<Body>& bodies,
                                     const RigidGroups& groups) {
  std::vector<int> moving;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (groups.of(bodies[b].frame) != groups.of(frame))
      moving.push_back(static_cast<int>(b));
  return moving;
}

} // namespace voluta::robot
