// The extruder as controllers with outputs know it: a digital one, on while it runs, and an
// analogue one, its flow as a share of the process's full flow.
#pragma once

#include "plan/program.h"

#include <optional>
#include <string>
#include <utility>

namespace voluta::program {

// Filament that is drawn back further than this is out of the hot end, mm; what of it may not be
// back before a bead, mm3.
inline constexpr double kMostDrawnBackMm = 20.0, kDrawnBackLeftMm3 = 0.02;
// Of an amount that is pushed (drawn, below zero) where so much had been drawn back: what comes
// out, and what is then drawn back. mm3.
std::pair<double, double> pushedOut(double mm3, double drawnMm3);

// A share of the full flow as it is written, in [0, 1]: four significant digits.
std::string shareText(double share);
double writtenShare(double share);

// What a writer last said, so that it says only what changes.
class WrittenOutputs {
public:
  explicit WrittenOutputs(double fullFlowMm3PerS) : full_(fullFlowMm3PerS) {}

  // The extruder is off; the next flow is written whatever it is.
  void off();
  // The share, 0..1, as it is to be written; nothing where it stands as it is.
  std::optional<std::string> flow(double mm3PerS);
  // Whether the digital output is to be written.
  bool turn(bool on);

private:
  double full_;
  bool on_ = false;
  std::string flowText_;
};

// What a reader has been told.
class ReadOutputs {
public:
  // A file begins: nothing is known.
  void begin() { *this = {}; }
  void turn(bool on);
  void flow(double share); // 0..1
  // Sets what the motion extrudes; false where an output was never set, which counts as off.
  bool moveWith(plan::ProgramMotion& motion, double fullFlowMm3PerS);
  bool on() const { return on_.value_or(false); }
  // What flows now, as a share of the full flow.
  double flowShare() const { return on() ? flow_.value_or(0.0) : 0.0; }
  // Both were set off since the last motion.
  bool ended() const { return offSaid_ && zeroSaid_; }

private:
  std::optional<bool> on_;
  std::optional<double> flow_;
  bool offSaid_ = false, zeroSaid_ = false;
};

} // namespace voluta::program
