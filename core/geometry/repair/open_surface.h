// Surfaces that enclose no volume: defects that a repair does not decide without being asked.
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
  double widestMm = 0.0; // diagonal of the bounding box of the widest rim
  Eigen::Vector3d widestAt = Eigen::Vector3d::Zero(); // its centre
  // every rim is flat, or small beside the surface: nothing is guessed where it is closed
  bool hasPlainRims = false;
  double capShare = 0.0; // area of the patches over those rims as a share of surface and patches
  std::size_t sheetTriangles = 0;
  double sheetShare = 0.0; // share of the surface area

  // Returns whether more than one percent of the surface would have to be invented.
  bool hasOpenRims() const { return capShare > kMaxUnasked; }
  bool isSheetModel() const { return sheetShare > kMaxUnasked; }
  // Returns whether closing its rims, as slicers do, gives the solid that it must be.
  bool isPlain() const { return hasPlainRims && hasOpenRims() && !isSheetModel(); }

  // Returns one sentence; empty if neither holds.
  base::Message sentence() const;

private:
  static constexpr double kMaxUnasked = 0.01;
};

// Returns the solid within half of `wallMm` of every open surface and every sheet, united with the
// closed components. It is closed, up to what windingUnion() leaves open. Edges are rounded
// (Portaneri 2022 as in CGAL). Precondition: wallMm > 0. Throws Error{UnusableInput} if the wall is
// too thin for the size of the surface. Throws Cancelled between the steps.
TriangleMesh thickened(const TriangleMesh& mesh, double wallMm, const base::RunContext& ctx);

} // namespace voluta::geometry
