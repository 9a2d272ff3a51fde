// Bars under a load, in closed form.
#include "toolpath/strength.h"

#include "base/error.h"
#include "base/units.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// A bar along x in flat layers, whose width varies from one value to another.
layers::LayerStack barStack(double lengthMm, double fromMm, double toMm, double heightMm,
                            int layers, int pieces = 50) {
  layers::LayerStack stack;
  stack.layerCount = layers;
  for (int k = 0; k < layers; ++k) {
    layers::Patch patch;
    const double h = heightMm / layers, z = (k + 0.5) * h;
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces,
                   half = 0.5 * (fromMm + share * (toMm - fromMm));
      patch.surface.vertices.emplace_back(share * lengthMm, -half, z);
      patch.surface.vertices.emplace_back(share * lengthMm, half, z);
      if (i > 0) {
        const int a = 2 * i - 2;
        patch.surface.triangles.push_back({a, a + 2, a + 3});
        patch.surface.triangles.push_back({a, a + 3, a + 1});
      }
    }
    patch.thicknessMm.assign(patch.surface.vertices.size(), h);
    patch.direction.assign(patch.surface.vertices.size(), Vector3d::UnitZ());
    patch.layer = k;
    stack.patches.push_back(std::move(patch));
  }
  return stack;
}

// Rings around x, from an inner to an outer radius.
layers::LayerStack woundStack(double lengthMm, double innerMm, double outerMm, int layers) {
  constexpr int kAround = 720;
  layers::LayerStack stack;
  for (int k = 0; k < layers; ++k) {
    layers::Patch patch;
    const double h = (outerMm - innerMm) / layers, r = innerMm + (k + 0.5) * h;
    for (int j = 0; j < kAround; ++j) {
      const double angle = 2.0 * base::kPi * j / kAround;
      const Vector3d out(0.0, std::cos(angle), std::sin(angle));
      for (const double x : {0.0, lengthMm}) {
        patch.surface.vertices.push_back(r * out + Vector3d(x, 0, 0));
        patch.direction.push_back(out);
      }
      const int a = 2 * j, b = 2 * ((j + 1) % kAround);
      patch.surface.triangles.push_back({a, a + 1, b + 1});
      patch.surface.triangles.push_back({a, b + 1, b});
    }
    patch.thicknessMm.assign(patch.surface.vertices.size(), h);
    patch.layer = k;
    stack.patches.push_back(std::move(patch));
  }
  return stack;
}

plan::StrengthStatistics of(const layers::LayerStack& stack, const Vector3d& load) {
  return strengthOf(stack, {}, 0, load.normalized());
}

TEST(Strength, ABarPrintedFlatHasNoInterfaceAcrossIt) {
  const plan::StrengthStatistics s = of(barStack(250, 10, 10, 5, 10), {1, 0, 0});
  EXPECT_NEAR(s.interfaceMm2, 0.0, 1e-9);
  EXPECT_NEAR(s.interfaceFraction, 0.0, 1e-12);
  EXPECT_NEAR(s.minSectionMm2, 50.0, 1e-6);
  EXPECT_EQ(s.maxInterfaceFraction, 0.0);
}

TEST(Strength, ABarPrintedUprightIsAllInterfaces) {
  // The same layers, loaded along their normal.
  const plan::StrengthStatistics s = of(barStack(10, 5, 5, 250, 500), {0, 0, 1});
  EXPECT_NEAR(s.interfaceMm2, 499 * 50.0, 1e-6);
  EXPECT_NEAR(s.interfaceFraction, 1.0, 1e-12);
  EXPECT_NEAR(s.maxInterfaceFraction, 1.0, 1e-12);
  EXPECT_NEAR(s.minSectionMm2, 50.0, 1e-6);
}

TEST(Strength, AWoundBarHasNoInterfaceAcrossItsAxis) {
  const layers::LayerStack stack = woundStack(100, 5, 8, 6);
  const plan::StrengthStatistics along = of(stack, {1, 0, 0});
  EXPECT_NEAR(along.interfaceFraction, 0.0, 1e-12);
  EXPECT_NEAR(along.minSectionMm2, base::kPi * (64.0 - 25.0), 0.01);
  // Across the axis, the mean of |cos| around the ring, by volume.
  EXPECT_NEAR(of(stack, {0, 0, 1}).interfaceMm2, 4.0 * 100.0 * (5.75 + 6.25 + 6.75 + 7.25 + 7.75),
              1.0);
}

TEST(Strength, InterfacesAtAnAngleCountByTheirProjection) {
  const layers::LayerStack stack = barStack(250, 10, 10, 5, 10);
  for (const double degrees : {1.0, 20.0, 45.0, 89.0}) {
    const double angle = base::degreesToRadians(degrees);
    const plan::StrengthStatistics s = of(stack, {std::cos(angle), 0.0, std::sin(angle)});
    EXPECT_NEAR(s.interfaceFraction, std::sin(angle), 1e-9) << degrees;
    EXPECT_NEAR(s.interfaceMm2, 9 * 2500.0 * std::sin(angle), 1e-6) << degrees;
  }
}

TEST(Strength, TheMinimumSectionOfATaperIsAtTheEndOfItsSections) {
  const plan::StrengthStatistics s = of(barStack(200, 20, 10, 4, 8), {1, 0, 0});
  // A tenth of the length at each end has no sections; slabs are 1 mm.
  EXPECT_NEAR(s.minSectionMm2, 4.0 * (10.0 + 20.5 / 200.0 * 10.0), 1e-6);
  EXPECT_NEAR(s.minSectionAtMm, 179.5, 1e-9);
}

TEST(Strength, DoesNotDependOnTheFrame) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const layers::LayerStack stack = barStack(80, 20, 12, 6, 6, 20);
  const Vector3d load = Vector3d(1.0, 0.3, 0.4).normalized();
  const plan::StrengthStatistics here = of(stack, load);
  for (int i = 0; i < 100; ++i) {
    const Quaterniond rotation =
        Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    layers::LayerStack turned = stack;
    for (layers::Patch& patch : turned.patches) {
      for (Vector3d& v : patch.surface.vertices)
        v = rotation * v;
      for (Vector3d& d : patch.direction)
        d = rotation * d;
    }
    const plan::StrengthStatistics there = of(turned, rotation * load);
    EXPECT_NEAR(there.interfaceFraction, here.interfaceFraction, 1e-6);
    EXPECT_NEAR(there.interfaceMm2, here.interfaceMm2, 1e-6);
    EXPECT_NEAR(there.minSectionMm2, here.minSectionMm2, 1e-4);
  }
}

TEST(Strength, BeadsAreWeighedByTheirVolume) {
  plan::ToolPlan plan;
  const auto add = [&](double degrees, double lengthMm, plan::PathKind kind) {
    const double angle = base::degreesToRadians(degrees);
    plan::ToolPath path;
    path.first = plan.position.size();
    path.count = 2;
    path.kind = kind;
    plan.paths.push_back(path);
    for (const double at : {0.0, lengthMm}) {
      plan.position.emplace_back(at * std::cos(angle), at * std::sin(angle), 0.0);
      plan.direction.push_back(Vector3d::UnitZ());
      plan.widthMm.push_back(1.2F);
      plan.heightMm.push_back(0.8F);
      plan.speedMmPerS.push_back(20.0F);
    }
  };
  add(0.0, 30.0, plan::PathKind::Wall);
  add(180.0, 10.0, plan::PathKind::Wall); // backwards is along as well
  add(90.0, 40.0, plan::PathKind::Infill);
  add(29.0, 20.0, plan::PathKind::Infill);
  add(90.0, 500.0, plan::PathKind::Support);
  add(90.0, 500.0, plan::PathKind::Skirt);
  add(90.0, 500.0, plan::PathKind::Shot); // the way into a pocket and out again
  const plan::StrengthStatistics s =
      strengthOf(barStack(100, 10, 10, 4, 4), plan, 0, Vector3d::UnitX());
  EXPECT_NEAR(s.angleMeanDeg, (40.0 * 90.0 + 20.0 * 29.0) / 100.0, 1e-5);
  EXPECT_NEAR(s.alignedFraction, 0.6, 1e-7);
}

TEST(Strength, DirectionsAreParsedOrRefused) {
  EXPECT_FALSE(loadDirection(""));
  EXPECT_NEAR((*loadDirection("0, 3,4") - Vector3d(0, 0.6, 0.8)).norm(), 0.0, 1e-12);
  for (const char* wrong : {"x", "1,0", "0,0,0", "1,0,0,0", "nan,0,1"})
    EXPECT_THROW(loadDirection(wrong), base::Error) << wrong;
}

} // namespace
} // namespace voluta::toolpath
