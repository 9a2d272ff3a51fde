#include "motion/motion_options.h"

#include "motion/layer_event_text.h"

#include <algorithm>
#include <string>

namespace voluta::motion {

namespace {
constexpr const char *kRotationSmoothing = "rotationSmoothing", *kWholePath = "wholePath",
                     *kMaxJerk = "maxJerk", *kCollisionModel = "collisionModel",
                     *kLearned = "learned", *kBranchChange = "branchChange", *kBlend = "blend";
constexpr const char *kNozzleRotation = "nozzleRotation", *kTangent = "tangent",
                     *kWorkAxis = "workAxis", *kRodrigues = "rodrigues";
constexpr const char *kMinLayerTime = "minLayerTimeS", *kMaxLayerTime = "maxLayerTimeS";

NozzleRotation nozzleRotation(const std::string& name) {
  return name == kTangent     ? NozzleRotation::Tangent
         : name == kWorkAxis  ? NozzleRotation::WorkAxis
         : name == kRodrigues ? NozzleRotation::Rodrigues
                              : NozzleRotation::Free;
}
} // namespace

base::ParameterTable motionParameters() {
  const MotionOptions d;
  return base::ParameterTable(
      {base::numberParameter(
           "bodyClearanceMm", "mm", d.printing.bodiesMm, 0.0, 50.0, "Motion"_text,
           "arm clearance"_text,
           "Minimum distance between links, plate, nozzle holder and obstacles."_text),
       base::numberParameter(
           "partClearanceMm", "mm", d.printing.partMm, 0.0, 50.0, "Motion"_text,
           "clearance to the part"_text,
           "Minimum distance of everything but the print head from printed material."_text),
       base::numberParameter(
           "liftMm", "mm", d.liftMm, 0.5, 100.0, "Motion"_text, "lift"_text,
           "Minimum distance by which the nozzle lifts off the part before it travels."_text),
       base::numberParameter(
           "wipeMm", "mm", d.wipeMm, 0.0, 200.0, "Motion"_text, "wipe"_text,
           "How far the nozzle moves back over its bead, or on along a closed one, with the extruder off before it lifts. 0: it lifts at the end of the bead."_text),
       base::choiceParameter(
           kNozzleRotation, "free",
           {{"free", "best for the arm"_text},
            {kTangent, "along the path"_text},
            {kWorkAxis, "along the plate"_text},
            {kRodrigues, "smallest rotation from upright"_text}},
           "Motion"_text, "nozzle rotation"_text,
           "Rotation of the nozzle about its own axis: best for the arm, or by a rule if the nozzle's attachments have a front. With a rule, fewer points can be reached."_text),
       base::integerParameter(
           "redundancySamples", d.samples, 8, 72, "Motion"_text, "rotations tried per point"_text,
           "How many rotations of the part about the nozzle's axis are tried at each point."_text),
       base::choiceParameter(
           kRotationSmoothing, "evened",
           {{"evened", "smoothed"_text}, {kWholePath, "minimum jerk of whole paths"_text}},
           "Motion"_text, "smoothing of rotations"_text,
           "How rotations about the nozzle are smoothed: quickly, or by a search for minimum joint jerk, which doubles the planning time of the motion."_text),
       base::numberParameter(
           "tiltToleranceDeg", "deg", base::radiansToDegrees(d.leanRad), 0.0, 10.0, "Motion"_text,
           "tilt tolerance"_text,
           "How far the nozzle may tilt from its planned direction where that makes the joints' motion smoother. Only with minimum jerk of whole paths."_text),
       base::numberParameter(
           kMaxJerk, "rad/s³", 0.0, 0.0, 1e6, "Motion"_text, "maximum jerk"_text,
           "Maximum jerk of every joint; for a sliding joint 100 mm count as 1 rad. The robot moves more slowly where a joint would exceed it, and speeds up and slows down more gently. 0: no limit."_text),
       base::choiceParameter(
           kCollisionModel, "exact",
           {{"exact", "shapes"_text}, {kLearned, "shapes, and a learned indicator"_text}},
           "Motion"_text, "collision model"_text,
           "How a search for minimum joint jerk of whole paths avoids collisions: by checks of the shapes afterwards, or also by the gradient of an indicator that is learned for each layer (for research; slow). The shapes decide in both cases."_text),
       base::choiceParameter(
           kBranchChange, "lift",
           {{"lift", "with the nozzle lifted"_text}, {kBlend, "while printing, if possible"_text}},
           "Motion"_text, "change of the arm's branch"_text,
           "Where the arm cannot print a whole path in one branch: whether the path is interrupted there, or the wrist changes over several points while printing, with the nozzle tilted within the tilt tolerance."_text),
       base::ofItem(base::textParameter(
           kPauseLayers, "Motion"_text, "pauses before layers"_text,
           "Numbers of layers of the part, separated by commas: before each of them the arm goes beside the part and waits until the operator continues, for example to put in an insert. Then it primes the nozzle there."_text)),
       base::ofItem(base::textParameter(
           kLayerEvents, "Motion"_text, "events before layers"_text,
           "What happens before layers of the part, separated by semicolons. Each begins with a layer (12) or a height in mm (z5.5): 12 pause TEXT; 20 wait SECONDS; 30 output NUMBER on; 35 photo OUTPUT SECONDS; 40 tool NUMBER; 50 statement FORMAT LINE."_text)),
       base::numberParameter(
           kMinLayerTime, "s", 0.0, 0.0, 3600.0, "Cooling"_text, "minimum layer time"_text,
           "Minimum time before a bead is covered by the next layer, at every place. The robot waits above the part where the order of the beads does not give them this time. 0: no limit."_text),
       base::numberParameter(
           kMaxLayerTime, "s", 0.0, 0.0, 36000.0, "Cooling"_text, "maximum layer time"_text,
           "Age up to which a bead still bonds with the one above it. Older places are reported. 0: no limit."_text),
       base::numberParameter(
           "purgeMm3", "mm3", d.purge.changeMm3, 0.0, 100000.0, "Tools"_text, "purge"_text,
           "Material that flows out at the place of the tool change after each change of the tool."_text),
       base::numberParameter("stitchFlow", "mm3/s", d.shot.flowMm3PerS, 0.0, 10000.0,
                             "Stitches"_text, "flow of a shot"_text,
                             "Flow into a pocket, at most that of the process. 0: as much."_text),
       base::numberParameter("stitchWait", "s", d.shot.waitS, 0.0, 60.0, "Stitches"_text,
                             "wait after a shot"_text,
                             "Time that the nozzle stays in the pocket after the shot, so that "
                             "the material does not come out again."_text)});
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
  o.rotation = nozzleRotation(values.text(kNozzleRotation));
  o.smoothing = values.text(kRotationSmoothing) == kWholePath ? SmoothingMethod::WholePath
                                                              : SmoothingMethod::Evened;
  o.maxJerk = values.number(kMaxJerk);
  o.learnedCollisions = values.text(kCollisionModel) == kLearned;
  o.blendsBranches = values.text(kBranchChange) == kBlend;
  o.leanRad = base::degreesToRadians(values.number("tiltToleranceDeg"));
  o.minLayerTimeS = layerTimes(values).minS;
  o.purge.changeMm3 = values.number("purgeMm3");
  o.purge.primesBeside = true;
  o.layerEvents = eventsAsked(values);
  o.shot.flowMm3PerS = values.number("stitchFlow");
  o.shot.waitS = values.number("stitchWait");
  return o;
}

plan::LayerTimes layerTimes(const base::ParameterValues& values) {
  return {values.number(kMinLayerTime), values.number(kMaxLayerTime)};
}

} // namespace voluta::motion
