// A turntable camera, z upwards: what mouse and keys do to a vtkCamera. Display coordinates are
// VTK's: device pixels, y up. No Qt, no window.
#pragma once

#include <Eigen/Geometry>

class vtkCamera;
class vtkRenderer;

namespace voluta::viewer {

struct Ray {
  Eigen::Vector3d origin, direction; // direction is a unit vector
};

class CameraControl {
public:
  // The renderer outlives this object.
  explicit CameraControl(vtkRenderer* renderer) : renderer_(renderer) {}

  // Turns about the focal point: a drag over the viewport's height is half a turn. Stops 3 degrees
  // before the poles; viewFrom reaches them.
  void orbit(double dxPixels, double dyPixels);
  // The point under the cursor in the focal plane follows the cursor.
  void pan(double dxPixels, double dyPixels);
  // factor > 1 comes nearer; the point under (x, y) stays where it is.
  void zoom(double factor, double x, double y);
  // Looks along -towardsEye at the present focal point, from the present distance.
  void viewFrom(const Eigen::Vector3d& towardsEye);
  // The ball fills the view; the direction stays.
  void frame(const Eigen::Vector3d& centre, double radius);

  Ray rayThrough(double x, double y) const;
  // Display coordinates; z < 0 when the place is behind the eye.
  Eigen::Vector3d project(const Eigen::Vector3d& world) const;
  // mm that a pixel covers at this place.
  double mmPerPixel(const Eigen::Vector3d& world) const;
  // Columns: right, up, towards the eye.
  Eigen::Matrix3d axes() const;

private:
  vtkCamera* camera() const;
  Eigen::Vector3d focalPoint() const;
  void place(const Eigen::Vector3d& focal, const Eigen::Vector3d& towardsEye, double distance);

  vtkRenderer* renderer_;
};

} // namespace voluta::viewer
