// Support below one piece of bead.
#pragma once

#include "replay/depositor.h"
#include "replay/printed_part.h"
#include "replay/replay_ground.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace voluta::replay {

// The probes of findSupport() at a piece's middle (beads.h). Keeps references to all arguments.
class Beneath {
public:
  Beneath(const std::vector<BeadPiece>& pieces, std::uint32_t index, const PrintedPart& printed,
          const GroundProbe& ground);

  bool supported() const;
  // Returns the supported share of its width, from eight probes.
  double carriedShare() const;
  // Returns whether there is support directly below, at this distance to the left (up x way) of its
  // middle.
  bool carriedAt(double lateralMm) const;

  // Returns the last piece whose own section, without displaced material, is directly below the
  // middle third of this one's width; kNeverFilled if there is none.
  std::uint32_t pieceBelow() const;

  // Returns whether there is ground at the point, or material that was deposited earlier and is no
  // longer soft. Cells resolve the part's surface to half their pitch, which is as much as thin
  // layers yield. If the point's own cell is not filled but the one below it is, the section of the
  // bead that filled the lower cell decides whether it reaches up to the point. A cell is no
  // support where the point is below the bead that filled it: neighbours in a layer fill cells that
  // reach a little below it.
  bool holds(const Eigen::Vector3d& point) const;

  const Eigen::Vector3d& tip() const { return tip_; } // nozzle tip
  const Eigen::Vector3d& up() const { return up_; }   // unit vector from the bead into the nozzle
  double heightMm() const { return height_; }

private:
  // Returns the piece of the bead that filled the point's cell in whose own section the point is;
  // kNeverFilled if there is none.
  std::uint32_t pieceAround(const Eigen::Vector3d& point) const;

  const std::vector<BeadPiece>& pieces_;
  const PrintedPart& printed_;
  const GroundProbe& ground_;
  Eigen::Vector3d tip_, up_, side_; // side_: unit, up x way
  double height_, width_;
  PrintState moment_;
};

} // namespace voluta::replay
