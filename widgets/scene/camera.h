// Camera of a renderer: standard views, framing, the point under a pixel. All points and directions
// are in world coordinates [mm].
#pragma once

#include <Eigen/Geometry>
#include <vector>

class vtkRenderer;

namespace voluta::scene {

enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric };

// Turns the camera to a standard view; frameBox() sets its distance.
void lookFrom(vtkRenderer* renderer, StandardView view);
// Moves the camera along its view until the corners of the box just fit the view. If the box would
// be under one of the `covered` rectangles [pixels from the lower left corner], it is drawn
// somewhat smaller, next to them. Does nothing for an empty box.
void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box,
              const std::vector<Eigen::AlignedBox2d>& covered = {});
// As above, but only `inside`, a part of the box, has to avoid the covered rectangles.
void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box,
              const std::vector<Eigen::AlignedBox2d>& covered, const Eigen::AlignedBox3d& inside);
// Returns the box of the print and as much of its machine as is needed to recognise it, so that the
// print stays large enough to work on.
Eigen::AlignedBox3d printInMachine(const Eigen::AlignedBox3d& print,
                                   const Eigen::AlignedBox3d& machine);
// Moves the camera along its view so that a ball about `target` fills the view's height.
// Precondition: radiusMm > 0.
void lookAt(vtkRenderer* renderer, const Eigen::Vector3d& target, double radiusMm);

// Returns the distance from the target at which lookAt() places the eye.
double lookingDistance(vtkRenderer* renderer, double radiusMm);

// Returns the vector from the focal point to the eye; not a unit vector.
Eigen::Vector3d towardsEye(vtkRenderer* renderer);
// Returns the visible height of the world at the distance of that point [mm].
double pictureHeightMm(vtkRenderer* renderer, const Eigen::Vector3d& point);
// Returns the point at a pixel (from the lower left corner) and a depth in [0, 1] between the
// clipping planes. Not finite if the camera's view is degenerate.
Eigen::Vector3d pointAt(vtkRenderer* renderer, int x, int y, double depth);

} // namespace voluta::scene
