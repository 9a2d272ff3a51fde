// The head's flat underside against the beads' own sections, which cells tell to half their width.
#pragma once

#include "geometry/box_grid.h"
#include "process/process.h"
#include "replay/beads.h"
#include "replay/distances.h"
#include "replay/printed_part.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::replay {

// A piece of bead: its section (a rectangle with half-round sides) from one end to the other.
RoundedQuad solidOf(const BeadPiece& piece, double widthMaxMm);

class Underside {
public:
  // `head`: less the contact tolerance (process::erodedHead); the widest of its sections
  // at the first height is the underside.
  // Keeps what it needs of the pieces.
  Underside(const process::HeadShape& head, const std::vector<BeadPiece>& pieces,
            double widthMaxMm);

  // Returns a place of a piece that the underside reaches into, none if it reaches into none of
  // what is laid at that moment and no longer soft. Work frame; `direction`: unit, from the tip
  // into the head.
  std::optional<Eigen::Vector3d> touched(const Eigen::Vector3d& tip,
                                         const Eigen::Vector3d& direction,
                                         const PrintState& moment) const;

private:
  struct Piece {
    RoundedQuad solid;
    std::uint32_t run;
    float runMm;
  };
  double upMm_, radiusMm_ = 0.0; // of the disc
  std::vector<Piece> pieces_;
  geometry::BoxGrid near_;
};

} // namespace voluta::replay
