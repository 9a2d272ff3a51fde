#include "curved/reverse_growth.h"

#include "curved/cut_voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr float kBehind = 4.0f;      // cells
constexpr std::size_t kFewPer = 200; // one voxel in so many may hang back: a fit smooths that out

class Peeler {
public:
  Peeler(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
         const std::vector<float>& guide, const PeelOptions& options, const base::RunContext& ctx)
      : graph_(graph), guide_(guide), options_(options), ctx_(ctx), front_(graph),
        present_(graph.size(), 0), removedIn_(graph.size(), 0), lockedIn_(graph.size(), 0),
        candidateIn_(graph.size(), 0) {
    const Flood reached = flood(graph, use, guide, guide.empty() ? 1.0f : 1e-3f, ctx);
    order_ = reached.order;
    out_.rank.assign(graph.size(), 0);
    out_.given.assign(graph.size(), 0);
    out_.level.assign(guide.empty() ? 0 : graph.size(), std::numeric_limits<float>::infinity());
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (order_[v] >= 0) {
        present_[v] = 1;
        front_.insert(v);
      }
    front_.rebuild();
  }

  Peeling run() {
    start_ = std::max<std::size_t>(1, front_.count());
    if (!guide_.empty())
      lowerLevels();
    while (front_.count() > 0) {
      reportProgress();
      if (round(options_.sheet, options_.tolerance) || goOnWhenStuck())
        continue;
      break;
    }
    out_.remaining = front_.count();
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (removedIn_[v] > 0 && !out_.given[v] && !present_[v])
        out_.rank[v] = removedIn_[v];
    turnRound();
    return std::move(out_);
  }

private:
  void reportProgress() const {
    ctx_.report(1.0 - static_cast<double>(front_.count()) / static_cast<double>(start_), "growth");
  }

  void lowerLevels() {
    float highest = 0.0f;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (present_[v])
        highest = std::max(highest, guide_[v]);
    const auto step = static_cast<float>(options_.levelStep);
    for (level_ = highest - step; level_ > -step && front_.count() > 0; level_ -= step) {
      reportProgress();
      round(options_.sheet, options_.tolerance);
      freeWhatHangsBack();
    }
    level_ = 0.0f;
  }

  // Voxels that stay behind the level would end up in one thick layer at the bottom. Where their
  // number does not fall they hang on one another's support: another order of support frees them.
  void freeWhatHangsBack() {
    std::size_t behind = 0;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      behind += present_[v] && guide_[v] > level_ + kBehind;
    const bool stuck = behind > start_ / kFewPer && behind >= behind_;
    behind_ = behind;
    if (!stuck)
      return;
    order_ = flood(graph_, present_, {}, 1.0f, ctx_).order;
    if (!round(options_.sheet, options_.tolerance) && options_.stuckTolerance > options_.tolerance)
      round(options_.sheet + 0.5, options_.stuckTolerance);
  }

  // Tells whether anything was peeled.
  bool round(double sheet, double tolerance) {
    ctx_.checkpoint();
    ++round_;
    const auto above = [&](std::size_t v) { return guide_.empty() || guide_[v] > level_; };
    front_.nearSurface(sheet, above, candidates_);
    for (const std::int32_t v : candidates_)
      candidateIn_[static_cast<std::size_t>(v)] = round_;
    std::sort(candidates_.begin(), candidates_.end(), [&](std::int32_t a, std::int32_t b) {
      return order_[static_cast<std::size_t>(a)] > order_[static_cast<std::size_t>(b)];
    });
    taken_.clear();
    for (const std::int32_t v : candidates_)
      if (supportAllows(static_cast<std::size_t>(v))) {
        const auto x = static_cast<std::size_t>(v);
        taken_.push_back(v);
        removedIn_[x] = round_;
        front_.remove(x);
      }
    if (taken_.empty())
      return false;
    front_.rebuild();
    std::size_t hint = 0, peeled = 0;
    for (const std::int32_t v : taken_) {
      const auto x = static_cast<std::size_t>(v);
      if (front_.deeperThan(x, tolerance, hint)) {
        removedIn_[x] = 0;
        front_.insert(x);
        continue;
      }
      if (tolerance > options_.tolerance && front_.deeperThan(x, options_.tolerance, hint))
        ++out_.relaxed;
      take(x);
      ++peeled;
    }
    return peeled > 0;
  }

  void take(std::size_t v) {
    present_[v] = 0;
    removedIn_[v] = round_;
    if (!guide_.empty())
      out_.level[v] = std::min(guide_[v], level_);
  }

  // Every neighbour that was reached later, also one taken in this round (it may be put back),
  // must keep another earlier neighbour; that one is locked for the round.
  bool supportAllows(std::size_t v) {
    if (lockedIn_[v] == round_)
      return false;
    locks_.clear();
    for (const std::int32_t w : graph_.neighbour[v]) {
      if (w < 0)
        continue;
      const auto x = static_cast<std::size_t>(w);
      if (!present_[x] || order_[x] < order_[v] || graph_.onPlatform[x])
        continue;
      std::int32_t best = -1;
      int bestMerit = -1;
      for (const std::int32_t u : graph_.neighbour[x]) {
        if (u < 0)
          continue;
        const auto y = static_cast<std::size_t>(u);
        if (y == v || !present_[y] || removedIn_[y] == round_ || order_[y] > order_[x])
          continue;
        const int merit = lockedIn_[y] == round_ ? 2 : candidateIn_[y] != round_ ? 1 : 0;
        if (merit > bestMerit) {
          bestMerit = merit;
          best = u;
        }
      }
      if (best < 0)
        return false;
      locks_.push_back(best);
    }
    for (const std::int32_t u : locks_)
      lockedIn_[static_cast<std::size_t>(u)] = round_;
    return true;
  }

  bool goOnWhenStuck() {
    // Another order of support may open a loop elsewhere.
    order_ = flood(graph_, present_, {}, 1.0f, ctx_).order;
    if (round(options_.sheet, options_.tolerance))
      return true;
    if (options_.stuckTolerance > options_.tolerance &&
        round(options_.sheet + 0.5, options_.stuckTolerance))
      return true;
    return options_.sacrifice && sacrificeLeast();
  }

  // Lays the voxel on the front on which the fewest others hang, and gives those up.
  bool sacrificeLeast() {
    const std::vector<std::int32_t> loss = lossWithout(graph_, present_);
    front_.nearSurface(
        0.0, [](std::size_t) { return true; }, candidates_);
    std::int32_t best = -1;
    for (const std::int32_t v : candidates_) {
      const auto x = static_cast<std::size_t>(v);
      const auto key = [&](std::size_t a) { return std::pair(loss[a], -order_[a]); };
      if (best < 0 || key(x) < key(static_cast<std::size_t>(best)))
        best = v;
    }
    if (best < 0)
      return false;
    ++round_;
    const auto x = static_cast<std::size_t>(best);
    front_.remove(x);
    take(x);
    if (loss[x] > 0) {
      const Flood rest = flood(graph_, present_, {}, 1.0f, ctx_);
      for (std::size_t v = 0; v < graph_.size(); ++v)
        if (present_[v] && rest.order[v] < 0) {
          present_[v] = 0;
          front_.remove(v);
          out_.given[v] = 1;
          ++out_.givenUp;
        }
    }
    front_.rebuild();
    order_ = flood(graph_, present_, {}, 1.0f, ctx_).order;
    return true;
  }

  // Ranks count from the platform; rounds that peeled nothing leave no gap.
  void turnRound() {
    std::vector<std::int32_t> rankOf(static_cast<std::size_t>(round_) + 1, 0);
    for (const std::int32_t r : out_.rank)
      if (r > 0)
        rankOf[static_cast<std::size_t>(r)] = 1;
    for (std::size_t r = rankOf.size(); r-- > 0;)
      if (rankOf[r] > 0)
        rankOf[r] = ++out_.ranks;
    for (std::int32_t& r : out_.rank)
      r = r > 0 ? rankOf[static_cast<std::size_t>(r)] : 0;
  }

  const VoxelGraph& graph_;
  const std::vector<float>& guide_;
  const PeelOptions& options_;
  const base::RunContext& ctx_;
  ConvexFront front_;
  std::vector<std::uint8_t> present_;
  std::vector<std::int32_t> order_;
  std::vector<std::int32_t> removedIn_, lockedIn_, candidateIn_; // round
  std::vector<std::int32_t> candidates_, taken_, locks_;
  std::int32_t round_ = 0;
  std::size_t start_ = 1, behind_ = 0;
  float level_ = 0.0f;
  Peeling out_;
};

} // namespace

Peeling peel(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
             const std::vector<float>& guide, const PeelOptions& options,
             const base::RunContext& ctx) {
  return Peeler(graph, use, guide, options, ctx).run();
}

Peeling peelAll(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
                const std::vector<float>& guide, const PeelOptions& options,
                const base::RunContext& ctx) {
  std::vector<std::uint8_t> kept = use.empty() ? std::vector<std::uint8_t>(graph.size(), 1) : use;
  std::vector<std::uint8_t> given(graph.size(), 0);
  constexpr int kMostRuns = 12;
  for (int run = 1;; ++run) {
    Peeling result = peel(graph, kept, guide, options,
                          ctx.sub(1.0 - std::pow(0.5, run - 1), 1.0 - std::pow(0.5, run)));
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (result.given[v]) {
        given[v] = 1;
        kept[v] = 0;
      }
    if (result.givenUp > 0 && run < kMostRuns)
      continue;
    if (result.givenUp > 0) {
      // What stood on what was given up falls too; the rest keeps its order.
      std::vector<std::vector<std::int32_t>> byRank(static_cast<std::size_t>(result.ranks) + 1);
      for (std::size_t v = 0; v < graph.size(); ++v)
        byRank[static_cast<std::size_t>(result.rank[v])].push_back(static_cast<std::int32_t>(v));
      for (std::size_t r = 1; r < byRank.size(); ++r)
        for (const std::int32_t v : byRank[r]) {
          const auto x = static_cast<std::size_t>(v);
          bool supported = graph.onPlatform[x] != 0;
          for (const std::int32_t u : graph.neighbour[x])
            supported |= u >= 0 && result.rank[static_cast<std::size_t>(u)] > 0 &&
                         result.rank[static_cast<std::size_t>(u)] < result.rank[x];
          if (!supported) {
            result.rank[x] = 0;
            given[x] = 1;
          }
        }
    }
    result.given = given;
    result.givenUp = static_cast<std::size_t>(std::count(given.begin(), given.end(), 1));
    return result;
  }
}

} // namespace voluta::curved
