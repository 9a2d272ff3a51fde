// Passes that mill a part out of a block: side A from above, side B from below, and the contour,
// which frees the part (Castelli 7.2.4).
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "milling/cutting_data.h"
#include "milling/height_map.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::milling {

struct MillRule {
  Cutter cutter;
  CuttingData data;
  double lineMm = 0.0;      // distance of lines; 0: that of the data (h_layer)
  double roughingMm = 5.0;  // depth of passes above the part (p0_roughing)
  double acrossMm = 4.0;    // block beyond the part along y (Z_gap_block), more than the cutter
  double alongMm = 8.0;     // block beyond the part along x, anchors included (X_gap_block)
  double skinMm = 1.0;      // block above and below the part
  double clearanceMm = 2.0; // of moves above the block (tool_clearance)
  double webMm = 1.0;       // thickness that sides A and B leave around the part, for the contour
  double stripMm = 3.0;     // of the contour that is left at the part's lower end along y
  double pitchMm = 0.1;     // cells of the part's map

  double distanceMm() const { return lineMm > 0.0 ? lineMm : lineDistanceMm(cutter, data); }
};

enum class MillStep {
  Rapid,    // above the block
  Roughing, // above the part
  Fine,     // down to the part
  Surface,  // along the part's surface
  Contour
};

struct MillMove {
  Eigen::Vector3d to = Eigen::Vector3d::Zero(); // the cutter's tip [mm]
  MillStep step = MillStep::Rapid;
};

enum class MillSide { A, B, Contour };

// Moves of one side. Sides B and Contour see part and block turned upside down about the x axis.
struct MillPasses {
  MillSide side = MillSide::A;
  std::vector<MillMove> moves;
};

struct MillPlan {
  Eigen::AlignedBox3d block; // as side A sees it
  HeightMap above, below;    // of the part, and of the part turned
  std::vector<MillPasses> sides;
};

// Returns the passes for a closed part. On each side, lines along x begin half a cutter from the
// block's upper end along y. On each line the cutter goes down in steps: roughing ones as long as
// they pass above the part, fine ones where they meet it, back and forth, and rises above the block
// to cross the part; a last pass follows the part's surface. Throws Error{Usage} if a gap is too
// small for the cutter, or a value is not positive; Cancelled.
MillPlan planMilling(const geometry::TriangleMesh& part, const MillRule& rule,
                     const base::RunContext& ctx);

} // namespace voluta::milling
