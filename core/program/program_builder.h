// Builder that every reader of a program feeds with motions, waits, outputs and words as they
// occur, and with defects; each is attributed to the current line.
#pragma once

#include "plan/program.h"
#include "process/tooling.h"
#include "program/common/extruder_outputs.h"
#include "program/common/known_words.h"
#include "program/common/program_text.h"
#include "program/filament.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

class ProgramBuilder {
public:
  ProgramBuilder(std::string_view format, process::Tooling tooling);
  ProgramBuilder(const ProgramBuilder&) = delete;

  // Reserves space for one motion per line: unused space takes no memory, whereas growing would
  // need twice the space.
  void expectMotionsOf(const std::vector<plan::ProgramFile>& files);

  std::size_t file = 0, line = 0; // current position of the reader
  void defect(base::Message reason) { defectAt(line, std::move(reason)); }
  // The same at an earlier line of the file.
  void defectAt(std::size_t at, base::Message reason) { defects_.add(file, at, std::move(reason)); }

  // Extruder by outputs. At the beginning of a file their state is unknown.
  void beginOutputs();
  void setExtruder(bool on);
  void flow(double share) { outputs_.flow(share); }
  // A text to the castelli-serial extruder, instead of both outputs, by that port or connection. A
  // defect if texts before it went another way.
  void send(std::string_view text, std::string_view to);
  bool outputsEnded() const { return outputs_.ended(); }

  // Adds a motion and sets its file and line. The extruder follows the outputs, or the motion's own
  // data.
  void motionByOutputs(plan::ProgramMotion motion);
  void motion(plan::ProgramMotion motion);
  // Adds a pause, in which the arm is at rest. The extruded volume follows from the outputs, or is
  // `volumeMm3`.
  void pauseByOutputs(double seconds);
  void pause(double seconds, double volumeMm3, double drawnMm = 0.0);

  // Extruder as an axis that moves with the arm (program/gcode/extruder_axis.h): its current
  // position becomes 0; during a motion, or while the arm is at rest, it moves to `mm` of filament.
  void zeroAxis();
  void motionByAxis(plan::ProgramMotion motion, double mm);
  void pauseByAxis(double seconds, double mm);

  // Handles a word of the table; a defect if it is not allowed at this place. Returns false if it
  // is not in the table.
  bool word(std::span<const KnownWord> table, std::string_view word);
  // Handles a word that the reader itself interprets.
  void wordAt(std::string_view word, std::uint8_t places);
  // Requires a statement of that kind in this program, in addition to those that all programs of
  // its language need (Dialect::states).
  void need(plan::FactKind kind);
  // Adds a statement that the replay compares with the plan's requirements, with its position.
  void state(plan::FactKind kind, double number = 0.0, std::string_view word = {});
  // A text that the operator sees from here on, until a stop or a motion.
  void show(std::string_view text) { (shown_ += shown_.empty() ? "" : " ").append(text); }
  // States a stop with the text that is shown. `waits`: until the operator continues.
  void operatorStop(bool waits = true);
  // As state(), about a tool that may be another than the selected one.
  void stateOf(int tool, plan::FactKind kind, double number = 0.0);
  // Sets an output of the extruder directly, not as a trigger of the next motion.
  void statePassingOutput();

  // Selects the tool that deposits from here on, and states it. A program begins with tool 0. A
  // defect, and no selection, if the job has no such tool.
  void selectTool(int tool);
  int selectedTool() const { return selected_; }
  // Sets the output of a tool but the first, that of the tool changer (kChangerOutput), or one that
  // announces marks (kMarkOutput and following). The tool
  // whose output alone is on deposits from the next motion, pause or statement on; the first one if
  // all are off. Returns false if the job has no such tool: then the output is another one.
  bool toolOutput(int tool, bool on);
  // Waits without time limit for an input of marks. Returns false if the input is another one.
  bool awaitInput(int input, bool on);

  // Sets the output of the tape's cutter. A cut (tape_cut.h) is the output on, a wait and the
  // output off: another order, a wait of another duration and a motion amid it are defects.
  void setCutter(bool on);
  // Adds a cut by a statement that states the whole pulse.
  void cutFor(double seconds);

  // Sets the speed of joint motions alone. A defect if a straight motion follows, unless it is the
  // first motion: programs state it at the joint motion that needs it.
  void setJointSpeed(std::string_view word);

  // Sets the arm's payload, and its centre of mass on the flange [mm]. A different payload during
  // the print is a defect.
  void load(std::string_view word, double kg,
            const std::optional<Eigen::Vector3d>& centreMm = std::nullopt);
  // The same of the centre alone.
  void loadCentre(std::string_view word, const Eigen::Vector3d& centreMm);

  // Sets the moved tool and the pose of a stationary nozzle, once for all motions
  // (plan::ReadProgram). Returns false if another tool was set before.
  bool tool(const Eigen::Isometry3d& flange_T_tcp,
            const std::optional<Eigen::Isometry3d>& base_T_nozzle);
  bool toolSet() const { return toolSet_; }

  plan::ReadProgram& program() { return program_; }
  plan::ReadProgram take(bool complete);

private:
  // Selects the tool by the outputs that were set.
  void settleTool();
  // Adds a defect if too much filament is retracted.
  void reportDrawn(double mm);
  void reportCutLasts(double seconds);
  // Adds a defect if the tape's cutter is out.
  void reportCutterOut();

  const process::Material& material() const { return tooling_.at(selected_).process.material; }

  const process::Tooling tooling_;
  int selected_ = 0;
  // Whether the output of each tool is on; nullopt: the program has not set it yet, an earlier run
  // may have. The first tool has no output.
  std::vector<std::optional<bool>> toolOutputs_ =
      std::vector<std::optional<bool>>(tooling_.tools().size());
  std::optional<std::size_t> outputLine_; // of the last tool output that is not settled
  std::string shown_;                     // to the operator
  plan::ReadProgram program_;
  Defects defects_;
  WordPlaces places_;
  ReadOutputs outputs_;
  bool toolSet_ = false;
  struct Statement {
    std::size_t file, line;
    std::size_t pause = 0; // index of the next one
    std::string word = {};
  };
  std::optional<Statement> cutterOut_;  // that set the cutter's output
  std::optional<Statement> jointSpeed_; // that no joint motion has followed
  // The extruder's reverse flow [mm3/s], and the retracted volume of filament [mm3].
  double drawsMm3PerS_ = 0.0, drawnMm3_ = 0.0;
  std::optional<std::string> sentTo_;
  FilamentCount axis_;
  bool axisZeroed_ = false;
  std::size_t onSince_ = 0; // number of motions and pauses when the extruder was switched on
};

} // namespace voluta::program
