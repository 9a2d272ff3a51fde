// A cutting plane moved and tilted a little, so that it gains more.
#pragma once

#include "planar/face_table.h"
#include "planar/pieces.h"

namespace voluta::planar {

struct PolishOptions {
  double tiltRad = 0.0872664625997165; // RoboFDM, phase III: 5 degrees
  double shiftMm = 2.0;                // RoboFDM: 2.5 % of the diagonal
  double maxContactLossMm2 = 0.0;      // as CandidateOptions
  double footPrice = 0.0;
  double sectionWeight = 0.004; // risky area that a mm2 of section is worth
  int rounds = 4;               // of the pattern search, each half as wide as the last
};

struct PlaneGain {
  double gainMm2 = 0.0, sectionMm2 = 0.0, footMm2 = 0.0; // foot: what goes of what it stands on
  bool allowed = false; // no more of what the piece stands on goes than may
};

// What the cut gains, faces counted as far as they lie above the plane: of what hangs together
// above it with face `top`.
PlaneGain planeGain(const Piece& piece, const FaceTable& faces, const RiskRule& rule,
                    const Plane& plane, int top, double maxContactLossMm2);

// The best of planes near `plane` (pattern search over two tilts and the offset).
Plane polished(const Piece& piece, const FaceTable& faces, const RiskRule& rule, const Plane& plane,
               int top, const PolishOptions& options);

} // namespace voluta::planar
