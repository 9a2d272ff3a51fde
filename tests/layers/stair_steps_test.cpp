// Steps of layers on a slope, in closed form.
#include "layers/stair_steps.h"

#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::layers {
namespace {

using Eigen::Vector3d;

constexpr double kLengthMm = 60.0, kWidthMm = 20.0;

// A wedge that rises from x = 0 at an angle; a rectangle of each layer is cut at half its height.
struct Wedge {
  double angle = 0.0, heightMm = 0.0;

  double startAt(double z) const { return z / std::tan(angle); }

  geometry::TriangleMesh mesh() const {
    geometry::TriangleMesh m;
    for (const double y : {0.0, kWidthMm})
      for (const auto& [x, z] : {std::pair{0.0, 0.0},
                                 {kLengthMm, 0.0},
                                 {kLengthMm, heightMm},
                                 {startAt(heightMm), heightMm}})
        m.vertices.emplace_back(x, y, z);
    m.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {0, 4, 5}, {0, 5, 1},
                   {1, 5, 6}, {1, 6, 2}, {2, 6, 7}, {2, 7, 3}, {3, 7, 4}, {3, 4, 0}};
    return m;
  }

  LayerStack flatLayers(double thicknessMm) const {
    LayerStack stack;
    stack.layerCount = static_cast<int>(std::lround(heightMm / thicknessMm));
    for (int k = 0; k < stack.layerCount; ++k) {
      const double z = (k + 0.5) * thicknessMm, x = startAt(z);
      Patch patch;
      patch.surface.vertices = {
          {x, 0, z}, {kLengthMm, 0, z}, {kLengthMm, kWidthMm, z}, {x, kWidthMm, z}};
      patch.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
      patch.thicknessMm.assign(4, thicknessMm);
      patch.direction.assign(4, Vector3d::UnitZ());
      patch.clearDirection = patch.direction;
      patch.layer = k;
      stack.patches.push_back(std::move(patch));
    }
    return stack;
  }
};

TEST(Steps, OfFlatLayersOnASlope) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const double degrees = std::uniform_real_distribution<double>(20.0, 85.0)(random);
    const double thickness = std::uniform_real_distribution<double>(0.1, 1.0)(random);
    const Wedge wedge{base::degreesToRadians(degrees), 20 * thickness};
    const StepFigures steps =
        stepsOf(wedge.flatLayers(thickness), wedge.mesh(), base::RunContext());
    const double step = thickness * std::cos(wedge.angle);
    EXPECT_NEAR(steps.maxMm, step, 1e-9) << degrees;
    const double slope = wedge.heightMm / std::sin(wedge.angle) * kWidthMm;
    EXPECT_NEAR(steps.meanMm, step * slope / geometry::area(wedge.mesh()), 1e-9) << degrees;
  }
}

// Layers parallel to the slope meet only sides that are perpendicular to them, but the last ones.
TEST(Steps, LayersThatFollowASlopeHaveNone) {
  const Wedge wedge{base::degreesToRadians(30.0), 4.0};
  const Vector3d normal(-std::sin(wedge.angle), 0.0, std::cos(wedge.angle));
  const Vector3d along(std::cos(wedge.angle), 0.0, std::sin(wedge.angle));
  Patch patch;
  const double lengthMm = wedge.heightMm / std::sin(wedge.angle);
  for (const auto& [u, y] :
       {std::pair{0.0, 0.0}, {lengthMm, 0.0}, {lengthMm, kWidthMm}, {0.0, kWidthMm}})
    patch.surface.vertices.push_back(u * along + Vector3d(0, y, 0) - 0.2 * normal);
  patch.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  patch.thicknessMm.assign(4, 0.4);
  patch.direction.assign(4, normal);
  patch.innerRim = {1, 1, 1, 1};
  patch.innerRim[1] = patch.innerRim[2] = 0;
  LayerStack stack;
  stack.patches.push_back(patch);
  stack.layerCount = 1;
  // All its edges are seams but the upper one, whose nearest face is horizontal.
  EXPECT_LT(stepsOf(stack, wedge.mesh(), base::RunContext()).meanMm, 0.01);
  patch.innerRim.assign(4, 1);
  stack.patches = {patch};
  EXPECT_EQ(stepsOf(stack, wedge.mesh(), base::RunContext()).maxMm, 0.0);
}

TEST(Steps, SupportsHaveNone) {
  const Wedge wedge{base::degreesToRadians(45.0), 8.0};
  LayerStack stack = wedge.flatLayers(0.4);
  for (Patch& patch : stack.patches)
    patch.group = kSupportGroup;
  EXPECT_EQ(stepsOf(stack, wedge.mesh(), base::RunContext()).maxMm, 0.0);
}

} // namespace
} // namespace voluta::layers
