#include "viewer/camera_control.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

namespace voluta::viewer {

namespace {
using Eigen::Vector3d;

// VTK needs a larger angle than this between the view's up and its direction.
constexpr double kPoleMargin = base::degreesToRadians(3.0);
constexpr double kNearestMm = 2.0, kFarthestMm = 20000.0;

Vector3d vectorOf(const double* p) {
  return {p[0], p[1], p[2]};
}
} // namespace

vtkCamera* CameraControl::camera() const {
  return renderer_->GetActiveCamera();
}

Vector3d CameraControl::focalPoint() const {
  return vectorOf(camera()->GetFocalPoint());
}

Eigen::Matrix3d CameraControl::axes() const {
  const vtkMatrix4x4* view = camera()->GetViewTransformMatrix();
  Eigen::Matrix3d columns;
  for (int row = 0; row < 3; ++row)
    for (int axis = 0; axis < 3; ++axis)
      columns(axis, row) = view->GetElement(row, axis);
  return columns;
}

void CameraControl::place(const Vector3d& focal, const Vector3d& towardsEye, double distance) {
  const Vector3d eye = towardsEye.normalized();
  Vector3d up = Vector3d::UnitZ();
  if (std::abs(eye.z()) > std::cos(kPoleMargin)) {
    // Straight from above or below: the screen's up direction is kept.
    up = axes().col(1);
    up.z() = 0.0;
    if (up.norm() < 1e-6)
      up = std::copysign(1.0, eye.z()) * Vector3d::UnitY();
    up.normalize();
  }
  const Vector3d position = focal + distance * eye;
  vtkCamera* c = camera();
  c->SetFocalPoint(focal.x(), focal.y(), focal.z());
  c->SetPosition(position.x(), position.y(), position.z());
  c->SetViewUp(up.x(), up.y(), up.z());
  renderer_->ResetCameraClippingRange();
}

void CameraControl::orbit(double dxPixels, double dyPixels) {
  const double perPixel = base::kPi / std::max(1, renderer_->GetSize()[1]);
  const Eigen::Matrix3d a = axes();
  const Vector3d eye = a.col(2);
  const double limit = 0.5 * base::kPi - 1.01 * kPoleMargin;
  // At a pole the eye has no azimuth, so the screen's up direction gives it.
  const bool pole = std::abs(eye.z()) > std::cos(kPoleMargin);
  const Vector3d behind = eye.z() > 0.0 ? Vector3d(-a.col(1)) : Vector3d(a.col(1));
  const Vector3d& heading = pole ? behind : eye;
  const double azimuth = std::atan2(heading.y(), heading.x()) - dxPixels * perPixel;
  const double elevation =
      std::clamp(std::asin(std::clamp(eye.z(), -1.0, 1.0)) - dyPixels * perPixel, -limit, limit);
  place(focalPoint(),
        {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
         std::sin(elevation)},
        camera()->GetDistance());
}

void CameraControl::pan(double dxPixels, double dyPixels) {
  const double mm = mmPerPixel(focalPoint());
  const Eigen::Matrix3d a = axes();
  place(focalPoint() - mm * (dxPixels * a.col(0) + dyPixels * a.col(1)), a.col(2),
        camera()->GetDistance());
}

void CameraControl::zoom(double factor, double x, double y) {
  const double distance = camera()->GetDistance();
  const double wanted = std::clamp(distance / factor, kNearestMm, kFarthestMm);
  const double mm = mmPerPixel(focalPoint());
  const int* size = renderer_->GetSize();
  const Eigen::Matrix3d a = axes();
  const Vector3d under = mm * ((x - 0.5 * size[0]) * a.col(0) + (y - 0.5 * size[1]) * a.col(1));
  place(focalPoint() + (1.0 - wanted / distance) * under, a.col(2), wanted);
}

void CameraControl::lookAt(const Vector3d& focal) {
  place(focal, axes().col(2), camera()->GetDistance());
}

void CameraControl::viewFrom(const Vector3d& towardsEye) {
  if (std::abs(towardsEye.normalized().z()) > std::cos(kPoleMargin))
    camera()->SetViewUp(0.0, std::copysign(1.0, towardsEye.z()), 0.0);
  place(focalPoint(), towardsEye, camera()->GetDistance());
}

void CameraControl::frame(const Vector3d& centre, double radius) {
  const int* size = renderer_->GetSize();
  const double aspect = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
  const double half = base::degreesToRadians(0.5 * camera()->GetViewAngle());
  const double narrow = aspect < 1.0 ? std::atan(std::tan(half) * aspect) : half;
  place(centre, axes().col(2), std::clamp(radius / std::sin(narrow), kNearestMm, kFarthestMm));
}

Ray CameraControl::rayThrough(double x, double y) const {
  const int* size = renderer_->GetSize();
  const double mm = mmPerPixel(focalPoint());
  const Eigen::Matrix3d a = axes();
  const Vector3d through =
      focalPoint() + mm * ((x - 0.5 * size[0]) * a.col(0) + (y - 0.5 * size[1]) * a.col(1));
  const Vector3d origin = vectorOf(camera()->GetPosition());
  return {origin, (through - origin).normalized()};
}

Vector3d CameraControl::project(const Vector3d& world) const {
  const int* size = renderer_->GetSize();
  const Vector3d position = vectorOf(camera()->GetPosition());
  const Vector3d inView = axes().transpose() * (world - position);
  const double depth = -inView.z();
  if (depth <= 1e-9)
    return {0.0, 0.0, -1.0};
  const double half = base::degreesToRadians(0.5 * camera()->GetViewAngle());
  const double pixels = 0.5 * size[1] / (std::tan(half) * depth);
  return {0.5 * size[0] + pixels * inView.x(), 0.5 * size[1] + pixels * inView.y(), 0.5};
}

double CameraControl::mmPerPixel(const Vector3d& world) const {
  const Vector3d position = vectorOf(camera()->GetPosition());
  const double depth = std::max(1e-6, (position - world).dot(axes().col(2)));
  const double half = base::degreesToRadians(0.5 * camera()->GetViewAngle());
  return 2.0 * depth * std::tan(half) / std::max(1, renderer_->GetSize()[1]);
}

} // namespace voluta::viewer
