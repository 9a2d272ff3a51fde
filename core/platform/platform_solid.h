// The solid on which printing starts: a plate, a rod, or any body.
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

// In the work frame [mm]. A plate alone, a rod alone, or a body with its support: a plate below it
// or a rod in it. Empty: not known yet.
struct PlatformSolid {
  PlatformSolid() = default;
  // Implicit: a plate is a platform.
  PlatformSolid(std::vector<Eigen::Vector2d> plate) : polygon(std::move(plate)) {}
  PlatformSolid(std::initializer_list<Eigen::Vector2d> plate) : polygon(plate) {}

  // The plate: convex, counter-clockwise, solid below z = 0.
  std::vector<Eigen::Vector2d> polygon;
  std::optional<RodShape> rod;
  std::shared_ptr<const geometry::TriangleMesh> mesh; // Closed, facing outward

  bool known() const { return polygon.size() >= 3 || rod || mesh; }
};

} // namespace voluta::platform
