// A trajectory's motions as KRL makes them: straight ones of $TOOL in $BASE, which are slowed by
// their turn ($VEL.ORI1, $VEL.ORI2) where the TCP hardly moves; those by joints in per cent of
// kKrlPtpDegPerS.
#pragma once

#include "base/run_context.h"
#include "program/common/motion_targets.h"
#include "program/common/tcp_motions.h"
#include "program/program_input.h"
#include "program/stream/link_writer.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::program {

class KrlMotions : public LinkMotions {
public:
  // Throws as motionTargets. The input lives as long.
  KrlMotions(const ProgramInput& input, const base::RunContext& ctx);
  KrlMotions(const KrlMotions&) = delete;

  const TcpMotions& tcp() const override { return motions_; }
  // Of the nozzle in the work frame, or on what the arm holds; positions as they are written.
  Eigen::Vector3d mm(std::size_t i) const override { return targets_[i].tcpMm; }
  Eigen::Vector3d degrees(std::size_t i) const override; // A, B, C
  double mmPerS(std::size_t i) const override;
  double degPerS(std::size_t i) const override;
  double blendMm(std::size_t i) const override;
  double jointPercent(std::size_t i) const override; // whole

  // Of the turn of all motions but those that it gives the time, degrees/s.
  double turnLimit() const { return turnLimit_; }
  // Straight motions slower than what $VEL.CP may take.
  std::size_t slow() const { return slow_; }

private:
  double turnDegPerS(std::size_t i) const;
  bool goesByTurn(std::size_t i) const;
  void findTurnLimit();

  const ProgramInput& in_;
  std::vector<MotionTarget> targets_;
  TcpMotions motions_;
  double turnLimit_;
  std::size_t slow_ = 0;
};

} // namespace voluta::program
