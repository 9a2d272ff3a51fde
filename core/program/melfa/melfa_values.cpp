#include "program/melfa/melfa_values.h"

#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/rapid/rapid_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace voluta::program {

namespace {

constexpr double kMaxMm = 1e5, kMaxDeg = 1e4;
constexpr std::size_t kPoseNumbers = 6, kMaxNumbers = 8;

std::optional<std::size_t> partOf(std::string_view name) {
  constexpr std::string_view kParts = "xyzabc";
  const std::string small = inSmallLetters(name);
  const std::size_t at = small.size() == 1 ? kParts.find(small) : std::string_view::npos;
  return at == std::string_view::npos ? std::nullopt : std::optional(at);
}

ScriptValue valueOf(const Eigen::Isometry3d& pose) {
  ScriptValue value;
  value.kind = ScriptKind::List;
  const Eigen::Vector3d angles = xyzAngles(Eigen::Quaterniond(pose.linear()));
  for (int k = 0; k < 3; ++k)
    value.list.push_back(pose.translation()[k]);
  for (int k = 0; k < 3; ++k)
    value.list.push_back(base::radiansToDegrees(angles[k]));
  return value;
}

ScriptValue numberOf(double number) {
  ScriptValue value;
  value.kind = ScriptKind::Number;
  value.number = number;
  return value;
}

ScriptValue nothing() {
  ScriptValue value;
  value.kind = ScriptKind::List;
  value.list.assign(kPoseNumbers, 0.0);
  return value;
}

bool isFunction(std::string_view small) {
  return small == "rad" || small == "deg" || small == "sqr" || small == "abs" || small == "inv";
}

bool given(std::string_view function, const ScriptValue& of, ScriptValue& value) {
  if (function == "inv") {
    const auto pose = melfaPose(of);
    if (pose)
      value = valueOf(pose->inverse());
    return pose.has_value();
  }
  if (of.kind != ScriptKind::Number)
    return false;
  if (function == "rad")
    value = numberOf(base::degreesToRadians(of.number));
  else if (function == "deg")
    value = numberOf(base::radiansToDegrees(of.number));
  else if (function == "abs")
    value = numberOf(std::abs(of.number));
  else
    value = numberOf(std::sqrt(of.number));
  return std::isfinite(value.number);
}

} // namespace

std::optional<Eigen::Isometry3d> melfaPose(const ScriptValue& value) {
  if (value.kind != ScriptKind::List || value.list.size() < kPoseNumbers ||
      value.list.size() > kMaxNumbers)
    return std::nullopt;
  return melfaPose(Eigen::Vector3d(value.list.data()), Eigen::Vector3d(value.list.data() + 3));
}

std::optional<Eigen::Isometry3d> melfaPose(const Eigen::Vector3d& mm,
                                           const Eigen::Vector3d& degrees) {
  if (!(mm.cwiseAbs().maxCoeff() <= kMaxMm) || !(degrees.cwiseAbs().maxCoeff() <= kMaxDeg))
    return std::nullopt;
  Eigen::Isometry3d pose(rotationOfXyz(degrees * base::degreesToRadians(1.0)));
  pose.pretranslate(mm);
  return pose;
}

void seeFromHeldWork(plan::ReadProgram& program, const Eigen::Isometry3d& base_T_nozzle) {
  program.base_T_nozzle = base_T_nozzle;
  for (plan::ProgramMotion& m : program.motions)
    if (m.target == plan::TargetKind::FlangePose) {
      m.target = plan::TargetKind::WorkPose;
      m.frame_T_tcp = m.frame_T_tcp.inverse() * base_T_nozzle;
    }
}

bool setMelfaPart(ScriptValue& position, std::string_view name, double value) {
  const auto at = partOf(name);
  if (position.kind != ScriptKind::List || !at || position.list.size() < kPoseNumbers)
    return false;
  position.list[*at] = *at < 3 ? value : base::radiansToDegrees(value);
  return true;
}

std::string MelfaScanner::variableName() {
  std::string small = inSmallLetters(name());
  if (!small.empty() && !rest.empty() &&
      std::string_view("%#!$").find(rest.front()) != std::string_view::npos)
    rest.remove_prefix(1);
  return small;
}

bool MelfaScanner::named(std::string_view name, ScriptValue& value) {
  const std::string small = inSmallLetters(name);
  if (isFunction(small)) {
    ScriptValue of;
    return take('(') && this->value(of) && take(')') && given(small, of, value);
  }
  if (small == "p_nbase" || small == "p_ntool") {
    value = nothing();
    return true;
  }
  if (small == "m_nspd" || small == "m_novrd" || small == "m_njovrd") {
    value = numberOf(small == "m_nspd" ? kMelfaFastestMmPerS : 100.0);
    return true;
  }
  if (!rest.empty() && std::string_view("%#!").find(rest.front()) != std::string_view::npos)
    rest.remove_prefix(1);
  return ScriptScanner::named(small, value) && part(value);
}

bool MelfaScanner::part(ScriptValue& value) {
  if (rest.empty() || rest.front() != '.')
    return true;
  rest.remove_prefix(1);
  const auto at = partOf(name());
  if (!at || value.kind != ScriptKind::List || value.list.size() < kPoseNumbers)
    return false;
  value = numberOf(*at < 3 ? value.list[*at] : base::degreesToRadians(value.list[*at]));
  return true;
}

bool MelfaScanner::behindList(ScriptValue& list) {
  if (rest.empty() || rest.front() != '(')
    return list.list.size() <= kMaxNumbers;
  rest.remove_prefix(1);
  std::vector<ScriptValue> flags;
  const bool sound =
      arguments(flags) && flags.size() <= 2 && list.list.size() <= kMaxNumbers &&
      std::all_of(flags.begin(), flags.end(), [](const ScriptValue& flag) {
        return flag.kind == ScriptKind::Number && flag.number == std::floor(flag.number);
      });
  for (const ScriptValue& flag : flags)
    list.flags.push_back(flag.number);
  return sound;
}

bool MelfaScanner::oddNumber(double& value) {
  if (rest.size() < 3 || rest.front() != '&')
    return false;
  const int base = sameWord(rest.substr(1, 1), "h") ? 16 : sameWord(rest.substr(1, 1), "b") ? 2 : 0;
  std::uint32_t number = 0;
  if (base == 0)
    return false;
  const auto [end, error] =
      std::from_chars(rest.data() + 2, rest.data() + rest.size(), number, base);
  if (error != std::errc())
    return false;
  value = number;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return true;
}

bool MelfaScanner::operate(char op, const ScriptValue& a, const ScriptValue& b,
                           ScriptValue& result) {
  if (a.kind != ScriptKind::List || b.kind != ScriptKind::List)
    return false;
  if (op == '+' || op == '-') {
    result = a;
    for (std::size_t k = 0; k < std::min(a.list.size(), b.list.size()); ++k)
      result.list[k] += op == '+' ? b.list[k] : -b.list[k];
    return a.list.size() == b.list.size();
  }
  const auto first = melfaPose(a), second = melfaPose(b);
  if (!first || !second)
    return false;
  result = valueOf(op == '*' ? *first * *second : *first * second->inverse());
  return true;
}

} // namespace voluta::program
