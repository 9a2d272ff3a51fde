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
// Like kStartQuestion, for machines that are not arms.
inline constexpr std::string_view kGcodeQuestion =
    "The machine drives home and then to its start. Is the way clear?";

class GcodeText {
public:
  // `letters` are written unchanged, with any blanks before them.
  void word(std::string_view letters, double value, int decimals, bool trim = false);
  void line(std::string_view text);
  void wait(double seconds);
  // Lets that length of filament flow out while the nozzle is at rest.
  void purge(double filamentMm, double seconds);
  void remark(std::string_view text);

  // Writes remarks, units, the question, home, heat of the bed and of each tool that prints, the
  // fan off, and the prime; `notes`: remarks of the dialect.
  void head(const ProgramInput& input, std::string_view title, std::string_view question,
            const std::vector<std::string>& notes = {});
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
  // Returns the command for a tool's heat; it names the tool if several print.
  std::string heating(std::string_view command, std::size_t tool) const;

  double lastMm_ = 0.0;
  std::size_t tools_ = 1; // that print
  int bedC_ = 0;          // 0: not heated
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
