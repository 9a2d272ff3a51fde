#include "milling/mill_passes.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "milling/contour.h"
#include "milling/drop_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::milling {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

void check(const MillRule& rule) {
  const auto refuse = [](base::Message reason, base::Message remedy) {
    throw base::Error(base::ErrorCode::Usage, std::move(reason), {}, std::move(remedy));
  };
  if (!(rule.cutter.diameterMm > 0.0) || rule.cutter.teeth < 1)
    refuse("the cutter has no diameter or no teeth"_text, "give --cutter and --teeth above 0"_text);
  if (!(rule.roughingMm > 0.0) || !(rule.pitchMm > 0.0) || rule.lineMm < 0.0 ||
      !(rule.distanceMm() > 0.0))
    refuse("a distance of passes is not positive"_text, "give distances above 0"_text);
  if (rule.acrossMm <= rule.cutter.diameterMm || rule.alongMm <= rule.cutter.diameterMm)
    refuse(base::message("the block is less than the cutter's {diameter} wider than the part"_text,
                         base::mm(rule.cutter.diameterMm)),
           "increase --gap"_text);
}

// A map of more cells takes gigabytes of memory.
void checkCells(const Eigen::AlignedBox3d& block, double pitchMm) {
  constexpr double kMaxCells = 4e7;
  const Vector3d size = block.sizes();
  if (size.x() / pitchMm * size.y() / pitchMm > kMaxCells)
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("cells of {pitch} are too fine for a block of {along} by {across}"_text,
                      base::mm(pitchMm), base::mm(size.x()), base::mm(size.y())),
        {},
        base::message("give --pitch of {least} or more"_text,
                      base::mm(std::sqrt(size.x() * size.y() / kMaxCells))));
}

geometry::TriangleMesh turned(const geometry::TriangleMesh& part) {
  geometry::TriangleMesh out = part;
  for (Vector3d& v : out.vertices)
    v = {v.x(), -v.y(), -v.z()};
  return out;
}

Eigen::AlignedBox3d turned(const Eigen::AlignedBox3d& box) {
  return {Vector3d(box.min().x(), -box.max().y(), -box.max().z()),
          Vector3d(box.max().x(), -box.min().y(), -box.min().z())};
}

// Returns the mean height, at the rim of the part's silhouette, of the middle between its sides.
double rimHeight(const HeightMap& above, const HeightMap& below) {
  const CellGrid& grid = above.grid;
  double sum = 0.0;
  std::size_t count = 0;
  for (int j = 1; j + 1 < grid.countY; ++j)
    for (int i = 1; i + 1 < grid.countX; ++i) {
      const std::size_t cell = grid.index(i, j),
                        other = grid.index(i, grid.countY - 1 - j); // turned about x
      const bool isRim =
          above.isPart(cell) && below.isPart(other) &&
          !(above.isPart(cell - 1) && above.isPart(cell + 1) &&
            above.isPart(grid.index(i, j - 1)) && above.isPart(grid.index(i, j + 1)));
      if (!isRim)
        continue;
      sum += 0.5 * (above.top[cell] - below.top[other]);
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

// Passes of one side.
class SidePlanner {
public:
  SidePlanner(const HeightMap& part, const Eigen::AlignedBox3d& block,
              const Eigen::AlignedBox3d& partBox, double floor, const MillRule& rule)
      : part_(part), block_(block), rule_(rule), floor_(floor),
        clear_(block.max().z() + rule.clearanceMm) {
    const double d = rule.cutter.diameterMm;
    first_ = partBox.min().x() - d;
    count_ = static_cast<int>(std::ceil((partBox.max().x() + d - first_) / part.grid.pitchMm));
  }

  std::vector<MillMove> plan(const base::RunContext& ctx) {
    std::vector<Line> lines = linesOf();
    base::parallelWithProgress(ctx, lines.size(), 1.0, "milling passes"_text,
                               [&](std::size_t i) { measure(lines[i]); });
    for (const Line& line : lines)
      mill(line);
    rise();
    return std::move(moves_);
  }

private:
  struct Line {
    double y = 0.0;
    std::vector<double> height;    // of the tip on the part, at xAt()
    std::vector<Vector3d> surface; // the tip along the part
  };

  double xAt(int i) const { return first_ + part_.grid.pitchMm * i; }

  std::vector<Line> linesOf() const {
    const double r = rule_.cutter.radiusMm(), step = rule_.distanceMm();
    const double last = block_.min().y() + r;
    std::vector<Line> lines{{block_.max().y() - r, {}, {}}};
    while (lines.back().y > last)
      lines.push_back({std::max(last, lines.back().y - step), {}, {}});
    return lines;
  }

  // The floor holds the part until the contour is milled; it begins outside the silhouette.
  double heightAt(double x, double y) const {
    const Cutter larger{rule_.cutter.diameterMm + 2.0 * kMarginMm, rule_.cutter.teeth};
    const double drop = dropHeight(part_, larger, {x, y}) + kMarginMm;
    const CellGrid& grid = part_.grid;
    const int i = static_cast<int>(std::floor((x - grid.low.x()) / grid.pitchMm)),
              j = static_cast<int>(std::floor((y - grid.low.y()) / grid.pitchMm));
    const bool isInside =
        i >= 0 && j >= 0 && i < grid.countX && j < grid.countY && part_.isPart(grid.index(i, j));
    return isInside ? drop : std::max(drop, floor_);
  }

  void measure(Line& line) const {
    for (int i = 0; i <= count_; ++i)
      line.height.push_back(heightAt(xAt(i), line.y));
    line.surface.emplace_back(xAt(0), line.y, line.height[0]);
    for (int i = 1; i <= count_; ++i)
      refine({xAt(i), line.y, line.height[static_cast<std::size_t>(i)]}, line.surface);
  }

  void mill(const Line& line) {
    const double highest = *std::ranges::max_element(line.height),
                 lowest = *std::ranges::min_element(line.height), fine = finePass();
    double level = block_.max().z();
    while (level > lowest + kSameMm) {
      const double rough = level - rule_.roughingMm;
      step_ = rough >= highest ? MillStep::Roughing : MillStep::Fine;
      level = std::max(lowest, step_ == MillStep::Roughing ? rough : level - fine);
      pass(line.y, level, line.height);
    }
    step_ = MillStep::Surface;
    follow(line.surface);
  }
  double finePass() const { return finePassMm(rule_.cutter, rule_.data); }

  // Mills the stretches of a line on which the level is above the part, from the nearer end.
  void pass(double y, double level, const std::vector<double>& height) {
    std::vector<std::pair<int, int>> stretches;
    for (int i = 0; i <= count_;) {
      int end = i;
      while (end <= count_ && height[static_cast<std::size_t>(end)] <= level + kSameMm)
        ++end;
      if (end > i)
        stretches.emplace_back(i, end - 1);
      i = std::max(end, i + 1);
    }
    if (isBackwards_)
      std::ranges::reverse(stretches);
    for (const auto& [low, high] : stretches) {
      const int from = isBackwards_ ? high : low, to = isBackwards_ ? low : high;
      enter({xAt(from), y, level});
      cut({xAt(to), y, level});
    }
    isBackwards_ = !isBackwards_;
  }

  // Follows the part's surface, with as few points as keep the cutter within kSameMm of it.
  void follow(std::vector<Vector3d> points) {
    if (isBackwards_)
      std::ranges::reverse(points);
    enter(points.front());
    for (std::size_t from = 0; from + 1 < points.size();) {
      std::size_t to = from + 1;
      while (to + 1 < points.size() && isStraight(points, from, to + 1))
        ++to;
      cut(points[to]);
      from = to;
    }
    isBackwards_ = !isBackwards_;
  }
  // Appends a point, and points before it where a straight line could cut into the part. The tip's
  // height jumps where the ball meets a wall: there the cutter goes straight up or down beside it.
  void refine(const Vector3d& to, std::vector<Vector3d>& points) const {
    constexpr double kMinMm = 0.004, kJumpMm = 0.05, kSteep = 2.0;
    const Vector3d from = points.back();
    const double width = to.x() - from.x(), rise = to.z() - from.z(), x = 0.5 * (from.x() + to.x());
    if (width > kMinMm) {
      const double z = heightAt(x, to.y());
      if (std::abs(rise) > kSteep * width || z > 0.5 * (from.z() + to.z()) + kSameMm) {
        refine({x, to.y(), z}, points);
        refine(to, points);
        return;
      }
    } else if (std::abs(rise) > kJumpMm) {
      points.emplace_back(rise > 0.0 ? from.x() : to.x(), to.y(), std::max(from.z(), to.z()));
    }
    points.push_back(to);
  }
  static bool isStraight(const std::vector<Vector3d>& points, std::size_t from, std::size_t to) {
    const Vector3d &a = points[from], &b = points[to];
    for (std::size_t k = from + 1; k < to; ++k) {
      if (!(b.x() != a.x() && points[k].x() != a.x() && points[k].x() != b.x()))
        return false; // straight up or down
      const double share = (points[k].x() - a.x()) / (b.x() - a.x());
      if (std::abs(a.z() + share * (b.z() - a.z()) - points[k].z()) > kSameMm)
        return false;
    }
    return true;
  }

  // Goes to a place above the block and down into it; straight down where it already is.
  void enter(const Vector3d& at) {
    const bool isHere = !moves_.empty() && (moves_.back().to - at).head<2>().norm() < kSameMm &&
                        moves_.back().to.z() >= at.z();
    if (!isHere) {
      rise();
      moves_.push_back({{at.x(), at.y(), clear_}, MillStep::Rapid});
    }
    cut(at);
  }
  void rise() {
    if (!moves_.empty() && moves_.back().to.z() < clear_)
      moves_.push_back({{moves_.back().to.x(), moves_.back().to.y(), clear_}, MillStep::Rapid});
  }
  void cut(const Vector3d& to) {
    if (moves_.empty() || (moves_.back().to - to).norm() > kSameMm)
      moves_.push_back({to, step_});
  }

  static constexpr double kSameMm = 0.002;
  // Beside a wall the digits of the program must not bring the ball into it.
  static constexpr double kMarginMm = 0.003;
  const HeightMap& part_;
  Eigen::AlignedBox3d block_;
  const MillRule& rule_;
  double floor_, clear_, first_ = 0.0;
  int count_ = 0;
  bool isBackwards_ = false;
  MillStep step_ = MillStep::Roughing;
  std::vector<MillMove> moves_;
};

} // namespace

MillPlan planMilling(const geometry::TriangleMesh& part, const MillRule& rule,
                     const base::RunContext& ctx) {
  check(rule);
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const Vector3d gap(rule.alongMm, rule.acrossMm, rule.skinMm);
  MillPlan plan;
  plan.block = {box.min() - gap, box.max() + gap};
  checkCells(plan.block, rule.pitchMm);
  CellGrid grid = gridOver(plan.block.min().head<2>(), plan.block.max().head<2>(), rule.pitchMm);
  plan.above = heightMap(part, grid, ctx.sub(0.0, 0.2));
  grid.low.y() = -(grid.low.y() + grid.pitchMm * grid.countY);
  plan.below = heightMap(turned(part), grid, ctx.sub(0.2, 0.4));
  const double rim = rimHeight(plan.above, plan.below), half = 0.5 * rule.webMm;
  const Eigen::AlignedBox3d blockB = turned(plan.block), boxB = turned(box);
  plan.sides.push_back(
      {MillSide::A,
       SidePlanner(plan.above, plan.block, box, rim + half, rule).plan(ctx.sub(0.4, 0.7))});
  plan.sides.push_back(
      {MillSide::B,
       SidePlanner(plan.below, blockB, boxB, half - rim, rule).plan(ctx.sub(0.7, 1.0))});
  plan.sides.push_back(
      {MillSide::Contour, contourMoves(plan.below, rule,
                                       {.highMm = half - rim,
                                        .lowMm = -rim - half,
                                        .clearMm = blockB.max().z() + rule.clearanceMm})});
  return plan;
}

} // namespace voluta::milling
