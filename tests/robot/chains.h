// Serial arms for tests: of the makers' descriptions, and made from seeds.
#pragma once

#include "base/units.h"
#include "robot/kinematics/serial_chain.h"

#include <array>
#include <random>

namespace voluta::test {

inline robot::ChainJoint jointAt(const Eigen::Vector3d& xyz, const Eigen::Vector3d& axis,
                                 const Eigen::Vector3d& rpy = Eigen::Vector3d::Zero()) {
  robot::ChainJoint joint;
  joint.link_T_joint = Eigen::Translation3d(xyz) *
                       Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                       Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                       Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
  joint.axis = axis;
  return joint;
}

inline const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kY = Eigen::Vector3d::UnitY(),
                             kZ = Eigen::Vector3d::UnitZ();

inline robot::SerialChain ur5Chain() {
  const double q = base::kPi / 2, h = base::kPi;
  robot::SerialChain chain;
  chain.joints = {jointAt({0, 0, 89.159}, kZ),
                  jointAt({0, 0, 0}, kZ, {q, 0, 0}),
                  jointAt({-425, 0, 0}, kZ),
                  jointAt({-392.25, 0, 109.15}, kZ),
                  jointAt({0, -94.65, 0}, kZ, {q, 0, 0}),
                  jointAt({0, 82.3, 0}, kZ, {q, h, h})};
  return chain;
}

inline robot::SerialChain irb1200Chain() {
  robot::SerialChain chain;
  chain.joints = {jointAt({0, 0, 399.1}, kZ), jointAt({0, 0, 0}, kY),   jointAt({0, 0, 350}, kY),
                  jointAt({0, 0, 42}, kX),    jointAt({351, 0, 0}, kY), jointAt({82, 0, 0}, kX)};
  chain.last_T_flange = Eigen::AngleAxisd(base::kPi / 2, kY);
  return chain;
}

inline robot::SerialChain gofaChain() {
  robot::SerialChain chain;
  chain.joints = {jointAt({0, 0, 265}, kZ), jointAt({0, 0, 0}, kY),   jointAt({0, 0, 444}, kY),
                  jointAt({0, 0, 110}, kX), jointAt({470, 0, 0}, kY), jointAt({101, 0, 80}, kX)};
  chain.last_T_flange = Eigen::AngleAxisd(base::kPi / 2, kY);
  return chain;
}

// FANUC CRX-10iA by its lengths: axis 6 meets axis 5 150 mm from where 4 and 5 meet.
inline robot::SerialChain crxChain() {
  robot::SerialChain chain;
  chain.joints = {jointAt({0, 0, 245}, kZ), jointAt({0, 0, 0}, kY),    jointAt({0, 0, 540}, -kY),
                  jointAt({0, 0, 0}, -kX),  jointAt({540, 0, 0}, -kY), jointAt({160, 150, 0}, -kX)};
  chain.last_T_flange = Eigen::AngleAxisd(base::kPi / 2, kY);
  return chain;
}

// An arm by the lines of its axes, each with a frame of its own turn, a zero of its own, and a base
// and a flange at random poses.
class MadeArms {
public:
  explicit MadeArms(unsigned seed) : random_(seed) {}

  double between(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }
  double length() { return between(100, 500); }
  double sign() { return between(-1, 1) < 0.0 ? -1.0 : 1.0; }
  Eigen::Vector3d direction() {
    Eigen::Vector3d d;
    do
      d = Eigen::Vector3d(between(-1, 1), between(-1, 1), between(-1, 1));
    while (d.norm() > 1.0 || d.norm() < 0.1);
    return d.normalized();
  }
  Eigen::Isometry3d anywhere(double mm) {
    return Eigen::Translation3d(mm * direction()) * Eigen::AngleAxisd(between(-3, 3), direction());
  }
  robot::JointVector joints() {
    robot::JointVector q(6);
    for (int i = 0; i < 6; ++i)
      q[i] = between(-base::kPi, base::kPi);
    return q;
  }

  robot::SerialChain chainOf(std::array<robot::AxisLine, 6> axes) {
    for (std::size_t i = 0; i < 6; ++i) {
      axes[i].direction *= sign();
      const Eigen::AngleAxisd rotation(between(-3, 3), axes[i].direction);
      for (std::size_t k = i + 1; k < 6; ++k) {
        axes[k].point = axes[i].point + rotation * (axes[k].point - axes[i].point);
        axes[k].direction = rotation * axes[k].direction;
      }
    }
    const Eigen::Isometry3d base = anywhere(300);
    robot::SerialChain chain;
    Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
    for (const robot::AxisLine& axis : axes) {
      Eigen::Isometry3d frame = anywhere(1);
      frame.translation() = axis.point + between(-100, 100) * axis.direction;
      frame = base * frame;
      robot::ChainJoint joint;
      joint.link_T_joint = before.inverse() * frame;
      joint.axis = frame.linear().transpose() * (base.linear() * axis.direction);
      chain.joints.push_back(joint);
      before = frame;
    }
    chain.last_T_flange = anywhere(100);
    return chain;
  }

  // Upright: shoulder, elbow and wrist above each other, with random offsets.
  robot::SerialChain sphericalWrist() {
    std::array<robot::AxisLine, 6> axes = orthoBase();
    axes[4] = {axes[3].point, kY};
    axes[5] = {axes[3].point, kZ};
    return chainOf(axes);
  }
  robot::SerialChain bentWrist() {
    std::array<robot::AxisLine, 6> axes = orthoBase();
    axes[4] = {axes[3].point, kY};
    axes[5] = {axes[3].point + Eigen::Vector3d(between(-120, 120), between(-120, 120), 0), kZ};
    return chainOf(axes);
  }
  robot::SerialChain parallelAxes() {
    const double a2 = length(), a3 = length(), d4 = between(-150, 150), d5 = between(-120, 120);
    return chainOf({{{{0, 0, 0}, kZ},
                     {{0, 0, 0}, kY},
                     {{0, 0, a2}, kY},
                     {{0, 0, a2 + a3}, kY},
                     {{0, d4, a2 + a3}, kZ},
                     {{0, d4, a2 + a3 + d5}, kY}}});
  }
  robot::SerialChain any() {
    std::array<robot::AxisLine, 6> axes;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    for (robot::AxisLine& axis : axes) {
      axis = {at, direction()};
      at += between(50, 300) * direction();
    }
    return chainOf(axes);
  }

private:
  std::array<robot::AxisLine, 6> orthoBase() {
    const double a1 = between(-150, 150), a2 = between(-150, 150), b = between(-100, 100),
                 c2 = length(), c3 = length();
    return {{{{0, 0, 0}, kZ},
             {{a1, 0, 0}, kY},
             {{a1, 0, c2}, kY},
             {{a1 + a2, b, c2 + c3}, kZ},
             {},
             {}}};
  }

  std::mt19937_64 random_;
};

} // namespace voluta::test
