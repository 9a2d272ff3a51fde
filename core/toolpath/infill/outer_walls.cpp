#include "toolpath/infill/outer_walls.h"

#include "base/error.h"
#include "base/index.h"
#include "geometry/nearest_share.h"
#include "process/bead_model.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {

using base::at;

constexpr double kSlope = 0.25; // Maximum change of width per length of rim
// [beads]: distance along the rim within which the measured room applies
constexpr double kRoomBeads = 1.5;

// A closed rim; the first vertex is not repeated at the end.
struct Loop {
  std::vector<int> vertices;
  std::vector<double> stepMm; // Distance to the next vertex
};

std::vector<Loop> loopsOf(const PatchSurface& s) {
  std::vector<int> next(s.position.size(), -1);
  for (const auto& e : s.boundary)
    next[at(e[0])] = e[1];
  std::vector<char> done(s.position.size(), 0);
  std::vector<Loop> loops;
  for (const auto& e : s.boundary) {
    Loop loop;
    for (int v = e[0]; v >= 0 && !done[at(v)]; v = next[at(v)]) {
      done[at(v)] = 1;
      loop.vertices.push_back(v);
    }
    const std::size_t n = loop.vertices.size();
    for (std::size_t i = 0; i < n; ++i)
      loop.stepMm.push_back(
          (s.position[at(loop.vertices[(i + 1) % n])] - s.position[at(loop.vertices[i])]).norm());
    if (n > 2)
      loops.push_back(std::move(loop));
  }
  return loops;
}

// Visits the loop's edges in both directions, twice around each: f(i, j, edge length [mm]), where j
// follows i in that direction.
template <typename F> void sweep(const Loop& loop, F&& f) {
  const std::size_t n = loop.vertices.size();
  for (std::size_t k = 0; k < 2 * n; ++k)
    f(k % n, (k + 1) % n, loop.stepMm[k % n]);
  for (std::size_t k = 2 * n; k-- > 0;)
    f((k + 1) % n, k % n, loop.stepMm[k % n]);
}

// Returns the required width per vertex of the loop, interpolated linearly between vertices where
// it is known.
std::vector<double> wantedAlong(const Loop& loop, const std::vector<double>& wantedMm,
                                double usualMm) {
  const std::size_t n = loop.vertices.size();
  const auto known = [&](std::size_t i) { return at(loop.vertices[i]) < wantedMm.size(); };
  std::vector<double> along(n, usualMm);
  std::size_t first = 0;
  while (first < n && !known(first))
    ++first;
  if (first == n)
    return along;
  for (std::size_t from = first; from < first + n;) {
    std::size_t to = from + 1;
    double length = loop.stepMm[from % n];
    for (; !known(to % n); ++to)
      length += loop.stepMm[to % n];
    const double a = wantedMm[at(loop.vertices[from % n])], b = wantedMm[at(loop.vertices[to % n])];
    double done = 0.0;
    for (std::size_t i = from; i < to; ++i) {
      along[i % n] = length > 0.0 ? a + done / length * (b - a) : a;
      done += loop.stepMm[i % n];
    }
    from = to;
  }
  return along;
}

// Returns the largest width up to the wanted one that leaves no gap which neither this bead nor
// another can fill; `roomMm`: from the rim to the middle of the patch.
double fitting(double wantedMm, double roomMm, double hatchMm, const process::Process& process) {
  const double overlap = process.beadWidthMm - hatchMm;
  double width = std::min(wantedMm, roomMm + overlap);
  const double left = roomMm + overlap - width,
               // Half the minimum width of a bead along the middle
      minimum = 0.5 * (process.beadWidthMinMm - overlap);
  if (width + left > process.beadWidthMaxMm && left < minimum)
    width -= minimum - left;
  return std::max(process.beadWidthMm, width);
}

} // namespace

std::vector<double> outerHatches(const PatchSurface& s, const std::vector<double>& wantedMm,
                                 const SegmentDistances& boundary,
                                 const std::vector<double>& hatchMm,
                                 const process::Process& process) {
  base::require(boundary.mm.size() == s.position.size() &&
                    boundary.nearest.size() == s.position.size() &&
                    hatchMm.size() == s.position.size() && wantedMm.size() <= s.position.size(),
                "outerHatches: a value per vertex");
  const auto wide = [&](double mm) { return mm > process.beadWidthMm; };
  if (std::ranges::none_of(wantedMm, wide))
    return hatchMm;
  // Depth of the patch at each boundary edge: the depth of the deepest vertex that is nearest to
  // that edge.
  const double reach = process.beadWidthMaxMm + 2.0 * process.beadWidthMm;
  // Returns the nearest boundary edge of a vertex; nullptr if none is within reach.
  const auto edgeOf = [&](std::size_t v) {
    const int edge = boundary.mm[v] <= reach ? boundary.nearest[v] : -1;
    return edge >= 0 ? &s.boundary[at(edge)] : nullptr;
  };
  std::vector<double> roomMm(s.position.size(), 0.0); // At vertices of the boundary
  for (std::size_t v = 0; v < s.position.size(); ++v)
    if (const auto* edge = edgeOf(v))
      for (const int end : {(*edge)[0], (*edge)[1]})
        roomMm[at(end)] = std::max(roomMm[at(end)], boundary.mm[v]);

  std::vector<double> widthMm(s.position.size(), process.beadWidthMm);
  for (const Loop& loop : loopsOf(s)) {
    const std::size_t n = loop.vertices.size();
    std::vector<double> width = wantedAlong(loop, wantedMm, process.beadWidthMm);
    if (std::ranges::none_of(width, wide))
      continue;
    std::vector<double> room(n);
    for (std::size_t i = 0; i < n; ++i) {
      const int v = loop.vertices[i];
      const double beyond = kRoomBeads * process.beadWidthMm;
      double back = 0.0, on = 0.0;
      room[i] = roomMm[at(v)];
      for (std::size_t k = 1; k < n && (on += loop.stepMm[(i + k - 1) % n]) < beyond; ++k)
        room[i] = std::max(room[i], roomMm[at(loop.vertices[(i + k) % n])]);
      for (std::size_t k = 1; k < n && (back += loop.stepMm[(i + n - k) % n]) < beyond; ++k)
        room[i] = std::max(room[i], roomMm[at(loop.vertices[(i + n - k) % n])]);
    }
    sweep(loop, [&](std::size_t i, std::size_t j, double mm) {
      width[j] = std::max(width[j], width[i] - kSlope * mm);
    });
    for (std::size_t i = 0; i < n; ++i)
      width[i] = fitting(width[i], room[i], hatchMm[at(loop.vertices[i])], process);
    sweep(loop, [&](std::size_t i, std::size_t j, double mm) {
      width[j] = std::min(width[j], width[i] + kSlope * mm);
    });
    for (std::size_t i = 0; i < n; ++i)
      widthMm[at(loop.vertices[i])] = width[i];
  }

  std::vector<double> hatches = hatchMm;
  for (std::size_t v = 0; v < hatches.size(); ++v) {
    const auto* edge = edgeOf(v);
    if (!edge)
      continue;
    const Eigen::Vector3d &a = s.position[at((*edge)[0])], &b = s.position[at((*edge)[1])];
    const double t = geometry::nearestShare(s.position[v], a, b);
    const double width = (1.0 - t) * widthMm[at((*edge)[0])] + t * widthMm[at((*edge)[1])];
    hatches[v] += width - process.beadWidthMm;
  }
  return hatches;
}

} // namespace voluta::toolpath
