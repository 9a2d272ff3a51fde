// A trajectory's motions in MELFA-BASIC V, shared by the dialects of that controller: straight
// motions of the TCP, or of the nozzle relative to the work that the arm holds (Ex-T control);
// joint motions in percent of kMelfaJointRadPerS.
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

// 1e-5 degrees rotate a point at 300 mm by 0.00005 mm.
inline constexpr int kMelfaMmDecimals = 4, kMelfaDegDecimals = 5, kMelfaFrameDecimals = 6;

// Returns "(x,y,z,a,b,c)" followed by `flags`.
std::string melfaPosition(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees, int mmDecimals,
                          int degDecimals, std::string_view flags);
// Returns A, B, C of a frame [degrees].
Eigen::Vector3d melfaDegrees(const Eigen::Isometry3d& pose);
// Returns a frame as a position; its flags have no meaning.
std::string melfaFrame(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);

class MelfaMotions : public LinkMotions {
public:
  // Throws as motionTargets. `input` must outlive this object.
  MelfaMotions(const ProgramInput& input, const base::RunContext& ctx);
  MelfaMotions(const MelfaMotions&) = delete;

  // Returns whether the nozzle is stationary and the arm holds the plate.
  bool holdsWork() const { return in_.cell.nozzleMount() == robot::Mount::World; }
  const TcpMotions& tcp() const override { return motions_; }
  std::size_t count() const { return poses_.size(); }
  // The TCP in the robot's base, rounded as written.
  Eigen::Vector3d mm(std::size_t i) const override { return poses_[i].tcpMm; }
  Eigen::Vector3d degrees(std::size_t i) const override { return angles_[i]; }
  // Speed of the straight motion.
  double mmPerS(std::size_t i) const override;
  // Rotation speeds are not part of the text.
  double degPerS(std::size_t) const override { return 0.0; }
  // Rounded down as written; 0: the arm stops after the motion. Precondition: i > 0.
  double blendMm(std::size_t i) const override;
  // Of a joint motion; the first one has kMelfaStartPercent.
  double jointPercent(std::size_t i) const override;

private:
  void placeNozzle();

  const ProgramInput& in_;
  // Targets of the stationary nozzle, or of the TCP in Base; poses_ of the TCP
  std::vector<MotionTarget> targets_, poses_;
  std::vector<Eigen::Vector3d> angles_; // Of poses_ [degrees]
  TcpMotions motions_;
};

} // namespace voluta::program
