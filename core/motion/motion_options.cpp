#include "motion/motion_options.h"

#include <algorithm>

namespace voluta::motion {

base::ParameterTable motionParameters() {
  const MotionOptions d;
  return base::ParameterTable(
      {base::numberParameter("bodyClearanceMm", "mm", d.printing.bodiesMm, 0.0, 50.0, "Motion"_text,
                             "clearance of the arm"_text,
                             "Distance that links, plate, nozzle holder and obstacles keep from "
                             "each other."_text),
       base::numberParameter(
           "partClearanceMm", "mm", d.printing.partMm, 0.0, 50.0, "Motion"_text,
           "clearance of the part"_text,
           "Distance that all but the print head keeps from what is printed."_text),
       base::numberParameter(
           "liftMm", "mm", d.liftMm, 0.5, 100.0, "Motion"_text, "lift"_text,
           "How far the nozzle leaves the part, at least, before it travels."_text),
       base::integerParameter("redundancySamples", d.samples, 8, 72, "Motion"_text,
                              "turns about the nozzle"_text,
                              "How many turns of the part about the nozzle's axis are tried at "
                              "each place."_text)});
}

MotionOptions motionOptions(const base::ParameterValues& values) {
  MotionOptions o;
  o.printing.bodiesMm = values.number("bodyClearanceMm");
  o.printing.partMm = values.number("partClearanceMm");
  o.travelling.bodiesMm = o.printing.bodiesMm;
  o.travelling.partMm = o.printing.partMm;
  o.liftMm = values.number("liftMm");
  o.hopLiftMm = std::min(o.hopLiftMm, o.liftMm);
  o.samples = static_cast<int>(values.integer("redundancySamples"));
  return o;
}

} // namespace voluta::motion
