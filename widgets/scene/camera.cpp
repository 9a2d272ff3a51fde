#include "scene/camera.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace voluta::scene {

using Eigen::Vector3d;

namespace {

constexpr double kMargin = 1.06;
constexpr double kMaxAway = 1.5, kAwayStep = 1.04; // to clear widgets over the view
// Visible surroundings of a machine on each side of a print: shares of the largest edge of the
// print's and the machine's box.
constexpr double kRoomOfPrint = 3.0, kRoomOfMachine = 0.3;

double halfViewAngle(vtkCamera* camera) {
  return camera->GetViewAngle() * base::kPi / 360.0;
}

void place(vtkCamera* camera, const Vector3d& target, const Vector3d& eye, double halfHeight) {
  camera->SetFocalPoint(target.x(), target.y(), target.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetParallelScale(halfHeight);
}

double aspectOf(vtkRenderer* renderer) {
  const int* size = renderer->GetSize();
  return size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.28;
}

std::vector<Vector3d> cornersOf(const Eigen::AlignedBox3d& box) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8 && !box.isEmpty(); ++i)
    corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  return corners;
}

// Projects points into the view [pixels from the lower left corner].
class Lens {
public:
  explicit Lens(vtkRenderer* renderer)
      : camera_(renderer->GetActiveCamera()), size_(renderer->GetSize()[0], renderer->GetSize()[1]),
        eye_(camera_->GetPosition()),
        back_((eye_ - Vector3d(camera_->GetFocalPoint())).normalized()),
        right_(Vector3d(camera_->GetViewUp()).cross(back_).normalized()), up_(back_.cross(right_)) {
  }

  Eigen::Vector2d operator()(const Vector3d& p) const {
    const Vector3d v = p - eye_;
    const double half = camera_->GetParallelProjection()
                            ? camera_->GetParallelScale()
                            : std::max(1e-6, -v.dot(back_)) * std::tan(halfViewAngle(camera_));
    return 0.5 * (size_ + size_.y() / half * Eigen::Vector2d(v.dot(right_), v.dot(up_)));
  }

private:
  vtkCamera* camera_;
  Eigen::Vector2d size_;
  Vector3d eye_, back_, right_, up_;
};

// Returns whether the hull of points intersects a rectangle: whether no line parallel to one of the
// rectangle's sides, or through two of the points, separates them.
bool meets(const std::vector<Eigen::Vector2d>& points, const Eigen::AlignedBox2d& rectangle) {
  std::vector<Eigen::Vector2d> normals{Eigen::Vector2d::UnitX(), Eigen::Vector2d::UnitY()};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      normals.emplace_back(points[i].y() - points[j].y(), points[j].x() - points[i].x());
  for (const Eigen::Vector2d& normal : normals) {
    double low = std::numeric_limits<double>::infinity(), high = -low, rLow = low, rHigh = high;
    for (const Eigen::Vector2d& p : points) {
      low = std::min(low, normal.dot(p));
      high = std::max(high, normal.dot(p));
    }
    for (int k = 0; k < 4; ++k) {
      const double at =
          normal.dot(rectangle.corner(static_cast<Eigen::AlignedBox2d::CornerType>(k)));
      rLow = std::min(rLow, at);
      rHigh = std::max(rHigh, at);
    }
    if (high < rLow || rHigh < low)
      return false;
  }
  return true;
}

// Moves the camera so that the corners of the box just fit, then `away` times as far.
void closeIn(vtkRenderer* renderer, const Eigen::AlignedBox3d& box, double away) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const double aspect = aspectOf(renderer);
  const Vector3d eye(camera->GetPosition()), centre = box.center();
  const Vector3d back = (eye - centre).normalized();
  const Vector3d right = Vector3d(camera->GetViewUp()).cross(back).normalized();
  const Vector3d up = back.cross(right);
  const double slope = std::tan(halfViewAngle(camera));
  double distance = 0.0, half = 0.0;
  for (const Vector3d& corner : cornersOf(box)) {
    const Vector3d v = corner - centre;
    const double extent = std::max(std::abs(v.dot(right)) / aspect, std::abs(v.dot(up)));
    half = std::max(half, extent);
    distance = std::max(distance, v.dot(back) + extent / slope);
  }
  place(camera, centre, centre + away * kMargin * distance * back, away * kMargin * half);
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

void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box,
              const std::vector<Eigen::AlignedBox2d>& covered) {
  frameBox(renderer, box, covered, box);
}

void frameBox(vtkRenderer* renderer, const Eigen::AlignedBox3d& box,
              const std::vector<Eigen::AlignedBox2d>& covered, const Eigen::AlignedBox3d& inside) {
  if (box.isEmpty())
    return;
  const double bounds[6] = {box.min().x(), box.max().x(), box.min().y(),
                            box.max().y(), box.min().z(), box.max().z()};
  renderer->ResetCamera(bounds);
  // VTK frames the box's bounding sphere, which leaves a wide margin.
  const std::vector<Vector3d> corners = cornersOf(inside);
  for (double away = 1.0; away < kMaxAway; away *= kAwayStep) {
    closeIn(renderer, box, away);
    const Lens lens(renderer);
    std::vector<Eigen::Vector2d> seen;
    for (const Vector3d& corner : corners)
      seen.push_back(lens(corner));
    if (std::none_of(covered.begin(), covered.end(),
                     [&](const Eigen::AlignedBox2d& one) { return meets(seen, one); }))
      break;
  }
  renderer->ResetCameraClippingRange();
}

Eigen::AlignedBox3d printInMachine(const Eigen::AlignedBox3d& print,
                                   const Eigen::AlignedBox3d& machine) {
  if (print.isEmpty() || machine.isEmpty())
    return print.merged(machine);
  const double room = std::max(kRoomOfPrint * print.sizes().maxCoeff(),
                               kRoomOfMachine * machine.sizes().maxCoeff());
  const Vector3d low = print.min().array() - room, high = print.max().array() + room;
  return print.merged(machine.intersection(Eigen::AlignedBox3d(low, high)));
}

double lookingDistance(vtkRenderer* renderer, double radiusMm) {
  return radiusMm / std::sin(halfViewAngle(renderer->GetActiveCamera()));
}

void lookAt(vtkRenderer* renderer, const Vector3d& target, double radiusMm) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const double distance = lookingDistance(renderer, radiusMm);
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
