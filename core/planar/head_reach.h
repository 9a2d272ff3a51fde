// Whether the head as it is reaches a piece past what is printed before it.
#pragma once

#include "planar/pieces.h"
#include "planar/point_blocks.h"
#include "process/process.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// Of a piece's points the head may be kept off this share: samples at the rim of its base.
inline constexpr double kBlockedShare = 0.002;
// By so much the head is taken wider, as obstacles are samples; and by so much where what is found
// is to hold on a finer mesh too.
inline constexpr double kHeadMarginMm = 0.2, kCoarseHeadMarginMm = 0.25;
// Between points of obstacles: what looks through between them is smaller than a bead.
inline constexpr double kReachSpacingMm = 1.0;

// Points on a surface, about one a spacing squared and one a triangle at least.
std::vector<Eigen::Vector3d> surfaceSamples(const geometry::TriangleMesh& mesh, double spacingMm);

// About as many of the points as lie two spacings apart, spread evenly.
std::vector<Eigen::Vector3d> tipsOf(const std::vector<Eigen::Vector3d>& samples);

// Points all over a convex plate whose top is the polygon on z = 0, its underside at -thicknessMm.
std::vector<Eigen::Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon,
                                          double thicknessMm, double spacingMm);

// Points all over a frustum about the z axis.
std::vector<Eigen::Vector3d> frustumSamples(double lowMm, double highMm, double lowRadiusMm,
                                            double highRadiusMm, double spacingMm);

// What may be in the head's way.
using Obstacles = std::vector<PointBlock>;

// Height along the base's normal at which the nozzle's tip lays the piece's first layer: twice
// rule.contactMm over its base.
double firstTipMm(const Piece& piece, const RiskRule& rule);

// The head by the height over its tip at which it grows past a radius.
class HeadReach {
public:
  explicit HeadReach(const process::HeadShape& head, double marginMm = kHeadMarginMm);

  bool empty() const { return rise_.empty(); }

  // Whether at more than kBlockedShare of the tips the head, coming along unit `direction`, has an
  // obstacle inside it. A piece is laid from its base upwards in layers across its direction, so
  // the tips are points all over it and over its base; those lower than `lowestMm` along the
  // direction (the top of its first layer: nearer the nozzle's tip never comes) are raised to it.
  // Precondition: the head's radius grows with the height, as heads' do; where it shrinks, the
  // largest below counts, and over its end its last.
  bool blocked(const std::vector<Eigen::Vector3d>& tips, const Obstacles& obstacles,
               const Eigen::Vector3d& direction, double lowestMm) const;

  // Those of the obstacles that are inside the head at any of the tips. As blocked.
  std::vector<Eigen::Vector3d> inside(const std::vector<Eigen::Vector3d>& tips,
                                      const Obstacles& obstacles, const Eigen::Vector3d& direction,
                                      double lowestMm) const;

private:
  // By steps of radius: obstacles so far off the axis are in the way when they are higher over the
  // tip than this. mm.
  std::vector<double> rise_;
};

} // namespace voluta::planar
