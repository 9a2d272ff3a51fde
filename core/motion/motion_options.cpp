#include "motion/motion_options.h"

#include <algorithm>

namespace voluta::motion {

base::ParameterTable motionParameters() {
  const MotionOptions d;
  return base::ParameterTable(
      {base::numberParameter("bodyClearanceMm", "mm", d.printing.bodiesMm, 0.0, 50.0, "Motion",
                             "clearance of the arm",
                             "Distance that links, plate, nozzle holder and obstacles keep from "
                             "each other."),
       base::numberParameter("partClearanceMm", "mm", d.printing.partMm, 0.0, 50.0, "Motion",
                             "clearance of the part",
                             "Distance that all but the print head keeps from what is printed."),
       base::numberParameter("liftMm", "mm", d.liftMm, 0.5, 100.0, "Motion", "lift",
                             "How far the nozzle leaves the part, at least, before it travels."),
       base::integerParameter("redundancySamples", d.samples, 8, 72, "Motion",
                              "turns about the nozzle",
                              "How many turns of the part about the nozzle's axis are tried at "
                              "each place.")});
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
