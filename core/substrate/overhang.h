// Where a part leans out over what is printed before it.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/ground.h"
#include "plan/finding.h"
#include "substrate/level_stack.h"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

namespace voluta::substrate {

struct OverhangRule {
  double overhangRad = 0.7853981633974483; // to which the part may lean out
  double contactMm = 0.1;                  // what is so near to the ground lies on it
  double sampleMm = 1.0; // edges of samples of a facet, over which the way outwards hardly turns
};

struct Overhang {
  double areaMm2 = 0.0;
  Eigen::Vector3d worstAt = Eigen::Vector3d::Zero();
};

// The area whose normal n has n . outward < -sin(overhangRad), off the ground.
Overhang findOverhang(const geometry::TriangleMesh& part, const layers::Ground& ground,
                      const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& outward,
                      const OverhangRule& rule);

// Not blocking; none where there is no area.
std::optional<plan::Finding> overhangFinding(const Overhang& overhang, const OverhangRule& rule,
                                             GroundKind ground);

} // namespace voluta::substrate
