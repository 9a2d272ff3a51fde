#include "indicator/learned_indicator.h"

#include "base/error.h"
#include "indicator/joint_circle.h"

#include <libsvm/svm.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace voluta::indicator {

using robot::JointVector;

namespace {

struct FreeModel {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using Model = std::unique_ptr<svm_model, FreeModel>;

svm_parameter parametersOf(const LearningOptions& options) {
  svm_parameter p{};
  p.svm_type = C_SVC;
  p.kernel_type = RBF;
  p.gamma = options.gamma;
  p.C = options.penalty;
  p.cache_size = 64.0; // MB
  p.eps = 1e-3;
  p.shrinking = 1;
  return p;
}

} // namespace

LearnedIndicator::LearnedIndicator(const std::vector<JudgedJoints>& samples,
                                   std::vector<robot::JointLimits> limits,
                                   const LearningOptions& options)
    : limits_(std::move(limits)), gamma_(options.gamma), constant_(options.bias) {
  base::require(!samples.empty(), "an indicator has samples to learn from");
  base::require(options.gamma > 0.0 && options.penalty > 0.0, "gamma and penalty > 0");
  const Eigen::Index size = circleSize(limits_);
  const bool first = samples.front().collides;
  if (std::all_of(samples.begin(), samples.end(),
                  [&](const JudgedJoints& s) { return s.collides == first; })) {
    // Nothing to distinguish: the same value everywhere, on the correct side for any bias.
    constant_ = first ? 1.0 : -1.0;
    towards_.resize(0, size);
    return;
  }

  // The library expects rows of (index from 1, value), each terminated by an index of -1.
  const auto row = static_cast<std::size_t>(size) + 1;
  std::vector<svm_node> nodes(samples.size() * row);
  std::vector<svm_node*> rows;
  std::vector<double> labels;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const Eigen::VectorXd point = onCircle(samples[s].q, limits_);
    svm_node* const at = nodes.data() + s * row;
    for (Eigen::Index k = 0; k < size; ++k)
      at[k] = {static_cast<int>(k) + 1, point[k]};
    at[size] = {-1, 0.0};
    rows.push_back(at);
    labels.push_back(samples[s].collides ? 1.0 : -1.0);
  }
  const svm_problem problem{static_cast<int>(samples.size()), labels.data(), rows.data()};
  const svm_parameter parameters = parametersOf(options);
  svm_set_print_string_function([](const char*) {});
  const Model model(svm_train(&problem, &parameters));

  // The sign of the class that libsvm made positive
  const double sign = model->label[0] > 0 ? 1.0 : -1.0;
  const Eigen::Index n = model->l;
  towards_.resize(n, size);
  offsets_.resize(n);
  weights_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    weights_[i] = sign * model->sv_coef[0][i];
    for (Eigen::Index k = 0; k < size; ++k)
      towards_(i, k) = model->SV[i][k].value;
    offsets_[i] = -gamma_ * towards_.row(i).squaredNorm();
  }
  towards_ *= 2.0 * gamma_;
  constant_ -= sign * model->rho[0];
}

Eigen::ArrayXd LearnedIndicator::terms(const Eigen::VectorXd& point) const {
  // -gamma |p - c|^2 = 2 gamma c.p - gamma |c|^2 - gamma |p|^2
  return ((towards_ * point).array() + (offsets_ - gamma_ * point.squaredNorm())).exp();
}

double LearnedIndicator::value(const JointVector& q) const {
  if (weights_.size() == 0)
    return constant_;
  return constant_ + weights_.dot(terms(onCircle(q, limits_)).matrix());
}

JointVector LearnedIndicator::gradient(const JointVector& q) const {
  JointVector gradient = JointVector::Zero(q.size());
  if (weights_.size() == 0)
    return gradient;
  const Eigen::VectorXd point = onCircle(q, limits_);
  const Eigen::VectorXd weighted = (terms(point) * weights_.array()).matrix();
  const Eigen::VectorXd byPoint =
      towards_.transpose() * weighted - 2.0 * gamma_ * weighted.sum() * point;
  Eigen::Index k = 0;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const robot::JointKind kind = limits_[static_cast<std::size_t>(j)].kind;
    if (kind == robot::JointKind::Turning) {
      gradient[j] = point[k] * byPoint[k + 1] - point[k + 1] * byPoint[k];
      k += 2;
    } else {
      gradient[j] = robot::asAngle(kind, byPoint[k++]);
    }
  }
  return gradient;
}

LearnedIndicator LearnedIndicator::withBias(double more) const {
  LearnedIndicator other = *this;
  other.constant_ += more;
  return other;
}

double carefulBias(const LearnedIndicator& learned, const std::vector<JudgedJoints>& heldOut,
                   double maxMissed) {
  base::require(0.0 <= maxMissed && maxMissed < 1.0, "a share of samples");
  std::vector<double> values;
  for (const JudgedJoints& s : heldOut)
    if (s.collides)
      values.push_back(learned.value(s.q));
  if (values.empty())
    return 0.0;
  // Below 0 is free: the bias moves the first value that must not be missed to 0.
  const auto missed = static_cast<std::ptrdiff_t>(maxMissed * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + missed, values.end());
  return -values[static_cast<std::size_t>(missed)];
}

} // namespace voluta::indicator
