// Small moves and tilts of a cutting plane that increase its gain.
#pragma once

#include "planar/face_table.h"
#include "planar/pieces.h"

namespace voluta::planar {

struct PolishOptions {
  double tiltRad = 0.0872664625997165; // RoboFDM, phase III: 5 degrees
  double shiftMm = 2.0;                // RoboFDM: 2.5 % of the diagonal
  double maxContactLossMm2 = 0.0;      // as in CandidateOptions
  double footPrice = 0.0;
  double sectionWeight = 0.004; // risky area that a mm² of section is worth
  int rounds = 4;               // of the pattern search; each halves the step
};

struct PlaneGain {
  double gainMm2 = 0.0, sectionMm2 = 0.0, footMm2 = 0.0; // foot: the contact area that is cut off
  bool allowed = false; // true: the lost contact area is within the limit
};

// Returns the gain of cutting off the connected part above the plane that contains face `top`.
// Faces across the plane count by their share above it.
PlaneGain planeGain(const Piece& piece, const FaceTable& faces, const RiskRule& rule,
                    const Plane& plane, int top, double maxContactLossMm2);

// Returns the best plane near `plane` (pattern search over two tilts and the offset).
Plane polished(const Piece& piece, const FaceTable& faces, const RiskRule& rule, const Plane& plane,
               int top, const PolishOptions& options);

} // namespace voluta::planar
