// Traverses a trajectory for all writers: calls a dialect's emitter with the contents of the
// program in order.
#pragma once

#include "base/run_context.h"
#include "program/common/tcp_motions.h"
#include "program/program_input.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::program {

// The vocabulary of a dialect. Points are indices into the trajectory; a motion is the one to its
// point.
class ProgramEmitter {
public:
  virtual ~ProgramEmitter() = default;
  // Files are numbered from 0. After beginFile and endFile the extruder is off.
  virtual void beginFile(std::size_t file) = 0;
  virtual void endFile(std::size_t file) = 0;
  // Before the first motion, whose target may be far from the arm's position.
  virtual void prompt() {}
  virtual void remark(std::string_view) {}
  // A line that the user asked for (program/own_lines.h) behind its mark, the arm at rest.
  virtual void ownLine(std::string_view line);
  // Called on changes only, for dialects with an extruder on two outputs (Walk::outputs).
  virtual void flow(std::string_view /*share*/) {} // 0..1, of Tooling::fullFlowMm3PerS()
  virtual void extruder(bool /*on*/) {}
  // A text for an extruder that is controlled by texts (Extruder::text).
  virtual void send(std::string_view /*text*/) {}
  virtual void wait(double /*seconds*/) {}
  // Part cooling from here on, called on changes only; off at the beginning.
  virtual void fan(double /*share*/) {}
  // Events of the trajectory, in place; for dialects that have words for them (Dialect::events).
  virtual void cut() {}
  // The tool: an output for each but the first, and one that locks it in a tool changer
  // (kChangerOutput), for dialects with an extruder on outputs; selectTool() for the others.
  virtual void setOutput(int /*output*/, bool /*on*/) {}
  virtual void selectTool(int /*tool*/) {}
  // Waits until the nozzle of a tool just selected is hot, for dialects that heat.
  virtual void awaitHeat(int /*tool*/) {}
  // Turns off the heat of a tool before the operator takes it off, for dialects that heat.
  virtual void coolTool(int /*tool*/) {}
  // Waits without time limit until an input has that value, the arm at rest. Marks set and await
  // the outputs and inputs kMarkOutput and the next.
  virtual void awaitInput(int /*input*/, bool /*on*/) {}
  virtual void pause(std::string_view /*message*/) {} // until the operator continues
  // Lets material flow out while the arm is at rest, for dialects whose motions contain amounts.
  virtual void purge(double /*filamentMm*/, double /*seconds*/) {}
  // Pushes filament (negative: retracts it) while the arm is at rest; for dialects whose motions
  // contain amounts.
  virtual void retract(double /*filamentMm*/) {}
  // For an extruder that is an axis (program/gcode/extruder_axis.h): resets its position to 0 while
  // the arm is at rest; pushes or retracts filament in the given time while the arm is at rest.
  virtual void zeroAxis() {}
  virtual void extrudeInPlace(double /*filamentMm*/, double /*seconds*/) {}
  // The first point is always a joint motion.
  virtual void jointMotion(std::size_t point) = 0;
  // `stops`: the arm stops after it, as the last motion of its file or before zeroAxis or an event.
  virtual void straightMotion(std::size_t point, bool stops) = 0;
};

struct Walk {
  std::string_view format; // for progress messages
  // Start indices of the files: first 0, ascending, last the number of points.
  std::vector<std::size_t> cuts;
  // The flow of a dialect whose extruder is controlled separately from the motions
  // (program/extruder.h), and which then primes at the first point; nullptr: the motions contain
  // amounts.
  const TcpMotions* outputs = nullptr;
  bool filesRunAlone = false; // each file is started by itself, when the one before has ended
  bool locksTool = false;     // the language has a word for the lock of a tool changer
  bool waitsByMotion = false; // a wait is a point of the motion: none before the first motion
};

// Emits per point its remark, the outputs and the motion; at the first point also the prime. With
// retractMm of the selected tool's process, filament is retracted after a bead that is followed by
// another, and returned before that or before the tool changes. Throws Cancelled.
void walkTrajectory(const ProgramInput& input, const Walk& walk, ProgramEmitter& emitter,
                    const base::RunContext& ctx);

// Height of the nozzle above its last bead while the next file is loaded or sent, if the motion has
// a travel that lifts it so far.
inline constexpr double kClearMm = 10.0;

// Returns the start indices of files with at most `limit` motions (0: one file). Files are cut
// after the lift of a travel: the last one of kClearMm or more in the second half of a file;
// otherwise the highest. If there is none in time, a file extends beyond `limit`, by a tenth of it
// or 100 motions, whichever is more, to the first travel or the program's end; without any it is
// cut there at a bead's point.
std::vector<std::size_t> cutsOf(const ProgramInput& input, std::size_t limit);

} // namespace voluta::program
