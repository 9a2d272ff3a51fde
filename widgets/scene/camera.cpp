#include "scene/camera.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace voluta::scene {

using Eigen::Vector3d;

namespace {

constexpr double kMargin = 1.06;

double halfViewAngle(vtkCamera* camera) {
  return camera->GetViewAngle() * base::kPi / 360.0;
}

void place(vtkCamera* camera, const Vector3d& target, const Vector3d& eye, double halfHeight) {
  camera->SetFocalPoint(target.x(), target.y(), target.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetParallelScale(halfHeight);
}

// Moves the camera so that the corners of the box just fit.
void closeIn(vtkRenderer* renderer, const Eigen::AlignedBox3d& box) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* size = renderer->GetSize();
  const double aspect = size[1] > 0 ? double(size[0]) / size[1] : 1.28;
  const Vector3d eye(camera->GetPosition()), centre = box.center();
  const Vector3d back = (eye - centre).normalized();
  const Vector3d right = Vector3d(camera->GetViewUp()).cross(back).normalized();
  const Vector3d up = back.cross(right);
  const double slope = std::tan(halfViewAngle(camera));
  double distance = 0.0, half = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Vector3d v = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - centre;
    const double extent = std::max(std::abs(v.dot(right)) / aspect, std::abs(v.dot(up)));
    half = std::max(half, extent);
    distance = std::max(distance, v.dot(back) + extent / slope);
  }
  place(camera, centre, centre + kMargin * distance * back, kMargin * half);
}

} // namespace

void lookFrom(vtkRenderer* renderer, StandardView view) {
  Vector3d back(0.75, -1.0, 0.62), up = Vector3d::UnitZ();
  switch (view) {
  case StandardView::Front:
    back = -Vector3d::UnitY();
    break;
  case StandardView::Back:
    back = Vector3d::UnitY();
    break;
  case StandardView::Left:
    back = -Vector3d::UnitX();
    break;
  case StandardView::Right:
    back = Vector3d::UnitX();
    break;
  case StandardView::Top:
    back = Vector3d::UnitZ();
    up = Vector3d::UnitY();
    break;
  case StandardView::Bottom:
    back = -Vector3d::UnitZ();
    up = Vector3d::UnitY();
    break;
  case StandardView::Isometric:
    break;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(back.data());
  camera->SetViewUp(up.data());
}

void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box) {
  if (box.isEmpty())
    return;
  const double bounds[6] = {box.min().x(), box.max().x(), box.min().y(),
                            box.max().y(), box.min().z(), box.max().z()};
  renderer->ResetCamera(bounds);
  // VTK frames the box's ball, which leaves a wide margin.
  closeIn(renderer, box);
  renderer->ResetCameraClippingRange();
}

void lookAt(vtkRenderer* renderer, const Vector3d& target, double radiusMm) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const double distance = radiusMm / std::sin(halfViewAngle(camera));
  place(camera, target, target + distance * towardsEye(renderer).normalized(), radiusMm);
  renderer->ResetCameraClippingRange();
}

Vector3d towardsEye(vtkRenderer* renderer) {
  vtkCamera* camera = renderer->GetActiveCamera();
  return Vector3d(camera->GetPosition()) - Vector3d(camera->GetFocalPoint());
}

double pictureHeightMm(vtkRenderer* renderer, const Vector3d& point) {
  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
    return 2.0 * camera->GetParallelScale();
  const Vector3d eye(camera->GetPosition());
  return 2.0 * (point - eye).norm() * std::tan(halfViewAngle(camera));
}

Vector3d pointAt(vtkRenderer* renderer, int x, int y, double depth) {
  double p[4];
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(p);
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

} // namespace voluta::scene
