// Writer helpers for all kinds of G-code: head, prime, end, number formats.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/filament.h"
#include "program/program_input.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::program {

inline constexpr int kGcodePositionDecimals = 4, kDirectionDecimals = 6;
inline constexpr double kGcodeFullFan = 255.0;
// Pin of the tape's cutter (M42), which cuts when it turns on.
inline constexpr int kGcodeCutPin = 1;
inline constexpr double kGcodeFullPin = 255.0;
// Speed of retracting and returning filament.
inline constexpr double kDrawnMmPerS = 30.0;
inline constexpr std::string_view kGcodeEnd = "; end";
inline constexpr std::string_view kGcodeWay = "The machine drives home and then to its start.";
// Like kStartQuestion, for machines that are not arms.
inline constexpr std::string_view kGcodeQuestion =
    "The machine drives home and then to its start. Is the way clear?";

// A message as the text of M0: firmware shows it, but takes a P or S with a number in it for a time
// after which the stop ends; the message has these letters small.
std::string gcodeStopText(std::string_view message);
// Returns whether the letter at `at`, a P or S, ends such a stop.
bool endsStop(std::string_view text, std::size_t at);

class GcodeText {
public:
  // `letters` are written unchanged, with any blanks before them.
  void word(std::string_view letters, double value, int decimals, bool trim = false);
  void line(std::string_view text);
  void wait(double seconds);
  // Lets that length of filament flow out while the nozzle is at rest, with the word F.
  void purge(double filamentMm, double f);
  // Waits for the operator, who reads the message.
  void stop(std::string_view message);
  // Waits until the tool's nozzle is hot, if its temperature is known.
  void awaitHeat(const ProgramInput& input, int tool);
  // Turns off the tool's heat, if its temperature is known.
  void cool(const ProgramInput& input, int tool);
  void remark(std::string_view text);

  // Writes remarks, units, the question, the tool that the program begins with (if the job has
  // several), home, heat of the bed and of each tool that prints and that the operator does not fit
  // later, the fan off, and the prime; `notes`: remarks of the dialect; `modes`: lines with its
  // units.
  void head(const ProgramInput& input, std::string_view title, std::string_view question,
            const std::vector<std::string>& notes = {}, std::string_view modes = "G21\nG90\nM82");
  void end();
  // Writes part cooling, 0..1, from here on.
  void fan(double share);

  // Writes the filament length at the end of a bead's motion.
  void amount(double filamentMm);
  // Writes a retraction from that length (negative), or the return to it.
  void retract(double filamentMm, double f);

  // Returns the filament's length at a point of a bead; nullopt if the motion to it does not print.
  static std::optional<double> filamentMm(const plan::Trajectory& trajectory, std::size_t point);

  std::string out;

private:
  // Returns the command for a tool's heat; it names the tool unless only the first one prints.
  std::string heating(std::string_view command, int tool) const;

  double lastMm_ = 0.0;
  std::vector<int> tools_; // that print
  int bedC_ = 0;           // 0: not heated
};

// Writes motions that are straight on the part, one per point, joint motions in pieces: extended
// G-code, or plain G-code without `directions`. Throws as a dialect's writer does.
struct StraightGcode {
  std::string_view format, extension, title, question;
  bool directions = true;
  std::vector<std::string> notes = {}; // remarks of the dialect
};
plan::Program writeStraightGcode(const StraightGcode& kind, const ProgramInput& input,
                                 const base::RunContext& ctx);

} // namespace voluta::program
