#include "motion/ladder/size_in_reach.h"

#include "base/run_context.h"
#include "base/units.h"
#include "plan/tool_plan.h"
#include "robot/nozzle_turns.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace voluta::motion {

namespace {

using Eigen::Vector3d;

constexpr int kTurns = 24;
constexpr std::size_t kSample = 150; // Waypoints of each half
constexpr double kMissed = 0.01;     // Share of them that may be missed at a size within reach
constexpr int kLargest = 19, kSmallest = 4, kSteps = 20; // Twentieths

bool isReached(const MotionScene& scene, const Vector3d& tip, const Vector3d& direction,
               std::vector<robot::JointVector>& solutions) {
  Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
  work_T_tool.translation() = tip;
  work_T_tool.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), -direction).toRotationMatrix();
  const robot::NozzleTurns turns(scene.cell, work_T_tool, scene.cell.home());
  collision::CellCollision::Frames frames;
  for (int k = 0; k < kTurns; ++k) {
    turns.at(base::kTwoPi * k / kTurns, solutions);
    for (const robot::JointVector& q : solutions) {
      scene.cell.framePoses(q, frames);
      if (!scene.collision.bodies(frames, scene.options.printing))
        return true;
    }
  }
  return false;
}

void addSpread(const std::vector<std::size_t>& from, std::vector<std::size_t>& sample) {
  const std::size_t count = std::min(from.size(), kSample);
  for (std::size_t k = 0; k < count; ++k)
    sample.push_back(from[k * from.size() / count]);
}

} // namespace

std::optional<double> sizeInReach(const MotionScene& scene, const std::vector<Refused>& refused,
                                  const base::RunContext& ctx) {
  const plan::ToolPlan& plan = scene.plan;
  if (!scene.cell.externalAxes().empty() || plan.waypointCount() == 0)
    return std::nullopt;
  std::vector<std::size_t> all(plan.waypointCount()), unreached;
  for (std::size_t w = 0; w < all.size(); ++w)
    all[w] = w;
  for (const Refused& r : refused)
    if (r.why == Refusal::Unreachable)
      unreached.push_back(r.waypoint);
  std::vector<std::size_t> sample;
  addSpread(unreached, sample);
  addSpread(all, sample);

  Eigen::AlignedBox3d box;
  for (const Vector3d& p : plan.position)
    box.extend(p);
  const Vector3d middle(box.center().x(), box.center().y(), std::min(box.min().z(), 0.0));
  const auto limit = static_cast<std::size_t>(kMissed * static_cast<double>(sample.size()));
  std::vector<robot::JointVector> solutions;
  for (int twentieths = kLargest; twentieths >= kSmallest; --twentieths) {
    const double size = static_cast<double>(twentieths) / kSteps;
    std::size_t missed = 0;
    for (std::size_t k = 0; k < sample.size() && missed <= limit; ++k) {
      ctx.checkpoint();
      const std::size_t w = sample[k];
      missed += !isReached(scene, middle + size * (plan.position[w] - middle), plan.direction[w],
                           solutions);
    }
    if (missed <= limit)
      return size;
  }
  return std::nullopt;
}

} // namespace voluta::motion
