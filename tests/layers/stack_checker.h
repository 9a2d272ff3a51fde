// A second opinion on a stack of layers, by code independent of the code under test: distances by a
// search of its own, inside by parity, support and thickness from the tops of earlier patches.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::test {

struct StackVerdict {
  double volumeRatio = 0.0; // sum of area x thickness over the part's volume

  // Boundary vertices.
  double boundaryFarthestMm = 0.0; // from the part's surface, of those that are on it or loose
  std::size_t seamVertices = 0;    // more than 1e-3 mm inside, beside one of another patch
  std::size_t nearVertices = 0;    // off the surface, on no seam, but within half a thickness: a
                                   // seam whose other side would be outside the part, or a fault
  std::size_t looseVertices = 0;   // farther off and on no seam
  std::size_t notSimple = 0;       // patches with a boundary that is not a set of simple loops

  // Points of patches, by area: from a point's top (half a thickness along its direction) to the
  // nearest top of an earlier patch, or the plate.
  double thicknessMeanMm = 0.0, thicknessP01Mm = 0.0, thicknessP99Mm = 0.0;
  double within = 0.0;             // share within the limits, of the supported area
  double asReported = 0.0;         // share within 10 % of the patch's own thickness, of the same
  double unsupported = 0.0;        // share with nothing within a quarter thickness of its foot
  std::size_t patchesInTheAir = 0; // hardly (2 %) any of it is on an earlier patch or the plate
  std::size_t outOfOrder = 0;      // in the air, but a later patch or a higher layer is under it
  bool layersRise = true;          // numbers without gaps that never fall

  // Points drawn evenly inside the part, by the number of patches whose thickness contains them (3
  // % of it and 0.01 mm either way allowed).
  double inNone = 0.0, inSeveral = 0.0;

  // Where the part's sharp edges (more than 40 degrees) pass through a patch's middle at 30 degrees
  // or more: how far that patch's boundary stays away.
  std::size_t sharpCrossings = 0;
  double sharpOffP99Mm = 0.0, sharpOffMaxMm = 0.0;
  Eigen::Vector3d sharpOffAt = Eigen::Vector3d::Zero(); // where it is most

  // Points drawn evenly on the part's surface where it faces along the layers (n . d > 0.5), to the
  // nearest top of a patch; and where it is on the plate, to the nearest foot.
  double topMeanMm = 0.0, topP99Mm = 0.0, plateMaxMm = 0.0;
  // The same for those within 25 degrees of the layers, and their share of the part's surface.
  double flatTopMeanMm = 0.0, flatTopP99Mm = 0.0, flatTopShare = 0.0;

  struct InTheAir {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double areaMm2 = 0.0;
    int patch = 0;
  };
  std::vector<InTheAir> air; // the patches in the air, one each
};

StackVerdict checkStack(const layers::LayerStack& stack, const geometry::TriangleMesh& part,
                        double heightMinMm, double heightMaxMm);

} // namespace voluta::test
