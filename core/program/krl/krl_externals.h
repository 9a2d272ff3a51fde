// External axes of KRL's targets: those that turn what is printed, those that carry the robot,
// where a program says that there are such (kKrlUnderRobot), and the extruder's, where it says that
// it is one (kKrlExtruder).
#pragma once

#include "base/text.h"
#include "plan/program.h"
#include "program/krl/krl_values.h"

#include <array>
#include <cstddef>
#include <optional>

namespace voluta::program {

class KrlExternals {
public:
  // `variables` outlive it.
  explicit KrlExternals(const KrlVariables& variables) : variables_(variables) {}

  // Takes over E1 and on of a motion's target. `turnBase`: they are an external kinematic's, and
  // become motion.externals, as those that carry the robot do; else all but the extruder's must
  // stand where they stood. The reason why they cannot be taken; nothing: they were.
  std::optional<base::Message> take(const KrlValue& target, bool turnBase,
                                    plan::ProgramMotion& motion);

  // Which E is the extruder's, from 0; nothing: it is no axis.
  std::optional<std::size_t> extruder() const;
  // As the rest, while there is one. Where it was last told to go, mm.
  double extruderMm() const;
  // Does $VEL_EXTAX hold it to less than it can?
  bool extruderIsSlowed() const;
  // It counts as 0 where it stands.
  void zeroExtruder();
  // Where it goes in a target that moves nothing else.
  std::optional<double> extruderAlone(const KrlValue& target) const;
  // It goes there; how long that takes, s. Nothing: no sensible number.
  std::optional<double> feed(double mm);

private:
  std::size_t underRobot() const; // how many carry it, from E1 on
  double extruderPercent() const;

  const KrlVariables& variables_;
  std::array<std::optional<double>, 6> at_; // degrees or mm, as last given
};

} // namespace voluta::program
