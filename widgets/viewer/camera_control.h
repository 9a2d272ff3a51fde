// A turntable camera, z upwards: the effect of mouse and keys on a vtkCamera. Display coordinates
// are VTK's: device pixels, y up. Independent of Qt and of windows.
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
  // The renderer must outlive this object.
  explicit CameraControl(vtkRenderer* renderer) : renderer_(renderer) {}

  // Rotates about the focal point: a drag over the viewport's height is half a turn. Stops 3
  // degrees before the poles, which only viewFrom reaches.
  void orbit(double dxPixels, double dyPixels);
  // The point under the cursor in the focal plane follows the cursor.
  void pan(double dxPixels, double dyPixels);
  // factor > 1 zooms in; the point under (x, y) keeps its place.
  void zoom(double factor, double x, double y);
  // Looks along -towardsEye at the current focal point, from the current distance.
  void viewFrom(const Eigen::Vector3d& towardsEye);
  // Moves the camera with its focal point to a place; keeps direction and distance.
  void lookAt(const Eigen::Vector3d& place);
  // Makes the sphere fill the view; keeps the direction.
  void frame(const Eigen::Vector3d& centre, double radius);

  Ray rayThrough(double x, double y) const;
  // Returns display coordinates; z < 0 if the point is behind the eye.
  Eigen::Vector3d project(const Eigen::Vector3d& world) const;
  // Returns the length that a pixel covers at this point [mm].
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
