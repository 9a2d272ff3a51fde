#include "pipeline/items/joined_plans.h"

#include "base/error.h"
#include "plan/waypoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace voluta::pipeline {

namespace {
using layers::PrintOrder;
using plan::ToolPath;
using plan::ToolPlan;

// Heights closer than this are those of one layer.
constexpr double kSameHeightMm = 0.01;

// Successive paths of one layer of an item, [first, last) of a plan.
struct LayerRun {
  std::size_t first = 0, last = 0;
  std::size_t item = 0;
  int layer = 0;         // in its own plan
  double heightMm = 0.0; // mean of the waypoints
};

double meanHeightMm(const ToolPlan& plan, std::size_t first, std::size_t last) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = first; k < last; ++k)
    for (std::size_t i = plan.paths[k].first; i < plan.paths[k].first + plan.paths[k].count; ++i) {
      sum += plan.position[i].z();
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

// One of the plans, and what is left of it.
struct Source {
  const ToolPlan& plan;
  std::vector<LayerRun> runs;
  std::size_t next = 0; // of its runs
  int firstPatch = 0;   // added to the numbers of its patches

  bool hasNext() const { return next < runs.size(); }
  const LayerRun& head() const { return runs[next]; }
};

// Returns the runs of the paths from `begin` on. `item`: of all of them; none: as they state.
std::vector<LayerRun> runsOf(const ToolPlan& plan, std::size_t begin,
                             std::optional<std::size_t> item) {
  std::vector<LayerRun> runs;
  for (std::size_t k = begin; k < plan.paths.size(); ++k) {
    const ToolPath& path = plan.paths[k];
    const std::size_t own = item.value_or(static_cast<std::size_t>(path.item));
    if (runs.empty() || runs.back().item != own || runs.back().layer != path.layer)
      runs.push_back({k, k, own, path.layer, 0.0});
    runs.back().last = k + 1;
  }
  for (LayerRun& run : runs)
    run.heightMm = meanHeightMm(plan, run.first, run.last);
  return runs;
}

int patchCount(const ToolPlan& plan) {
  int count = 0;
  for (const ToolPath& path : plan.paths)
    count = std::max(count, path.patch + 1);
  return count;
}

class PlanJoiner {
public:
  PlanJoiner(const ToolPlan& planned, std::span<const GivenPlan> given, PrintOrder order,
             std::span<const std::size_t> sequence)
      : order_(order), rank_(sequence.size()) {
    for (std::size_t r = 0; r < sequence.size(); ++r)
      rank_.at(sequence[r]) = r;
    while (waste_ < planned.paths.size() && plan::isWaste(planned.paths[waste_].kind))
      ++waste_;
    sources_.push_back({planned, runsOf(planned, waste_, std::nullopt)});
    int patches = patchCount(planned);
    for (const GivenPlan& one : given) {
      sources_.push_back({*one.plan, runsOf(*one.plan, 0, one.item), 0, patches});
      patches += patchCount(*one.plan);
    }
    joined_.fill.resize(sequence.size());
    for (std::size_t item = 0; item < sequence.size(); ++item)
      joined_.fill[item] = planned.fillOf(item);
    for (const GivenPlan& one : given)
      joined_.fill.at(one.item) = one.plan->fillOf(0);
  }

  ToolPlan run() {
    for (std::size_t k = 0; k < waste_; ++k)
      add(sources_.front(), k, static_cast<std::size_t>(sources_.front().plan.paths[k].item), 0);
    while (Source* source = nextSource()) {
      const LayerRun& run = source->head();
      const int layer = numberOf(*source, run);
      for (std::size_t k = run.first; k < run.last; ++k)
        add(*source, k, run.item, layer);
      ++source->next;
    }
    return std::move(joined_);
  }

private:
  Source* nextSource() {
    double lowestMm = std::numeric_limits<double>::infinity();
    for (const Source& source : sources_)
      if (source.hasNext())
        lowestMm = std::min(lowestMm, source.head().heightMm);
    Source* next = nullptr;
    for (Source& source : sources_) {
      if (!source.hasNext() ||
          (order_ == PrintOrder::ByLayer && source.head().heightMm > lowestMm + kSameHeightMm))
        continue;
      if (!next || comesBefore(source.head(), next->head()))
        next = &source;
    }
    return next;
  }

  bool comesBefore(const LayerRun& a, const LayerRun& b) const {
    return order_ == PrintOrder::ByLayer ? a.item < b.item : rank_.at(a.item) < rank_.at(b.item);
  }

  int numberOf(const Source& source, const LayerRun& run) {
    const auto [known, isNew] = number_.try_emplace({&source.plan, run.item, run.layer}, layers_);
    if (!isNew)
      return known->second;
    const bool continues = order_ == PrintOrder::ByLayer && layers_ > 0 &&
                           std::abs(run.heightMm - lastHeightMm_) <= kSameHeightMm;
    if (continues)
      known->second = layers_ - 1;
    else {
      ++layers_;
      lastHeightMm_ = run.heightMm;
    }
    return known->second;
  }

  void add(const Source& source, std::size_t k, std::size_t item, int layer) {
    ToolPath path = source.plan.paths[k];
    for (std::size_t i = 0; i < path.count; ++i)
      plan::appendWaypoint(joined_, source.plan, path.first + i);
    path.first = joined_.waypointCount() - path.count;
    path.item = static_cast<int>(item);
    path.patch += source.firstPatch;
    path.layer = layer;
    joined_.paths.push_back(path);
  }

  const PrintOrder order_;
  std::vector<std::size_t> rank_; // of each item in the sequence
  std::size_t waste_ = 0;         // paths with which the planned ones begin
  std::vector<Source> sources_;
  // Of the joined plan, by plan, item and layer there
  std::map<std::tuple<const ToolPlan*, std::size_t, int>, int> number_;
  int layers_ = 0;
  double lastHeightMm_ = 0.0; // of the layer that was numbered last
  ToolPlan joined_;
};

} // namespace

plan::ToolPlan joinedPlans(const plan::ToolPlan& planned, std::span<const GivenPlan> given,
                           layers::PrintOrder order, std::span<const std::size_t> sequence) {
  for (const GivenPlan& one : given)
    base::require(one.plan && one.item < sequence.size(), "a plan of one of the job's items");
  return PlanJoiner(planned, given, order, sequence).run();
}

} // namespace voluta::pipeline
