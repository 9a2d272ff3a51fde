// A guess at whether an arm collides, learned from answers of the true check: Gaussian kernels over
// the joints. It says "free" where it is sure, and else that the true check has to be asked.
// Source: Dai 2020, 4.4.1, eq. 4.14.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::indicator {

// Joints and what the true check says of them.
struct JudgedJoints {
  robot::JointVector q;
  bool collides = false;
};

struct LearningOptions {
  double gamma = 0.7;   // how narrow kernels are, 1 / rad^2
  double penalty = 1e4; // of a sample on the wrong side: C of the support vector machine
  double bias = 1.0;    // added to what was learned; at 1 samples within the margin are not free
};

// Immutable; queries may run in parallel.
class LearnedIndicator {
public:
  // Joints are those of `limits`, of whose kinds alone it takes note; whole turns change nothing.
  // The same samples give the same indicator. Where all samples are of one kind so is every answer.
  // Cannot be cancelled on the way. Preconditions: samples not empty, as many joints each as there
  // are limits, gamma and penalty > 0.
  LearnedIndicator(const std::vector<JudgedJoints>& samples, std::vector<robot::JointLimits> limits,
                   const LearningOptions& options);

  // Below 0: free, as far as it was taught; the lower the surer.
  double value(const robot::JointVector& q) const;
  // Its derivative by the joints, 1 / rad or 1 / mm.
  robot::JointVector gradient(const robot::JointVector& q) const;
  bool saysFree(const robot::JointVector& q) const { return value(q) < 0.0; }

  // The same with so much more added: more careful where it is more than 0.
  LearnedIndicator withBias(double more) const;

  std::size_t kernels() const { return static_cast<std::size_t>(weights_.size()); }

private:
  Eigen::ArrayXd terms(const Eigen::VectorXd& point) const; // one a kernel

  std::vector<robot::JointLimits> limits_;
  double gamma_, constant_;
  Eigen::MatrixXd towards_; // a kernel a row: 2 gamma times its centre
  Eigen::ArrayXd offsets_;  // -gamma times its centre's squared length
  Eigen::VectorXd weights_;
};

// The bias to add so that of the samples that collide at most the share `mostMissed` is called
// free. Samples that it has not learned from, as they will be asked for: on those that it has, it
// is better than it is. 0 where none collides. Precondition: 0 <= mostMissed < 1.
double carefulBias(const LearnedIndicator& learned, const std::vector<JudgedJoints>& heldOut,
                   double mostMissed);

} // namespace voluta::indicator
