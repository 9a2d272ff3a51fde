#include "toolpath/plane/joined_lines.h"

#include "geometry/polyline.h"
#include "toolpath/plane/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;

constexpr double kArcMm = 0.01;     // chord error of the inset edge
constexpr double kFarthestEdge = 4; // [insets] from the end of a line to the area's edge

// A stretch of a line inside the inset area. Its ends are on the edge of that area, except those of
// a closed line.
struct Stretch {
  PlaneLine line;
  std::array<std::optional<ContourPlace>, 2> end; // its front and its back
};

double lengthOf(const PlaneLine& line) {
  const double open = geometry::polylineLength(
      line.points.size(), [&](std::size_t i) -> const Vector2d& { return line.points[i]; });
  return open + (line.isClosed ? (line.points.front() - line.points.back()).norm() : 0.0);
}

// Cuts lines at contours.
class Cutter {
public:
  explicit Cutter(const Contours& contours) : contours_(contours) {}

  void cut(const PlaneLine& line, std::vector<Stretch>& to) {
    const std::size_t n = line.points.size(), first = to.size();
    Stretch now;
    const std::size_t segments = line.isClosed ? n : n - 1;
    bool isCut = false;
    for (std::size_t i = 0; i < segments; ++i) {
      const Vector2d &a = line.points[i], &b = line.points[(i + 1) % n];
      const std::vector<Contours::Crossing> crossings = contours_.crossings(a, b);
      isCut = isCut || !crossings.empty();
      double from = 0.0;
      for (std::size_t k = 0; k <= crossings.size(); ++k) {
        const double until = k < crossings.size() ? crossings[k].share : 1.0;
        const Vector2d p = a + from * (b - a), q = a + until * (b - a);
        if (contours_.contains(0.5 * (p + q))) {
          if (now.line.points.empty()) {
            now.line.points.push_back(p);
            if (k > 0)
              now.end[0] = crossings[k - 1].place;
          }
          if ((q - p).squaredNorm() > 0.0)
            now.line.points.push_back(q);
          if (k < crossings.size()) {
            now.end[1] = crossings[k].place;
            to.push_back(std::exchange(now, {}));
          }
        }
        from = until;
      }
    }
    if (now.line.points.empty())
      return;
    if (line.isClosed && !isCut) {
      now.line.points.pop_back();
      now.line.isClosed = true;
    } else if (line.isClosed && to.size() > first && !to[first].end[0]) {
      // The stretch that passes the closed line's first point
      const auto& more = to[first].line.points;
      now.line.points.insert(now.line.points.end(), more.begin() + 1, more.end());
      now.end[1] = to[first].end[1];
      to[first] = std::move(now);
      return;
    }
    to.push_back(std::move(now));
  }

private:
  const Contours& contours_;
};

// Joints between the ends of stretches. End 2 i is the front of stretch i, end 2 i + 1 its back.
class Joints {
public:
  Joints(const std::vector<Stretch>& stretches, const Contours& edge)
      : stretches_(stretches), edge_(edge), joined_(2 * stretches.size()),
        chain_(stretches.size()) {
    std::iota(chain_.begin(), chain_.end(), 0U);
  }

  void make(double longestMm, double totalMm) {
    for (const Candidate& one : candidates(longestMm)) {
      const std::size_t a = chainOf(one.from / 2), b = chainOf(one.to / 2);
      if (joined_[one.from] || joined_[one.to] || a == b || one.mm > totalMm)
        continue;
      totalMm -= one.mm;
      chain_[a] = b;
      const auto& [from, to] = std::pair(endAt(one.from), endAt(one.to));
      std::vector<Vector2d> way = edge_.between(from.contour, from.arcMm, to.arcMm);
      joined_[one.from] = Joint{one.to, way};
      std::ranges::reverse(way);
      joined_[one.to] = Joint{one.from, std::move(way)};
    }
  }

  bool isFree(std::size_t end) const { return !joined_[end]; }

  // Returns each chain of joined stretches as one line. `ends`: places of free ends.
  std::vector<PlaneLine> chains(const std::vector<Vector2d>& ends) const {
    std::vector<PlaneLine> lines;
    std::vector<char> used(stretches_.size(), 0);
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      if (used[i] || !(isFree(2 * i) || isFree(2 * i + 1)))
        continue;
      if (stretches_[i].line.isClosed) {
        lines.push_back(stretches_[i].line);
        continue;
      }
      PlaneLine line;
      std::size_t end = isFree(2 * i) ? 2 * i : 2 * i + 1;
      line.points.push_back(ends[end]);
      for (;;) {
        used[end / 2] = 1;
        const auto& points = stretches_[end / 2].line.points;
        if (end % 2 == 0)
          line.points.insert(line.points.end(), points.begin(), points.end());
        else
          line.points.insert(line.points.end(), points.rbegin(), points.rend());
        const std::size_t other = end ^ 1U;
        if (isFree(other)) {
          line.points.push_back(ends[other]);
          break;
        }
        line.points.insert(line.points.end(), joined_[other]->way.begin(),
                           joined_[other]->way.end());
        end = joined_[other]->end;
      }
      const auto same = std::ranges::unique(line.points, [](const Vector2d& p, const Vector2d& q) {
        return (p - q).squaredNorm() < 1e-12;
      });
      line.points.erase(same.begin(), same.end());
      lines.push_back(std::move(line));
    }
    return lines;
  }

private:
  struct Candidate {
    double mm;
    std::size_t from, to; // in the contour's direction
  };
  struct Joint {
    std::size_t end;
    std::vector<Vector2d> way;
  };

  const ContourPlace& endAt(std::size_t end) const { return *stretches_[end / 2].end[end % 2]; }

  std::size_t chainOf(std::size_t stretch) {
    while (chain_[stretch] != stretch)
      stretch = chain_[stretch] = chain_[chain_[stretch]];
    return stretch;
  }

  // Returns the pairs of ends that follow each other on a contour, the nearest first.
  std::vector<Candidate> candidates(double longestMm) const {
    std::vector<std::size_t> ends;
    for (std::size_t end = 0; end < joined_.size(); ++end)
      if (stretches_[end / 2].end[end % 2])
        ends.push_back(end);
    std::ranges::sort(ends, [&](std::size_t a, std::size_t b) {
      const ContourPlace &p = endAt(a), &q = endAt(b);
      return std::tie(p.contour, p.arcMm, a) < std::tie(q.contour, q.arcMm, b);
    });
    std::vector<Candidate> all;
    for (std::size_t begin = 0; begin < ends.size();) {
      std::size_t stop = begin;
      while (stop < ends.size() && endAt(ends[stop]).contour == endAt(ends[begin]).contour)
        ++stop;
      const double around = edge_.lengthMm(endAt(ends[begin]).contour);
      for (std::size_t k = begin; k < stop; ++k) {
        const std::size_t next = k + 1 < stop ? ends[k + 1] : ends[begin];
        double mm = endAt(next).arcMm - endAt(ends[k]).arcMm;
        mm += mm < 0.0 ? around : 0.0;
        if (mm <= longestMm)
          all.push_back({mm, ends[k], next});
      }
      begin = stop;
    }
    std::ranges::stable_sort(all, {}, &Candidate::mm);
    return all;
  }

  const std::vector<Stretch>& stretches_;
  const Contours& edge_;
  std::vector<std::optional<Joint>> joined_; // per end
  std::vector<std::size_t> chain_;           // per stretch: another one of its chain
};

// Returns the end of a line, moved outwards beyond the edge of the area.
Vector2d extended(const PlaneLine& line, bool atFront, const Contours& area,
                  const LineJoints& joints) {
  const auto& points = line.points;
  const Vector2d& end = atFront ? points.front() : points.back();
  const Vector2d& before = atFront ? points[1] : points[points.size() - 2];
  const Vector2d along = (end - before).normalized();
  const double reach = kFarthestEdge * joints.insetMm;
  const auto crossings = area.crossings(end, end + reach * along);
  const double toEdge = crossings.empty() ? joints.insetMm : crossings.front().share * reach;
  return end + (toEdge + joints.overlapMm) * along;
}
} // namespace

std::vector<PlaneLine> joinedLines(const std::vector<PlaneLine>& lines,
                                   const ClipperLib::Paths& area, const LineJoints& joints,
                                   const base::RunContext& ctx) {
  const Contours whole(area), edge(geometry::offsetPaths(area, -joints.insetMm, {kArcMm}));
  std::vector<Stretch> stretches;
  Cutter cutter(edge);
  for (const PlaneLine& line : lines)
    cutter.cut(line, stretches);
  ctx.checkpoint();
  std::erase_if(stretches, [&](const Stretch& stretch) {
    return stretch.line.points.size() < 2 || lengthOf(stretch.line) < joints.shortestMm;
  });
  Joints made(stretches, edge);
  made.make(joints.longestMm, joints.totalMm);
  ctx.checkpoint();
  std::vector<Vector2d> ends(2 * stretches.size());
  for (std::size_t end = 0; end < ends.size(); ++end)
    if (made.isFree(end) && !stretches[end / 2].line.isClosed)
      ends[end] = extended(stretches[end / 2].line, end % 2 == 0, whole, joints);
  return made.chains(ends);
}

} // namespace voluta::toolpath
