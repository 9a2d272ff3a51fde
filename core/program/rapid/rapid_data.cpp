#include "program/rapid/rapid_data.h"

#include "program/common/program_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace voluta::program {

std::string_view rapidShape(std::string_view type) {
  static const std::map<std::string_view, std::string_view> table = {
      {"num", "n"},
      {"bool", "b"},
      {"string", "s"},
      {"pos", "[nnn]"},
      {"orient", "[nnnn]"},
      {"pose", "[[nnn][nnnn]]"},
      {"confdata", "[nnnn]"},
      {"extjoint", "[nnnnnn]"},
      {"robjoint", "[nnnnnn]"},
      {"loaddata", "[n[nnn][nnnn]nnn]"},
      {"speeddata", "[nnnn]"},
      {"zonedata", "[bnnnnnn]"},
      {"robtarget", "[[nnn][nnnn][nnnn][nnnnnn]]"},
      {"jointtarget", "[[nnnnnn][nnnnnn]]"},
      {"tooldata", "[b[[nnn][nnnn]][n[nnn][nnnn]nnn]]"},
      {"wobjdata", "[bbs[[nnn][nnnn]][[nnn][nnnn]]]"},
  };
  const auto row = table.find(type);
  return row == table.end() ? std::string_view() : row->second;
}

std::optional<RapidData> predeclaredRapid(std::string_view type, std::string_view name) {
  const auto named = [&](char letter, auto& sizes) -> double {
    double value = 0.0;
    const bool known = name.size() > 1 && name.front() == letter &&
                       parseNumber(name.substr(1), value) &&
                       std::find(std::begin(sizes), std::end(sizes), value) != std::end(sizes);
    return known ? value : -1.0;
  };
  static constexpr double kSpeeds[] = {5,    10,   20,   30,   40,   50,   60,  80,   100,
                                       150,  200,  300,  400,  500,  600,  800, 1000, 1500,
                                       2000, 2500, 3000, 4000, 5000, 6000, 7000};
  static constexpr double kZones[] = {0, 1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200};
  if (type == "speeddata") {
    if (const double v = named('v', kSpeeds); v > 0.0)
      return RapidData{"[nnnn]", {v, 500, 5000, 1000}, ""};
  } else if (type == "zonedata") {
    if (name == "fine")
      return RapidData{"[bnnnnnn]", {1, 0, 0, 0, 0, 0, 0}, ""};
    if (const double z = named('z', kZones); z >= 0.0) {
      const double tcp = z > 0.0 ? z : 0.3, rotation = z > 1.0 ? 1.5 * z : tcp;
      return RapidData{
          "[bnnnnnn]", {0, tcp, rotation, rotation, 0.1 * rotation, rotation, 0.1 * rotation}, ""};
    }
  } else if (type == "tooldata" && name == "tool0") {
    return RapidData{"", {1, 0, 0, 0, 1, 0, 0, 0}, ""};
  } else if (type == "wobjdata" && name == "wobj0") {
    return RapidData{"", {0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, ""};
  }
  return std::nullopt;
}

bool rapidPose(const std::vector<double>& numbers, std::size_t at, Eigen::Isometry3d& pose,
               base::Message& reason) {
  constexpr double kQuaternionTolerance = 1e-5; // Of a quaternion's length
  const Eigen::Vector3d mm(numbers[at], numbers[at + 1], numbers[at + 2]);
  const Eigen::Quaterniond rotation(numbers[at + 3], numbers[at + 4], numbers[at + 5],
                                    numbers[at + 6]);
  if (!(mm.cwiseAbs().maxCoeff() <= kMaxRapidMm)) {
    reason = "a position far outside any robot's reach"_text;
    return false;
  }
  if (!(std::abs(rotation.norm() - 1.0) <= kQuaternionTolerance)) {
    reason = "a quaternion that is not normalised"_text;
    return false;
  }
  pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = mm;
  return true;
}

} // namespace voluta::program
