// The steps between the edges of layers and the part's surface (staircase effect).
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"

#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::layers {

struct StepFigures {
  double meanMm = 0.0; // over the part's whole surface
  double maxMm = 0.0;
};

// Returns the heights of steps, measured perpendicular to the surface: a layer of thickness h whose
// edge is on a surface at angle a to the layer makes steps of h cos a (Dolenc, Makela 1994). A
// surface that no edge of a layer meets follows a layer and has none. Seams within the part and
// supports have none. Throws Cancelled.
StepFigures stepsOf(const LayerStack& stack, const geometry::TriangleMesh& part,
                    const base::RunContext& ctx);

// Same, on some of the part's faces only. Precondition: `isMeant` has an entry per triangle.
StepFigures stepsOn(const LayerStack& stack, const geometry::TriangleMesh& part,
                    const std::vector<char>& isMeant, const base::RunContext& ctx);

} // namespace voluta::layers
