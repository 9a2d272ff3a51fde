// Where the camera of a renderer stands: standard views, framing, what is under a pixel. All points
// and directions are in the world, mm.
#pragma once

#include <Eigen/Geometry>
#include <vector>

class vtkRenderer;

namespace voluta::scene {

enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric };

// Turns the camera to look from there; how far away it stands is left to frameBox().
void lookFrom(vtkRenderer* renderer, StandardView view);
// Moves the camera along its view until the corners of the box just fit the picture; where it would
// lie under something that covers a corner of the picture (pixels from the lower left corner), it
// is seen somewhat smaller, beside that. Nothing happens with an empty box.
void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box,
              const std::vector<Eigen::AlignedBox2d>& covered = {});
// The same, where only `inside`, which is a part of the box, keeps clear of what covers a corner.
void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box,
              const std::vector<Eigen::AlignedBox2d>& covered, const Eigen::AlignedBox3d& inside);
// The box of what is printed, and of its machine as much as it takes to know the machine, so that
// the print stays large enough to work on.
Eigen::AlignedBox3d printInMachine(const Eigen::AlignedBox3d& print,
                                   const Eigen::AlignedBox3d& machine);
// Moves the camera along its view so that a ball about `target` fills the picture's height.
// radiusMm > 0.
void lookAt(vtkRenderer* renderer, const Eigen::Vector3d& target, double radiusMm);

// How far from the target lookAt() puts the eye.
double lookingDistance(vtkRenderer* renderer, double radiusMm);

// From what is looked at to the eye; not a unit vector.
Eigen::Vector3d towardsEye(vtkRenderer* renderer);
// How much of the world the picture shows from bottom to top at the distance of that point, mm.
double pictureHeightMm(vtkRenderer* renderer, const Eigen::Vector3d& point);
// The point at a pixel (from the lower left corner) and a depth in [0, 1] between the clipping
// planes. Not finite where the camera shows nothing.
Eigen::Vector3d pointAt(vtkRenderer* renderer, int x, int y, double depth);

} // namespace voluta::scene
