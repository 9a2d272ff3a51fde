#include "program/assumptions.h"

#include "base/units.h"

namespace voluta::program {

namespace {

std::vector<base::Message> ofTime(const plan::TimeModel& time) {
  std::vector<base::Message> said;
  const bool ramps = time.accelerationMmPerS2 > 0.0 || time.jointAccelerationRadPerS2 > 0.0;
  if (time.accelerationMmPerS2 > 0.0)
    said.push_back(base::message("Straight motions speed up at {acceleration} mm/s2 where the text "
                                 "says nothing else."_text,
                                 base::number(time.accelerationMmPerS2)));
  if (time.jointAccelerationRadPerS2 > 0.0)
    said.push_back(base::message(
        "Joints speed up at {acceleration:.0f}/s2 where the text says nothing else."_text,
        base::degrees(base::radiansToDegrees(time.jointAccelerationRadPerS2))));
  if (!ramps)
    said.emplace_back(
        "Motions speed up as their text says, and at once where it says nothing."_text);
  if (time.jointsInPercent)
    said.emplace_back("Joint speeds are told in percent: all of it is taken for 180 degrees/s, and "
                      "those travels' times are estimates."_text);
  if (time.junctionMm > 0.0)
    said.push_back(base::message("Corners are passed without a stop, as if rounded by an arc "
                                 "{distance:.3g} beside them."_text,
                                 base::mm(time.junctionMm)));
  else
    said.emplace_back("The arm stands where a motion has no blend."_text);
  if (time.cycleS > 0.0)
    said.push_back(
        base::message("No motion is shorter than the controller's cycle of {cycle} ms."_text,
                      base::number(1000.0 * time.cycleS)));
  if (time.lookAhead > 0)
    said.push_back(
        base::message("The controller looks {motions} motions ahead."_text, time.lookAhead));
  else
    said.emplace_back("The controller looks as far ahead as it has to."_text);
  if (time.turnMmPerRad > 0.0)
    said.push_back(
        base::message("The turn of the tool may have a limit of its own, a radian as long "
                      "as {way:.0f} of way: of both laws the worse counts for the flow."_text,
                      base::mm(time.turnMmPerRad)));
  return said;
}

} // namespace

std::vector<base::Message> assumptionsOf(const Dialect& dialect) {
  std::vector<base::Message> said = ofTime(dialect.time);
  if (dialect.merge.leastS > 0.0)
    said.push_back(base::message("Points of a bead nearer than {time} ms or {way} are joined where "
                                 "the bead stays the same."_text,
                                 base::number(1000.0 * dialect.merge.leastS),
                                 base::mm(dialect.merge.leastMm)));
  if (dialect.merge.motionS > 0.0)
    said.push_back(
        base::message("A motion that the plan makes in less than {time} ms takes as long, "
                      "and its flow is as much less."_text,
                      base::number(1000.0 * dialect.merge.motionS)));
  said.emplace_back(
      "The time that outputs take, and how the arm lags behind, are not counted."_text);
  said.emplace_back(
      "None of this was tried on a machine: begin slowly, with the extruder cold."_text);
  return said;
}

} // namespace voluta::program
