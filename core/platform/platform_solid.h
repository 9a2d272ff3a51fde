// What material starts on: a plate, a rod, or any body.
#pragma once

#include "geometry/triangle_mesh.h"
#include "platform/rod_shape.h"

#include <Eigen/Core>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::platform {

// Work frame, mm. A plate alone, a rod alone, or a body with what carries it: a plate below it or a
// rod within it. None: not known yet.
struct PlatformSolid {
  PlatformSolid() = default;
  // A plate is a platform, wherever one is asked for.
  PlatformSolid(std::vector<Eigen::Vector2d> plate) : polygon(std::move(plate)) {}
  PlatformSolid(std::initializer_list<Eigen::Vector2d> plate) : polygon(plate) {}

  // Of the plate: convex, counter-clockwise, solid below z = 0.
  std::vector<Eigen::Vector2d> polygon;
  std::optional<RodShape> rod;
  std::shared_ptr<const geometry::TriangleMesh> mesh; // closed, outward

  bool known() const { return polygon.size() >= 3 || rod || mesh; }
};

} // namespace voluta::platform
