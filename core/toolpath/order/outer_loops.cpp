#include "toolpath/order/outer_loops.h"

#include "geometry/edges.h"
#include "geometry/nearest_share.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// Contours touch up to this distance [mm]; loops do up to this many bead widths, more than twice
// half of one because corners are round.
constexpr double kContactMm = 0.05, kContactWidths = 2.2;

double distanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  return (a + geometry::nearestShare(p, a, b) * (b - a) - p).norm();
}

double distanceToRim(const Vector3d& p, const layers::Patch& patch) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto sides = geometry::sortedHalfEdges(patch.surface);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    const auto& at = patch.surface.vertices;
    if (end == begin + 1)
      nearest =
          std::min(nearest, distanceToSegment(p, at[static_cast<std::size_t>(sides[begin].low)],
                                              at[static_cast<std::size_t>(sides[begin].high)]));
  });
  return nearest;
}

// The nearest places of two loops: on segments of each.
struct Contact {
  std::size_t one = 0, other = 0;          // segments
  double oneShare = 0.0, otherShare = 0.0; // along them
  double distanceMm = std::numeric_limits<double>::infinity();
};

// Sets `best` if a vertex of `a` is nearer to `b`.
void findContact(const Bead& a, const Bead& b, bool swapped, Contact& best) {
  for (std::size_t i = 0; i + 1 < a.points.size(); ++i)
    for (std::size_t j = 0; j + 1 < b.points.size(); ++j) {
      const Vector3d &p = a.points[i].middle, &q = b.points[j].middle,
                     &next = b.points[j + 1].middle;
      const double share = geometry::nearestShare(p, q, next);
      const double d = (q + share * (next - q) - p).norm();
      if (d < best.distanceMm)
        best = swapped ? Contact{j, i, share, 0.0, d} : Contact{i, j, 0.0, share, d};
    }
}

BeadPoint mixed(const BeadPoint& a, const BeadPoint& b, double share) {
  const auto mean = [&](const auto& x, const auto& y) { return (1.0 - share) * x + share * y; };
  return {mean(a.middle, b.middle), Vector3d(mean(a.direction, b.direction)).normalized(),
          Vector3d(mean(a.clearDirection, b.clearDirection)).normalized(),
          mean(a.widthMm, b.widthMm), mean(a.heightMm, b.heightMm)};
}

// Returns the loop without `openMm` around a place, from one end of the opening to the other; empty
// if it is too short.
std::vector<BeadPoint> openedAtPlace(const Bead& loop, std::size_t segment, double share,
                                     double openMm) {
  const std::size_t n = loop.points.size() - 1;
  std::vector<BeadPoint> turn{mixed(loop.points[segment], loop.points[segment + 1], share)};
  for (std::size_t k = 1; k <= n; ++k)
    turn.push_back(loop.points[(segment + k) % n]);
  turn.push_back(turn.front());
  double length = 0.0;
  for (std::size_t i = 1; i < turn.size(); ++i)
    length += (turn[i].middle - turn[i - 1].middle).norm();
  if (length < 4.0 * openMm)
    return {};
  for (int end = 0; end < 2; ++end) {
    double left = 0.5 * openMm;
    while (turn.size() > 2) {
      const double step = (turn[turn.size() - 2].middle - turn.back().middle).norm();
      if (step > left) {
        turn.back() = mixed(turn.back(), turn[turn.size() - 2], left / step);
        break;
      }
      left -= step;
      turn.pop_back();
    }
    std::ranges::reverse(turn);
  }
  return turn;
}

std::optional<Bead> joinedLoop(const Bead& one, const Bead& other, const Contact& contact) {
  const double width =
      0.5 * (one.points[contact.one].widthMm + other.points[contact.other].widthMm);
  std::vector<BeadPoint> joined = openedAtPlace(one, contact.one, contact.oneShare, width),
                         more = openedAtPlace(other, contact.other, contact.otherShare, width);
  if (joined.empty() || more.empty())
    return std::nullopt;
  const auto apart = [](const BeadPoint& a, const BeadPoint& b) {
    return (a.middle - b.middle).norm();
  };
  if (apart(joined.back(), more.back()) + apart(joined.front(), more.front()) <
      apart(joined.back(), more.front()) + apart(joined.front(), more.back()))
    std::ranges::reverse(more);
  joined.insert(joined.end(), more.begin(), more.end());
  joined.push_back(joined.front());
  Bead bead = one;
  bead.points = std::move(joined);
  return bead;
}

bool touch(const OuterLoop& a, const OuterLoop& b, const Contact& contact,
           std::span<const layers::Patch> patches) {
  const BeadPoint &p = a.bead.points[contact.one], &q = a.bead.points[contact.one + 1];
  const BeadPoint on = mixed(p, q, contact.oneShare),
                  off = mixed(b.bead.points[contact.other], b.bead.points[contact.other + 1],
                              contact.otherShare);
  if (contact.distanceMm > kContactWidths * 0.5 * (on.widthMm + off.widthMm))
    return false;
  const Vector3d middle = 0.5 * (on.middle + off.middle);
  return distanceToRim(middle, patches[a.patch]) < kContactMm &&
         distanceToRim(middle, patches[b.patch]) < kContactMm;
}
} // namespace

std::vector<OuterLoop> joinedWhereTouching(std::vector<OuterLoop> loops,
                                           std::span<const layers::Patch> patches) {
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = i + 1; j < loops.size();) {
      Contact contact;
      findContact(loops[i].bead, loops[j].bead, false, contact);
      findContact(loops[j].bead, loops[i].bead, true, contact);
      std::optional<Bead> joined;
      if (touch(loops[i], loops[j], contact, patches))
        joined = joinedLoop(loops[i].bead, loops[j].bead, contact);
      if (!joined) {
        ++j;
        continue;
      }
      loops[i].bead = std::move(*joined);
      loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1; // the joined loop may touch one that the first loop did not
    }
  return loops;
}

std::size_t largestLoop(std::span<const OuterLoop> loops) {
  const auto areaOf = [](const OuterLoop& loop) {
    Vector3d sum = Vector3d::Zero();
    const Vector3d& from = loop.bead.points.front().middle;
    for (std::size_t i = 1; i < loop.bead.points.size(); ++i)
      sum += (loop.bead.points[i - 1].middle - from).cross(loop.bead.points[i].middle - from);
    return sum.norm();
  };
  std::size_t largest = 0;
  for (std::size_t i = 1; i < loops.size(); ++i)
    if (areaOf(loops[i]) > areaOf(loops[largest]))
      largest = i;
  return largest;
}

} // namespace voluta::toolpath
