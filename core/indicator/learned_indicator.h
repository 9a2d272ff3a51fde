// Learned estimate of whether an arm collides, trained on results of the true check: Gaussian
// kernels over the joints. It answers "free" only where it is certain; elsewhere the true check is
// needed. Source: Dai 2020, 4.4.1, eq. 4.14.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::indicator {

// Joints and the result of the true check for them.
struct JudgedJoints {
  robot::JointVector q;
  bool collides = false;
};

struct LearningOptions {
  double gamma = 0.7;   // inverse squared width of kernels, 1 / rad^2
  double penalty = 1e4; // for a sample on the wrong side: C of the support vector machine
  double bias = 1.0;    // added to the learned value; at 1, samples within the margin are not free
};

// Immutable; queries may run in parallel.
class LearnedIndicator {
public:
  // Joints are those of `limits`, of which only the kinds are used; whole turns do not matter. The
  // same samples give the same indicator. If all samples are of one class, so is every answer.
  // Cannot be cancelled. Preconditions: samples not empty, each with as many joints as limits,
  // gamma and penalty > 0.
  LearnedIndicator(const std::vector<JudgedJoints>& samples, std::vector<robot::JointLimits> limits,
                   const LearningOptions& options);

  // Below 0: free according to the samples; the lower, the more certain.
  double value(const robot::JointVector& q) const;
  // Returns its derivative with respect to the joints, 1 / rad or 1 / mm.
  robot::JointVector gradient(const robot::JointVector& q) const;
  bool saysFree(const robot::JointVector& q) const { return value(q) < 0.0; }

  // Returns the indicator with `more` added to its value: more conservative if `more` > 0.
  LearnedIndicator withBias(double more) const;

  std::size_t kernels() const { return static_cast<std::size_t>(weights_.size()); }

private:
  Eigen::ArrayXd terms(const Eigen::VectorXd& point) const; // one per kernel

  std::vector<robot::JointLimits> limits_;
  double gamma_, constant_;
  Eigen::MatrixXd towards_; // a kernel per row: 2 gamma times its centre
  Eigen::ArrayXd offsets_;  // -gamma times its centre's squared length
  Eigen::VectorXd weights_;
};

// Returns the bias to add so that at most the share `maxMissed` of the colliding samples is called
// free. `heldOut`: samples it was not trained on, distributed like later queries; on its own
// training samples it performs better than in use. Returns 0 if none collides. Precondition: 0 <=
// maxMissed < 1.
double carefulBias(const LearnedIndicator& learned, const std::vector<JudgedJoints>& heldOut,
                   double maxMissed);

} // namespace voluta::indicator
