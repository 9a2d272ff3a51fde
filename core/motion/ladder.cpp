#include "motion/ladder.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// As std::round, without a call.
double rounded(double x) {
  return static_cast<double>(static_cast<long>(x + (x < 0.0 ? -0.5 : 0.5)));
}

// L1 step of the joints that have limits here from `from` to the representative of `to` nearest to
// it; infinite where a joint's step is larger than maxStep or its limits are left, and where the
// sum is no less than `most`.
double step(const robot::JointVector& from, const robot::JointVector& to,
            const std::vector<robot::JointLimits>& limits, double maxStep, double most) {
  double sum = 0.0;
  const auto count = static_cast<Eigen::Index>(limits.size());
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto& limit = limits[static_cast<std::size_t>(j)];
    double d = robot::asTurn(limit.kind, to[j] - from[j]);
    if (std::abs(d) > maxStep) {
      if (limit.kind == robot::JointKind::Sliding)
        return kInfinity;
      d -= base::kTurn * rounded(d / base::kTurn);
      if (std::abs(d) > maxStep)
        return kInfinity;
      const double q = from[j] + d;
      if (q < limit.min || q > limit.max)
        return kInfinity;
    }
    sum += std::abs(d);
    if (sum >= most)
      return kInfinity;
  }
  return sum;
}

robot::JointVector nearestTurns(const robot::JointVector& from, robot::JointVector to,
                                const std::vector<robot::JointLimits>& limits, double maxStep) {
  for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(limits.size()); ++j) {
    const double d = to[j] - from[j];
    const bool turns = limits[static_cast<std::size_t>(j)].kind == robot::JointKind::Turning;
    if (turns && std::abs(d) > maxStep)
      to[j] = from[j] + d - base::kTurn * rounded(d / base::kTurn);
  }
  return to;
}

} // namespace

LadderWay shortestWay(const std::vector<Rung>& rungs, const std::vector<double>& startCost,
                      const std::vector<robot::JointLimits>& limits, const LadderOptions& options) {
  LadderWay way;
  if (rungs.empty())
    return way;
  base::require(startCost.size() == rungs.front().size(), "a start cost for each first node");
  base::require(options.maxStepRad.size() == rungs.size(), "a largest step for each rung");

  std::vector<std::vector<double>> cost(rungs.size());
  std::vector<std::vector<int>> parent(rungs.size());
  std::vector<robot::JointVector> here, before;
  // Reached nodes of the rung before; all turns are neighbours where the window spans the circle.
  std::vector<std::vector<int>> bySample(static_cast<std::size_t>(options.samples));
  const int reach = std::min(options.window, (options.samples - 1) / 2);
  for (std::size_t r = 0; r < rungs.size(); ++r) {
    const Rung& rung = rungs[r];
    cost[r].assign(rung.size(), kInfinity);
    parent[r].assign(rung.size(), -1);
    here.assign(rung.size(), {});
    bool any = false;
    for (std::size_t n = 0; n < rung.size(); ++n) {
      if (rung[n].blocked)
        continue;
      if (r == 0) {
        cost[r][n] = startCost[n] + rung[n].cost;
        here[n] = rung[n].q;
      } else {
        // The nearest turns first: what they cost bounds the search through the others.
        for (int turn = 0; turn <= 2 * reach; ++turn) {
          const int k = turn % 2 == 0 ? turn / 2 : -(turn + 1) / 2;
          const int sample =
              ((rung[n].sample + k) % options.samples + options.samples) % options.samples;
          for (const int m : bySample[static_cast<std::size_t>(sample)]) {
            const auto from = static_cast<std::size_t>(m);
            if (std::abs(rungs[r - 1][from].aside - rung[n].aside) > options.asideWindow)
              continue;
            const double soFar = cost[r - 1][from] + rung[n].cost;
            if (soFar >= cost[r][n])
              continue;
            const double total = soFar + step(before[from], rung[n].q, limits,
                                              options.maxStepRad[r], cost[r][n] - soFar);
            if (total < cost[r][n]) {
              cost[r][n] = total;
              parent[r][n] = m;
            }
          }
        }
        if (parent[r][n] >= 0)
          here[n] = nearestTurns(before[static_cast<std::size_t>(parent[r][n])], rung[n].q, limits,
                                 options.maxStepRad[r]);
      }
      any = any || cost[r][n] < kInfinity;
    }
    if (!any)
      break;
    way.reached = r + 1;
    before.swap(here);
    for (auto& nodes : bySample)
      nodes.clear();
    for (std::size_t n = 0; n < rung.size(); ++n)
      if (cost[r][n] < kInfinity)
        bySample[static_cast<std::size_t>(rung[n].sample)].push_back(static_cast<int>(n));
  }
  if (way.reached == 0)
    return way;

  const std::vector<double>& last = cost[way.reached - 1];
  const auto best = std::min_element(last.begin(), last.end());
  way.cost = *best;
  way.node.resize(way.reached);
  way.q.resize(way.reached);
  int n = static_cast<int>(best - last.begin());
  for (std::size_t r = way.reached; r-- > 0;) {
    way.node[r] = n;
    n = parent[r][static_cast<std::size_t>(n)];
  }
  for (std::size_t r = 0; r < way.reached; ++r) {
    const robot::JointVector& q = rungs[r][static_cast<std::size_t>(way.node[r])].q;
    way.q[r] = r == 0 ? q : nearestTurns(way.q[r - 1], q, limits, options.maxStepRad[r]);
  }
  return way;
}

} // namespace voluta::motion
