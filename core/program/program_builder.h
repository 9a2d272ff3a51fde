// What every reader of a program feeds: motions, waits, outputs and words as they come, and what is
// wrong with them, each at the line that is being read.
#pragma once

#include "plan/program.h"
#include "process/process.h"
#include "program/common/extruder_outputs.h"
#include "program/common/known_words.h"
#include "program/common/text.h"
#include "program/filament.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::program {

class ProgramBuilder {
public:
  ProgramBuilder(std::string_view format, const process::Process& process);
  ProgramBuilder(const ProgramBuilder&) = delete;

  // Room for a motion a line. What stays empty of it takes no memory, what has to grow twice its
  // own.
  void expectMotionsOf(const std::vector<plan::ProgramFile>& files);

  std::size_t file = 0, line = 0; // what is being read
  void defect(base::Message reason) { defects_.add(file, line, std::move(reason)); }

  // The extruder by outputs. A file begins: nothing is known of them.
  void beginOutputs();
  void turn(bool on);
  void flow(double share) { outputs_.flow(share); }
  // A text of the castelli-serial extruder, in place of both outputs.
  void send(std::string_view text);
  bool outputsEnded() const { return outputs_.ended(); }

  // File and line are filled in. With the extruder as the outputs have it, or as the motion says.
  void motionByOutputs(plan::ProgramMotion motion);
  void motion(plan::ProgramMotion motion);
  // The arm stands. What flows is what the outputs let, or `volumeMm3`.
  void pauseByOutputs(double seconds);
  void pause(double seconds, double volumeMm3, double drawnMm = 0.0);

  // The extruder as an axis that goes with the arm (program/gcode/extruder_axis.h): it is where it
  // counts as 0; during a motion, or while the arm stands, it goes on to `mm` of filament.
  void zeroAxis();
  void motionByAxis(plan::ProgramMotion motion, double mm);
  void pauseByAxis(double seconds, double mm);

  // A word of the table at a place where it may stand; else a defect. false: it isn't in the table.
  bool word(std::span<const KnownWord> table, std::string_view word);
  // One that the reader knows better.
  void wordAt(std::string_view word, std::uint8_t places);
  // What this program does needs a statement of that kind, beside those that all of its language
  // need (Dialect::states).
  void need(plan::FactKind kind);
  // A statement that the replay compares with the plan's needs. Filled in: where it stands.
  void state(plan::FactKind kind, double number = 0.0, std::string_view word = {});
  // An output of the extruder's is set, and not as a trigger of the next motion.
  void statePassingOutput();

  // The mass that the arm is told to carry. A defect where it is told another amid the print.
  void load(std::string_view word, double kg);

  // What moves and, where the nozzle stands, that: set once for all motions (plan::ReadProgram).
  // false: another one was set before.
  bool tool(const Eigen::Isometry3d& flange_T_tcp,
            const std::optional<Eigen::Isometry3d>& base_T_nozzle);
  bool toolSet() const { return toolSet_; }

  plan::ReadProgram& program() { return program_; }
  plan::ReadProgram take(bool complete);

private:
  // A defect where more of the filament is drawn back than may be.
  void tellDrawn(double mm);

  const process::Process& process_;
  plan::ReadProgram program_;
  Defects defects_;
  WordPlaces places_;
  ReadOutputs outputs_;
  bool toolSet_ = false;
  // The extruder runs back, mm3/s; so much of the filament is drawn back, mm3.
  double drawsMm3PerS_ = 0.0, drawnMm3_ = 0.0;
  FilamentCount axis_;
  bool axisZeroed_ = false;
  std::size_t onSince_ = 0; // motions and pauses when the extruder was turned on
};

} // namespace voluta::program
