// Checks the head's flat underside against the exact sections of beads, which cells resolve only to
// half their width.
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

// Returns a piece of bead: its section (a rectangle with half-round sides) swept from one end to
// the other.
RoundedQuad solidOf(const BeadPiece& piece, double widthMaxMm);

class Underside {
public:
  // `head`: reduced by the contact tolerance (process::erodedHead). Its widest section at the
  // lowest height is the underside. Copies the needed data of the pieces.
  Underside(const process::HeadShape& head, const std::vector<BeadPiece>& pieces,
            double widthMaxMm);

  // Returns a place where the underside intersects a piece that is printed at that moment and no
  // longer soft, nullopt if there is none. Work frame; `direction`: unit, from the tip into the
  // head.
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
