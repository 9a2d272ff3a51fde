// Reads what all kinds of G-code have in common: lines, comments, commands, the filament's length,
// heat, the end. A kind says what its targets are.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "process/process.h"
#include "program/gcode/gcode_line.h"
#include "program/gcode/gcode_text.h"
#include "program/program_builder.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::program {

// What may stand in any kind of G-code beside motion, heat and filament, and where; everything else
// is refused.
std::span<const KnownWord> gcodeWords();

// What slicers write besides.
std::span<const KnownWord> slicerWords();

class GcodeReader {
public:
  GcodeReader(std::string_view format, const process::Process& process,
              const base::RunContext& ctx);
  virtual ~GcodeReader() = default;
  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files);

protected:
  // Is it a word of this kind's targets, beside X Y Z?
  virtual bool isTargetWord(char /*letter*/) const { return false; }
  // Does the line go anywhere though it has no X Y Z?
  virtual bool movesBeside(GcodeWords&) const { return false; }
  // Takes over the words of a motion's target, and how fast it is reached. false: there is no
  // motion, or a defect was told. `g`: 0 or 1.
  virtual bool target(GcodeWords& words, double g, bool extruding, plan::ProgramMotion& motion) = 0;
  // G92 of the axes that isTargetWord() names. false: their origin would be another.
  virtual bool setsCount(GcodeWords&) { return false; }
  // G commands of this kind's own. false: it is none.
  virtual bool command(double /*g*/) { return false; }
  // Filament that is pushed or drawn on the spot.
  virtual double secondsOf(GcodeWords& words, double filamentMm);
  virtual void note(std::string_view /*comment*/) {}
  // Words that this kind knows besides gcodeWords().
  virtual std::span<const KnownWord> ownWords() const { return {}; }
  // All has been read.
  virtual void finish() {}
  virtual bool isEnd(std::string_view line) const { return line == kGcodeEnd; }
  // A line that is a text for people.
  virtual bool isMessage(std::string_view code) const;

  void defect(base::Message reason) { out_.defect(std::move(reason)); }
  // X Y Z as far as the line has them. false: one of them is still unknown.
  bool takePosition(GcodeWords& words);
  bool knows(char letter) const { return known_[static_cast<std::size_t>(letter - 'X')]; }

  ProgramBuilder out_;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero(); // the axes', as last said
  double perS_ = 0.0;                                  // F by 60; 0: none yet

private:
  void readLine(std::string_view line);
  void comment(std::string_view text);
  void execute(GcodeWords& words);
  void executeG(double g, GcodeWords& words);
  void executeM(double m, GcodeWords& words);
  bool inTable(char letter, double number);
  void heat(double m, GcodeWords& words);
  void setPosition(GcodeWords& words);
  void motion(double g, GcodeWords& words);

  const process::Process& process_;
  const base::RunContext& ctx_;
  std::array<bool, 3> known_{};
  double filamentMm2_ = filamentArea();
  FilamentCount e_;
  double celsius_ = 0.0;
  bool relativeE_ = false, cold_ = false, motorsOff_ = false, ended_ = false;
};

} // namespace voluta::program
