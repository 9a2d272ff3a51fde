// Test whether the head's true shape reaches a piece past earlier pieces.
#pragma once

#include "planar/pieces.h"
#include "planar/point_blocks.h"
#include "process/process.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// The share of a piece's points that may be blocked: samples at the rim of its base.
inline constexpr double kBlockedShare = 0.002;
// The head is enlarged by this margin, because obstacles are samples; and by the coarse margin if
// the result must also hold on a finer mesh.
inline constexpr double kHeadMarginMm = 0.2, kCoarseHeadMarginMm = 0.25;
// Spacing of obstacle points; smaller gaps between them are narrower than a bead.
inline constexpr double kReachSpacingMm = 1.0;

// Returns points on a surface, about one per squared spacing and at least one per triangle.
std::vector<Eigen::Vector3d> surfaceSamples(const geometry::TriangleMesh& mesh, double spacingMm);

// Returns evenly distributed points, about as many as have a spacing of twice the samples'.
std::vector<Eigen::Vector3d> tipsOf(const std::vector<Eigen::Vector3d>& samples);

// Returns points on the whole surface of a convex plate; `polygon` is its top at z = 0, its
// underside is at -thicknessMm.
std::vector<Eigen::Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon,
                                          double thicknessMm, double spacingMm);

// Returns points on the whole surface of a frustum about the z axis.
std::vector<Eigen::Vector3d> frustumSamples(double lowMm, double highMm, double lowRadiusMm,
                                            double highRadiusMm, double spacingMm);

// Possible obstacles for the head.
using Obstacles = std::vector<PointBlock>;

// Returns the height along the base's normal at which the nozzle's tip prints the piece's first
// layer: twice rule.contactMm above its base.
double firstTipMm(const Piece& piece, const RiskRule& rule);

// The head's shape as a table of heights over its tip at which it exceeds a radius.
class HeadReach {
public:
  explicit HeadReach(const process::HeadShape& head, double marginMm = kHeadMarginMm);

  bool empty() const { return rise_.empty(); }

  // Returns whether an obstacle is inside the head at more than kBlockedShare of the tips, with the
  // head oriented along the unit vector `direction`. A piece is printed from its base upwards in
  // layers perpendicular to its direction; therefore the tips are points all over the piece and its
  // base. Tips below `lowestMm` along the direction (the top of the first layer, which the nozzle's
  // tip never goes below) are raised to it. Precondition: the head's radius increases with the
  // height. Where it decreases, the largest radius below applies; above the head's end its last
  // radius applies.
  bool blocked(const std::vector<Eigen::Vector3d>& tips, const Obstacles& obstacles,
               const Eigen::Vector3d& direction, double lowestMm) const;

  // Returns the obstacles that are inside the head at any of the tips. Preconditions as for
  // blocked().
  std::vector<Eigen::Vector3d> inside(const std::vector<Eigen::Vector3d>& tips,
                                      const Obstacles& obstacles, const Eigen::Vector3d& direction,
                                      double lowestMm) const;

private:
  // Per step of radius: obstacles at this distance from the axis collide if they are higher above
  // the tip than this [mm].
  std::vector<double> rise_;
};

} // namespace voluta::planar
