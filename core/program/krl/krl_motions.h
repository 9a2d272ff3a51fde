// A trajectory's motions in the form KRL needs: straight motions of $TOOL in $BASE, whose time is
// determined by their rotation ($VEL.ORI1, $VEL.ORI2) where the TCP hardly moves; joint motions in
// percent of kKrlPtpDegPerS.
#pragma once

#include "base/run_context.h"
#include "program/common/motion_targets.h"
#include "program/common/tcp_motions.h"
#include "program/program_input.h"
#include "program/stream/link_writer.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::program {

class KrlMotions : public LinkMotions {
public:
  // Throws as motionTargets. The input must outlive this object.
  KrlMotions(const ProgramInput& input, const base::RunContext& ctx);
  KrlMotions(const KrlMotions&) = delete;

  const TcpMotions& tcp() const override { return motions_; }
  // Pose of the nozzle in the work frame, or on the object the arm holds; positions as written.
  Eigen::Vector3d mm(std::size_t i) const override { return targets_[i].tcpMm; }
  Eigen::Vector3d degrees(std::size_t i) const override; // A, B, C
  // Returns the pose that motion i passes if it is an arc.
  std::optional<ViaTarget> via(std::size_t i) const;
  double mmPerS(std::size_t i) const override;
  double degPerS(std::size_t i) const override;
  double blendMm(std::size_t i) const override;
  double jointPercent(std::size_t i) const override; // whole

  // Rotation speed [degrees/s] that suffices for all motions except those whose time the rotation
  // determines.
  double rotationLimit() const { return rotationLimit_; }
  // Number of straight motions slower than the minimum of $VEL.CP.
  std::size_t slow() const { return slow_; }

private:
  double rotationDegPerS(std::size_t i) const;
  bool isTimedByRotation(std::size_t i) const;
  void findRotationLimit();

  const ProgramInput& in_;
  std::vector<MotionTarget> targets_;
  TcpMotions motions_;
  double rotationLimit_;
  std::size_t slow_ = 0;
};

} // namespace voluta::program
