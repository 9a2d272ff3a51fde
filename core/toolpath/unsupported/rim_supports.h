// Support beads under beads that would overhang just above the plate or printed material.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

namespace voluta::toolpath {

// Rims of round feet widen by more than a bead within a layer, bellies close just above the plate,
// roofs just above printed material: beads there are unsupported, a few layers above the surface
// below. In unsupported stretches (bridges.h) longer than half of the process's bridge length,
// where the plate, or material printed before the patch, is within six times the widest bead's
// width below, support beads with heights in the range of layer heights are printed on it along the
// bead's own curve, before the first path of its patch. They are as narrow as walls six times as
// high can be, since higher ones tip over. They end a fourteenth of the bead's height below it, so
// that they break off. They are printed upright; where the head would collide with printed
// material, in the direction of the beads that they support, or tilted to either side. No support
// is printed inside earlier material, or below places where a region blocks supports. Clears the
// marks of the beads that they support. Reports the supported paths ("rimSupports").
std::optional<PassResult> addRimSupports(const UnsupportedBeads& beads, const SeenPart& part,
                                         const PassScene& scene, const base::RunContext& ctx);

} // namespace voluta::toolpath
