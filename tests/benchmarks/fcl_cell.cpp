#include "fcl_cell.h"
#include "voxel/voxel_grid.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace voluta::test {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

// Both are in the middle of the segment with z along it.
Isometry3d along(const Vector3d& p0, const Vector3d& p1) {
  Isometry3d pose = Isometry3d::Identity();
  if ((p1 - p0).norm() > 0.0)
    pose.linear() =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), p1 - p0).toRotationMatrix();
  pose.translation() = 0.5 * (p0 + p1);
  return pose;
}

std::pair<Geometry, Isometry3d> made(const robot::Capsule& s) {
  return {std::make_shared<fcl::Capsuled>(s.radius, (s.p1 - s.p0).norm()), along(s.p0, s.p1)};
}
std::pair<Geometry, Isometry3d> made(const robot::Box& s) {
  return {std::make_shared<fcl::Boxd>(Vector3d(2.0 * s.half)), s.frame_T_box};
}
std::pair<Geometry, Isometry3d> made(const robot::Frustum& s) {
  return {std::make_shared<fcl::Cylinderd>(std::max(s.r0, s.r1), (s.p1 - s.p0).norm()),
          along(s.p0, s.p1)};
}
std::pair<Geometry, Isometry3d> made(const robot::Prism& s) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : s.polygon)
    box.extend(p);
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() << box.center(), 0.5 * (s.zMin + s.zMax);
  return {std::make_shared<fcl::Boxd>(box.sizes().x(), box.sizes().y(), s.zMax - s.zMin), pose};
}

// The faces between cells filled in time and others, two triangles each.
std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> facesOf(const collision::GrowingPart& part,
                                                     std::size_t before, std::size_t& triangles) {
  const voxel::VoxelGrid& grid = part.grid();
  const auto filled = [&](const Eigen::Vector3i& c) {
    return grid.contains(c.x(), c.y(), c.z()) &&
           part.filledAt(grid.index(c.x(), c.y(), c.z())) < before;
  };
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel();
  triangles = 0;
  for (std::size_t i = 0; i < grid.cellCount(); ++i) {
    const Eigen::Vector3i cell = grid.cell(i);
    if (!filled(cell))
      continue;
    const Vector3d centre = grid.centre(cell.x(), cell.y(), cell.z());
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        if (filled(cell + side * Eigen::Vector3i::Unit(axis)))
          continue;
        const Vector3d u = 0.5 * grid.pitch * Vector3d::Unit((axis + 1) % 3);
        const Vector3d v = 0.5 * grid.pitch * Vector3d::Unit((axis + 2) % 3);
        const Vector3d m = centre + 0.5 * grid.pitch * side * Vector3d::Unit(axis);
        model->addTriangle(m - u - v, m + u - v, m + u + v);
        model->addTriangle(m - u - v, m + u + v, m - u + v);
        triangles += 2;
      }
  }
  model->endModel();
  return model;
}

} // namespace

struct FclCell::Objects {
  struct Placed {
    fcl::CollisionObjectd object;
    Isometry3d body_T_shape;
  };
  std::vector<std::vector<Placed>> bodies; // as cell.bodies()
  std::unique_ptr<fcl::CollisionObjectd> part;

  // Of all pairs that are to be looked at, until `visit` is true.
  template <typename Visit> bool any(const robot::Cell& cell, Visit&& visit) const {
    for (const auto& [a, b] : cell.checkedPairs())
      for (const Placed& s : bodies[static_cast<std::size_t>(a)])
        for (const Placed& t : bodies[static_cast<std::size_t>(b)])
          if (visit(s.object, t.object))
            return true;
    if (!part)
      return false;
    for (const int i : cell.bodiesAgainstPart())
      if (cell.bodies()[static_cast<std::size_t>(i)].role != robot::BodyRole::Head)
        for (const Placed& s : bodies[static_cast<std::size_t>(i)])
          if (visit(s.object, *part))
            return true;
    return false;
  }
};

FclCell::FclCell(const robot::Cell& cell, const collision::GrowingPart& part, std::size_t before)
    : cell_(cell), objects_(std::make_unique<Objects>()) {
  for (const robot::Body& body : cell.bodies()) {
    auto& shapes = objects_->bodies.emplace_back();
    for (const robot::Shape& shape : body.shapes) {
      const auto [geometry, pose] = std::visit([](const auto& s) { return made(s); }, shape);
      shapes.push_back({fcl::CollisionObjectd(geometry), pose});
    }
  }
  const auto faces = facesOf(part, before, partTriangles_);
  if (partTriangles_ > 0)
    objects_->part = std::make_unique<fcl::CollisionObjectd>(faces);
}

FclCell::~FclCell() = default;

void FclCell::place(const std::vector<Isometry3d>& base_T_frame) {
  const auto put = [](fcl::CollisionObjectd& object, const Isometry3d& pose) {
    object.setTransform(pose);
    object.computeAABB();
  };
  for (std::size_t i = 0; i < objects_->bodies.size(); ++i)
    for (Objects::Placed& s : objects_->bodies[i])
      put(s.object,
          base_T_frame[static_cast<std::size_t>(cell_.bodies()[i].frame)] * s.body_T_shape);
  if (objects_->part)
    put(*objects_->part, base_T_frame[static_cast<std::size_t>(cell_.workFrame())]);
}

bool FclCell::collides(const std::vector<Isometry3d>& base_T_frame) {
  place(base_T_frame);
  const fcl::CollisionRequestd request;
  return objects_->any(cell_, [&](const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
    fcl::CollisionResultd result;
    return a.getAABB().overlap(b.getAABB()) && fcl::collide(&a, &b, request, result) > 0;
  });
}

double FclCell::distance(const std::vector<Isometry3d>& base_T_frame) {
  place(base_T_frame);
  const fcl::DistanceRequestd request;
  double minimum = std::numeric_limits<double>::infinity();
  objects_->any(cell_, [&](const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
    if (a.getAABB().distance(b.getAABB()) < minimum) {
      fcl::DistanceResultd result;
      minimum = std::min(minimum, std::max(0.0, fcl::distance(&a, &b, request, result)));
    }
    return minimum <= 0.0;
  });
  return minimum;
}

} // namespace voluta::test
