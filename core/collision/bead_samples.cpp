#include "collision/bead_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::collision {

namespace {
using Eigen::Vector3d;

// Length of samples of beads up to 2 mm wide, and in widths of wider ones.
constexpr double kSampleMm = 1.0, kSampleWidths = 0.5;
// Depth of the tip of a covered bead below that of the covering one, in heights of the latter.
constexpr double kMinDepth = 0.4, kMaxDepth = 1.6;
// Places across a bead that are compared with those below, in widths.
constexpr std::array<double, 3> kAcross = {-0.2, 0.0, 0.2};
// Beads spread sideways by up to this share of their width.
constexpr double kSpread = 0.05;
constexpr double kAlongShare = 0.1; // tolerance along a bead, in lengths of a sample

// Returns the maximum distance between the tips of a bead and of one that covers it [mm].
double reachMm(const plan::ToolPlan& plan) {
  float width = kSampleMm, height = kSampleMm;
  for (std::size_t w = 0; w < plan.waypointCount(); ++w) {
    width = std::max(width, plan.widthMm[w]);
    height = std::max(height, plan.heightMm[w]);
  }
  return std::hypot(static_cast<double>(width), kMaxDepth * static_cast<double>(height));
}

double sampleMm(double widthMm) {
  return std::max(kSampleMm, kSampleWidths * widthMm);
}
} // namespace

void appendSamples(const plan::ToolPlan& plan, std::size_t a, std::size_t b,
                   std::vector<BeadSample>& samples) {
  const Vector3d step = plan.position[b] - plan.position[a];
  const double lengthMm = sampleMm(std::min(plan.widthMm[a], plan.widthMm[b]));
  const int pieces = std::max(1, static_cast<int>(std::ceil(step.norm() / lengthMm)));
  for (int k = 0; k < pieces; ++k) {
    BeadSample sample;
    sample.from = static_cast<double>(k) / pieces;
    sample.to = static_cast<double>(k + 1) / pieces;
    const double middle = 0.5 * (sample.from + sample.to);
    const auto between = [&](double x, double y) { return x + middle * (y - x); };
    sample.tip = plan.position[a] + middle * step;
    sample.along = 0.5 * (sample.to - sample.from) * step;
    sample.direction = (plan.direction[a] + plan.direction[b]).normalized();
    sample.widthMm = between(plan.widthMm[a], plan.widthMm[b]);
    sample.heightMm = between(plan.heightMm[a], plan.heightMm[b]);
    sample.waypoint = b;
    samples.push_back(sample);
  }
}

BeadSampleGrid::BeadSampleGrid(const plan::ToolPlan& plan) : cellMm_(reachMm(plan)) {}

void BeadSampleGrid::add(const BeadSample& sample) {
  cells_[keyOf(cellOf(sample.tip))].push_back(samples_.size());
  samples_.push_back(sample);
}

bool BeadSampleGrid::covers(const BeadSample& upper, const BeadSample& lower) {
  const Vector3d off = lower.tip - upper.tip;
  const double depthMm = -off.dot(upper.direction);
  if (depthMm < kMinDepth * upper.heightMm || depthMm > kMaxDepth * upper.heightMm)
    return false;
  const Vector3d side = upper.direction.cross(upper.along).normalized();
  const Vector3d axis = lower.along.normalized();
  const double halfMm = lower.along.norm() + kAlongShare * sampleMm(lower.widthMm),
               lateralMm = (0.5 + kSpread) * lower.widthMm;
  return std::ranges::any_of(kAcross, [&](double share) {
    const Vector3d at = share * upper.widthMm * side - off - depthMm * upper.direction;
    const double along = at.dot(axis);
    return std::abs(along) <= halfMm && (at - along * axis).norm() <= lateralMm;
  });
}

Eigen::Vector3i BeadSampleGrid::cellOf(const Vector3d& point) const {
  return (point / cellMm_).array().floor().cast<int>();
}

std::uint64_t BeadSampleGrid::keyOf(const Eigen::Vector3i& cell) {
  constexpr int kBits = 21;
  const auto part = [](int value) {
    return static_cast<std::uint64_t>(value) & ((1U << kBits) - 1U);
  };
  return part(cell.x()) | part(cell.y()) << kBits | part(cell.z()) << 2 * kBits;
}

} // namespace voluta::collision
