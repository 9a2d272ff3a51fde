#include "program/spel/spelplus_points.h"

#include "program/common/euler_angles.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
constexpr double kMaxMm = 1e5, kMaxDegrees = 1e4;
constexpr std::size_t kMaxNumbers = 9;
} // namespace

LinePart spelplusPart(LineCursor line, std::string& name) {
  if (line.takeWord("fend"))
    return line.ended() ? LinePart::Ends : LinePart::Other;
  if (!line.takeWord("function"))
    return LinePart::Other;
  const bool named =
      line.takeName(name) && (!line.takeMark('(') || line.takeMark(')')) && line.ended();
  if (!named)
    name.clear();
  return LinePart::Begins;
}

Eigen::Isometry3d SpelplusPoint::pose() const {
  return poseOfZyx({parts[0], parts[1], parts[2]}, {parts[3], parts[4], parts[5]});
}

bool SpelplusVariables::takeNumber(LineCursor& line, double& value) const {
  return takeSum(
      line,
      [this](LineCursor&, const std::string& name, double& number) {
        const auto known = numbers.find(name);
        if (known == numbers.end())
          return false;
        number = known->second;
        return true;
      },
      value);
}

// ( number , ... )
bool SpelplusVariables::takeList(LineCursor& line, std::vector<double>& values) const {
  if (!line.takeMark('('))
    return false;
  do {
    double value = 0.0;
    if (values.size() == kMaxNumbers || !takeNumber(line, value))
      return false;
    values.push_back(value);
  } while (line.takeMark(','));
  return line.takeMark(')');
}

bool SpelplusVariables::takePoint(LineCursor& line, SpelplusPoint& point) const {
  std::string name;
  LineCursor ahead = line;
  if (!ahead.takeName(name))
    return false;
  if (std::vector<double> values; name == "xy") {
    if (!takeList(ahead, values) || (values.size() != 4 && values.size() != 6))
      return false;
    std::copy(values.begin(), values.end(), point.parts.begin());
  } else if (name == "agltopls") {
    if (!takeList(ahead, values) || (values.size() != 4 && values.size() != 6))
      return false;
    point.joints = values;
  } else if (const auto known = points.find(name); known != points.end()) {
    point = known->second;
  } else {
    return false;
  }
  while (takeOffset(ahead, point)) {
  }
  line = ahead;
  for (std::size_t k = 0; k < point.parts.size(); ++k)
    if (!(std::abs(point.parts[k]) <= (k < 3 ? kMaxMm : kMaxDegrees)))
      return false;
  return std::all_of(point.joints.begin(), point.joints.end(),
                     [](double degrees) { return std::abs(degrees) <= kMaxDegrees; });
}

// +X(5), -X(5), :X(5), or after a slash: a local's number or a posture.
bool SpelplusVariables::takeOffset(LineCursor& line, SpelplusPoint& point) const {
  static constexpr std::array<std::string_view, 6> kNames = {"x", "y", "z", "u", "v", "w"};
  static constexpr std::array<std::string_view, 6> kPostures = {"r", "l", "a", "b", "f", "nf"};
  LineCursor ahead = line;
  std::string name;
  if (ahead.takeMark('/')) {
    double number = 0.0;
    if (ahead.takeNumber(number)) {
      if (!(number >= 0.0 && number <= 15.0 && number == std::floor(number)))
        return false;
      point.local = static_cast<int>(number);
    } else if (!ahead.takeName(name) ||
               std::find(kPostures.begin(), kPostures.end(), name) == kPostures.end()) {
      return false;
    } else if (name == "r" || name == "l") {
      point.elbow = name == "r" ? 1 : -1;
    }
    line = ahead;
    return true;
  }
  const bool plus = ahead.takeMark('+'), minus = !plus && ahead.takeMark('-');
  const bool sets = !plus && !minus && ahead.takeMark(':');
  std::vector<double> values;
  if (!(plus || minus || sets) || !point.joints.empty() || !ahead.takeName(name) ||
      !takeList(ahead, values) || values.size() != 1)
    return false;
  const auto part = std::find(kNames.begin(), kNames.end(), name);
  if (part == kNames.end())
    return false;
  double& changed = point.parts[static_cast<std::size_t>(part - kNames.begin())];
  changed = sets ? values[0] : changed + (plus ? values[0] : -values[0]);
  line = ahead;
  return true;
}

} // namespace voluta::program
