// Rough printing time of a part as it stands, from measures of its surface.
#pragma once

#include "geometry/triangle_mesh.h"
#include "process/process.h"

#include <Eigen/Core>

namespace voluta::placement {

// Areas of a part's facets as it stands [mm2].
struct StandingSurface {
  double outlinesMm2 = 0.0; // the integral, over the height, of the length of all outlines
  // The share of outlinesMm2 that facets within 45 degrees of the vertical have; the others
  // projected onto the plate, by the side that they face.
  double steepMm2 = 0.0, upMm2 = 0.0, downMm2 = 0.0;
};
// `up`: unit vector that points up as the part stands, in the mesh's frame.
StandingSurface standingSurface(const geometry::TriangleMesh& mesh, const Eigen::Vector3d& up);

struct StandingPart {
  double volumeMm3 = 0.0, heightMm = 0.0, contactMm2 = 0.0;
  double acrossMm = 0.0; // the diagonal of the footprint's smallest rectangle
  StandingSurface surface;
};

// How layers are filled; the default is solid.
struct Filling {
  int walls = 2;
  double density = 1.0;               // share of the interior within walls and skins
  double topMm = 0.0, bottomMm = 0.0; // thickness of the skins
  bool spiral = false;                // one rising bead on a solid bottom of bottomMm
  double minLayerS = 0.0;             // no layer takes less
};

// Returns the volume of the interior that a density below 1 fills sparsely: the part's without its
// walls and skins. Exact for boxes on a square.
double sparseVolume(const StandingPart& part, const Filling& filling,
                    const process::Process& process);

// Returns a rough estimate of the printing time: walls, solid and sparse interior by their speeds,
// and for each layer the starts of its walls and its interior, and a travel across the footprint.
// Ignores supports, reach, slow places and the first layer's settings.
double estimatedSeconds(const StandingPart& part, const Filling& filling,
                        const process::Process& process);

} // namespace voluta::placement
