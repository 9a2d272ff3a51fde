// An extruder controlled by two outputs: a digital one, on while it runs, and an analogue one with
// its flow as a share of the process's full flow.
#pragma once

#include "plan/program.h"

#include <optional>
#include <string>
#include <utility>

namespace voluta::program {

// Filament retracted further than this is out of the hot end [mm]; tolerance on the retracted
// volume that has to be returned before a bead [mm3].
inline constexpr double kMaxDrawnBackMm = 20.0, kDrawnBackLeftMm3 = 0.02;
// For a volume that is pushed (negative: retracted) while drawnMm3 is retracted: returns the volume
// that comes out and the volume retracted afterwards [mm3].
std::pair<double, double> pushedOut(double mm3, double drawnMm3);

// The output that locks the tool of a tool changer. Output k selects tool k, counted from 0; the
// first tool has none.
inline constexpr int kChangerOutput = 4;
// The first of the outputs that announce marks, and of the inputs that await them
// (plan/marks.h): plan::kMarkSignals each.
inline constexpr int kMarkOutput = 5;

// Share of the full flow as written to programs, in [0, 1]: four significant digits.
std::string shareText(double share);
double writtenShare(double share);

// Output state last written, so that a writer writes changes only.
class WrittenOutputs {
public:
  explicit WrittenOutputs(double fullFlowMm3PerS) : full_(fullFlowMm3PerS) {}

  // The extruder is off; the next flow is written in any case.
  void off();
  // Returns the share, 0..1, to be written; nullopt if it is unchanged.
  std::optional<std::string> flow(double mm3PerS);
  // Returns whether the digital output has to be written.
  bool setExtruder(bool on);

private:
  double full_;
  bool on_ = false;
  std::string flowText_;
};

// Output state as read so far.
class ReadOutputs {
public:
  // At the beginning of a file nothing is known.
  void begin() { *this = {}; }
  void setExtruder(bool on);
  void flow(double share); // 0..1
  // Sets the extrusion of the motion. Returns false if an output was never set, which counts as
  // off.
  bool moveWith(plan::ProgramMotion& motion, double fullFlowMm3PerS);
  bool on() const { return on_.value_or(false); }
  // Returns the present flow as a share of the full flow.
  double flowShare() const { return on() ? flow_.value_or(0.0) : 0.0; }
  // Returns whether both were set off since the last motion.
  bool ended() const { return offSaid_ && zeroSaid_; }

private:
  std::optional<bool> on_;
  std::optional<double> flow_;
  bool offSaid_ = false, zeroSaid_ = false;
};

} // namespace voluta::program
