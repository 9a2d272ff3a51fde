// Reader base for all kinds of G-code: lines, comments, commands, the filament's length, heat, the
// end. Each kind interprets its own targets.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "process/tooling.h"
#include "program/gcode/gcode_line.h"
#include "program/gcode/gcode_text.h"
#include "program/program_builder.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::program {

// Words allowed in any kind of G-code beside motion, heat and filament, and where; all others are
// refused.
std::span<const KnownWord> gcodeWords();

// Additional words that slicers write.
std::span<const KnownWord> slicerWords();

class GcodeReader {
public:
  GcodeReader(std::string_view format, const process::Tooling& tooling,
              const base::RunContext& ctx);
  virtual ~GcodeReader() = default;
  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files);

protected:
  // Returns whether the letter is a word of this kind's targets, beside X Y Z.
  virtual bool isTargetWord(char /*letter*/) const { return false; }
  // Returns whether G28 may give an axis that number; others are a place to go to.
  virtual bool isHomeNumber(double number) const { return number == 0.0; }
  // Returns whether the line moves although it has no X Y Z.
  virtual bool movesBeside(GcodeWords&) const { return false; }
  // Takes the words of a motion's target and its speed. Returns false if there is no motion or a
  // defect was reported. `g`: 0 to 3.
  virtual bool target(GcodeWords& words, double g, bool extruding, plan::ProgramMotion& motion) = 0;
  // Returns the time that a G4 waits.
  virtual double dwellS(GcodeWords& words) const;
  // Returns whether G2 and G3 are motions of this kind.
  virtual bool hasArcs() const { return false; }
  // Handles G92 of the axes that isTargetWord() names. Returns false if it would shift their
  // origin.
  virtual bool setsCount(GcodeWords&) { return false; }
  // Handles this kind's own G commands. Returns false if it is not one of them.
  virtual bool command(double /*g*/) { return false; }
  // Returns the time to extrude or retract filament at rest.
  virtual double secondsOf(GcodeWords& words, double filamentMm);
  virtual void note(std::string_view /*comment*/) {}
  // Additional words of this kind beside gcodeWords().
  virtual std::span<const KnownWord> ownWords() const { return {}; }
  // Called after the last line.
  virtual void finish() {}
  virtual bool isEnd(std::string_view line) const { return line == kGcodeEnd; }
  // Returns whether the line is a message for people.
  virtual bool isMessage(std::string_view code) const;

  void defect(base::Message reason) { out_.defect(std::move(reason)); }
  // Takes X Y Z as far as the line has them. Returns false if one of them is still unknown.
  bool takePosition(GcodeWords& words);
  // Takes a motion whose target has unknown axes, or one above the start.
  void approach(GcodeWords& words);
  bool knows(char letter) const { return known_[static_cast<std::size_t>(letter - 'X')]; }

  ProgramBuilder out_;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero(); // of the axes, as last stated
  double perS_ = 0.0;                                  // F / 60; 0: none yet

private:
  void readLine(std::string_view line);
  void comment(std::string_view text);
  void execute(GcodeWords& words);
  void executeG(double g, GcodeWords& words);
  void executeM(double m, GcodeWords& words);
  bool inTable(char letter, double number);
  // Takes M0 and a text for the operator. Returns false if the line is none.
  bool takeStop(std::string_view code);
  void heat(double m, GcodeWords& words);
  void heatBed(double m, GcodeWords& words);
  void cool(double m, GcodeWords& words);
  void switchCutter(GcodeWords& words);
  void home(GcodeWords& words);
  void setPosition(GcodeWords& words);
  void motion(double g, GcodeWords& words);
  void wait(GcodeWords& words);
  bool arc(const Eigen::Vector3d& from, double g, GcodeWords& words, plan::ProgramMotion& motion);

  // Returns the tool that the line heats: its T, else the selected one; nullopt if the job has no
  // such tool.
  std::optional<int> heatedTool(GcodeWords& words) const;
  // Returns whether the tool was selected since the last motion.
  bool isJustSelected(int tool);
  bool isCold() const;

  // A tool that was heated or has extruded must be cold at the end.
  struct Nozzle {
    double celsius = 0.0;
    bool used = false, cold = false;
  };
  Nozzle& nozzleOf(int tool) { return nozzles_[static_cast<std::size_t>(tool)]; }

  const process::Tooling tooling_;
  const base::RunContext& ctx_;
  std::vector<Nozzle> nozzles_; // per tool
  std::array<bool, 3> known_{}, homed_{};
  double filamentMm2_ = filamentArea();
  FilamentCount e_;
  bool relativeE_ = false, motorsOff_ = false, ended_ = false;
  bool isSettled_ = true; // all motions and waits are done (M400)
};

} // namespace voluta::program
