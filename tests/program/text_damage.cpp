#include "program/text_damage.h"

#include "program/common/program_text.h"
#include "program/dialect.h"
#include "program/tmscript/tmscript_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>

namespace voluta::test {

namespace {

using plan::ProgramMotion, plan::ReadProgram;

constexpr double kMinMm = 1.0, kMaxMm = 4.0;     // a target beside the one it was
constexpr double kMinRad = 2e-3, kMaxRad = 1e-2; // the same of one joint, at a lever of 0.5 m

double durationOf(const ProgramMotion& m) {
  return m.durationS > 0.0 ? m.durationS : m.speedMmPerS > 0.0 ? 1.0 / m.speedMmPerS : 0.0;
}

// A little beside: by length, or where there is none by a joint's angle.
bool isBeside(const ProgramMotion& a, const ProgramMotion& b) {
  if (a.target != b.target)
    return false;
  if (a.target == plan::TargetKind::Joints) {
    double turned = 0.0;
    for (std::size_t k = 0; k < a.joints.size(); ++k)
      turned += std::abs(a.joints[k] - b.joints[k]);
    return turned > kMinRad && turned < kMaxRad;
  }
  const double moved = (a.frame_T_tcp.translation() - b.frame_T_tcp.translation()).norm() +
                       (a.position - b.position).norm();
  return moved > kMinMm && moved < kMaxMm;
}

bool isSound(const ReadProgram& program) {
  return program.defects.empty() && program.complete;
}

// All targets but that of motion `except` are as they were.
bool sameTargets(const ReadProgram& a, const ReadProgram& b, std::size_t except) {
  if (a.motions.size() != b.motions.size())
    return false;
  for (std::size_t i = 0; i < a.motions.size(); ++i)
    if (i != except && !sameTarget(a.motions[i], b.motions[i]))
      return false;
  return true;
}

// Tries each number of a line with each of the values that `others` makes of it.
template <typename Others, typename Fits>
bool changeNumber(std::string& line, Others&& others, Fits&& fits) {
  const std::string whole = line;
  for (const auto& where : numbersIn(whole))
    for (const double value : others(std::stod(whole.substr(where.first)))) {
      line = withNumber(whole, where, value);
      if (fits())
        return true;
    }
  line = whole;
  return false;
}

// Statements are in frames, whose length and checksum follow them.
bool isFramed(std::string_view format) {
  return format == "tmscript";
}
bool isStatement(std::string_view line) {
  line = program::trimmed(line);
  return !line.empty() && !line.starts_with("//") && !line.starts_with('$');
}

constexpr std::size_t kMaxLinesAbove = 20;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

} // namespace

ProgramText textOf(const plan::Program& program) {
  ProgramText text{program.format, program.files.at(0).name, {}};
  std::istringstream in(program.files[0].text);
  for (std::string line; std::getline(in, line);)
    text.lines.push_back(isFramed(program.format) && line.starts_with('$')
                             ? std::string(program::takeTmFrame(line).script) + "\r"
                             : line);
  return text;
}

ReadProgram read(const ProgramText& text, const process::Process& process) {
  return read(text, process::Tooling(process));
}

ReadProgram read(const ProgramText& text, const process::Tooling& tooling) {
  std::string joined;
  std::size_t id = 0;
  for (const std::string& line : text.lines)
    joined += isFramed(text.format) && isStatement(line)
                  ? program::tmFrame(std::to_string(++id),
                                     line.substr(0, line.size() - (line.ends_with('\r') ? 1 : 0)))
                  : line + "\n";
  return program::readProgram(text.format, {{text.name, joined}}, tooling);
}

std::vector<std::pair<std::size_t, std::size_t>> numbersIn(std::string_view line) {
  static const std::regex kNumber(R"([-+]?\d+(\.\d*)?([eE][-+]?\d+)?)");
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::cregex_iterator it(line.data(), line.data() + line.size(), kNumber), end; it != end;
       ++it)
    found.emplace_back(it->position(), it->position() + it->length());
  return found;
}

std::string withNumber(const std::string& line, std::pair<std::size_t, std::size_t> where,
                       double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.9f", value);
  return line.substr(0, where.first) + buffer + line.substr(where.second);
}

bool sameTarget(const ProgramMotion& a, const ProgramMotion& b) {
  return a.target == b.target && a.jointInterpolated == b.jointInterpolated &&
         a.joints == b.joints && a.externals == b.externals &&
         a.frame_T_tcp.matrix() == b.frame_T_tcp.matrix() && a.position == b.position &&
         a.direction == b.direction;
}

bool sameMotion(const ProgramMotion& a, const ProgramMotion& b) {
  return sameTarget(a, b) && a.speedMmPerS == b.speedMmPerS &&
         a.jointSpeedRadPerS == b.jointSpeedRadPerS && a.durationS == b.durationS &&
         a.accelerationMmPerS2 == b.accelerationMmPerS2 && a.blendMm == b.blendMm &&
         a.extruding == b.extruding && a.flowMm3PerS == b.flowMm3PerS && a.volumeMm3 == b.volumeMm3;
}

std::optional<std::size_t> moveTarget(ProgramText& text, std::size_t motion,
                                      const process::Process& process) {
  const ReadProgram whole = read(text, process);
  const std::size_t line = whole.motions.at(motion).line;
  // In mm, in m and in degrees.
  const auto others = [](double x) { return std::vector{x + 2.0, x + 0.002, x + 0.25}; };
  const auto moved = [&](bool sound) {
    return changeNumber(text.lines.at(line - 1), others, [&] {
      const ReadProgram changed = read(text, process);
      return (!sound || isSound(changed)) && sameTargets(whole, changed, motion) &&
             isBeside(whole.motions[motion], changed.motions[motion]);
    });
  };
  // Where a text also states the speed of the motion, its reader may find the change already.
  return moved(true) || moved(false) ? std::optional(line) : std::nullopt;
}

std::optional<std::size_t> tenfoldSpeed(ProgramText& text, std::size_t motion,
                                        const process::Process& process) {
  const ReadProgram whole = read(text, process);
  const std::size_t line = whole.motions.at(motion).line;
  const double before = durationOf(whole.motions[motion]);
  // A speed, a time, and a time from the program's beginning.
  const auto others = [&](double x) { return std::vector{10.0 * x, 0.1 * x, x - 0.9 * before}; };
  const auto isTenfold = [&] {
    const ReadProgram changed = read(text, process);
    return isSound(changed) && sameTargets(whole, changed, kNone) &&
           std::abs(durationOf(changed.motions[motion]) / before - 0.1) < 1e-3;
  };
  // In its own line, or in one above that sets the speed: of the motions behind that, too.
  std::size_t first = line;
  for (std::size_t l = line; l > 0; --l) {
    for (const ProgramMotion& m : whole.motions)
      first = m.line == l ? l : first;
    if (changeNumber(text.lines.at(l - 1), others, isTenfold))
      return first;
    if (l + kMaxLinesAbove < line)
      break;
  }
  // Or a speed from further up is repeated, without that line's number.
  constexpr std::size_t kBack = 40;
  static const std::regex kStep(R"(^\d+\s+)");
  const auto here = text.lines.begin() + static_cast<std::ptrdiff_t>(line - 1);
  text.lines.insert(here, "");
  for (std::size_t back = 1; back < std::min(line, kBack); ++back) {
    text.lines[line - 1] = std::regex_replace(text.lines[line - 1 - back], kStep, "");
    if (changeNumber(text.lines[line - 1], others, isTenfold))
      return line;
  }
  text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(line - 1));
  return std::nullopt;
}

std::optional<std::size_t> extrudeOverTravel(ProgramText& text, std::size_t motion,
                                             const process::Process& process) {
  const ReadProgram whole = read(text, process);
  std::size_t travel = motion;
  while (travel < whole.motions.size() && whole.motions[travel].extruding)
    ++travel;
  if (travel == motion || travel == whole.motions.size())
    return std::nullopt;
  const auto lays = [&] {
    const ReadProgram changed = read(text, process);
    return sameTargets(whole, changed, kNone) && changed.motions[travel].extruding;
  };
  const std::size_t before = whole.motions[travel - 1].line, line = whole.motions[travel].line;
  // The statement that switches the extruder off between them is missing,
  for (std::size_t l = before + 1; l < line; ++l) {
    const std::string off = text.lines[l - 1];
    text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(l - 1));
    if (lays())
      return read(text, process).motions[travel].line;
    text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(l - 1), off);
  }
  // or the travel's line has an amount, or that it is on,
  std::string& own = text.lines.at(line - 1);
  if (changeNumber(
          own,
          [](double x) {
            return std::vector{x + 2.0, x + 1.0};
          },
          lays))
    return line;
  // or is given the word for one from the line before.
  const std::string without = own;
  std::istringstream words(text.lines.at(before - 1));
  for (std::string word; words >> word;)
    for (const auto& where : numbersIn(word)) {
      own = without + " " + withNumber(word, where, std::stod(word.substr(where.first)) + 0.8);
      if (lays())
        return line;
    }
  own = without;
  return std::nullopt;
}

} // namespace voluta::test
