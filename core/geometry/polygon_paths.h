// Polygons as paths of Clipper, whose coordinates are integers.
#pragma once

#include <Eigen/Core>
#include <polyclipping/clipper.hpp>

namespace voluta::geometry {

inline constexpr double kPathUnits = 1e4; // per mm

ClipperLib::IntPoint pathPoint(const Eigen::Vector2d& mm);
Eigen::Vector2d pointMm(const ClipperLib::IntPoint& point);

// Returns the union of closed paths by their winding.
ClipperLib::Paths united(const ClipperLib::Paths& paths);
// Returns the union, difference or intersection of two sets of closed paths by their winding.
ClipperLib::Paths combined(const ClipperLib::Paths& a, const ClipperLib::Paths& b,
                           ClipperLib::ClipType how);

struct OffsetStyle {
  double arcMm = 0.01; // chord error of round corners
  ClipperLib::JoinType corners = ClipperLib::jtRound;
  ClipperLib::EndType ends = ClipperLib::etClosedPolygon;
  double miterLimit = 2.0; // [offsets]: longest tip of a sharp corner
};
// Returns the paths moved outwards by `byMm`; inwards if it is negative.
ClipperLib::Paths offsetPaths(const ClipperLib::Paths& paths, double byMm,
                              const OffsetStyle& style);

// Returns the signed area: holes, whose paths run clockwise, count as negative.
double areaMm2(const ClipperLib::Paths& paths);

} // namespace voluta::geometry
