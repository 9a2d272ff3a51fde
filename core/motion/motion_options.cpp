#include "motion/motion_options.h"

#include <algorithm>
#include <string>

namespace voluta::motion {

namespace {
constexpr const char *kTurnSmoothing = "turnSmoothing", *kWholePath = "wholePath";
constexpr const char *kNozzleTurn = "nozzleTurn", *kTangent = "tangent", *kWorkAxis = "workAxis",
                     *kRodrigues = "rodrigues";

NozzleTurn nozzleTurn(const std::string& name) {
  return name == kTangent     ? NozzleTurn::Tangent
         : name == kWorkAxis  ? NozzleTurn::WorkAxis
         : name == kRodrigues ? NozzleTurn::Rodrigues
                              : NozzleTurn::Free;
}
} // namespace

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
       base::numberParameter(
           "wipeMm", "mm", d.wipeMm, 0.0, 20.0, "Motion"_text, "wipe"_text,
           "How far the nozzle goes back over its bead, or on along one that closes, with the "
           "extruder off, before it lifts for the next. 0: it lifts where the bead ends."_text),
       base::choiceParameter(
           kNozzleTurn, "free",
           {{"free", "as the arm goes best"_text},
            {kTangent, "along the path"_text},
            {kWorkAxis, "along the plate"_text},
            {kRodrigues, "least turn from upright"_text}},
           "Motion"_text, "turn of the nozzle"_text,
           "How the nozzle stands about its own axis: as it suits the arm, or by a rule, where "
           "what it carries has a front. By a rule fewer places are reached."_text),
       base::integerParameter("redundancySamples", d.samples, 8, 72, "Motion"_text,
                              "turns about the nozzle"_text,
                              "How many turns of the part about the nozzle's axis are tried at "
                              "each place."_text),
       base::choiceParameter(
           kTurnSmoothing, "evened",
           {{"evened", "evened out"_text}, {kWholePath, "least jerk of whole paths"_text}},
           "Motion"_text, "smooth turns"_text,
           "How turns about the nozzle are made smooth: quickly, or by a search for the least jerk "
           "of the joints, which takes as long again as the rest of the motion."_text),
       base::numberParameter("directionConeDeg", "deg", base::radiansToDegrees(d.leanRad), 0.0,
                             10.0, "Motion"_text, "directions may lean"_text,
                             "How far the nozzle may lean from its planned direction where that "
                             "makes the joints' motion smoother. With least jerk of whole paths "
                             "only."_text)});
}

MotionOptions motionOptions(const base::ParameterValues& values) {
  MotionOptions o;
  o.printing.bodiesMm = values.number("bodyClearanceMm");
  o.printing.partMm = values.number("partClearanceMm");
  o.travelling.bodiesMm = o.printing.bodiesMm;
  o.travelling.partMm = o.printing.partMm;
  o.liftMm = values.number("liftMm");
  o.wipeMm = values.number("wipeMm");
  o.hopLiftMm = std::min(o.hopLiftMm, o.liftMm);
  o.samples = static_cast<int>(values.integer("redundancySamples"));
  o.turn = nozzleTurn(values.text(kNozzleTurn));
  o.smoothing =
      values.text(kTurnSmoothing) == kWholePath ? TurnMethod::WholePath : TurnMethod::Evened;
  o.leanRad = base::degreesToRadians(values.number("directionConeDeg"));
  return o;
}

} // namespace voluta::motion
