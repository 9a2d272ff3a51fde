// Beads drawn as flat strips that face the eye and are shaded as if round: two triangles a
// segment, with the outline and the shading of a swept ellipse of the bead's width and height.
#pragma once

class vtkActor;

namespace voluta::scene {

class RangeMapper;

// `mapper` draws polydata with the point arrays beadTangent, beadDirection (unit vectors of the
// model) and beadShape (half width, half height, side: -1 or 1).
void drawAsBeads(vtkActor* actor, RangeMapper* mapper);
// Share of the beads' section that is drawn: 1 for beads, less for thin lines.
void setBeadScale(vtkActor* actor, double scale);

} // namespace voluta::scene
