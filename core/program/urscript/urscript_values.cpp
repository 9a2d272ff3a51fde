#include "program/urscript/urscript_values.h"

#include "base/units.h"
#include "program/common/program_text.h"
#include "program/common/rotation_vector.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::program {

namespace {
constexpr int kMaxDepth = 20;

bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isNumber(const Value& v) {
  return v.kind == ValueKind::Number;
}
bool isPose(const Value& v) {
  return v.kind == ValueKind::Pose && v.count == 6;
}

Eigen::Isometry3d poseOf(const Value& v) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotationOf({v.list[3], v.list[4], v.list[5]}).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(v.list[0], v.list[1], v.list[2]);
  return pose;
}
Value valueOf(const Eigen::Isometry3d& pose) {
  Value v;
  v.kind = ValueKind::Pose;
  v.count = 6;
  const Eigen::Vector3d rotation = rotationVector(Eigen::Quaterniond(pose.linear()));
  for (std::size_t k = 0; k < 3; ++k) {
    v.list[k] = pose.translation()[static_cast<Eigen::Index>(k)];
    v.list[k + 3] = rotation[static_cast<Eigen::Index>(k)];
  }
  return v;
}

// Evaluates a function. Returns false for a function that queries the robot or is unknown.
bool given(const Call& call, Value& result) {
  const Value &first = call.arguments[0].value, &second = call.arguments[1].value;
  const bool number = call.count == 1 && isNumber(first);
  result = {};
  result.kind = ValueKind::Number;
  if (call.name == "d2r" && number)
    result.number = base::degreesToRadians(first.number);
  else if (call.name == "r2d" && number)
    result.number = base::radiansToDegrees(first.number);
  else if (call.name == "sqrt" && number && first.number >= 0.0)
    result.number = std::sqrt(first.number);
  else if (call.name == "pose_trans" && call.count == 2 && isPose(first) && isPose(second))
    result = valueOf(poseOf(first) * poseOf(second));
  else if (call.name == "pose_inv" && call.count == 1 && isPose(first))
    result = valueOf(poseOf(first).inverse());
  else
    return false;
  return true;
}
} // namespace

const Value* Call::find(std::string_view key, std::size_t position) const {
  for (std::size_t i = 0; i < count; ++i)
    if (arguments[i].name == key || (arguments[i].name.empty() && i == position))
      return &arguments[i].value;
  return nullptr;
}

bool UrscriptScanner::list(Value& value) {
  value.count = 0;
  if (take(']'))
    return true;
  do {
    Value number;
    if (value.count == value.list.size() || !this->value(number) || !isNumber(number))
      return false;
    value.list[value.count++] = number.number;
  } while (take(','));
  return take(']');
}

bool UrscriptScanner::value(Value& value) {
  if (++depth > kMaxDepth || !product(value))
    return false;
  for (blanks(); !rest.empty() && (rest.front() == '+' || rest.front() == '-'); blanks()) {
    const double sign = rest.front() == '+' ? 1.0 : -1.0;
    rest.remove_prefix(1);
    Value next;
    if (!product(next) || !isNumber(value) || !isNumber(next))
      return false;
    value.number += sign * next.number;
  }
  --depth;
  return !isNumber(value) || std::isfinite(value.number);
}

bool UrscriptScanner::product(Value& value) {
  if (!factor(value))
    return false;
  for (blanks(); !rest.empty() && (rest.front() == '*' || rest.front() == '/'); blanks()) {
    const bool times = rest.front() == '*';
    rest.remove_prefix(1);
    Value next;
    if (!factor(next) || !isNumber(value) || !isNumber(next))
      return false;
    value.number = times ? value.number * next.number : value.number / next.number;
  }
  return true;
}

bool UrscriptScanner::factor(Value& value) {
  blanks();
  value = {};
  if (rest.size() >= 2 && rest[0] == 'p' && rest[1] == '[') {
    rest.remove_prefix(2);
    value.kind = ValueKind::Pose;
    return list(value);
  }
  if (take('[')) {
    value.kind = ValueKind::List;
    return list(value);
  }
  if (take('"')) {
    value.kind = ValueKind::Text;
    return textBehindQuote(value.text);
  }
  if (take('('))
    return this->value(value) && take(')');
  if (!rest.empty() && isNameStart(rest.front()))
    return named(value);
  value.kind = ValueKind::Number;
  if (takeNumber(rest, value.number))
    return true;
  // -name and the like; a sign before a number belongs to the number.
  const bool minus = take('-');
  if ((!minus && !take('+')) || ++depth > kMaxDepth || !factor(value) || !isNumber(value))
    return false;
  --depth;
  value.number = minus ? -value.number : value.number;
  return true;
}

bool UrscriptScanner::named(Value& value) {
  const std::string_view before = rest, word = name();
  if (word == "True" || word == "true" || word == "False" || word == "false") {
    value.kind = ValueKind::Boolean;
    value.number = word.size() == 4 ? 1.0 : 0.0;
    return true;
  }
  if (const auto known = variables.find(word); known != variables.end()) {
    value = known->second;
    return true;
  }
  Call call;
  rest = before;
  call.name = name();
  return take('(') && arguments(call) && given(call, value);
}

bool UrscriptScanner::argument(Argument& argument) {
  const std::string_view before = rest;
  const std::string_view key = name();
  if (!key.empty() && take('=')) {
    argument.name = key;
  } else {
    rest = before;
  }
  return value(argument.value);
}

// After '('.
bool UrscriptScanner::arguments(Call& call) {
  if (take(')'))
    return true;
  do {
    if (call.count == call.arguments.size() || !argument(call.arguments[call.count]))
      return false;
    ++call.count;
  } while (take(','));
  return take(')');
}

bool UrscriptScanner::call(Call& call) {
  call.name = name();
  return !call.name.empty() && take('(') && arguments(call) && ended();
}

} // namespace voluta::program
