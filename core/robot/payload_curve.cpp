#include "robot/payload_curve.h"

#include "base/data_files.h"
#include "base/error.h"

#include <algorithm>

namespace voluta::robot {

namespace {

std::vector<LoadPoint> curveOf(const RobotModel& robot) {
  try {
    const base::JsonNode top =
        base::JsonNode::readFile(base::dataFile("robots", robot.id, "unknown robot '{id}'"_text));
    if (top.has("payloadCurve"))
      return readPayloadCurve(top.at("payloadCurve"));
  } catch (const base::Error&) {
    // A robot described in its cell's file has its rated payload only.
  }
  return {};
}

} // namespace

std::vector<LoadPoint> readPayloadCurve(const base::JsonNode& list) {
  std::vector<LoadPoint> curve;
  for (const base::JsonNode& node : list.items()) {
    node.allowOnly({"offsetMm", "kg"});
    const LoadPoint point{node.at("offsetMm").notNegative(), node.at("kg").positive()};
    if (!curve.empty() && point.offsetMm <= curve.back().offsetMm)
      node.at("offsetMm").fail("must be larger than that of the point before"_text);
    if (!curve.empty() && point.kg > curve.back().kg)
      node.at("kg").fail("must not be larger than that of the point before"_text);
    curve.push_back(point);
  }
  if (curve.empty())
    list.fail("must have at least one point"_text);
  return curve;
}

double payloadAt(const std::vector<LoadPoint>& curve, double offsetMm) {
  base::require(!curve.empty(), "a payload curve with points");
  const auto next = std::ranges::find_if(
      curve, [&](const LoadPoint& point) { return point.offsetMm >= offsetMm; });
  if (next == curve.begin())
    return next->kg;
  const LoadPoint& last = *std::prev(next);
  if (next == curve.end())
    return last.offsetMm > 0.0 ? last.kg * last.offsetMm / offsetMm : last.kg;
  const double share = (offsetMm - last.offsetMm) / (next->offsetMm - last.offsetMm);
  return last.kg + share * (next->kg - last.kg);
}

std::optional<Payload> payloadAt(const RobotModel& robot, double offsetMm) {
  if (const std::vector<LoadPoint> curve = curveOf(robot); !curve.empty())
    return Payload{payloadAt(curve, offsetMm), true};
  if (!robot.payloadKg)
    return std::nullopt;
  return Payload{*robot.payloadKg, false};
}

} // namespace voluta::robot
