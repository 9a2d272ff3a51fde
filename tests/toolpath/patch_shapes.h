// Patches in closed form: a map from a region of the plane to a surface.
#pragma once

#include "layers/layer_stack.h"

#include <functional>
#include <vector>

namespace voluta::test {

using Loop = std::vector<Eigen::Vector2d>; // the first counter-clockwise, holes clockwise
using Lift = std::function<Eigen::Vector3d(const Eigen::Vector2d&)>;
using Height = std::function<double(const Eigen::Vector3d&)>;

Loop circle(double radius, bool hole = false, Eigen::Vector2d centre = {0, 0});
Loop rectangle(double width, double height);
Loop star(int tips, double outer, double inner);
Loop ell(double size, double arm);

// Irregular triangles of about `edgeMm` over the region, lifted; directions are the surface's
// normals. Seeded by `seed`.
layers::Patch patchOver(
    const std::vector<Loop>& loops, double edgeMm = 0.8,
    const Lift& lift = [](const Eigen::Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), 0.4); },
    const Height& height = [](const Eigen::Vector3d&) { return 0.8; }, unsigned seed = 1);

// A field of one direction, inclined to all axes (toolpath::StrandDyads).
Eigen::Matrix3d oneDirection(const Eigen::Vector3d& place);

// Lifts. A disc of radius R a becomes a cap of half angle a (equidistant from the pole).
Lift onSphere(double radius);
Lift onCylinder(double radius);
Lift onSaddle(double radius);

} // namespace voluta::test
