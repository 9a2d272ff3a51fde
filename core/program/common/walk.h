// One walk over a trajectory for all writers: what a program says, in order. A dialect spells it.
#pragma once

#include "base/run_context.h"
#include "program/common/tcp_motions.h"
#include "program/program_input.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::program {

// The words of a dialect. Points are indices into the trajectory; a motion is that to its point.
class ProgramEmitter {
public:
  virtual ~ProgramEmitter() = default;
  // Files are numbered from 0. Behind beginFile and endFile the extruder is off.
  virtual void beginFile(std::size_t file) = 0;
  virtual void endFile(std::size_t file) = 0;
  // Before the first motion, which goes to where the arm may be far from.
  virtual void prompt() {}
  virtual void remark(std::string_view) {}
  // Told only where they change; of dialects that have an extruder of two outputs (Walk::outputs).
  virtual void flow(std::string_view /*share*/) {} // 0..1, of process.maxFlowMm3PerS
  virtual void extruder(bool /*on*/) {}
  // A text for an extruder that takes texts (Extruder::text).
  virtual void send(std::string_view /*text*/) {}
  virtual void wait(double /*seconds*/) {}
  // Events of the trajectory, in place, of dialects that have words for them (Dialect::events).
  virtual void selectTool(int /*tool*/) {}
  virtual void cut() {}
  virtual void pause() {} // until the operator continues
  // Filament goes forth, or back below zero, where the arm stands; of dialects whose motions tell
  // amounts.
  virtual void retract(double /*filamentMm*/) {}
  // Of an extruder that is an axis (program/gcode/extruder_axis.h): it counts from 0 from here on,
  // where the arm stands; and filament goes forth, or back, in that time while it stands.
  virtual void zeroAxis() {}
  virtual void extrudeInPlace(double /*filamentMm*/, double /*seconds*/) {}
  // The first point is always a joint motion.
  virtual void jointMotion(std::size_t point) = 0;
  // `stops`: the arm stops at its end: the last motion of its file, or before zeroAxis or an event.
  virtual void straightMotion(std::size_t point, bool stops) = 0;
};

struct Walk {
  std::string_view format; // for the progress that is told
  // Where files begin: first 0, ascending, last the number of points.
  std::vector<std::size_t> cuts;
  // The flow of a dialect whose extruder is told beside the motions (program/extruder.h), and then
  // primes at the first point; nullptr: amounts are told by the motions.
  const TcpMotions* outputs = nullptr;
};

// Per point: its remark, the outputs, the motion; at the first, the prime. With process.retractMm
// filament is drawn back behind a bead that another follows, and returned before that. Throws
// Cancelled.
void walkTrajectory(const ProgramInput& input, const Walk& walk, ProgramEmitter& emitter,
                    const base::RunContext& ctx);

// How high the nozzle stands over its last bead while the next file is loaded or sent, where the
// motion has a travel that lifts it so far.
inline constexpr double kClearMm = 10.0;

// Returns where files begin that are to have at most `most` motions (0: one file). Files are cut
// behind the lift of a travel: the last one of kClearMm or more in the second half of a file; else
// the highest. Where none is found in time a file goes on beyond `most`, by a tenth of it or 100
// motions, whichever is more, to the first travel or the program's end; without any it is cut there
// at a bead's point.
std::vector<std::size_t> cutsOf(const ProgramInput& input, std::size_t most);

} // namespace voluta::program
