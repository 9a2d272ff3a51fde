#include "motion/ladder/ladder.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace voluta::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Like std::round, without a function call.
double rounded(double x) {
  return static_cast<double>(static_cast<long>(x + (x < 0.0 ? -0.5 : 0.5)));
}

// Returns the L1 step, over the joints with limits, from `from` to the representative of `to`
// nearest to it; infinite if a joint's step exceeds maxStep, a limit is exceeded, or the sum is at
// least `maxCost`.
double step(const double* from, const robot::JointVector& to,
            const std::vector<robot::JointLimits>& limits, double maxStep, double maxCost) {
  double sum = 0.0;
  const auto count = static_cast<Eigen::Index>(limits.size());
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto& limit = limits[static_cast<std::size_t>(j)];
    double d = robot::asAngle(limit.kind, to[j] - from[j]);
    if (std::abs(d) > maxStep) {
      // Most candidates of another IK branch are rejected here: no whole turn brings them nearer.
      if (limit.kind == robot::JointKind::Sliding || std::abs(d) < base::kTwoPi - maxStep)
        return kInfinity;
      d -= base::kTwoPi * rounded(d / base::kTwoPi);
      if (std::abs(d) > maxStep)
        return kInfinity;
      const double q = from[j] + d;
      if (q < limit.min || q > limit.max)
        return kInfinity;
    }
    sum += std::abs(d);
    if (sum >= maxCost)
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
      to[j] = from[j] + d - base::kTwoPi * rounded(d / base::kTwoPi);
  }
  return to;
}

// The sectors of the circle in which the first turning joints are, one bit each. Most pairs of
// nodes belong to different IK branches, which the sectors show immediately.
class Sectors {
public:
  explicit Sectors(const std::vector<robot::JointLimits>& limits) {
    for (std::size_t j = 0; j < std::min(limits.size(), kJoints); ++j)
      turns_[j] = limits[j].kind == robot::JointKind::Turning;
  }

  std::uint64_t of(const double* q) const {
    std::uint64_t bits = 0;
    for (std::size_t j = 0; j < kJoints; ++j)
      if (turns_[j])
        bits |= std::uint64_t{1} << (kCount * j + sectorAt(q[j]) % kCount);
    return bits;
  }
  // Returns the sectors that a step of at most maxStepRad can reach; sliding joints may be
  // anywhere.
  std::uint64_t within(const double* q, double maxStepRad) const {
    constexpr double kRounding = 1e-9;
    constexpr std::uint64_t kAll = (std::uint64_t{1} << kCount) - 1;
    const double reach = maxStepRad + kRounding;
    std::uint64_t bits = 0;
    for (std::size_t j = 0; j < kJoints; ++j)
      if (turns_[j]) {
        const std::uint64_t low = sectorAt(q[j] - reach), high = sectorAt(q[j] + reach);
        const std::uint64_t row =
            high - low >= kCount ? kAll : (kAll >> (kCount - 1 - (high - low))) << low % kCount;
        bits |= ((row | row >> kCount) & kAll) << (kCount * j);
      }
    return bits;
  }

private:
  static constexpr std::size_t kJoints = 6;
  static constexpr std::uint64_t kCount = 10; // Sectors per turn
  // Numbered continuously over several turns, starting below any joint's range.
  static std::uint64_t sectorAt(double q) {
    constexpr double kTurns = 1 << 10;
    return static_cast<std::uint64_t>((q / base::kTwoPi + kTurns) * static_cast<double>(kCount));
  }

  std::array<bool, kJoints> turns_{};
};

// The reached nodes of the previous rung, grouped by sample and sorted by cost: the search reads
// contiguous memory and stops where the remaining nodes are too expensive.
class Reached {
public:
  Reached(int samples, const std::vector<robot::JointLimits>& limits)
      : sectors_(limits), joints_(limits.size()), first_(static_cast<std::size_t>(samples) + 1, 0) {
  }

  struct Node {
    int index, offset, side;
    double cost;
    std::uint64_t sectors;
  };

  // `q`: like `rung`, with joints at the whole turns at which they were reached.
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
        nodes_[at] = {static_cast<int>(n), rung[n].offset, rung[n].side, cost[n],
                      sectors_.of(rung[n].q.data())};
      }
    for (std::size_t at = 0; at < nodes_.size(); ++at)
      std::copy_n(q[static_cast<std::size_t>(nodes_[at].index)].data(), joints_,
                  q_.begin() + static_cast<std::ptrdiff_t>(at * joints_));
  }
  // Range of the nodes of a sample: [begin, end).
  std::size_t begin(int sample) const { return first_[static_cast<std::size_t>(sample)]; }
  std::size_t end(int sample) const { return first_[static_cast<std::size_t>(sample) + 1]; }
  const Node& node(std::size_t at) const { return nodes_[at]; }
  const double* joints(std::size_t at) const { return q_.data() + at * joints_; }
  const Sectors& sectors() const { return sectors_; }

private:
  Sectors sectors_;
  std::size_t joints_;
  std::vector<std::size_t> first_, fill_; // Per sample
  std::vector<Node> nodes_;
  std::vector<double> q_;
};

// Returns the cost of the cheapest path to a node and its predecessor in the previous rung; -1 if
// no path costs at most `maxCost`.
std::pair<double, int> cheapestPath(const LadderNode& node, const Reached& reached,
                                    const std::vector<robot::JointLimits>& limits,
                                    const LadderOptions& options, double maxStepRad,
                                    double maxCost) {
  // If the window spans the circle, all rotations are neighbours.
  const int reach = std::min(options.window, (options.samples - 1) / 2);
  double lowest = std::nextafter(maxCost, kInfinity);
  int parent = -1;
  std::uint64_t near = 0; // Sectors within a step; computed on first use
  // Start with the nearest rotations: their cost bounds the search through the others.
  for (int rank = 0; rank <= 2 * reach; ++rank) {
    const int k = rank % 2 == 0 ? rank / 2 : -(rank + 1) / 2;
    int sample = node.sample + k;
    sample += sample < 0 ? options.samples : sample >= options.samples ? -options.samples : 0;
    const std::size_t end = reached.end(sample);
    std::size_t m = reached.begin(sample);
    if (m < end && near == 0)
      near = reached.sectors().within(node.q.data(), maxStepRad);
    for (; m < end; ++m) {
      const Reached::Node& from = reached.node(m);
      const double soFar = from.cost + node.cost;
      if (soFar >= lowest)
        break;
      if ((from.sectors & ~near) != 0 ||
          std::abs(from.offset - node.offset) > options.offsetWindow || from.side * node.side < 0)
        continue;
      const double total =
          soFar + step(reached.joints(m), node.q, limits, maxStepRad, lowest - soFar);
      if (total < lowest) {
        lowest = total;
        parent = from.index;
      }
    }
  }
  return {parent < 0 ? kInfinity : lowest, parent};
}

// Keeps the cheapest `count` nodes, and those that cost the same as the last of them; the others
// become unreachable.
void keepCheapest(std::vector<double>& cost, std::size_t count, std::vector<double>& scratch) {
  if (cost.size() <= count)
    return;
  scratch = cost;
  const auto last = scratch.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(scratch.begin(), last, scratch.end());
  for (double& c : cost)
    if (c > *last)
      c = kInfinity;
}

// As shortestPath(), restricted to nodes with a path cost of at most `maxCost` and to the `beam`
// cheapest nodes of each rung.
LadderPath sweep(const std::vector<Rung>& rungs, const std::vector<LadderStart>& starts,
                 const std::vector<robot::JointLimits>& limits, const LadderOptions& options,
                 double maxCost, std::size_t beam) {
  LadderPath path;
  std::vector<std::vector<int>> parent(rungs.size());
  std::vector<double> cost, lastCost, scratch;
  std::vector<robot::JointVector> here, before;
  Reached reached(options.samples, limits);
  for (std::size_t r = 0; r < rungs.size(); ++r) {
    const Rung& rung = rungs[r];
    cost.assign(rung.size(), kInfinity);
    parent[r].assign(rung.size(), -1);
    for (std::size_t n = 0; n < rung.size(); ++n) {
      if (rung[n].blocked)
        continue;
      if (r > 0)
        std::tie(cost[n], parent[r][n]) =
            cheapestPath(rung[n], reached, limits, options, options.maxStepRad[r], maxCost);
      else if (const double start = starts[n].cost + rung[n].cost; start <= maxCost)
        cost[n] = start;
    }
    keepCheapest(cost, beam, scratch);
    if (std::ranges::none_of(cost, [](double c) { return c < kInfinity; }))
      break;
    here.resize(rung.size());
    for (std::size_t n = 0; n < rung.size(); ++n)
      if (cost[n] < kInfinity)
        here[n] = r == 0 ? starts[n].q
                         : nearestTurns(before[static_cast<std::size_t>(parent[r][n])], rung[n].q,
                                        limits, options.maxStepRad[r]);
    path.reached = r + 1;
    before.swap(here);
    lastCost.swap(cost);
    reached.take(rung, before, lastCost);
  }
  if (path.reached == 0)
    return path;

  const auto best = std::ranges::min_element(lastCost);
  path.cost = *best;
  path.node.resize(path.reached);
  path.q.resize(path.reached);
  int n = static_cast<int>(best - lastCost.begin());
  for (std::size_t r = path.reached; r-- > 0;) {
    path.node[r] = n;
    n = parent[r][static_cast<std::size_t>(n)];
  }
  path.q[0] = starts[static_cast<std::size_t>(path.node[0])].q;
  for (std::size_t r = 1; r < path.reached; ++r)
    path.q[r] = nearestTurns(path.q[r - 1], rungs[r][static_cast<std::size_t>(path.node[r])].q,
                             limits, options.maxStepRad[r]);
  return path;
}

} // namespace

LadderPath shortestPath(const std::vector<Rung>& rungs, const std::vector<LadderStart>& starts,
                        const std::vector<robot::JointLimits>& limits,
                        const LadderOptions& options) {
  if (rungs.empty())
    return {};
  base::require(starts.size() == rungs.front().size(), "a start for each first node");
  base::require(options.maxStepRad.size() == rungs.size(), "a largest step for each rung");

  // The cost of a path through few nodes is an upper bound: nodes that cost more need no search.
  constexpr std::size_t kBeam = 16, kAll = std::numeric_limits<std::size_t>::max();
  const LadderPath quick = sweep(rungs, starts, limits, options, kInfinity, kBeam);
  if (quick.reached < rungs.size())
    return sweep(rungs, starts, limits, options, kInfinity, kAll);
  LadderPath path = sweep(rungs, starts, limits, options, quick.cost, kAll);
  // The cheapest path to a node may have wound a joint up to its limit, where a more expensive one
  // can continue.
  return path.reached < rungs.size() ? quick : path;
}

} // namespace voluta::motion
