// Finds where a part overhangs the layers printed before.
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
  double overhangRad = 0.7853981633974483; // Maximum overhang angle
  double contactMm = 0.1;                  // Surfaces this near to the ground rest on it
  // Edge length of a facet's samples, over which the outward direction hardly changes
  double sampleMm = 1.0;
};

struct Overhang {
  double areaMm2 = 0.0;
  Eigen::Vector3d worstAt = Eigen::Vector3d::Zero();
};

// Returns the area whose normal n satisfies n . outward < -sin(overhangRad), except on the ground.
Overhang findOverhang(const geometry::TriangleMesh& part, const layers::Ground& ground,
                      const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& outward,
                      const OverhangRule& rule);

// Not blocking; nullopt if there is no area.
std::optional<plan::Finding> overhangFinding(const Overhang& overhang, const OverhangRule& rule,
                                             GroundKind ground);

} // namespace voluta::substrate
