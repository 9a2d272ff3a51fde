// Judges a plan of pieces by geometry alone: shares no code with the planner.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/pieces.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace voluta::test {

struct PlanCheck {
  double overhangRad = 0.7853981633974483;
  // Half the first layer: points that low on a piece on the plate count as on the plate.
  double contactMm = 0.4;
  process::HeadShape head;            // empty: reach is not checked
  std::vector<Eigen::Vector2d> plate; // convex, its top on z = 0; empty: the head meets pieces only
  double spacingMm = 2.0;             // between samples of surfaces
  double mayHitShare = 0.01;          // of a piece's samples
};

struct PlanVerdict {
  std::vector<std::string> faults; // one line each; empty: a valid plan
  double riskyMm2 = 0.0;           // from scratch
  std::size_t blockedPieces =
      0; // pieces that the head does not reach everywhere: not among the faults
};

// That every piece is closed and above its base plane; that they are disjoint and together the part
// (volume to 1e-6, each face of a piece inside the part has another piece behind it); that the
// section below each is carried by pieces before it; that no section passes through another
// (RoboFDM, constraint I); where the head, at samples all over each piece, meets pieces printed
// before it or the plate; the area of eq. 2.1 without parts on earlier pieces or the plate.
PlanVerdict checkPlan(const geometry::TriangleMesh& part, const std::vector<planar::Piece>& pieces,
                      const PlanCheck& check);

// The head's radius at a height over its tip; 0 where it is not.
double headRadius(const process::HeadShape& head, double zMm);

} // namespace voluta::test
