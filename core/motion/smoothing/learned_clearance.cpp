#include "motion/smoothing/learned_clearance.h"

#include "collision/cell_collision.h"
#include "indicator/contact_samples.h"
#include "indicator/contact_space.h"
#include "indicator/learned_indicator.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace voluta::motion {

using robot::JointVector;

namespace {
constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kFirstShare = 6; // of all samples, the inverse: those at random waypoints
} // namespace

const Nearness* LearnedClearance::of(std::size_t path, const base::RunContext& ctx) {
  if (!scene_.cell.externalAxes().empty())
    return nullptr;
  const int layer = scene_.plan.paths[path].layer;
  if (layer_ != layer)
    learn(layer, ctx);
  return nearness_ ? &*nearness_ : nullptr;
}

void LearnedClearance::learn(int layer, const base::RunContext& ctx) {
  layer_ = layer;
  nearness_.reset();
  std::size_t first = scene_.plan.waypointCount(), end = 0;
  for (const plan::ToolPath& path : scene_.plan.paths)
    if (path.layer == layer) {
      first = std::min(first, path.first);
      end = std::max(end, path.first + path.count);
    }
  const collision::Margins& margins = scene_.options.printing;
  const indicator::TrueCheck collides = [&](const JointVector& q) {
    collision::CellCollision::Frames frames;
    scene_.cell.framePoses(q, frames);
    return scene_.collision.bodies(frames, margins) ||
           scene_.collision.bodiesAndPart(frames, scene_.part, end, margins);
  };
  const indicator::ContactSpace space(scene_.cell, scene_.plan, first, end - first);
  const indicator::ContactSampling sampling;
  const std::vector<JointVector> begin = space.random(sampling.samples / kFirstShare, kSeed);
  if (begin.empty())
    return;
  const auto learned = std::make_shared<const indicator::LearnedIndicator>(
      indicator::contactSamples(
          begin, scene_.cell.limits(), collides,
          [&](const JointVector& q) { return space.project(q); }, sampling, ctx),
      scene_.cell.limits(), indicator::LearningOptions{});
  nearness_ = Nearness{[learned](const JointVector& q) { return learned->value(q); },
                       [learned](const JointVector& q) { return learned->gradient(q); }};
}

} // namespace voluta::motion
