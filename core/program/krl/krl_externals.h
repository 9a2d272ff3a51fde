// External axes in KRL's targets: those that turn the part, those that carry the robot (if the
// program defines kKrlUnderRobot), and the extruder's (if it defines kKrlExtruder).
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
  // `variables` must outlive this object.
  explicit KrlExternals(const KrlVariables& variables) : variables_(variables) {}

  // Takes over E1, E2, ... of a motion's target. If `rotatesBase`, they belong to an external
  // kinematic system and become motion.externals, as do those that carry the robot; otherwise all
  // except the extruder's must keep their values. Returns the reason if they are invalid, else
  // nullopt.
  std::optional<base::Message> take(const KrlValue& target, bool rotatesBase,
                                    plan::ProgramMotion& motion);

  // Returns the index of the extruder's axis from 0; nullopt if the extruder is no axis.
  std::optional<std::size_t> extruder() const;
  // The following require an extruder axis. Returns its last commanded position [mm].
  double extruderMm() const;
  // Returns whether $VEL_EXTAX limits it to less than its maximum.
  bool extruderIsSlowed() const;
  // Sets its current position to 0.
  void zeroExtruder();
  // Returns its position in a target that moves nothing else.
  std::optional<double> extruderAlone(const KrlValue& target) const;
  // Moves it to the position and returns the time [s]; nullopt if a number is invalid.
  std::optional<double> feed(double mm);

private:
  std::size_t underRobot() const; // number of axes that carry the robot, starting with E1
  double extruderPercent() const;

  const KrlVariables& variables_;
  std::array<std::optional<double>, 6> at_; // degrees or mm, as last given
};

} // namespace voluta::program
