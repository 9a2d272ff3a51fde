// Result and options of the planar decomposition: a part's pieces in print order.
#pragma once

#include "plan/finding.h"
#include "planar/pieces.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::planar {

// A frustum about the z axis [mm], part of the body that carries the plate.
struct StemFrustum {
  double lowMm = 0.0, highMm = 0.0; // z, low < high <= 0
  double lowRadiusMm = 0.0, highRadiusMm = 0.0;
};

// The platform below the part, in the part's frame. The head must clear it when printing any piece.
struct PlanarPlatform {
  // Top of the plate at z = 0, convex, counter-clockwise. If empty, the plate is made for the part:
  // the convex hull of the first piece's contact area, widened by marginMm. Other pieces that touch
  // z = 0 then have no plate below them, only the material they are printed on.
  std::vector<Eigen::Vector2d> polygon;
  double marginMm = 0.0;
  double thicknessMm = 5.0;
  std::vector<StemFrustum> stem; // the bodies that carry the plate, in any order
};

struct PlanarOptions {
  RiskRule rule;
  process::HeadShape head; // must clear earlier pieces; empty: not checked
  PlanarPlatform platform;
  double minVolumeMm3 = 10.0; // smaller pieces are not cut off
  // The first piece keeps these shares of the part's contact area and of the area of its convex
  // hull [mm2/mm2]. If the target is not reached that way, the shares are multiplied by 0.4 (but 1
  // stays 1).
  double keptContact = 0.35, keptHull = 0.05;
  // The value of the whole contact area and of the whole hull, as shares of the initial risky area.
  double contactWeight = 0.1, hullWeight = 0.05;
  // The search stops at this share of the initial risky area [mm2/mm2].
  double target = 0.008;
  std::size_t beam = 6;               // number of partial results kept
  int normals = 200;                  // number of cutting directions, over the allowed directions
  double lowestZ = -0.71;             // lowest z of the normals (constraint II: 0)
  double stepMm = 2.0;                // distance between the offsets of planes
  std::size_t searchTriangles = 4000; // triangles of the simplified mesh used for the search
  int maxCuts = 40;
};

struct PlanarDecomposition {
  std::vector<Piece> pieces; // in print order: each piece comes after the one it is printed on
  double riskyBeforeMm2 = 0.0, riskyMm2 = 0.0;
  double sectionMm2 = 0.0;       // of all cuts
  std::size_t blockedPieces = 0; // pieces with places that the head does not reach
  plan::Findings findings;
  struct {
    double search = 0.0, cut = 0.0;
  } seconds;
};

// Orders the pieces such that each comes after all pieces it is printed on and the head reaches it
// past the earlier ones, as far as such an order exists; `blocked` counts the pieces the head does
// not reach everywhere. Sets Piece::parent and under.
std::vector<Piece> printOrder(std::vector<Piece> pieces, const PlanarOptions& options,
                              double spacingMm, std::size_t& blocked);

// Returns the plate that the pieces are printed on: options.platform.polygon, or the one made for
// the pieces.
std::vector<Eigen::Vector2d> plateOf(const std::vector<Piece>& pieces,
                                     const PlanarOptions& options);

} // namespace voluta::planar
