// Surfaces that enclose nothing: what a repair does not decide on its own.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <cstddef>

namespace voluta::geometry {

// Rims at which a surface ends, and sheets without thickness.
struct OpenSurface {
  std::size_t rims = 0;
  double widestMm = 0.0;                              // diagonal of the box of the widest rim
  Eigen::Vector3d widestAt = Eigen::Vector3d::Zero(); // its middle
  double capShare = 0.0; // of the patches over those rims in the area of surface and patches
  std::size_t sheetTriangles = 0;
  double sheetShare = 0.0; // of the area of the surface

  // More than one part in a hundred of the surface would have to be invented, or left out.
  bool hasOpenRims() const { return capShare > kMostUnasked; }
  bool isSheetModel() const { return sheetShare > kMostUnasked; }

  // One sentence; empty if neither holds.
  base::Message sentence() const;

private:
  static constexpr double kMostUnasked = 0.01;
};

// The solid within half of `wallMm` of every open surface and every sheet, united with the closed
// components. Closed, up to what windingUnion() leaves. Edges are rounded (Portaneri 2022 as in
// CGAL). Precondition: wallMm > 0. Throws Error{UnusableInput}: the wall is too thin for the size
// of the surface. Throws Cancelled between the steps.
TriangleMesh thickened(const TriangleMesh& mesh, double wallMm, const base::RunContext& ctx);

} // namespace voluta::geometry
