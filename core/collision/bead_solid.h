// Solid of one printed segment, as used for depositing it in the grid.
#pragma once

#include "plan/tool_plan.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace voluta::collision {

// The bead between waypoints i and i + 1 of one path: the section of process/bead_model.h (a
// rectangle with half-round ends, height h below the tip) swept along the segment, rotated with the
// waypoints' directions and rounded at both ends. Widths, heights and directions are interpolated
// linearly; a point is tested against the section at the nearest position on the bead's centreline.
class BeadSolid {
public:
  // Precondition: i + 1 < plan.waypointCount().
  BeadSolid(const plan::ToolPlan& plan, std::size_t i)
      : direction0_(plan.direction[i]), bend_(plan.direction[i + 1] - plan.direction[i]),
        width0_(plan.widthMm[i]), width1_(plan.widthMm[i + 1]), height0_(plan.heightMm[i]),
        height1_(plan.heightMm[i + 1]) {
    centre0_ = plan.position[i] - 0.5 * height0_ * direction0_;
    along_ = plan.position[i + 1] - 0.5 * height1_ * plan.direction[i + 1] - centre0_;
    const double squared = along_.squaredNorm();
    inverseSquared_ = squared > 0.0 ? 1.0 / squared : 0.0;
    turns_ = !bend_.isZero(0.0);
    if (!turns_)
      direction0_.normalize();
  }

  bool contains(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d r0 = point - centre0_;
    const double t = std::clamp(r0.dot(along_) * inverseSquared_, 0.0, 1.0);
    const Eigen::Vector3d r = r0 - t * along_;
    if (r.squaredNorm() > reach() * reach())
      return false;
    const double height = height0_ + t * (height1_ - height0_);
    const double width = width0_ + t * (width1_ - width0_);
    double up = r.dot(direction0_);
    if (turns_) {
      const Eigen::Vector3d d = direction0_ + t * bend_;
      up = r.dot(d) / d.norm();
    }
    const double quarter = 0.25 * height * height;
    if (up * up > quarter)
      return false;
    const double flat = 0.5 * std::max(0.0, width - height);
    const double sideways = r.squaredNorm() - up * up; // squared
    if (sideways <= flat * flat)
      return true;
    const double beyond = std::sqrt(sideways) - flat;
    return beyond * beyond + up * up <= quarter;
  }

  // Corners of a box that contains the bead.
  Eigen::Vector3d low() const { return centre0_.cwiseMin(centre0_ + along_) - extent(); }
  Eigen::Vector3d high() const { return centre0_.cwiseMax(centre0_ + along_) + extent(); }

private:
  double reach() const { return 0.5 * std::max({width0_, width1_, height0_, height1_}); }
  // Returns its extent from the centreline along each axis.
  Eigen::Vector3d extent() const {
    // On the arc between two unit directions a component is at most the larger end's absolute value
    // divided by the cosine of half the arc, and, if both are on one side, at least the smaller
    // end's.
    const Eigen::Array3d up0 = direction0_.normalized(), up1 = (direction0_ + bend_).normalized();
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1.0 + (up0 * up1).sum())));
    if (cosine < 0.5)
      return Eigen::Vector3d::Constant(reach());
    const Eigen::Array3d maximum = (up0.abs().max(up1.abs()) / cosine).min(1.0);
    const Eigen::Array3d minimum = (up0 * up1 > 0.0).select(up0.abs().min(up1.abs()), 0.0);
    const Eigen::Array3d lateral = (1.0 - minimum.square()).max(0.0).sqrt();
    const double height = std::max(height0_, height1_);
    return (0.5 * (height * maximum + std::max({width0_, width1_, height}) * lateral))
        .min(reach())
        .matrix();
  }

  Eigen::Vector3d centre0_, along_, direction0_, bend_;
  double inverseSquared_, width0_, width1_, height0_, height1_;
  bool turns_;
};

} // namespace voluta::collision
