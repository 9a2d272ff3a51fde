#include "toolpath/plane/field_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;

constexpr int kRefinements = 6; // of a point on a grid's edge

// The grid's values, and the points where lines cross its edges.
class Grid {
public:
  Grid(const PlaneBox& box, double stepMm, const std::function<double(const Vector2d&)>& value,
       const std::function<bool(const Vector2d&)>& isWanted)
      : low_(box.low), step_(stepMm), value_(value) {
    columns_ = static_cast<std::int64_t>(std::ceil((box.high.x() - box.low.x()) / stepMm)) + 2;
    rows_ = static_cast<std::int64_t>(std::ceil((box.high.y() - box.low.y()) / stepMm)) + 2;
    values_.resize(static_cast<std::size_t>(columns_ * rows_));
    wanted_.resize(values_.size());
    for (std::int64_t j = 0; j < rows_; ++j)
      for (std::int64_t i = 0; i < columns_; ++i)
        wanted_[indexOf(i, j)] = isWanted(place(indexOf(i, j)));
    for (std::int64_t j = 0; j < rows_; ++j)
      for (std::int64_t i = 0; i < columns_; ++i)
        if (isCorner(i, j))
          values_[indexOf(i, j)] = value(place(indexOf(i, j)));
  }

  // Finds the segments of all lines, each between two points on the grid's edges.
  void addSegments() {
    for (std::int64_t j = 0; j + 1 < rows_; ++j)
      for (std::int64_t i = 0; i + 1 < columns_; ++i) {
        if (!isCellWanted(i, j))
          continue;
        const std::size_t a = indexOf(i, j), b = indexOf(i + 1, j), c = indexOf(i + 1, j + 1),
                          d = indexOf(i, j + 1);
        addSegments({a, b, c});
        addSegments({a, c, d});
      }
  }

  std::vector<PlaneLine> linked() const {
    std::vector<std::array<int, 2>> next(points_.size(), {-1, -1});
    for (const auto& [a, b] : segments_) {
      const auto link = [&](int from, int to) {
        auto& two = next[static_cast<std::size_t>(from)];
        (two[0] < 0 ? two[0] : two[1]) = to;
      };
      link(a, b);
      link(b, a);
    }
    std::vector<char> used(points_.size(), 0);
    std::vector<PlaneLine> lines;
    const auto follow = [&](std::size_t start) {
      PlaneLine line;
      int at = static_cast<int>(start);
      while (at >= 0 && !used[static_cast<std::size_t>(at)]) {
        used[static_cast<std::size_t>(at)] = 1;
        line.points.push_back(points_[static_cast<std::size_t>(at)]);
        const auto& two = next[static_cast<std::size_t>(at)];
        const auto isOpen = [&](int p) { return p >= 0 && !used[static_cast<std::size_t>(p)]; };
        at = isOpen(two[0]) ? two[0] : isOpen(two[1]) ? two[1] : -1;
      }
      return line;
    };
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (!used[p] && next[p][1] < 0)
        lines.push_back(follow(p));
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (!used[p]) {
        lines.push_back(follow(p));
        lines.back().isClosed = true;
      }
    return lines;
  }

private:
  std::size_t indexOf(std::int64_t i, std::int64_t j) const {
    return static_cast<std::size_t>(j * columns_ + i);
  }
  Vector2d place(std::size_t v) const {
    const auto index = static_cast<std::int64_t>(v);
    return low_ + step_ * Vector2d(static_cast<double>(index % columns_),
                                   static_cast<double>(index / columns_));
  }
  bool isCellWanted(std::int64_t i, std::int64_t j) const {
    return wanted_[indexOf(i, j)] || wanted_[indexOf(i + 1, j)] || wanted_[indexOf(i, j + 1)] ||
           wanted_[indexOf(i + 1, j + 1)];
  }

  // Returns whether a cell that is wanted has this corner.
  bool isCorner(std::int64_t i, std::int64_t j) const {
    for (std::int64_t l = std::max<std::int64_t>(0, j - 1); l <= std::min(j, rows_ - 2); ++l)
      for (std::int64_t k = std::max<std::int64_t>(0, i - 1); k <= std::min(i, columns_ - 2); ++k)
        if (isCellWanted(k, l))
          return true;
    return false;
  }

  // Returns the number of the point where `level` crosses an edge of the grid.
  int pointOn(std::size_t a, std::size_t b, double level) {
    if (a > b)
      std::swap(a, b);
    auto& onEdge = onEdge_[(static_cast<std::uint64_t>(a) << 3U) +
                           (b - a == 1                                    ? 0U
                            : b - a == static_cast<std::size_t>(columns_) ? 1U
                                                                          : 2U)];
    for (const auto& [known, point] : onEdge)
      if (known == level)
        return point;
    double low = 0.0, high = 1.0, below = values_[a] - level, above = values_[b] - level;
    const Vector2d from = place(a), along = place(b) - from;
    double share = below / (below - above);
    for (int k = 0; k < kRefinements; ++k) {
      const double here = value_(from + share * along) - level;
      if ((here > 0.0) == (above > 0.0)) {
        high = share;
        above = here;
      } else {
        low = share;
        below = here;
      }
      // Halves every second time, so that neither end stays.
      share = k % 2 == 0 ? 0.5 * (low + high)
                         : low + (high - low) * (above == below ? 0.5 : below / (below - above));
    }
    onEdge.emplace_back(level, static_cast<int>(points_.size()));
    points_.push_back(from + share * along);
    return onEdge.back().second;
  }

  void addSegments(const std::array<std::size_t, 3>& corners) {
    const auto [low, high] = std::ranges::minmax(
        std::array{values_[corners[0]], values_[corners[1]], values_[corners[2]]});
    for (double level = std::floor(low) - 0.5; level <= high; level += 1.0) {
      std::array<int, 2> ends{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = corners[k], b = corners[(k + 1) % 3];
        if ((values_[a] > level) != (values_[b] > level))
          ends.at(count++) = pointOn(a, b, level);
      }
      if (count == 2)
        segments_.push_back(ends);
    }
  }

  Vector2d low_;
  double step_;
  const std::function<double(const Vector2d&)>& value_;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<double> values_;
  std::vector<char> wanted_;
  std::unordered_map<std::uint64_t, std::vector<std::pair<double, int>>> onEdge_;
  std::vector<Vector2d> points_;
  std::vector<std::array<int, 2>> segments_;
};
} // namespace

std::vector<PlaneLine> fieldLines(const PlaneBox& box, double stepMm,
                                  const std::function<double(const Vector2d&)>& value,
                                  const std::function<bool(const Vector2d&)>& isWanted) {
  Grid grid(box, stepMm, value, isWanted);
  grid.addSegments();
  return grid.linked();
}

} // namespace voluta::toolpath
