// Whether the head as it is reaches a piece past what is printed before it.
#pragma once

#include "planar/pieces.h"
#include "process/process.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// Of a piece's points the head may be kept off this share: samples at the rim of its base.
inline constexpr double kBlockedShare = 0.002;

// Points on a surface, about one a spacing squared and one a triangle at least.
std::vector<Eigen::Vector3d> surfaceSamples(const geometry::TriangleMesh& mesh, double spacingMm);

// Points all over a convex plate whose top is the polygon on z = 0, its underside at -thicknessMm.
std::vector<Eigen::Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon,
                                          double thicknessMm, double spacingMm);

// Points all over a frustum about the z axis.
std::vector<Eigen::Vector3d> frustumSamples(double lowMm, double highMm, double lowRadiusMm,
                                            double highRadiusMm, double spacingMm);

// The head as radii by height over its tip.
class HeadReach {
public:
  explicit HeadReach(const process::HeadShape& head);

  bool empty() const { return squared_.empty(); }

  // Whether at more than kBlockedShare of the tips the head, coming along unit `direction`, has an
  // obstacle strictly inside it. A piece is laid from its base upwards in layers across its
  // direction, so the tips are points all over it and over its base: tips higher up are reached
  // past the same obstacles. Precondition: the head's radius grows with the height, as heads' do;
  // where it shrinks, the largest below counts.
  bool blocked(const std::vector<Eigen::Vector3d>& tips,
               const std::vector<Eigen::Vector3d>& obstacles,
               const Eigen::Vector3d& direction) const;

private:
  std::vector<double> squared_; // radius by steps of height, mm2
};

} // namespace voluta::planar
