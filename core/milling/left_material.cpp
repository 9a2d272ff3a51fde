#include "milling/left_material.h"

#include "milling/drop_cutter.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <utility>
#include <vector>

namespace voluta::milling {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kHiddenMm = 0.2; // undercuts, with the rounding of cells
// Layers that a ball leaves along a right-angled groove, in its radii.
const double kGroove = std::numbers::sqrt2 - 1.0;

// Calls visit(neighbour) for the neighbours of a cell.
template <typename Visit>
void visitBeside(const CellGrid& grid, std::size_t cell, const Visit& visit) {
  const int i = static_cast<int>(cell) % grid.countX, j = static_cast<int>(cell) / grid.countX;
  for (const auto& [x, y] : {std::pair(i - 1, j), {i + 1, j}, {i, j - 1}, {i, j + 1}})
    if (x >= 0 && y >= 0 && x < grid.countX && y < grid.countY)
      visit(grid.index(x, y));
}

// Returns for each cell beside the part how far it is from the places that the cutter reaches [mm],
// along steps between cells; 0: reached, or of the part; infinity: in a hole through the part,
// which no contour frees.
std::vector<double> depthsBesidePart(const HeightMap& part, double radiusMm) {
  const CellGrid& grid = part.grid;
  const auto each = [&](const auto& visit) {
    for (int j = 0; j < grid.countY; ++j)
      for (int i = 0; i < grid.countX; ++i)
        visit(i, j, grid.index(i, j));
  };
  const auto isRim = [&](int i, int j, const std::vector<char>& inside) {
    const auto differs = [&](int x, int y) {
      return x >= 0 && y >= 0 && x < grid.countX && y < grid.countY &&
             inside[grid.index(x, y)] != inside[grid.index(i, j)];
    };
    return differs(i - 1, j) || differs(i + 1, j) || differs(i, j - 1) || differs(i, j + 1);
  };
  std::vector<char> isPart(grid.size());
  for (std::size_t c = 0; c < grid.size(); ++c)
    isPart[c] = part.isPart(c) ? 1 : 0;
  // The middle of the cutter stays away from the part; a cell is rounding.
  std::vector<char> isBlocked = isPart;
  each([&](int i, int j, std::size_t c) {
    if (isPart[c] && isRim(i, j, isPart))
      visitAround(grid, grid.middle(i, j), radiusMm - grid.pitchMm,
                  [&](std::size_t other, double) { isBlocked[other] = 1; });
  });
  std::vector<char> isReached(grid.size());
  each([&](int i, int j, std::size_t c) {
    if (isBlocked[c])
      return;
    isReached[c] = 1;
    if (isRim(i, j, isBlocked))
      visitAround(grid, grid.middle(i, j), radiusMm,
                  [&](std::size_t other, double) { isReached[other] = 1; });
  });
  std::vector<char> isOutside(grid.size());
  std::deque<std::size_t> front;
  const auto reach = [&](std::size_t c) {
    if (isPart[c] || isOutside[c])
      return;
    isOutside[c] = 1;
    front.push_back(c);
  };
  each([&](int i, int j, std::size_t c) {
    if (i == 0 || j == 0 || i + 1 == grid.countX || j + 1 == grid.countY)
      reach(c);
  });
  for (; !front.empty(); front.pop_front())
    visitBeside(grid, front.front(), reach);
  std::vector<double> depth(grid.size(), 0.0);
  for (std::size_t c = 0; c < grid.size(); ++c) {
    if (isReached[c] && isOutside[c])
      front.push_back(c);
    else if (!isPart[c])
      depth[c] = INFINITY;
  }
  for (; !front.empty(); front.pop_front())
    visitBeside(grid, front.front(), [&](std::size_t other) {
      if (isOutside[other] && depth[other] == INFINITY) {
        depth[other] = depth[front.front()] + grid.pitchMm;
        front.push_back(other);
      }
    });
  return depth;
}

// Returns the upward component of the unit normal of the part's top, by the gentler slope along
// each axis, so that the foot of a wall is no slope.
double levelness(const HeightMap& part, int i, int j) {
  const CellGrid& grid = part.grid;
  const double top = part.top[grid.index(i, j)];
  const auto slope = [&](int di, int dj) {
    double gentlest = INFINITY;
    for (const int sign : {-1, 1}) {
      const int x = i + sign * di, y = j + sign * dj;
      if (x >= 0 && y >= 0 && x < grid.countX && y < grid.countY && part.isPart(grid.index(x, y)))
        gentlest = std::min(gentlest, std::abs(part.top[grid.index(x, y)] - top) / grid.pitchMm);
    }
    return gentlest;
  };
  const double x = slope(1, 0), y = slope(0, 1);
  return 1.0 / std::sqrt(1.0 + x * x + y * y);
}

// Returns for each cell with material on the part that is thicker than `thinMm` along the normal,
// how far it is from places where the block is cleared down to that height [mm], along steps
// between such cells; infinity: no way leads there; 0 for other cells.
std::vector<double> depthsOnPart(const HeightMap& part, const Stock& stock, double thinMm) {
  const CellGrid& grid = part.grid;
  std::vector<double> depth(grid.size(), 0.0);
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i)
      if (const std::size_t c = grid.index(i, j);
          part.isPart(c) && (stock.highAt(c) - part.top[c]) * levelness(part, i, j) > thinMm)
        depth[c] = INFINITY;
  std::deque<std::size_t> front;
  for (std::size_t c = 0; c < grid.size(); ++c) {
    bool isRim = false;
    if (depth[c] > 0.0)
      visitBeside(grid, c, [&](std::size_t other) {
        isRim |= depth[other] == 0.0 && stock.highAt(other) <= part.top[c] + thinMm;
      });
    if (isRim)
      front.push_back(c);
  }
  for (const std::size_t c : front)
    depth[c] = grid.pitchMm;
  for (; !front.empty(); front.pop_front()) {
    const std::size_t c = front.front();
    visitBeside(grid, c, [&](std::size_t other) {
      // A wall between them separates them.
      if (depth[other] == INFINITY && part.top[other] < stock.highAt(c) &&
          part.top[c] < stock.highAt(other)) {
        depth[other] = depth[c] + grid.pitchMm;
        front.push_back(other);
      }
    });
  }
  return depth;
}

// Heights that the cutter could clear a part down to, were its lines as close as can be. Strips at
// walls do not count: a cell is rounding, and ridges between lines end at walls.
class Clearable {
public:
  Clearable(const HeightMap& part, const MillRule& rule)
      : part_(part), cutter_(rule.cutter),
        reach_(rule.cutter.radiusMm() - part.grid.pitchMm -
               ridgeOnPlaneMm(rule.cutter.radiusMm(), rule.distanceMm())),
        tip_(part.grid.size(), NAN) {}

  // Returns the least height of the ball over a cell.
  double heightAt(std::size_t cell) {
    const CellGrid& grid = part_.grid;
    const double r = cutter_.radiusMm();
    double minimum = INFINITY;
    visitAround(grid, middle(cell), reach_, [&](std::size_t other, double squared) {
      if (std::isnan(tip_[other]))
        tip_[other] = dropHeight(part_, cutter_, middle(other));
      minimum = std::min(minimum, tip_[other] + r - std::sqrt(r * r - squared));
    });
    return minimum;
  }

private:
  Vector2d middle(std::size_t cell) const {
    return part_.grid.middle(static_cast<int>(cell) % part_.grid.countX,
                             static_cast<int>(cell) / part_.grid.countX);
  }
  const HeightMap& part_;
  const Cutter& cutter_;
  double reach_;
  std::vector<double> tip_; // NaN: not known yet
};

// Marks the cells of the part with more material than a round cutter leaves everywhere.
std::vector<char> leftOnPart(const HeightMap& part, const Stock& stock, const MillRule& rule) {
  const CellGrid& grid = part.grid;
  const double radius = rule.cutter.radiusMm(), limit = radius + grid.pitchMm;
  const double thin =
      std::max(kGroove * radius, ridgeOnPlaneMm(radius, rule.distanceMm())) + grid.pitchMm;
  const std::vector<double> depth = depthsOnPart(part, stock, thin);
  Clearable clearable(part, rule);
  std::vector<char> isLeft(grid.size());
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i)
      if (const std::size_t c = grid.index(i, j); depth[c] > 0.0) {
        const double level = levelness(part, i, j);
        isLeft[c] = depth[c] > limit || ((stock.highAt(c) - part.top[c]) * level > limit &&
                                         (stock.highAt(c) - clearable.heightAt(c)) * level > limit);
      }
  return isLeft;
}

class Sum {
public:
  Sum(const CellGrid& grid, LeftMaterial& left) : grid_(grid), left_(left) {}

  // Adds the material between two heights over a cell.
  void add(const Vector2d& at, double lowMm, double highMm) {
    const double thick = highMm - lowMm;
    left_.volumeMm3 += thick * grid_.pitchMm * grid_.pitchMm;
    if (thick <= left_.thickestMm)
      return;
    left_.thickestMm = thick;
    left_.atMm = {at.x(), at.y(), 0.5 * (lowMm + highMm)};
  }
  void addCorner(double thickMm) {
    left_.cornersMm3 += std::max(0.0, thickMm) * grid_.pitchMm * grid_.pitchMm;
  }

private:
  const CellGrid& grid_;
  LeftMaterial& left_;
};
} // namespace

LeftMaterial leftMaterial(const Stock& rest, const MillPlan& plan, const MillRule& rule) {
  LeftMaterial left;
  const HeightMap &above = plan.above, &below = plan.below;
  const CellGrid& grid = above.grid;
  const double radius = rule.cutter.radiusMm(), limit = radius + grid.pitchMm;
  const std::vector<double> beside = depthsBesidePart(above, radius);
  const std::vector<char> on = leftOnPart(above, rest, rule),
                          under = leftOnPart(below, rest.turned(), rule);
  Sum sum(grid, left);
  for (int j = 0; j < grid.countY; ++j)
    for (int i = 0; i < grid.countX; ++i) {
      const std::size_t c = grid.index(i, j);
      const Vector2d at = grid.middle(i, j);
      const double high = rest.highAt(c), low = rest.lowAt(c);
      if (!above.isPart(c)) {
        if (beside[c] > limit && high > low)
          sum.add(at, low, high);
        continue;
      }
      const std::size_t other = grid.index(i, grid.countY - 1 - j); // of the part turned about x
      const double top = above.top[c], bottom = -below.top[other];
      if (on[c])
        sum.add(at, top, high);
      else
        sum.addCorner(high - top);
      if (!below.isPart(other))
        continue;
      if (under[other])
        sum.add(at, low, bottom);
      else
        sum.addCorner(bottom - low);
      const double hidden = top - bottom - above.solidMm[c];
      if (hidden > kHiddenMm && hidden < top - bottom) {
        const double middle =
            (0.5 * (top * top - bottom * bottom) - above.solidMomentMm2[c]) / hidden;
        sum.add(at, middle - 0.5 * hidden, middle + 0.5 * hidden);
      }
    }
  if (left.volumeMm3 < kMinLeftMm3)
    return {.cornersMm3 = left.cornersMm3};
  return left;
}

} // namespace voluta::milling
