#include "sliced/unused_commands.h"

#include "base/lower_case.h"
#include "base/valid_utf8.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace voluta::sliced {

namespace {

// A printer waits for its user: M0 and M1, pauses of the print, changes of the filament.
constexpr std::array kStops{0.0, 1.0, 25.0, 226.0, 600.0, 601.0};

// Reports, displays, limits and calibration.
constexpr std::array kPlainM{17.0,  18.0,  20.0,  21.0,  22.0,  23.0,  24.0,  26.0,  27.0,  31.0,
                             73.0,  75.0,  76.0,  77.0,  78.0,  80.0,  81.0,  84.0,  85.0,  105.0,
                             107.0, 110.0, 111.0, 113.0, 114.0, 115.0, 117.0, 118.0, 119.0, 120.0,
                             121.0, 145.0, 150.0, 155.0, 201.0, 202.0, 203.0, 204.0, 205.0, 207.0,
                             208.0, 211.0, 300.0, 301.0, 302.0, 303.0, 304.0, 355.0, 400.0, 413.0,
                             420.0, 486.0, 500.0, 501.0, 502.0, 503.0, 555.0, 566.0, 569.0, 572.0,
                             593.0, 602.0, 862.0, 900.0, 906.0, 907.0, 913.0, 914.0, 928.0};
constexpr std::array kPlainG{12.0, 17.0, 26.0, 27.0, 29.0, 30.0, 31.0, 32.0,
                             33.0, 34.0, 35.0, 36.0, 42.0, 76.0, 80.0};

// Words of firmwares that tell the printer about the print.
constexpr std::array<std::string_view, 8> kPlainMacros{
    "exclude_object", "set_velocity_limit", "set_pressure_advance", "set_print_stats",
    "timelapse",      "bed_mesh",           "quad_gantry_level",    "skew_profile"};

std::string shortened(std::string_view text) {
  constexpr std::size_t kMaxLength = 60;
  return std::string(program::trimmed(base::validText(text, kMaxLength)));
}

std::string_view firstWord(std::string_view text) {
  return text.substr(0, text.find_first_of(" \t="));
}

bool isStop(const GcodeCommand& command) {
  if (command.letter == 'M')
    return std::ranges::find(kStops, command.number) != kStops.end() ||
           (command.number == 400.0 && command.text.find("U1") != std::string_view::npos);
  const std::string word = base::lowerCase(firstWord(command.text));
  return word == "pause" || word == "pause_base" || word == "@pause";
}

// Returns the text for the operator: the one behind M0 and M1, if there is one.
std::string textOfStop(const GcodeCommand& command) {
  if (command.letter == 'M' && command.number == 600.0)
    return "Change the filament";
  const std::size_t words = command.text.find_first_of(" \t");
  const bool hasText = command.letter == 'M' && command.number <= 1.0;
  std::string text =
      hasText && words != std::string_view::npos ? shortened(command.text.substr(words)) : "";
  constexpr std::size_t kShortest = 6; // P1000 and S5 are times
  return text.size() < kShortest ? "Pause" : text;
}

// Returns the name of a command that changes the print; nullopt for others.
std::optional<std::string> nameOf(const GcodeCommand& command) {
  if (command.letter == 'G' || command.letter == 'M') {
    const double whole = std::floor(command.number);
    const bool isPlain = command.letter == 'M' ? std::ranges::find(kPlainM, whole) != kPlainM.end()
                                               : std::ranges::find(kPlainG, whole) != kPlainG.end();
    return isPlain ? std::nullopt
                   : std::optional(command.letter + program::fixedText(command.number, 2));
  }
  const std::string word = base::lowerCase(firstWord(command.text));
  if (word.empty() || std::ranges::any_of(kPlainMacros, [&](std::string_view known) {
        return word.starts_with(known);
      }))
    return std::nullopt;
  return shortened(firstWord(command.text));
}
} // namespace

bool UnusedCommands::take(const GcodeCommand& command, std::size_t line, bool hasBeads) {
  if (command.letter == 'M' && command.number == 117.0) {
    shown_ = shortened(command.text.substr(4));
    shownIn_ = line;
  } else if (isStop(command)) {
    const bool isShown = shownIn_ + 1 == line && !shown_.empty();
    stops_.push_back({line, isShown ? shown_ : textOfStop(command), shortened(command.text)});
    return true;
  } else if (const std::optional<std::string> name = nameOf(command); name && hasBeads) {
    takeNamed(*name, line);
  }
  return false;
}

void UnusedCommands::takeNamed(const std::string& name, std::size_t line) {
  constexpr std::size_t kMaxNames = 200;
  if (others_.size() >= kMaxNames && !others_.contains(name))
    return;
  Seen& seen = others_[name];
  if (seen.count++ == 0)
    seen.line = line;
}

std::vector<base::Message> UnusedCommands::notes(std::size_t lastLine) const {
  std::vector<base::Message> notes;
  for (const auto& [name, seen] : others_)
    if (seen.line <= lastLine)
      notes.emplace_back("not used: {command} in {count} line, line {line}|"
                         "not used: {command} in {count} lines, the first is line {line}"_plural,
                         std::vector<base::Value>{name, seen.count, seen.line});
  return notes;
}

} // namespace voluta::sliced
