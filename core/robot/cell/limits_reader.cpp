#include "robot/cell/limits_reader.h"

namespace voluta::robot {

JointLimits readJointLimits(const base::JsonNode& joint, JointKind kind) {
  const bool slides = kind == JointKind::Sliding;
  const auto value = [&](double shown) { return ofShownValue(kind, shown); };
  const JointLimits limits{
      value(joint.at(slides ? "minMm" : "minDeg").number()),
      value(joint.at(slides ? "maxMm" : "maxDeg").number()),
      value(joint.at(slides ? "velocityMmPerS" : "velocityDegPerS").positive()),
      value(joint.at(slides ? "accelerationMmPerS2" : "accelerationDegPerS2").positive()), kind};
  if (limits.min >= limits.max)
    joint.fail(slides ? "must have minMm below maxMm"_text : "must have minDeg below maxDeg"_text);
  return limits;
}

} // namespace voluta::robot
