#include "milling/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace voluta::milling {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Returns the distance of each cell's middle from the nearest cell of the part, up to `maxMm`.
std::vector<double> distances(const HeightMap& part, double maxMm) {
  std::vector<double> out(part.grid.size(), maxMm);
  const CellGrid& grid = part.grid;
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i) {
      const std::size_t cell = grid.index(i, j);
      if (!part.isPart(cell))
        continue;
      out[cell] = 0.0;
      const bool isRim = i == 0 || j == 0 || i + 1 == grid.countX || j + 1 == grid.countY ||
                         !part.isPart(cell - 1) || !part.isPart(cell + 1) ||
                         !part.isPart(grid.index(i, j - 1)) || !part.isPart(grid.index(i, j + 1));
      if (isRim)
        visitAround(grid, grid.middle(i, j), maxMm, [&](std::size_t other, double squared) {
          out[other] = std::min(out[other], std::sqrt(squared));
        });
    }
  return out;
}

// Lines of equal value between the middles of cells (marching squares).
class Isolines {
public:
  Isolines(const CellGrid& grid, const std::vector<double>& value, double level)
      : grid_(grid), value_(value), level_(level) {}

  std::vector<std::vector<Vector2d>> trace() {
    for (int j = 0; j + 1 < grid_.countY; ++j)
      for (int i = 0; i + 1 < grid_.countX; ++i)
        square(i, j);
    std::vector<std::vector<Vector2d>> loops;
    while (!next_.empty()) {
      std::uint64_t edge = next_.begin()->first;
      std::vector<Vector2d> loop;
      for (auto at = next_.find(edge); at != next_.end(); at = next_.find(edge)) {
        loop.push_back(crossing(edge));
        edge = at->second;
        next_.erase(at);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

private:
  // Edges from a cell to the one on its right (0) or above it (1).
  std::uint64_t edgeOf(int i, int j, int axis) const { return 2 * grid_.index(i, j) + axis; }
  bool isLow(int i, int j) const { return value_[grid_.index(i, j)] < level_; }

  Vector2d crossing(std::uint64_t edge) const {
    const auto cell = edge / 2;
    const auto columns = static_cast<std::uint64_t>(grid_.countX);
    const int i = static_cast<int>(cell % columns), j = static_cast<int>(cell / columns);
    const int right = edge % 2 == 0 ? 1 : 0;
    const Vector2d a = grid_.middle(i, j), b = grid_.middle(i + right, j + 1 - right);
    const double from = value_[grid_.index(i, j)],
                 to = value_[grid_.index(i + right, j + 1 - right)];
    return a + (level_ - from) / (to - from) * (b - a);
  }

  // Adds the lines of a square of four cells, the low values to their left.
  void square(int i, int j) {
    const std::array<bool, 4> low{isLow(i, j), isLow(i + 1, j), isLow(i + 1, j + 1),
                                  isLow(i, j + 1)};
    const std::array<std::uint64_t, 4> edges{edgeOf(i, j, 0), edgeOf(i + 1, j, 1),
                                             edgeOf(i, j + 1, 0), edgeOf(i, j, 1)};
    // Around the square, lines leave where values go from low to high, and enter where they go
    // from high to low; each leads to the next exit.
    for (std::size_t k = 0; k < 4; ++k) {
      if (low[k] || !low[(k + 1) % 4])
        continue;
      for (std::size_t n = 1; n < 4; ++n) {
        const std::size_t out = (k + n) % 4;
        if (low[out] && !low[(out + 1) % 4]) {
          next_[edges[out]] = edges[k];
          break;
        }
      }
    }
  }

  const CellGrid& grid_;
  const std::vector<double>& value_;
  double level_;
  std::unordered_map<std::uint64_t, std::uint64_t> next_;
};

double areaOf(const std::vector<Vector2d>& loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

// Appends the moves along a loop at one height, above the strip.
void addLoop(const std::vector<Vector2d>& loop, double heightMm, double stripY, double clearMm,
             std::vector<MillMove>& moves) {
  const auto at = [&](std::size_t i) -> const Vector2d& { return loop[i % loop.size()]; };
  std::size_t start = 0;
  while (start < loop.size() && !(at(start).y() < stripY && at(start + 1).y() >= stripY))
    ++start;
  const bool isWhole = start == loop.size();
  start = isWhole ? 0 : start + 1;
  bool isDown = false;
  for (std::size_t k = 0; k <= loop.size(); ++k) {
    const Vector2d& p = at(start + k);
    if (p.y() < stripY) {
      if (isDown)
        moves.push_back({{moves.back().to.x(), moves.back().to.y(), clearMm}, MillStep::Rapid});
      isDown = false;
      continue;
    }
    if (!isDown)
      moves.push_back({{p.x(), p.y(), clearMm}, MillStep::Rapid});
    moves.push_back({{p.x(), p.y(), heightMm}, MillStep::Contour});
    isDown = true;
  }
  if (isDown)
    moves.push_back({{moves.back().to.x(), moves.back().to.y(), clearMm}, MillStep::Rapid});
}

} // namespace

std::vector<std::vector<Vector2d>> outlinesAround(const HeightMap& part, double distanceMm) {
  const std::vector<double> distance = distances(part, distanceMm + 2.0 * part.grid.pitchMm);
  std::vector<std::vector<Vector2d>> loops = Isolines(part.grid, distance, distanceMm).trace();
  std::erase_if(loops, [](const std::vector<Vector2d>& loop) { return areaOf(loop) <= 0.0; });
  return loops;
}

std::vector<MillMove> contourMoves(const HeightMap& part, const MillRule& rule,
                                   const ContourHeights& heights) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int j = 0; j < part.grid.countY; ++j)
    for (int i = 0; i < part.grid.countX; ++i)
      if (part.isPart(part.grid.index(i, j)))
        lowest = std::min(lowest, part.grid.middle(i, j).y());
  // Half a cell more, since the silhouette is between the middles of cells.
  const auto loops = outlinesAround(part, rule.cutter.radiusMm() + 0.5 * part.grid.pitchMm);
  std::vector<MillMove> moves;
  double level = heights.highMm;
  do {
    level = std::max(heights.lowMm, level - finePassMm(rule.cutter, rule.data));
    // The cutter's end is round: its full width is one radius higher.
    for (const auto& loop : loops)
      addLoop(loop, level - rule.cutter.radiusMm(), lowest + rule.stripMm, heights.clearMm, moves);
  } while (level > heights.lowMm);
  return moves;
}

} // namespace voluta::milling
