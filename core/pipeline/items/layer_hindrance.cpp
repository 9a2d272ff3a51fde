#include "pipeline/items/layer_hindrance.h"

#include "base/parallel.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "geometry/directions.h"
#include "geometry/measures.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "toolpath/unsupported/head_clearance.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace voluta::pipeline {

namespace {
using Eigen::Vector3d;

constexpr double kTiltedDeg = 3.0;
constexpr double kMaxSamples = 120'000; // of all items
constexpr std::size_t kMaxTips = 1'500; // of one item
constexpr double kFarthestMm = 400.0;
constexpr std::size_t kMaxMovedTips = 60; // for which a distance is sought
// Stands for what samples lack: the beads between them, and the way from one to the next.
constexpr double kMarginMm = 0.3;
constexpr double kPitch = 0.4;          // of the grid, in sides of a sample
constexpr std::size_t kSoftSamples = 4; // of the same layer, printed just before

// A piece of a layer, about as long as wide.
struct Sample {
  Vector3d middle, direction;
  double heightMm = 0.0;
  std::size_t item = 0, patch = 0, inPatch = 0; // `inPatch`: its number there
};

double areaOf(const layers::LayerStack& stack) {
  double area = 0.0;
  for (const layers::Patch& patch : stack.patches)
    area += geometry::area(patch.surface);
  return area;
}

// Appends samples of the patch, one per `cellMm2`.
void samplePatch(const layers::Patch& patch, std::size_t index, double cellMm2,
                 std::vector<Sample>& samples) {
  double due = 0.5;
  std::size_t drawn = 0;
  for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
    due += geometry::triangleArea(patch.surface, t) / cellMm2;
    for (; due >= 1.0; due -= 1.0, ++drawn) {
      // The R2 sequence, folded into the triangle
      double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(drawn), 1.0);
      double v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(drawn), 1.0);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      const std::array<double, 3> weight{1.0 - u - v, u, v};
      Sample sample{Vector3d::Zero(),
                    Vector3d::Zero(),
                    0.0,
                    static_cast<std::size_t>(patch.item),
                    index,
                    drawn};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(patch.surface.triangles[t][k]);
        sample.middle += weight[k] * patch.surface.vertices[vertex];
        sample.direction += weight[k] * patch.direction[vertex];
        sample.heightMm += weight[k] * patch.thicknessMm[vertex];
      }
      sample.direction.normalize();
      samples.push_back(sample);
    }
  }
}

class LayerCheck {
public:
  LayerCheck(const layers::LayerStack& joined, const robot::Cell& cell,
             const process::Process& process, const base::RunContext& ctx)
      : head_(cell, process), ctx_(ctx) {
    sideMm_ = std::max(process.beadWidthMm, std::sqrt(areaOf(joined) / kMaxSamples));
    for (std::size_t p = 0; p < joined.patches.size(); ++p)
      samplePatch(joined.patches[p], p, sideMm_ * sideMm_, samples_);
    for (const Sample& sample : samples_) {
      if (sample.item >= centres_.size())
        centres_.resize(sample.item + 1);
      centres_[sample.item].extend(sample.middle);
    }
  }

  std::optional<LayerHindrance> worst() const {
    const Scene all = scene([](std::size_t) { return true; });
    LayerHindrance found;
    std::vector<std::size_t> hindered;
    for (std::size_t item = 0; item < centres_.size(); ++item) {
      const std::vector<std::size_t> tips = tipsOf(item);
      std::vector<std::size_t> blocked = blockedIn(all, tips);
      if (blocked.empty())
        continue;
      const Scene own = scene([item](std::size_t i) { return i == item; });
      const std::vector<std::size_t> byItself = blockedIn(own, blocked);
      std::erase_if(blocked,
                    [&](std::size_t tip) { return std::ranges::binary_search(byItself, tip); });
      const double share = static_cast<double>(blocked.size()) / static_cast<double>(tips.size());
      if (share > found.share) {
        found = {item, item, share, {}};
        hindered = std::move(blocked);
      }
    }
    if (found.share <= plan::kBlockingShare)
      return std::nullopt;
    found.neighbour = neighbourAt(found.item, hindered);
    found.moveMm = moveFor(found, hindered);
    return found;
  }

private:
  // Printed samples, and per patch the first waypoint of it.
  struct Scene {
    collision::GrowingPart part;
    std::vector<std::size_t> firstOfPatch;
  };

  // `shift`: of the items other than `fixed`.
  Scene scene(const std::function<bool(std::size_t)>& has, std::size_t fixed = 0,
              const Vector3d& shift = Vector3d::Zero()) const {
    plan::ToolPlan plan;
    std::vector<std::size_t> firstOfPatch(samples_.empty() ? 0 : samples_.back().patch + 1, 0);
    std::size_t patch = 0;
    for (const Sample& sample : samples_) {
      for (; patch <= sample.patch; ++patch)
        firstOfPatch[patch] = plan.waypointCount();
      if (!has(sample.item))
        continue;
      const Vector3d along = 0.5 * sideMm_ * sample.direction.unitOrthogonal();
      const Vector3d tip = sample.middle + 0.5 * sample.heightMm * sample.direction +
                           (sample.item == fixed ? Vector3d::Zero().eval() : shift);
      plan::ToolPath path;
      path.first = plan.waypointCount();
      path.count = 2;
      plan.paths.push_back(path);
      for (const Vector3d& end : {(tip - along).eval(), (tip + along).eval()}) {
        plan.position.push_back(end);
        plan.direction.push_back(sample.direction);
        plan.widthMm.push_back(static_cast<float>(sideMm_));
        plan.heightMm.push_back(static_cast<float>(sample.heightMm));
        plan.speedMmPerS.push_back(1.0F);
      }
    }
    return {collision::GrowingPart(plan, kPitch * sideMm_, ctx_), std::move(firstOfPatch)};
  }

  // Returns the samples of an item that are tested, ascending.
  std::vector<std::size_t> tipsOf(std::size_t item) const {
    std::vector<std::size_t> all;
    for (std::size_t s = 0; s < samples_.size(); ++s)
      if (samples_[s].item == item)
        all.push_back(s);
    const std::size_t step = (all.size() + kMaxTips - 1) / kMaxTips;
    std::vector<std::size_t> tips;
    for (std::size_t k = 0; k < all.size(); k += step)
      tips.push_back(all[k]);
    return tips;
  }

  // Returns the tips at which the head is clear in no direction up to that of tool-paths.
  std::vector<std::size_t> blockedIn(const Scene& scene,
                                     const std::vector<std::size_t>& tips) const {
    std::vector<char> blocked(tips.size(), 0);
    base::parallelChunks(ctx_, tips.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end && !ctx_.cancelled(); ++k)
        blocked[k] = !isClear(scene, samples_[tips[k]]);
    });
    ctx_.checkpoint();
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < tips.size(); ++k)
      if (blocked[k])
        found.push_back(tips[k]);
    return found;
  }

  bool isClear(const Scene& scene, const Sample& sample) const {
    const std::size_t hard = std::max(sample.inPatch, kSoftSamples) - kSoftSamples;
    const std::size_t before = scene.firstOfPatch[sample.patch] + 2 * hard;
    const auto clears = [&](const Vector3d& d) {
      return head_.clears(scene.part, sample.middle + 0.5 * sample.heightMm * d, d, before,
                          kMarginMm);
    };
    const Vector3d& t = sample.direction;
    if (clears(t))
      return true;
    constexpr int kSphere = 500; // as toolpath::orientDirections(), coarser
    const double minCosine = std::cos(base::degreesToRadians(75.0));
    const Vector3d u = t.unitOrthogonal(), v = t.cross(u);
    for (int k = 0; k < kSphere; ++k) {
      const Vector3d p = geometry::onSpiral(k, 1.0 - (2.0 * k + 1.0) / kSphere);
      if (p.z() < minCosine)
        return false;
      if (clears(p.x() * u + p.y() * v + p.z() * t))
        return true;
    }
    return false;
  }

  // Returns the item beside which most of the tips are blocked.
  std::size_t neighbourAt(std::size_t item, const std::vector<std::size_t>& hindered) const {
    std::size_t neighbour = item == 0 ? 1 : 0, maximum = 0;
    for (std::size_t other = 0; other < centres_.size(); ++other) {
      if (other == item || centres_[other].isEmpty())
        continue;
      const Scene pair = scene([&](std::size_t i) { return i == item || i == other; });
      const std::size_t count = blockedIn(pair, hindered).size();
      if (count > maximum) {
        maximum = count;
        neighbour = other;
      }
    }
    return neighbour;
  }

  std::optional<double> moveFor(const LayerHindrance& pair,
                                std::vector<std::size_t> hindered) const {
    const std::size_t step = (hindered.size() + kMaxMovedTips - 1) / kMaxMovedTips;
    for (std::size_t k = 0; k * step < hindered.size(); ++k)
      hindered[k] = hindered[k * step];
    hindered.resize((hindered.size() + step - 1) / step);
    Vector3d away = centres_[pair.neighbour].center() - centres_[pair.item].center();
    away.z() = 0.0;
    if (away.norm() < 1e-6)
      away = Vector3d::UnitX();
    away.normalize();
    const auto suffices = [&](double mm) {
      const Scene moved =
          scene([&](std::size_t i) { return i == pair.item || i == pair.neighbour; }, pair.item,
                mm * away);
      return static_cast<double>(blockedIn(moved, hindered).size()) * pair.share <=
             plan::kBlockingShare * static_cast<double>(hindered.size());
    };
    double enough = 10.0;
    while (enough < kFarthestMm && !suffices(enough))
      enough *= 2.0;
    if (enough >= kFarthestMm)
      return std::nullopt;
    double less = enough <= 10.0 ? 0.0 : 0.5 * enough;
    while (enough - less > 2.0) {
      const double middle = 0.5 * (less + enough);
      (suffices(middle) ? enough : less) = middle;
    }
    return std::ceil(enough);
  }

  toolpath::HeadClearance head_;
  const base::RunContext ctx_;
  double sideMm_ = 0.0;
  std::vector<Sample> samples_;              // in print order
  std::vector<Eigen::AlignedBox3d> centres_; // of the items' samples
};

base::Message helpFor(const LayerHindrance& hindrance, const std::string& neighbour,
                      bool hasSequence) {
  if (hasSequence && hindrance.moveMm)
    return base::message("print one after another, or move {second} by {move:.0f}"_text, neighbour,
                         base::mm(*hindrance.moveMm));
  if (hasSequence)
    return "print one after another"_text;
  if (hindrance.moveMm)
    return base::message("move {second} by {move:.0f}"_text, neighbour,
                         base::mm(*hindrance.moveMm));
  return "print them as separate jobs"_text;
}
} // namespace

bool tiltsHead(const layers::LayerStack& stack) {
  const double minCosine = std::cos(base::degreesToRadians(kTiltedDeg));
  return std::ranges::any_of(stack.patches, [&](const layers::Patch& patch) {
    return std::ranges::any_of(patch.direction,
                               [&](const Vector3d& d) { return d.z() < minCosine; });
  });
}

std::optional<LayerHindrance> layerHindrance(const layers::LayerStack& joined,
                                             const robot::Cell& cell,
                                             const process::Process& process,
                                             const base::RunContext& ctx) {
  if (!tiltsHead(joined))
    return std::nullopt;
  return LayerCheck(joined, cell, process, ctx).worst();
}

HindranceStage hindranceStage(const std::optional<LayerHindrance>& hindrance,
                              const std::vector<std::string>& names, bool hasSequence) {
  if (!hindrance)
    return {};
  const std::string& neighbour = names.at(hindrance->neighbour);
  return {{plan::makeFinding(plan::FindingKind::PartsHinder,
                             {{"share", base::percent(100.0 * hindrance->share)},
                              {"first", names.at(hindrance->item)},
                              {"second", neighbour},
                              {"help", helpFor(*hindrance, neighbour, hasSequence)}})}};
}

} // namespace voluta::pipeline
