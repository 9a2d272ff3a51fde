#include "sliced/layer_slabs.h"

#include <algorithm>
#include <cmath>

namespace voluta::sliced {

namespace {
constexpr double kSameShare = 0.1; // [usual heights] bounds closer than this are one
constexpr double kMaxPerLayer = 3.0;

struct Span {
  double low, high;
};

Span spanOf(const plan::ToolPlan& plan, std::size_t end) {
  const double top = 0.5 * (plan.position[end - 1].z() + plan.position[end].z());
  return {top - 0.5 * (plan.heightMm[end - 1] + plan.heightMm[end]), top};
}

std::vector<double> distinct(std::vector<double> bounds, double apartMm) {
  std::ranges::sort(bounds);
  std::vector<double> kept;
  for (const double bound : bounds)
    if (kept.empty() || bound - kept.back() > apartMm)
      kept.push_back(bound);
  return kept;
}

// For beads that rise continuously.
std::vector<double> even(double low, double high, double heightMm) {
  const double count = std::max(1.0, std::round((high - low) / heightMm));
  std::vector<double> bounds;
  for (double k = 0.0; k <= count; ++k)
    bounds.push_back(low + k / count * (high - low));
  return bounds;
}
} // namespace

LayerSlabs::LayerSlabs(const plan::ToolPlan& plan, bool (*takes)(plan::PathKind)) {
  std::vector<double> edges, heights;
  for (const plan::ToolPath& path : plan.paths)
    if (takes(path.kind))
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
        const Span span = spanOf(plan, i);
        edges.push_back(span.low);
        edges.push_back(span.high);
        heights.push_back(span.high - span.low);
      }
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  const double usual = *middle;
  const auto [low, high] = std::ranges::minmax(edges);
  bounds_ = distinct(std::move(edges), kSameShare * usual);
  if (static_cast<double>(bounds_.size()) > kMaxPerLayer * (high - low) / usual + 2.0 ||
      bounds_.size() < 2)
    bounds_ = even(low, high, usual);
  segments_.resize(count());
  for (std::size_t p = 0; p < plan.paths.size(); ++p)
    if (const plan::ToolPath& path = plan.paths[p]; takes(path.kind))
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
        const Span span = spanOf(plan, i);
        const auto from = std::ranges::upper_bound(bounds_, span.low) - bounds_.begin() - 1;
        bool found = false;
        for (auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(from, 0)); k < count();
             ++k) {
          const double centre = 0.5 * (bounds_[k] + bounds_[k + 1]);
          if (centre > span.high)
            break;
          if (centre >= span.low) {
            segments_[k].push_back({p, i});
            found = true;
          }
        }
        // A bead thinner than its slab, e.g. where a spiral begins
        if (!found)
          segments_[slabAt(0.5 * (span.low + span.high))].push_back({p, i});
      }
}

std::size_t LayerSlabs::slabAt(double z) const {
  const auto above = std::ranges::upper_bound(bounds_, z) - bounds_.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(count()) - 1));
}

double LayerSlabs::heightAt(double slabs) const {
  const double k = std::clamp(std::floor(slabs), 0.0, static_cast<double>(count()) - 1.0);
  const auto i = static_cast<std::size_t>(k);
  return bounds_[i] + (slabs - k) * (bounds_[i + 1] - bounds_[i]);
}

} // namespace voluta::sliced
