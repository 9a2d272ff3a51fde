#include "robot/limits_reader.h"

#include "base/units.h"

namespace voluta::robot {

JointLimits readJointLimits(const base::JsonNode& joint) {
  const JointLimits limits{base::degreesToRadians(joint.at("minDeg").number()),
                           base::degreesToRadians(joint.at("maxDeg").number()),
                           base::degreesToRadians(joint.at("velocityDegPerS").positive()),
                           base::degreesToRadians(joint.at("accelerationDegPerS2").positive())};
  if (limits.min >= limits.max)
    joint.fail("has minDeg not below maxDeg"_text);
  return limits;
}

} // namespace voluta::robot
