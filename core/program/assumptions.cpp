#include "program/assumptions.h"

#include "base/units.h"

namespace voluta::program {

namespace {

std::vector<base::Message> ofTime(const plan::TimeModel& time) {
  std::vector<base::Message> said;
  const bool ramps = time.accelerationMmPerS2 > 0.0 || time.jointAccelerationRadPerS2 > 0.0;
  if (time.accelerationMmPerS2 > 0.0)
    said.push_back(base::message("Straight motions accelerate at {acceleration} mm/s2 "
                                 "unless the program states otherwise."_text,
                                 base::number(time.accelerationMmPerS2)));
  if (time.jointAccelerationRadPerS2 > 0.0)
    said.push_back(base::message(
        "Joints accelerate at {acceleration:.0f}/s2 unless the program states otherwise."_text,
        base::degrees(base::radiansToDegrees(time.jointAccelerationRadPerS2))));
  if (!ramps)
    said.emplace_back(
        "Programmed accelerations are used; where none is given, motion starts instantly."_text);
  if (time.jointsInPercent)
    said.emplace_back("Joint speeds are in percent: 100 % is assumed to be 180 "
                      "degrees/s, so the times of these travels are estimates."_text);
  if (time.junctionMm > 0.0)
    said.push_back(base::message("Corners are passed without a stop, as if rounded by an "
                                 "arc with a deviation of {distance:.3g}."_text,
                                 base::mm(time.junctionMm)));
  else
    said.emplace_back("The arm stops at points without a blend."_text);
  if (time.cycleS > 0.0)
    said.push_back(
        base::message("No motion is shorter than the controller's cycle of {cycle} ms."_text,
                      base::number(1000.0 * time.cycleS)));
  if (time.lookAhead > 0)
    said.push_back(base::message("Look-ahead of {motions} motions."_text, time.lookAhead));
  else
    said.emplace_back("Unlimited look-ahead."_text);
  if (time.rotationMmPerRad > 0.0)
    said.push_back(base::message("Tool rotation may be limited separately (1 rad = {way:.0f} of "
                                 "path); the slower of the two sets the flow."_text,
                                 base::mm(time.rotationMmPerRad)));
  return said;
}

} // namespace

std::vector<base::Message> assumptionsOf(const Dialect& dialect) {
  std::vector<base::Message> said = ofTime(dialect.time);
  if (dialect.merge.minS > 0.0)
    said.push_back(base::message("Points of a bead closer than {time} ms or {way} are "
                                 "merged if the bead stays the same."_text,
                                 base::number(1000.0 * dialect.merge.minS),
                                 base::mm(dialect.merge.minMm)));
  if (dialect.merge.motionS > 0.0)
    said.push_back(base::message("Motions shorter than {time} ms are stretched to that time and "
                                 "their flow is reduced to match."_text,
                                 base::number(1000.0 * dialect.merge.motionS)));
  if (dialect.sendsTexts)
    said.emplace_back("At a stop the pendant shows no text: the controller sends it to the sender "
                      "of the frames, which has to show it."_text);
  said.emplace_back("Output delays and following error are not modelled."_text);
  said.emplace_back("Not tested on a machine: start slowly, with a cold extruder."_text);
  return said;
}

} // namespace voluta::program
