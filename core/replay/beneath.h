// What one piece of bead rests on.
#pragma once

#include "replay/depositor.h"
#include "replay/ground.h"
#include "replay/printed_part.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace voluta::replay {

// As findSupport() asks, of a piece's middle (beads.h). Keeps references to all.
class Beneath {
public:
  Beneath(const std::vector<BeadPiece>& pieces, std::uint32_t index, const PrintedPart& printed,
          const GroundProbe& ground);

  bool supported() const;
  // Of its width, looked at in eight places.
  double carriedShare() const;
  // Right beneath it, so far to the left (up x way) of its middle?
  bool carriedAt(double asideMm) const;

  // Is there the ground, or material that was laid before and is not soft? Cells tell the part's
  // surface to half their pitch, which is as much as thin layers give way: where a point's own cell
  // is not filled but the one below it is, the bead that filled that tells whether it reaches up to
  // the point.
  bool holds(const Eigen::Vector3d& point) const;

  const Eigen::Vector3d& tip() const { return tip_; } // of the nozzle
  const Eigen::Vector3d& up() const { return up_; }   // unit, into the nozzle
  double heightMm() const { return height_; }

private:
  const std::vector<BeadPiece>& pieces_;
  const PrintedPart& printed_;
  const GroundProbe& ground_;
  Eigen::Vector3d tip_, up_, side_; // side_: unit, up x way
  double height_, width_;
  PrintState moment_;
};

} // namespace voluta::replay
