#include "motion/transfers/rrt_connect.h"

#include "base/run_context.h"
#include "base/units.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <random>

namespace voluta::motion {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using robot::JointVector;

namespace {

using Space = ob::RealVectorStateSpace;

using Kinds = std::vector<robot::JointKind>;

// States hold revolute coordinates; sliding joints are converted by robot::asAngle.
JointVector jointsOf(const ob::State* state, const Kinds& kinds) {
  JointVector q(static_cast<Eigen::Index>(kinds.size()));
  for (unsigned j = 0; j < kinds.size(); ++j)
    q[j] = robot::fromAngle(kinds[j], (*state->as<Space::StateType>())[j]);
  return q;
}

// OMPL's own generators draw their seeds from one global sequence; this generator is local to the
// call.
class SeededSampler final : public ob::StateSampler {
public:
  SeededSampler(const ob::StateSpace* space, std::uint64_t seed)
      : StateSampler(space), engine_(seed) {}

  void sampleUniform(ob::State* state) override {
    const ob::RealVectorBounds& b = space_->as<Space>()->getBounds();
    for (std::size_t j = 0; j < b.low.size(); ++j)
      set(state, j, number(b.low[j], b.high[j]));
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const ob::RealVectorBounds& b = space_->as<Space>()->getBounds();
    for (std::size_t j = 0; j < b.low.size(); ++j) {
      const double middle = (*near->as<Space::StateType>())[static_cast<unsigned>(j)];
      set(state, j, std::clamp(middle + number(-distance, distance), b.low[j], b.high[j]));
    }
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2.0 * deviation);
  }

private:
  // Not std::uniform_real_distribution: its results differ between libraries.
  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  static void set(ob::State* state, std::size_t j, double value) {
    (*state->as<Space::StateType>())[static_cast<unsigned>(j)] = value;
  }
  std::mt19937_64 engine_;
};

class SegmentValidator final : public ob::MotionValidator {
public:
  using Free = std::function<bool(const JointVector&, const JointVector&)>;
  SegmentValidator(const ob::SpaceInformationPtr& si, Kinds kinds, Free segmentFree)
      : MotionValidator(si), kinds_(std::move(kinds)), free_(std::move(segmentFree)) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return free_(jointsOf(a, kinds_), jointsOf(b, kinds_));
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& lastValid) const override {
    if (checkMotion(a, b))
      return true;
    if (lastValid.first != nullptr)
      si_->copyState(lastValid.first, a);
    lastValid.second = 0.0;
    return false;
  }

private:
  Kinds kinds_;
  Free free_;
};

void shorten(std::vector<JointVector>& jointPath,
             const std::function<bool(const JointVector&, const JointVector&)>& segmentFree,
             int tries, std::uint64_t seed, const base::RunContext& ctx) {
  std::mt19937_64 engine(seed);
  for (int t = 0; t < tries && jointPath.size() > 2; ++t) {
    ctx.checkpoint();
    const std::size_t a = engine() % jointPath.size(), b = engine() % jointPath.size();
    const std::size_t low = std::min(a, b), high = std::max(a, b);
    if (high - low >= 2 && segmentFree(jointPath[low], jointPath[high]))
      jointPath.erase(jointPath.begin() + static_cast<std::ptrdiff_t>(low) + 1,
                      jointPath.begin() + static_cast<std::ptrdiff_t>(high));
  }
}

} // namespace

std::vector<JointVector>
treePath(const JointVector& from, const JointVector& to,
         const std::vector<robot::JointLimits>& limits,
         const std::function<bool(const JointVector&)>& free,
         const std::function<bool(const JointVector&, const JointVector&)>& segmentFree,
         const TreeOptions& options, const base::RunContext& ctx) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const auto dof = static_cast<unsigned>(from.size());
  auto space = std::make_shared<Space>(dof);
  ob::RealVectorBounds bounds(dof);
  const Kinds kinds = robot::kindsOf(limits);
  for (unsigned j = 0; j < dof; ++j) {
    const auto angle = [&](double value) { return robot::asAngle(limits[j].kind, value); };
    bounds.low[j] =
        std::max(angle(limits[j].min), std::min(angle(from[j]), angle(to[j])) - base::kPi);
    bounds.high[j] =
        std::min(angle(limits[j].max), std::max(angle(from[j]), angle(to[j])) + base::kPi);
  }
  space->setBounds(bounds);
  space->setStateSamplerAllocator([&options](const ob::StateSpace* s) {
    return std::make_shared<SeededSampler>(s, options.seed);
  });
  auto info = std::make_shared<ob::SpaceInformation>(space);
  info->setStateValidityChecker(
      [&](const ob::State* s) { return !ctx.cancelled() && free(jointsOf(s, kinds)); });
  info->setMotionValidator(std::make_shared<SegmentValidator>(
      info, kinds, [&](const JointVector& a, const JointVector& b) {
        return !ctx.cancelled() && segmentFree(a, b);
      }));
  info->setup();

  auto problem = std::make_shared<ob::ProblemDefinition>(info);
  ob::ScopedState<Space> start(space), goal(space);
  for (unsigned j = 0; j < dof; ++j) {
    start[j] = robot::asAngle(kinds[j], from[j]);
    goal[j] = robot::asAngle(kinds[j], to[j]);
  }
  problem->setStartAndGoalStates(start, goal);
  og::RRTConnect planner(info);
  planner.setRange(options.rangeRad);
  planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();
  planner.setProblemDefinition(problem);
  planner.setup();
  ob::IterationTerminationCondition iterations(static_cast<unsigned>(options.iterations));
  const ob::PlannerTerminationCondition stop = ob::plannerOrTerminationCondition(
      ob::PlannerTerminationCondition(iterations),
      ob::PlannerTerminationCondition([&ctx] { return ctx.cancelled(); }));
  const ob::PlannerStatus status = planner.solve(stop);
  ctx.checkpoint();
  if (status != ob::PlannerStatus::EXACT_SOLUTION)
    return {};

  const auto& path = *problem->getSolutionPath()->as<og::PathGeometric>();
  std::vector<JointVector> jointPath;
  for (std::size_t i = 0; i < path.getStateCount(); ++i)
    jointPath.push_back(jointsOf(path.getState(static_cast<unsigned>(i)), kinds));
  jointPath.front() = from;
  jointPath.back() = to;
  shorten(jointPath, segmentFree, options.shortcuts, options.seed, ctx);
  return jointPath;
}

} // namespace voluta::motion
