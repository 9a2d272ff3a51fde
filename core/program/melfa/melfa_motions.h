// A trajectory's motions as MELFA-BASIC V makes them, for the dialects of that controller: straight
// ones of the TCP, or, where the arm holds the work, of the nozzle on it (Ex-T control); those by
// joints in per cent of kMelfaJointRadPerS.
#pragma once

#include "base/run_context.h"
#include "program/common/motion_targets.h"
#include "program/common/tcp_motions.h"
#include "program/program_input.h"
#include "program/stream/link_writer.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// 1e-5 degrees turn a point 300 mm off by 0.00005 mm.
inline constexpr int kMelfaMmDecimals = 4, kMelfaDegDecimals = 5, kMelfaFrameDecimals = 6;

// "(x,y,z,a,b,c)" with `flags` behind it.
std::string melfaPosition(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees, int mmDecimals,
                          int degDecimals, std::string_view flags);
// A, B, C of a frame, degrees.
Eigen::Vector3d melfaDegrees(const Eigen::Isometry3d& pose);
// A frame as a position; its flags say nothing.
std::string melfaFrame(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);

class MelfaMotions : public LinkMotions {
public:
  // Throws as motionTargets. The input lives as long.
  MelfaMotions(const ProgramInput& input, const base::RunContext& ctx);
  MelfaMotions(const MelfaMotions&) = delete;

  // The nozzle is in the world, the arm holds the plate.
  bool holdsWork() const { return in_.cell.nozzleMount() == robot::Mount::World; }
  const TcpMotions& tcp() const override { return motions_; }
  std::size_t count() const { return poses_.size(); }
  // The TCP in the robot's base, rounded as it is written.
  Eigen::Vector3d mm(std::size_t i) const override { return poses_[i].tcpMm; }
  Eigen::Vector3d degrees(std::size_t i) const override { return angles_[i]; }
  // Of what moves straight.
  double mmPerS(std::size_t i) const override;
  // Turns are not in the text.
  double degPerS(std::size_t) const override { return 0.0; }
  // Rounded down as written; 0: the arm stands behind it. Precondition: i > 0.
  double blendMm(std::size_t i) const override;
  // Of a motion by joints; the first one's is kMelfaStartPercent.
  double jointPercent(std::size_t i) const override;

private:
  void placeNozzle();

  const ProgramInput& in_;
  std::vector<MotionTarget> targets_, poses_; // of the nozzle where it stands; of the TCP in Base
  std::vector<Eigen::Vector3d> angles_;       // of poses_, degrees
  TcpMotions motions_;
};

} // namespace voluta::program
