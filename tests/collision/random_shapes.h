// Seeded random solids and placements.
#pragma once

#include "base/units.h"
#include "robot/body.h"

#include <Eigen/Geometry>
#include <random>

namespace voluta::test {

class RandomShapes {
public:
  explicit RandomShapes(unsigned seed) : engine_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Eigen::Vector3d point(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }
  Eigen::Isometry3d pose(double size) {
    Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
    const Eigen::Vector3d place = point(size), axis = point(1.0).normalized();
    t.linear() = Eigen::AngleAxisd(number(-3.0, 3.0), axis).toRotationMatrix();
    t.translation() = place;
    return t;
  }
  robot::Shape shape(int kind, double size) {
    switch (kind % 4) {
    case 0: {
      const Eigen::Vector3d a = point(size), b = point(size);
      return robot::Capsule{a, b, number(0.05, 0.6) * size};
    }
    case 1: {
      const Eigen::Isometry3d t = pose(size);
      const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.6 * size) + 0.5 * point(size);
      return robot::Box{t, half};
    }
    case 2: {
      const Eigen::Vector3d a = point(size), b = point(size);
      const double r0 = number(0.0, 0.8) * size, r1 = number(0.0, 0.8) * size;
      return robot::Frustum{a, b, r0, r1};
    }
    default: {
      robot::Prism prism;
      const int corners = 3 + static_cast<int>(number(0.0, 5.0));
      for (int i = 0; i < corners; ++i) {
        const double a = 2.0 * base::kPi * (i + number(0.0, 0.6)) / corners;
        prism.polygon.emplace_back(size * std::cos(a), size * std::sin(a));
      }
      prism.zMin = -number(0.1, 1.0) * size;
      prism.zMax = number(0.1, 1.0) * size;
      return prism;
    }
    }
  }

private:
  std::mt19937 engine_;
};

} // namespace voluta::test
