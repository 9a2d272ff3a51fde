// The mass that a robot carries by the distance of the load's centre from the flange, as makers
// state it (Castelli 2020, 2.1.5 and fig. 2.17).
#pragma once

#include "base/json_node.h"
#include "robot/robot_model.h"

#include <optional>
#include <vector>

namespace voluta::robot {

struct LoadPoint {
  double offsetMm = 0.0; // from the flange's centre
  double kg = 0.0;
};

// Reads "payloadCurve" of a robot's file: points with ascending offsets and masses that do not
// grow. Throws Error{UnusableInput}.
std::vector<LoadPoint> readPayloadCurve(const base::JsonNode& list);

// Returns the mass [kg] at that offset: linear between the points, that of the first below it, and
// beyond the last with the same moment. Precondition: the curve is not empty.
double payloadAt(const std::vector<LoadPoint>& curve, double offsetMm);

struct Payload {
  double kg = 0.0;
  bool byCurve = false; // false: the rated payload, whatever the offset
};
// Returns what the robot carries at that offset, by the curve of its file, if it has one. nullopt
// if its file states neither curve nor payload.
std::optional<Payload> payloadAt(const RobotModel& robot, double offsetMm);

} // namespace voluta::robot
