#include "program/krl/krl_values.h"

#include "program/common/euler_angles.h"

#include <charconv>
#include <cmath>

namespace voluta::program {

namespace {

constexpr int kMaxDepth = 4;
constexpr std::size_t kMaxParts = 40;
constexpr double kMaxMm = 1e5, kMaxDegrees = 1e7;

std::string pathOf(const std::string& within, const std::string& part) {
  return within.empty() ? part : part.empty() ? within : within + "." + part;
}

// Parses 'B0101' or 'HFF', the usual notation of S and T.
bool takeBits(LineCursor& line, double& value) {
  std::string digits;
  if (!line.takeMark('\'') || !line.takeName(digits) || !line.takeMark('\'') || digits.size() < 2)
    return false;
  const int base = digits.front() == 'b' ? 2 : digits.front() == 'h' ? 16 : 0;
  unsigned bits = 0;
  if (base == 0 || digits.size() > 9)
    return false;
  const char* end = digits.data() + digits.size();
  const auto [read, error] = std::from_chars(digits.data() + 1, end, bits, base);
  value = bits;
  return error == std::errc() && read == end;
}

// Returns whether `path` is the variable itself or a part of it; `rest`: the path within it.
bool isBelow(std::string_view path, std::string_view variable, std::string_view& rest) {
  if (!path.starts_with(variable))
    return false;
  rest = path.substr(variable.size());
  if (rest.empty())
    return true;
  if (rest.front() != '.')
    return false;
  rest.remove_prefix(1);
  return true;
}

template <typename Map> Map partsBelow(const Map& all, const std::string& variable) {
  Map parts;
  std::string_view rest;
  for (auto it = all.lower_bound(variable); it != all.end() && it->first.starts_with(variable);
       ++it)
    if (isBelow(it->first, variable, rest))
      parts.emplace(rest, it->second);
  return parts;
}

template <typename Map> void eraseBelow(Map& all, const std::string& variable) {
  std::string_view rest;
  for (auto it = all.lower_bound(variable); it != all.end() && it->first.starts_with(variable);)
    it = isBelow(it->first, variable, rest) ? all.erase(it) : std::next(it);
}

} // namespace

bool takeKrlInput(LineCursor& line, int& input, bool& on) {
  constexpr std::string_view kInput = "$in[";
  std::string path, value;
  double number = 0.0;
  if (!takeKrlPath(line, path) || !path.starts_with(kInput) || !path.ends_with("]") ||
      !parseNumber(std::string_view(path).substr(kInput.size(), path.size() - kInput.size() - 1),
                   number) ||
      !(number >= 1.0 && number <= 255.0) || !line.takeMark('=') || !line.takeMark('=') ||
      !line.takeName(value) || (value != "true" && value != "false") || !line.ended())
    return false;
  input = static_cast<int>(number) - 1;
  on = value == "true";
  return true;
}

int krlToolOf(std::string_view path) {
  constexpr std::string_view kOutput = "$out[";
  double number = 0.0;
  if (!path.starts_with(kOutput) || !path.ends_with("]") ||
      !parseNumber(path.substr(kOutput.size(), path.size() - kOutput.size() - 1), number))
    return 0;
  return number >= 2.0 && number <= 255.0 ? static_cast<int>(number) - 1 : 0;
}

bool takeKrlPath(LineCursor& line, std::string& path) {
  if (!line.takeName(path))
    return false;
  for (;;) {
    if (line.isMark('[')) {
      LineCursor ahead = line;
      double index = 0.0;
      ahead.takeMark('[');
      if (!ahead.takeNumber(index) || !ahead.takeMark(']') || index != std::floor(index) ||
          !(index >= 0.0 && index < 1e6))
        return false;
      path += "[" + std::to_string(static_cast<long>(index)) + "]";
      line = ahead;
    } else if (line.isMark('.')) {
      std::string part;
      line.takeMark('.');
      if (!line.takeName(part))
        return false;
      path += "." + part;
    } else {
      return true;
    }
  }
}

std::optional<double> krlNumber(const KrlValue& value, std::string_view path) {
  const auto found = value.numbers.find(path);
  return found == value.numbers.end() ? std::nullopt : std::optional(found->second);
}

KrlVariables::KrlVariables() {
  for (const std::string_view part : kKrlPose)
    all_.numbers.emplace("$nullframe." + std::string(part), 0.0);
}

bool KrlVariables::takeNumber(LineCursor& line, double& value) const {
  return takeSum(
      line,
      [this](LineCursor& rest, const std::string& name, double& number) {
        std::string path = name, part;
        LineCursor ahead = rest;
        while (ahead.isMark('.')) {
          ahead.takeMark('.');
          if (!ahead.takeName(part))
            return false;
          path += "." + part;
        }
        const auto known = all_.numbers.find(path);
        if (known == all_.numbers.end())
          return false;
        rest = ahead;
        number = known->second;
        return true;
      },
      value);
}

bool KrlVariables::takeValue(LineCursor& line, KrlValue& value) const {
  return takePart(line, "", value, 0);
}

bool KrlVariables::takePart(LineCursor& line, const std::string& within, KrlValue& value,
                            int depth) const {
  if (value.numbers.size() + value.words.size() > kMaxParts)
    return false;
  if (line.isMark('{'))
    return takeAggregate(line, within, value, depth);
  if (std::string_view text; line.takeText(text))
    return true;
  if (line.takeMark('#')) {
    std::string word;
    return line.takeName(word) && (value.words[within] = word, true);
  }
  double number = 0.0;
  if (line.isMark('\'')) {
    if (!takeBits(line, number))
      return false;
    value.numbers[within] = number;
    return true;
  }
  if (line.isWord("true") || line.isWord("false")) {
    value.numbers[within] = line.isWord("true") ? 1.0 : 0.0;
    std::string word;
    return line.takeName(word);
  }
  LineCursor ahead = line;
  if (takeNumber(ahead, number)) {
    line = ahead;
    value.numbers[within] = number;
    return true;
  }
  ahead = line;
  std::string path;
  if (!takeKrlPath(ahead, path))
    return false;
  const KrlValue named = below(path);
  if (named.numbers.empty() && named.words.empty())
    return false;
  line = ahead;
  for (const auto& [part, n] : named.numbers)
    value.numbers[pathOf(within, part)] = n;
  for (const auto& [part, w] : named.words)
    value.words[pathOf(within, part)] = w;
  return true;
}

// Parses { TYPE: NAME value, NAME value, ... }; the type is optional.
bool KrlVariables::takeAggregate(LineCursor& line, const std::string& within, KrlValue& value,
                                 int depth) const {
  if (depth == kMaxDepth || !line.takeMark('{'))
    return false;
  LineCursor ahead = line;
  if (std::string type; ahead.takeName(type) && ahead.takeMark(':'))
    line = ahead;
  std::map<std::string, bool> seen;
  do {
    std::string part;
    if (!takeKrlPath(line, part) || !seen.emplace(part, true).second ||
        !takePart(line, pathOf(within, part), value, depth + 1))
      return false;
  } while (line.takeMark(','));
  return line.takeMark('}');
}

void KrlVariables::set(const std::string& path, const KrlValue& value) {
  for (const auto& [part, n] : value.numbers)
    all_.numbers[pathOf(path, part)] = n;
  for (const auto& [part, w] : value.words)
    all_.words[pathOf(path, part)] = w;
}

void KrlVariables::set(const std::string& path, double value) {
  all_.numbers[path] = value;
}

void KrlVariables::erase(const std::string& path) {
  eraseBelow(all_.numbers, path);
  eraseBelow(all_.words, path);
}

std::optional<double> KrlVariables::number(std::string_view path) const {
  const auto known = all_.numbers.find(path);
  return known == all_.numbers.end() ? std::nullopt : std::optional(known->second);
}

std::string_view KrlVariables::word(std::string_view path) const {
  const auto known = all_.words.find(path);
  return known == all_.words.end() ? std::string_view() : std::string_view(known->second);
}

KrlValue KrlVariables::below(const std::string& path) const {
  return {partsBelow(all_.numbers, path), partsBelow(all_.words, path)};
}

std::optional<Eigen::Isometry3d> krlPose(const Eigen::Vector3d& mm,
                                         const Eigen::Vector3d& degrees) {
  const auto within = [](const Eigen::Vector3d& v, double limit) {
    return (v.array().abs() <= limit).all();
  };
  if (!within(mm, kMaxMm) || !within(degrees, kMaxDegrees))
    return std::nullopt;
  return poseOfZyx(mm, degrees);
}

std::optional<Eigen::Isometry3d> krlFrame(const KrlValue& value) {
  std::array<double, 6> parts{};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto part = value.numbers.find(kKrlPose[k]);
    if (part == value.numbers.end())
      return std::nullopt;
    parts[k] = part->second;
  }
  return krlPose(Eigen::Vector3d(parts.data()), Eigen::Vector3d(parts.data() + 3));
}

} // namespace voluta::program
