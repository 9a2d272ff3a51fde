// Beads drawn as flat strips that face the eye and are shaded as if round: two triangles per
// segment, with the outline and the shading of a swept ellipse of the bead's width and height.
#pragma once

class vtkActor;

namespace voluta::scene {

class RangeMapper;

// Precondition: `mapper` draws polydata with the point arrays beadTangent, beadDirection (unit
// vectors in model coordinates), beadShape (half width, half height, side: -1 or 1) and beadOpen
// (unit vector to the side without other beads, or zero).
void drawAsBeads(vtkActor* actor, RangeMapper* mapper);
// A bead's section is nearly a rectangle; beadShape is larger than its ellipse by these factors in
// width and height, to avoid visible gaps between neighbouring beads.
inline constexpr double kBeadFuller[] = {1.06, 1.25};
// Sets the drawn share of the beads' section: 1 for beads, less for thin lines. A height above the
// width is added below the bead.
void setBeadScale(vtkActor* actor, double width, double height);
// Hides beads whose open side faces away from the eye: valid for a body seen from outside.
void setBackBeadsHidden(vtkActor* actor, bool hidden);

} // namespace voluta::scene
