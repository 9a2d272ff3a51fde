// Where in a picture a body can be labelled: in the middle of what is seen of it. A small picture
// of who is seen where is made for that, without OpenGL.
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
  bool throughOthers = false; // the others are glass before it
};

struct LabelView {
  Eigen::Matrix4d clip_T_world = Eigen::Matrix4d::Identity(); // OpenGL's: visible in [-1, 1]^3
  int width = 0, height = 0;                                  // pixels
  double leastRadius = 0.0; // pixels: what shows less than a disc of it gets no label
  double apart = 0.0;       // pixels between two labels at least
  // Null: all is. In the world.
  std::function<bool(const Eigen::Vector3d&)> shown;
};

// One a body, in the body's frame, on its surface: where the largest disc fits into what is seen of
// it. None where it is hidden, or where the label of a body that shows more is in the way.
std::vector<std::optional<Eigen::Vector3d>> labelPlaces(const std::vector<SeenBody>& bodies,
                                                        const LabelView& view);

} // namespace voluta::scene
