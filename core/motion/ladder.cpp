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
double step(const double* from, const robot::JointVector& to,
            const std::vector<robot::JointLimits>& limits, double maxStep, double most) {
  double sum = 0.0;
  const auto count = static_cast<Eigen::Index>(limits.size());
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto& limit = limits[static_cast<std::size_t>(j)];
    double d = robot::asTurn(limit.kind, to[j] - from[j]);
    if (std::abs(d) > maxStep) {
      // Most candidates of another branch end here: no whole turn brings them nearer.
      if (limit.kind == robot::JointKind::Sliding || std::abs(d) < base::kTurn - maxStep)
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

// The reached nodes of the rung before, those of one sample side by side, the cheapest first: what
// the search through them reads lies together, and it ends where the rest costs too much already.
class Reached {
public:
  Reached(int samples, std::size_t joints)
      : joints_(joints), first_(static_cast<std::size_t>(samples) + 1, 0) {}

  struct Node {
    int index, aside, side;
    double cost;
  };

  // `q` as `rung`: joints by whole turns as they were reached.
  void take(const Rung& rung, const std::vector<robot::JointVector>& q,
            const std::vector<double>& cost) {
    std::fill(first_.begin(), first_.end(), 0);
    const auto slot = [&](std::size_t n) { return static_cast<std::size_t>(rung[n].sample); };
    for (std::size_t n = 0; n < rung.size(); ++n)
      if (cost[n] < kInfinity)
        ++first_[slot(n) + 1];
    for (std::size_t s = 1; s < first_.size(); ++s)
      first_[s] += first_[s - 1];
    nodes_.resize(first_.back());
    q_.resize(first_.back() * joints_);
    fill_.assign(first_.begin(), first_.end() - 1);
    for (std::size_t n = 0; n < rung.size(); ++n)
      if (cost[n] < kInfinity) {
        std::size_t at = fill_[slot(n)]++;
        for (; at > first_[slot(n)] && nodes_[at - 1].cost > cost[n]; --at)
          nodes_[at] = nodes_[at - 1];
        nodes_[at] = {static_cast<int>(n), rung[n].aside, rung[n].side, cost[n]};
      }
    for (std::size_t at = 0; at < nodes_.size(); ++at)
      std::copy_n(q[static_cast<std::size_t>(nodes_[at].index)].data(), joints_,
                  q_.begin() + static_cast<std::ptrdiff_t>(at * joints_));
  }
  // Places of the nodes of a sample: from begin to end.
  std::size_t begin(int sample) const { return first_[static_cast<std::size_t>(sample)]; }
  std::size_t end(int sample) const { return first_[static_cast<std::size_t>(sample) + 1]; }
  const Node& node(std::size_t at) const { return nodes_[at]; }
  const double* joints(std::size_t at) const { return q_.data() + at * joints_; }

private:
  std::size_t joints_;
  std::vector<std::size_t> first_, fill_; // per sample
  std::vector<Node> nodes_;
  std::vector<double> q_;
};

} // namespace

LadderWay shortestWay(const std::vector<Rung>& rungs, const std::vector<LadderStart>& starts,
                      const std::vector<robot::JointLimits>& limits, const LadderOptions& options) {
  LadderWay way;
  if (rungs.empty())
    return way;
  base::require(starts.size() == rungs.front().size(), "a start for each first node");
  base::require(options.maxStepRad.size() == rungs.size(), "a largest step for each rung");

  std::vector<std::vector<double>> cost(rungs.size());
  std::vector<std::vector<int>> parent(rungs.size());
  std::vector<robot::JointVector> here, before;
  Reached reached(options.samples, limits.size());
  // All turns are neighbours where the window spans the circle.
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
        cost[r][n] = starts[n].cost + rung[n].cost;
        here[n] = starts[n].q;
      } else {
        double least = kInfinity;
        // The nearest turns first: what they cost bounds the search through the others.
        for (int turn = 0; turn <= 2 * reach; ++turn) {
          const int k = turn % 2 == 0 ? turn / 2 : -(turn + 1) / 2;
          int sample = rung[n].sample + k;
          sample += sample < 0 ? options.samples : sample >= options.samples ? -options.samples : 0;
          for (std::size_t m = reached.begin(sample); m < reached.end(sample); ++m) {
            const Reached::Node& from = reached.node(m);
            const double soFar = from.cost + rung[n].cost;
            if (soFar >= least)
              break;
            if (std::abs(from.aside - rung[n].aside) > options.asideWindow ||
                from.side * rung[n].side < 0)
              continue;
            const double total = soFar + step(reached.joints(m), rung[n].q, limits,
                                              options.maxStepRad[r], least - soFar);
            if (total < least) {
              least = total;
              parent[r][n] = from.index;
            }
          }
        }
        cost[r][n] = least;
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
    reached.take(rung, before, cost[r]);
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
  way.q[0] = starts[static_cast<std::size_t>(way.node[0])].q;
  for (std::size_t r = 1; r < way.reached; ++r)
    way.q[r] = nearestTurns(way.q[r - 1], rungs[r][static_cast<std::size_t>(way.node[r])].q, limits,
                            options.maxStepRad[r]);
  return way;
}

} // namespace voluta::motion
