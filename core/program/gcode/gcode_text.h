// What all kinds of G-code are written with: head, prime, end, and how many digits.
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

inline constexpr int kPositionDecimals = 4, kDirectionDecimals = 6;
// Of filament that is drawn back and returned.
inline constexpr double kDrawnMmPerS = 30.0;
inline constexpr std::string_view kGcodeEnd = "; end";
// Of machines that are no arms; as kStartQuestion.
inline constexpr std::string_view kGcodeQuestion =
    "The machine drives home and then to its start. Is the way clear?";

class GcodeText {
public:
  // `letters` as they stand, blanks before them too.
  void word(std::string_view letters, double value, int decimals, bool trim = false);
  void line(std::string_view text);
  void remark(std::string_view text);

  // Remarks, units, the question, home, heat, the prime; `notes`: remarks of the dialect's own.
  void head(const ProgramInput& input, std::string_view title, std::string_view question,
            const std::vector<std::string>& notes = {});
  void end();

  // A bead's motion has so much filament out at its end.
  void amount(double filamentMm);
  // Filament that is drawn back from there (below zero), or returned to it.
  void retract(double filamentMm, double f);

  // The filament's length at a point of a bead; none where the motion to it does not print.
  static std::optional<double> filamentMm(const plan::Trajectory& trajectory, std::size_t point);

  std::string out;

private:
  double lastMm_ = 0.0;
};

// Motions that are straight on the part, one a point, a joint motion in pieces: extended G-code,
// and without `directions` plain G-code. Throws as a dialect's writer does.
struct StraightGcode {
  std::string_view format, extension, title, question;
  bool directions = true;
  std::vector<std::string> notes = {}; // remarks of the dialect's own
};
plan::Program writeStraightGcode(const StraightGcode& kind, const ProgramInput& input,
                                 const base::RunContext& ctx);

} // namespace voluta::program
