// Stitches (Castelli 6.2): dovetail pockets that layers leave open, so that material extruded into
// them from above locks the layers together.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "planar/pieces.h"

#include <vector>

namespace voluta::planar {

enum class PocketShape { Dovetail, Cone };

struct StitchRule {
  double spacingMm = 0.0;  // of the pockets of one height, along x and y; 0: none
  double diameterMm = 8.0; // where a pocket is widest
  PocketShape shape = PocketShape::Dovetail;
  int everyLayers = 20;    // pockets end at the top of every n-th layer
  double marginMm = 2.0;   // least material around a pocket

  bool makesPockets() const { return spacingMm > 0.0; }
};

// Returns a pocket with its top at a point. Dovetail: a chamber of the diameter, a cone that tapers
// to half of it, and a sprue of that diameter, each a quarter of the diameter high (diameter 8:
// 184.3 mm3). Cone: from the diameter to half of it, half of the diameter high (diameter 6:
// 49.5 mm3).
layers::Pocket pocketAt(const Eigen::Vector3d& top, double diameterMm,
                        PocketShape shape = PocketShape::Dovetail);
// Returns the radius of a pocket of that shape at a height above its bottom [mm].
double pocketRadius(const layers::Pocket& pocket, double heightMm,
                    PocketShape shape = PocketShape::Dovetail);

// Returns the pockets of a part whose layers have these boundaries: on a square grid around the
// middle of its bounding box, shifted by half the spacing at every other height, wherever the part
// surrounds a pocket by the margin and continues above it. Pockets of different heights keep the
// margin, too. Layers are those of `bounds`. Precondition: the piece is on the plate.
std::vector<layers::Pocket> placePockets(const Piece& piece, const std::vector<double>& bounds,
                                         const StitchRule& rule);

// Returns the surfaces of the pockets, facing into them: together with the surface of the part that
// contains them, the solid without them. Precondition: all pockets have the shape.
geometry::TriangleMesh pocketSurfaces(const std::vector<layers::Pocket>& pockets,
                                      PocketShape shape = PocketShape::Dovetail);

// Numbers the pockets by the layers of a finished stack. Pockets without a layer are dropped.
void assignLayers(std::vector<layers::Pocket>& pockets, const layers::LayerStack& stack);

} // namespace voluta::planar
