// Beads drawn as flat strips that face the eye and are shaded as if round: two triangles a
// segment, with the outline and the shading of a swept ellipse of the bead's width and height.
#pragma once

class vtkActor;

namespace voluta::scene {

class RangeMapper;

// `mapper` draws polydata with the point arrays beadTangent, beadDirection (unit vectors of the
// model), beadShape (half width, half height, side: -1 or 1) and beadOpen (unit vector to the side
// on which nothing is printed, or zero).
void drawAsBeads(vtkActor* actor, RangeMapper* mapper);
// Share of the beads' section that is drawn: 1 for beads, less for thin lines.
void setBeadScale(vtkActor* actor, double scale);
// Leave out beads whose open side is turned away from the eye: right for a body seen from outside.
void setBackBeadsHidden(vtkActor* actor, bool hidden);

} // namespace voluta::scene
