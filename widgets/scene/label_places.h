// Positions of body labels in a view: the middle of a body's visible area. Computed from a small
// image of the nearest bodies, rendered without OpenGL.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

namespace voluta::scene {

struct SeenBody {
  const geometry::TriangleMesh* mesh = nullptr;
  Eigen::Isometry3d world_T_body = Eigen::Isometry3d::Identity();
  bool throughOthers = false; // the others are drawn as glass in front of it
};

struct LabelView {
  Eigen::Matrix4d clip_T_world = Eigen::Matrix4d::Identity(); // OpenGL's: visible in [-1, 1]^3
  int width = 0, height = 0;                                  // pixels
  double minRadius = 0.0; // minimum radius [pixels] of a visible disc that gets a label
  double apart = 0.0;     // minimum distance between two labels [pixels]
  // Whether a point in world coordinates is shown. Null: all are.
  std::function<bool(const Eigen::Vector3d&)> shown;
};

// Returns for each body the point on its surface, in its frame, where the largest disc fits into
// its visible area. None if it is hidden, or if the label of a body with a larger visible area is
// too near.
std::vector<std::optional<Eigen::Vector3d>> labelPlaces(const std::vector<SeenBody>& bodies,
                                                        const LabelView& view);

} // namespace voluta::scene
