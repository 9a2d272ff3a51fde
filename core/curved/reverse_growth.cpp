#include "curved/reverse_growth.h"

#include "base/parallel.h"
#include "curved/cut_voxels.h"
#include "curved/nozzle_reach.h"
#include "curved/support_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace voluta::curved {

namespace {

// Guided: a voxel that has waited for more than kLate levels is late; cells by which it may be
// deeper for each further level, and the maximum.
constexpr double kLate = 1.0, kEasedPerCell = 0.25, kMaxEased = 0.75;

// If peeling is stuck: distances are recomputed once this share of the voxels was removed since the
// last time; otherwise at most kRerouted voxels get new distances.
constexpr std::size_t kStale = 32, kRerouted = 256;

class Peeler {
public:
  Peeler(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
         const std::vector<float>& guide, const std::vector<std::int32_t>& order,
         const PeelOptions& options, const base::RunContext& ctx)
      : graph_(graph), guide_(guide), options_(options), ctx_(ctx), front_(graph),
        present_(presentAtFirst(graph, use)),
        support_(order.empty() ? SupportOrder(graph, present_, ctx)
                               : SupportOrder(graph, present_, order, ctx)),
        deepest_(lookedFor(options)), cuts_(graph), removedIn_(graph.size(), 0) {
    out_.deepest = options.tolerance;
    out_.rank.assign(graph.size(), 0);
    out_.given.assign(graph.size(), 0);
    out_.level.assign(guide.empty() ? 0 : graph.size(), std::numeric_limits<float>::infinity());
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (present_[v])
        front_.insert(v);
    front_.rebuild();
  }

  Peeling run() {
    start_ = std::max<std::size_t>(1, front_.count());
    if (!guide_.empty())
      lowerLevels();
    while (front_.count() > 0 && isWanted()) {
      reportProgress();
      if (round(options_.sheet, options_.tolerance) || peelFrontOnly() || goOnWhenStuck())
        continue;
      break;
    }
    out_.remaining = front_.count();
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (removedIn_[v] > 0 && !out_.given[v] && !present_[v])
        out_.rank[v] = removedIn_[v];
    reverseOrder();
    return std::move(out_);
  }

private:
  static std::vector<std::uint8_t> presentAtFirst(const VoxelGraph& graph,
                                                  const std::vector<std::uint8_t>& use) {
    return use.empty() ? std::vector<std::uint8_t>(graph.size(), 1) : use;
  }

  void reportProgress() const {
    ctx_.report(1.0 - static_cast<double>(front_.count()) / static_cast<double>(start_),
                "growth"_text);
  }

  bool isWanted() const { return !options_.superseded || !options_.superseded->cancelled(); }

  void lowerLevels() {
    float highest = 0.0f;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (present_[v])
        highest = std::max(highest, guide_[v]);
    const auto step = static_cast<float>(options_.levelStep);
    // per round; may be one round early because of rounding
    std::vector<std::vector<std::int32_t>> passed;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (present_[v]) {
        const auto at = static_cast<std::size_t>(
            std::max(0.0f, std::floor((highest - guide_[v]) / step) - 1.0f));
        passed.resize(std::max(passed.size(), at + 1));
        passed[at].push_back(static_cast<std::int32_t>(v));
      }
    std::size_t next = 0;
    for (level_ = highest - step; level_ > -step && front_.count() > 0 && isWanted();
         level_ -= step, ++next) {
      reportProgress();
      if (next < passed.size())
        waiting_.insert(waiting_.end(), passed[next].begin(), passed[next].end());
      round(options_.sheet, options_.tolerance);
    }
    level_ = 0.0f;
  }

  // A voxel that stays behind the level blocks all voxels that support it, often for a fraction of
  // a cell: the longer it waits, the deeper it may be.
  double toleranceOf(std::size_t v, double tolerance) const {
    if (guide_.empty())
      return tolerance;
    const double allowed =
        options_.allowance.empty() ? tolerance : tolerance + options_.allowance[v];
    const double late = static_cast<double>(guide_[v] - level_) - kLate;
    if (!options_.eases || late <= 0.0)
      return allowed;
    return std::max(allowed, std::min(tolerance + kEasedPerCell * late, kMaxEased));
  }

  bool allowed(std::size_t v) const {
    return !options_.allowance.empty() && options_.allowance[v] > 0.0f;
  }

  // Guided: depth below the front to which voxels are searched: a sheet, or deeper for voxels that
  // are late or have an allowance.
  static double lookedFor(const PeelOptions& options) {
    double maximum = std::max(options.sheet, options.eases ? kMaxEased : 0.0);
    for (const float allowed : options.allowance)
      if (allowed > 0.0f)
        maximum = std::max(maximum, options.tolerance + allowed);
    return maximum;
  }

  // Returns whether anything was peeled.
  bool round(double sheet, double tolerance) {
    ctx_.checkpoint();
    ++round_;
    proposed_.clear();
    if (laysInside(tolerance)) {
      proposeNear(sheet);
    } else {
      lookAtFront();
      front_.nearRemovable(
          sheet, [&](std::size_t v) { return late(v) && support_.allows(v); }, candidates_);
      candidates_.insert(candidates_.end(), onFront_.begin(), onFront_.end());
      sortOut(candidates_);
      propose(candidates_);
      front_.nearRemoved(sheet, candidates_);
      propose(candidates_);
    }
    if (proposed_.empty())
      return false;
    front_.rebuild();
    shadowed_.resize(proposed_.size());
    base::parallelChunks(ctx_, proposed_.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin, hint = 0; i < end; ++i)
        shadowed_[i] =
            front_.deeperThan(static_cast<std::size_t>(proposed_[i]),
                              toleranceOf(static_cast<std::size_t>(proposed_[i]), tolerance), hint)
                ? 1
                : 0;
    });
    std::size_t hint = 0, peeled = 0;
    for (std::size_t i = 0; i < proposed_.size(); ++i) {
      const auto x = static_cast<std::size_t>(proposed_[i]);
      if (shadowed_[i]) {
        support_.putBack(x);
        front_.insert(x);
        continue;
      }
      if (tolerance > options_.tolerance && front_.deeperThan(x, options_.tolerance, hint))
        noteRelaxed(x);
      take(x);
      ++peeled;
    }
    return peeled > 0;
  }

  // Removes the removable voxels on the front itself, for good. Returns whether any was removed.
  bool peelFrontOnly() {
    if (laysInside(options_.tolerance))
      return false;
    ++round_;
    lookAtFront();
    proposed_.clear();
    propose(onFront_);
    for (const std::int32_t v : proposed_)
      take(static_cast<std::size_t>(v));
    front_.rebuild();
    return !proposed_.empty();
  }

  // Returns whether some voxels may be inside the front.
  bool laysInside(double tolerance) const {
    return tolerance > 0.0 || options_.eases || !options_.allowance.empty();
  }

  bool late(std::size_t v) const { return guide_.empty() || guide_[v] > level_; }

  // Removes the removable candidates tentatively, farthest from the platform first.
  void propose(std::vector<std::int32_t>& candidates) {
    sortByDistance(candidates);
    for (const std::int32_t v : candidates) {
      const auto x = static_cast<std::size_t>(v);
      if (!late(x) || !support_.allows(x))
        continue;
      proposed_.push_back(v);
      support_.lift(x);
      front_.remove(x);
    }
  }

  // Proposes all voxels near the front, whether or not those on the front can be removed.
  void proposeNear(double sheet) {
    if (guide_.empty())
      front_.nearSurface(sheet, candidates_);
    else
      gatherWaiting(sheet);
    propose(candidates_);
  }

  // Candidates among the voxels that the level has passed. These are few, so each is checked for
  // being near the front.
  void gatherWaiting(double sheet) {
    std::erase_if(waiting_, [&](std::int32_t v) { return !present_[static_cast<std::size_t>(v)]; });
    candidates_.clear();
    std::size_t hint = 0;
    for (const std::int32_t v : waiting_) {
      const auto x = static_cast<std::size_t>(v);
      if (late(x) && front_.isNearSurface(x, deepest_) && support_.allows(x) &&
          (guide_[x] - level_ > kLate || allowed(x) || !front_.deeperThan(x, sheet, hint)))
        candidates_.push_back(v);
    }
  }

  // Brings onFront_ up to date.
  void lookAtFront() {
    front_.onNewFacets(candidates_);
    onFront_.insert(onFront_.end(), candidates_.begin(), candidates_.end());
    onFront_.erase(
        std::remove_if(onFront_.begin(), onFront_.end(),
                       [&](std::int32_t v) { return !present_[static_cast<std::size_t>(v)]; }),
        onFront_.end());
    sortOut(onFront_);
  }

  static void sortOut(std::vector<std::int32_t>& voxels) {
    std::sort(voxels.begin(), voxels.end());
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  }

  void sortByDistance(std::vector<std::int32_t>& voxels) const {
    std::sort(voxels.begin(), voxels.end(), [&](std::int32_t a, std::int32_t b) {
      return support_.later(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    });
  }

  void noteRelaxed(std::size_t v) {
    ++out_.relaxed;
    out_.deepest = std::max(out_.deepest, front_.depth(v));
  }

  void take(std::size_t v) {
    present_[v] = 0;
    if (reach_)
      reach_->remove(v);
    support_.drop(v);
    removedIn_[v] = round_;
    if (!guide_.empty())
      out_.level[v] = std::min(guide_[v], level_ + static_cast<float>(options_.levelSlack));
  }

  // Collects the at most `many` voxels that are cut off from the platform without `cut`.
  void gatherLoss(std::size_t cut, std::size_t many) {
    loss_.clear();
    ++visit_;
    visitedIn_.resize(graph_.size(), 0);
    visitedIn_[cut] = visit_;
    for (const std::int32_t first : graph_.neighbour[cut]) {
      if (first < 0 || !present_[static_cast<std::size_t>(first)] ||
          visitedIn_[static_cast<std::size_t>(first)] == visit_)
        continue;
      const std::size_t begin = loss_.size();
      bool grounded = false;
      const auto reach = [&](std::int32_t v) {
        visitedIn_[static_cast<std::size_t>(v)] = visit_;
        loss_.push_back(v);
        grounded |= graph_.onPlatform[static_cast<std::size_t>(v)] != 0;
      };
      reach(first);
      for (std::size_t i = begin; i < loss_.size() && !grounded && loss_.size() <= many; ++i)
        for (const std::int32_t w : graph_.neighbour[static_cast<std::size_t>(loss_[i])])
          if (w >= 0 && present_[static_cast<std::size_t>(w)] &&
              visitedIn_[static_cast<std::size_t>(w)] != visit_)
            reach(w);
      if (grounded || loss_.size() > many)
        loss_.resize(begin);
    }
  }

  // If peeling is stuck, each voxel on the front is the last support of another. First checks
  // whether that is due to outdated distances only, then whether the voxels that rest on one could
  // rest on others nearby: usually this opens a loop, and nothing is lost. Otherwise removes the
  // voxel that supports the fewest others.
  bool goOnWhenStuck() {
    front_.nearSurface(0.0, candidates_);
    if (candidates_.empty())
      return false;
    if ((support_.remaining().size() - front_.count()) * kStale > front_.count()) {
      support_.flood(ctx_);
      return true;
    }
    if (takeRerouted())
      return true;
    cuts_.find(present_, support_.remaining());
    const auto loss = [&](std::size_t v) { return cuts_.lossWithout(v); };
    const auto best = *std::min_element(
        candidates_.begin(), candidates_.end(), [&](std::int32_t a, std::int32_t b) {
          const auto x = static_cast<std::size_t>(a), y = static_cast<std::size_t>(b);
          return loss(x) != loss(y) ? loss(x) < loss(y) : support_.later(x, y);
        });
    const auto cut = static_cast<std::size_t>(best);
    gatherLoss(cut, static_cast<std::size_t>(loss(cut)));
    if (!loss_.empty()) {
      if (!options_.relaxSheets && relaxLoss())
        return true;
      support_.flood(ctx_);
      if (round(options_.sheet, options_.tolerance) || relaxSheet() || relaxLoss() || reachLoss())
        return true;
      if (!options_.sacrifice)
        return false;
    }
    ++round_;
    front_.remove(cut);
    take(cut);
    for (const std::int32_t v : loss_) {
      const auto x = static_cast<std::size_t>(v);
      present_[x] = 0;
      if (reach_)
        reach_->remove(x);
      front_.remove(x);
      out_.given[x] = 1;
      ++out_.abandoned;
    }
    front_.rebuild();
    support_.flood(ctx_);
    return true;
  }

  // Removes candidates, no two of them adjacent, if all voxels that rest on them can rest on
  // others. With relaxSheets, where fewer relaxed and missed voxels count more than time, only the
  // first.
  bool takeRerouted() {
    sortByDistance(candidates_);
    ++round_;
    bool any = false;
    for (const std::int32_t v : candidates_) {
      const auto x = static_cast<std::size_t>(v);
      const auto& beside = graph_.neighbour[x];
      if (std::any_of(beside.begin(), beside.end(), [&](std::int32_t w) {
            return w >= 0 && removedIn_[static_cast<std::size_t>(w)] == round_;
          }))
        continue;
      present_[x] = 0;
      if (!support_.reroute(x, kRerouted)) {
        present_[x] = 1;
        continue;
      }
      front_.remove(x);
      take(x);
      any = true;
      if (options_.relaxSheets)
        break;
    }
    if (any)
      front_.rebuild();
    return any;
  }

  bool relaxSheet() {
    return options_.relaxSheets && options_.stuckTolerance > options_.tolerance &&
           round(options_.sheet + 0.5, options_.stuckTolerance);
  }

  // Peels the voxels that rest on one voxel although they are inside the front, those nearest to it
  // last. Returns false and changes nothing if some of them are too deep.
  bool relaxLoss() {
    constexpr std::size_t kMax = 64;
    if (options_.stuckTolerance <= options_.tolerance || loss_.size() > kMax)
      return false;
    for (const std::int32_t v : loss_)
      front_.remove(static_cast<std::size_t>(v));
    front_.rebuild();
    std::size_t hint = 0;
    const bool shallow = std::none_of(loss_.begin(), loss_.end(), [&](std::int32_t v) {
      return front_.deeperThan(static_cast<std::size_t>(v), options_.stuckTolerance, hint);
    });
    if (!shallow) {
      for (const std::int32_t v : loss_)
        front_.insert(static_cast<std::size_t>(v));
      front_.rebuild();
      return false;
    }
    // Reverse breadth-first order from the voxel that supports them: each is printed after its
    // support.
    for (std::size_t i = loss_.size(); i-- > 0;) {
      ++round_;
      const auto x = static_cast<std::size_t>(loss_[i]);
      if (front_.deeperThan(x, options_.tolerance, hint))
        noteRelaxed(x);
      support_.lift(x);
      take(x);
    }
    return true;
  }

  // Peels the voxels that rest on one voxel as long as the head is clear of all earlier material,
  // those nearest to it last.
  bool reachLoss() {
    if (options_.head == nullptr)
      return false;
    if (!reach_) {
      reach_.emplace(graph_, *options_.head);
      for (std::size_t v = 0; v < graph_.size(); ++v)
        if (present_[v])
          reach_->insert(v);
      out_.headDirection.assign(graph_.size(), Eigen::Vector3f::Zero());
    }
    bool any = false;
    for (std::size_t i = loss_.size(); i-- > 0;) {
      ctx_.checkpoint();
      const auto x = static_cast<std::size_t>(loss_[i]);
      const std::optional<Eigen::Vector3d> direction =
          reach_->direction(x, front_.clearNormal(x, Eigen::Vector3d::UnitZ()));
      if (!direction)
        break;
      ++round_;
      front_.remove(x);
      take(x);
      out_.headDirection[x] = direction->cast<float>();
      ++out_.byHead;
      any = true;
    }
    if (any) {
      front_.rebuild();
      support_.flood(ctx_);
    }
    return any;
  }

  // Reverses the order: ranks count from the platform, without gaps for rounds that peeled nothing.
  void reverseOrder() {
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
  std::optional<NozzleReach> reach_;
  std::vector<std::uint8_t> present_;
  SupportOrder support_;
  double deepest_;                    // guided: depth below the front to which voxels are searched
  std::vector<std::int32_t> waiting_; // guided: present voxels that the level has passed, or nearly
  CutVoxels cuts_;
  std::vector<std::int32_t> removedIn_; // round
  std::vector<std::int32_t> onFront_;   // on the front at the last update and not removed then
  std::vector<std::int32_t> candidates_, proposed_, loss_;
  std::vector<std::uint8_t> shadowed_; // per proposed voxel
  std::vector<std::uint32_t> visitedIn_;
  std::uint32_t visit_ = 0;
  std::int32_t round_ = 0;
  std::size_t start_ = 1;
  float level_ = 0.0f;
  Peeling out_;
};

// Drops voxels that rested on given-up ones; the rest keeps its order.
std::size_t dropUnsupported(const VoxelGraph& graph, Peeling& peeling) {
  std::vector<std::vector<std::int32_t>> byRank(static_cast<std::size_t>(peeling.ranks) + 1);
  for (std::size_t v = 0; v < graph.size(); ++v)
    byRank[static_cast<std::size_t>(peeling.rank[v])].push_back(static_cast<std::int32_t>(v));
  std::size_t fallen = 0;
  for (std::size_t r = 1; r < byRank.size(); ++r)
    for (const std::int32_t v : byRank[r]) {
      const auto x = static_cast<std::size_t>(v);
      bool supported = graph.onPlatform[x] != 0;
      for (const std::int32_t u : graph.neighbour[x])
        supported |= u >= 0 && peeling.rank[static_cast<std::size_t>(u)] > 0 &&
                     peeling.rank[static_cast<std::size_t>(u)] < peeling.rank[x];
      if (supported)
        continue;
      peeling.rank[x] = 0;
      peeling.given[x] = 1;
      ++fallen;
    }
  return fallen;
}

} // namespace

Peeling peel(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
             const PeelOptions& options, const base::RunContext& ctx) {
  return Peeler(graph, use, {}, {}, options, ctx).run();
}

Peeling peelGuided(const VoxelGraph& graph, const std::vector<float>& guide,
                   const std::vector<std::int32_t>& order, const PeelOptions& options,
                   const base::RunContext& ctx) {
  return Peeler(graph, {}, guide, order, options, ctx).run();
}

Peeling peelAll(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
                const PeelOptions& options, const base::RunContext& ctx) {
  std::vector<std::uint8_t> kept = use.empty() ? std::vector<std::uint8_t>(graph.size(), 1) : use;
  std::vector<std::uint8_t> given(graph.size(), 0);
  Peeling best;
  std::size_t abandoned = 0;
  for (int run = 1; run <= options.runs; ++run) {
    Peeling result =
        peel(graph, kept, options, ctx.sub(1.0 - std::pow(0.5, run - 1), 1.0 - std::pow(0.5, run)));
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (result.given[v]) {
        given[v] = 1;
        kept[v] = 0;
      }
    abandoned += result.abandoned;
    result.fallen = result.abandoned == 0 ? 0 : dropUnsupported(graph, result);
    result.abandoned = abandoned + result.fallen;
    const bool settled = result.fallen == 0;
    if (best.rank.empty() || result.abandoned < best.abandoned) {
      for (std::size_t v = 0; v < graph.size(); ++v)
        result.given[v] |= given[v];
      best = std::move(result);
    }
    if (settled)
      break;
  }
  return best;
}

} // namespace voluta::curved
