#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/rounded_settings.h"
#include "program/common/tape_cut.h"
#include "program/common/tcp_motions.h"
#include "program/common/walk.h"
#include "program/extruder.h"
#include "program/filament.h"
#include "program/full_flow.h"
#include "program/gcode/extruder_axis.h"
#include "program/job_head.h"
#include "program/krl/krl.h"
#include "program/krl/krl_motions.h"
#include "program/krl/krl_text.h"
#include "program/krl/krl_values.h"
#include "program/own_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::program {

namespace {

constexpr int kSpeedDigits = 6, kBlendDecimals = 4;
constexpr double kMaxRotationDegPerS = 400.0; // usual machine data

class KrlWriter : private ProgramEmitter {
public:
  KrlWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), motions_(input, ctx),
        cuts_(cutsOf(input, motionsPerFile(input.options, kKrlMotionsPerFile))),
        name_(krlName(input.name)), byAxis_(extruderOf(input).byAxis) {
    program_.format = "krl";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    walkTrajectory(in_, {"krl", cuts_, &motions_.tcp(), false, true}, *this, ctx_);
    program_.files.push_back({name_ + ".src", mainFile()});
    program_.files.push_back({name_ + ".dat", dataFile()});
    for (std::size_t part = 1; !oneFile() && part <= bodies_.size(); ++part)
      program_.files.push_back({partName(part) + ".src", partFile(part)});
    if (byAxis_)
      program_.files.push_back({joined({kKrlZero, ".src"}), zeroFile()});
    return std::move(program_);
  }

private:
  bool oneFile() const { return cuts_.size() == 2; }
  bool heldPlate() const { return in_.cell.nozzleMount() == robot::Mount::World; }
  bool movesPart() const { return in_.cell.axesMovePlatform(); }
  std::size_t underRobot() const { return in_.cell.axesUnderRobot(); }
  std::string partName(std::size_t part) const {
    return joined({name_, "_", std::to_string(part)});
  }

  void line(std::string_view text) {
    out_ += text;
    out_ += "\r\n";
  }
  void number(double value, int decimals) { appendFixed(out_, value, decimals, true); }

  // ---- files

  std::string mainFile() {
    std::size_t bytes = 0;
    for (const std::string& body : bodies_)
      bytes += body.size();
    out_.clear();
    header(name_);
    if (byAxis_)
      line(joined({"DECL INT ", kKrlExtruder}));
    if (underRobot() > 0)
      line(joined({"DECL INT ", kKrlUnderRobot}));
    about(bytes);
    setUp();
    if (oneFile()) {
      out_ += bodies_.front();
    } else {
      outputsOff();
      for (std::size_t part = 1; part <= bodies_.size(); ++part)
        line(joined({partName(part), " ( )"}));
    }
    line("END");
    return std::move(out_);
  }
  std::string partFile(std::size_t part) {
    out_.clear();
    header(partName(part));
    out_ += bodies_[part - 1];
    line("END");
    return std::move(out_);
  }
  std::string zeroFile() {
    out_.clear();
    header(std::string(kKrlZero));
    line(joined({"; ", kAxisQuestion}));
    line("HALT");
    line("END");
    return std::move(out_);
  }
  std::string dataFile() {
    out_.clear();
    line("&ACCESS RVP");
    line("&REL 1");
    line(joined({"DEFDAT ", name_, " PUBLIC"}));
    line("ENDDAT");
    return std::move(out_);
  }
  void header(const std::string& name) {
    line("&ACCESS RVP");
    line("&REL 1");
    line(joined({"DEF ", name, " ( )"}));
  }

  void about(std::size_t bytes) {
    line("; Robot program for printing, KRL");
    if (program_.foreign)
      line(
          "; FOREIGN: not the language of the cell's controller; Cartesian targets only, without S "
          "and T");
    for (const std::string& head : headLines(in_))
      line(joined({"; ", head}));
    if (heldPlate())
      line("; fixed nozzle: $BASE is the nozzle, $TOOL the work frame on the flange; poses are the "
           "nozzle's on it");
    else
      line("; moving nozzle: $TOOL is the nozzle's tip, $BASE the work frame");
    if (movesPart()) {
      if (in_.cell.rod()) {
        out_ += "; the rod is E1 of MACHINE_DEF[2]; its ROOT, z along the axis, is expected at ";
      } else {
        out_ += "; the table is on MACHINE_DEF[2]:";
        line(axesNote(underRobot(), in_.cell.externalAxes().size()));
        out_ += "; its frame, where all of them are at 0, z along the last one, is expected at ";
      }
      frame(in_.cell.base_T_fixed() * in_.cell.work_T_unit());
      line("");
    }
    if (underRobot() > 0) {
      line(joined({"; the arm rides on external axes:", axesNote(0, underRobot()),
                   "; $ROBROOT is expected to go with them,"}));
      line("; and to be $WORLD with them at 0");
    }
    if (byAxis_)
      line(joined({"; ", axisNote(extruderAxis(), axisCount(in_)),
                   "; 100 percent of its speed is taken as ", fixedText(kKrlExtruderMmPerS, 0),
                   " mm/s"}));
    else
      line(joined({"; extruder on: $OUT[1]; flow: $ANOUT[1], ", fullFlowText("1", in_.tooling),
                   ", 0 to 10 V"}));
    for (const std::string& note : toolNotes(in_, [](int k) {
           return joined({"$OUT[", std::to_string(k + 1), "]"});
         }))
      line(joined({"; ", note}));
    if (cutsTape(in_))
      line(joined({"; cutter of the tape: ", kKrlCutOutput, ", cuts when it turns on"}));
    if (motions_.rotationLimit() > kMaxRotationDegPerS)
      line(joined({"; the tool turns by up to ", fixedText(motions_.rotationLimit(), 0),
                   " degrees/s: machine data ($VEL_MA.ORI1) may hold it to less"}));
    if (motions_.slow() > 0)
      line(joined({"; ", std::to_string(motions_.slow()),
                   " motions are slower than 1 mm/s, which may be the least that $VEL.CP takes"}));
    if (bodies_.size() > 1)
      line(joined({"; it calls ", std::to_string(bodies_.size()), " more files beside it"}));
    const double megabytes = static_cast<double>(bytes) * 1e-6,
                 room = numberOf(krlMemoryMb(), in_.options);
    line(joined({megabytes > room ? "; TOO LONG: " : "; ", fixedText(megabytes, 1),
                 " MB of programs, the controller has room for ", fixedText(room, 2), " MB"}));
  }

  std::string axesNote(std::size_t first, std::size_t end) const {
    std::string note;
    for (std::size_t k = first; k < end; ++k)
      note += joined({k > first ? ", " : " ", in_.cell.externalAxes()[k].name, " is E",
                      std::to_string(k + 1)});
    return note;
  }

  void setUp() {
    for (const std::string_view text : kKrlInit)
      line(text);
    line("$ADVANCE=5");
    if (byAxis_)
      line(joined({kKrlExtruder, "=", std::to_string(in_.cell.externalAxes().size() + 1)}));
    if (underRobot() > 0)
      line(joined({kKrlUnderRobot, "=", std::to_string(underRobot())}));
    line(heldPlate() ? "$IPO_MODE=#TCP" : "$IPO_MODE=#BASE");
    out_ += "$BASE=";
    if (movesPart()) {
      out_ += "EK(MACHINE_DEF[2].ROOT,MACHINE_DEF[2].MECH_TYPE,";
      frame(in_.cell.work_T_unit().inverse());
      line(")");
    } else {
      frame(in_.cell.base_T_fixed());
      line("");
    }
    out_ += "$TOOL=";
    frame(in_.cell.flange_T_moved());
    line("");
    line(joined({"$LOAD=", krlLoadText(assumedLoadKg(in_), in_.cell.flange_T_moved().translation()),
                 " ; assumed: ", assumedLoadText(in_)}));
    if (!in_.arcs.empty())
      line("$CIRC_TYPE=#BASE");
    line(joined({"$ACC.CP=", fixedText(kKrlMaxMmPerS2 / 1000.0, 2)}));
    line(joined({"$VEL.ORI1=", fixedText(motions_.rotationLimit(), 0)}));
    line(joined({"$VEL.ORI2=", fixedText(motions_.rotationLimit(), 0)}));
  }

  void frame(const Eigen::Isometry3d& pose) {
    out_ += krlFrameText(pose.translation(), zyxDegrees(Eigen::Quaterniond(pose.linear())));
  }

  // ---- ProgramEmitter interface

  void beginFile(std::size_t) override {
    out_.clear();
    // Settings persist between files, but each file must also be readable alone.
    held_.clear();
    held_["$VEL.ORI1"] = held_["$VEL.ORI2"] = fixedText(motions_.rotationLimit(), 0);
    outputsOff();
    stands_ = true;
  }
  void endFile(std::size_t) override {
    line("; end");
    outputsOff();
    bodies_.push_back(std::move(out_));
  }
  void outputsOff() {
    if (byAxis_)
      return;
    line("$OUT[1]=FALSE");
    line("$ANOUT[1]=0");
  }
  void setOutput(int output, bool on) override {
    line(joined({"$OUT[", std::to_string(output + 1), on ? "]=TRUE" : "]=FALSE"}));
  }
  void awaitInput(int input, bool on) override {
    line(joined({"WAIT FOR $IN[", std::to_string(input + 1), on ? "]==TRUE" : "]==FALSE"}));
  }
  // HALT shows nothing itself.
  void pause(std::string_view message) override {
    line(joined({"MsgNotify(\"", message, "\")"}));
    line("HALT");
  }
  void cut() override {
    line(
        joined({"PULSE(", kKrlCutOutput, ",TRUE,", fixedText(kCutPulseS, 1), ") ; cuts the tape"}));
  }
  void prompt() override { pause(startQuestion(in_)); }
  // The advance run takes it while the arm still moves.
  void ownLine(std::string_view code) override {
    line(kKrlSettles);
    ProgramEmitter::ownLine(code);
  }
  void remark(std::string_view text) override { line(joined({"; ", text})); }
  void flow(std::string_view share) override {
    line(joined({stands_ ? "" : "TRIGGER WHEN DISTANCE=0 DELAY=0 DO ", "$ANOUT[1]=", share}));
  }
  void extruder(bool on) override { line(on ? "$OUT[1]=TRUE" : "$OUT[1]=FALSE"); }
  void wait(double seconds) override { line(joined({"WAIT SEC ", fixedText(seconds, 3)})); }

  std::string extruderAxis() const {
    return joined({"E", std::to_string(in_.cell.externalAxes().size() + 1)});
  }
  void zeroAxis() override {
    line(joined({kKrlZero, " ( )"}));
    axisMm_ = 0.0;
  }
  void extrudeInPlace(double filamentMm, double seconds) override {
    axisMm_ += filamentMm;
    setFeedPercent(std::clamp(
        std::round(100.0 * std::abs(filamentMm) / seconds / kKrlExtruderMmPerS), 1.0, 100.0));
    out_ += joined({"PTP {", extruderAxis(), " "});
    number(axisMm_, kFilamentDecimals);
    line("}");
    stands_ = true;
  }
  std::string feedSpeed() const {
    return joined({"$VEL_EXTAX[", std::to_string(in_.cell.externalAxes().size() + 1), "]"});
  }
  void setFeedPercent(double percent) {
    if (byAxis_)
      set(feedSpeed(), fixedText(percent, 0));
  }

  // Writes an assignment unless the variable already has this value.
  void set(std::string_view name, const std::string& value) {
    std::string& held = held_[std::string(name)];
    if (held == value)
      return;
    held = value;
    line(joined({name, "=", value}));
  }

  void jointMotion(std::size_t i) override {
    const plan::Trajectory& t = in_.trajectory;
    const std::string said = fixedText(motions_.jointPercent(i), 0);
    if (held_["BAS"] != said) {
      line(joined({"BAS (#VEL_PTP,", said, ")"})); // also sets the speed of external axes
      held_.erase(feedSpeed());
    }
    held_["BAS"] = said;
    setFeedPercent(100.0);
    out_ += "PTP ";
    if (program_.foreign) {
      target(i);
    } else {
      for (int k = 0; k < in_.cell.armDof(); ++k) {
        out_ += joined({k > 0 ? ",A" : "{A", std::to_string(k + 1), " "});
        number(base::radiansToDegrees(t.at(i)[k]), kKrlDegDecimals);
      }
      external(i);
      out_ += '}';
    }
    line("");
    stands_ = true;
  }
  void target(std::size_t i) {
    appendKrlTarget(out_, motions_.mm(i), motions_.degrees(i));
    external(i);
    out_ += '}';
  }
  void external(std::size_t i) {
    for (int k = in_.cell.armDof(); k < in_.cell.dof(); ++k) {
      out_ += joined({",E", std::to_string(k - in_.cell.armDof() + 1), " "});
      // degrees, or mm of a sliding axis
      number(robot::shownValue(in_.cell.limits()[static_cast<std::size_t>(k)].kind,
                               in_.trajectory.at(i)[k]),
             kKrlDegDecimals);
    }
    if (byAxis_) {
      out_ += joined({",", extruderAxis(), " "});
      number(axisMm_, kFilamentDecimals);
    }
  }

  void straightMotion(std::size_t i, bool stops) override {
    axisMm_ += motionVolumeMm3(in_.trajectory, i) / filamentArea();
    setFeedPercent(100.0);
    const double mmPerS = motions_.mmPerS(i), degPerS = motions_.degPerS(i);
    const std::string rotation = fixedText(degPerS, decimalsFor(degPerS, kSpeedDigits));
    set("$VEL.CP", fixedText(mmPerS / 1000.0, decimalsFor(mmPerS / 1000.0, kSpeedDigits)));
    set("$VEL.ORI1", rotation);
    set("$VEL.ORI2", rotation);
    const double blend = stops ? 0.0 : motions_.blendMm(i);
    const bool rounds = blend > 0.0;
    if (rounds)
      set("$APO.CDIS", fixedText(steppedDown(blend), kBlendDecimals));
    if (const std::optional<ViaTarget> via = motions_.via(i)) {
      out_ += "CIRC ";
      appendKrlTarget(out_, via->mm, zyxDegrees(via->rotation));
      out_ += "},";
    } else {
      out_ += "LIN ";
    }
    target(i);
    line(rounds ? " C_DIS" : "");
    stands_ = !rounds;
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  KrlMotions motions_;
  std::vector<std::size_t> cuts_; // points of file k: cuts_[k - 1] .. cuts_[k]
  std::string name_, out_;
  const bool byAxis_; // the extruder is an external axis
  double axisMm_ = 0.0;
  std::vector<std::string> bodies_; // of the files
  std::map<std::string, std::string> held_;
  bool stands_ = true; // the arm is at rest after the last motion
  plan::Program program_;
};

} // namespace

base::ParameterSpec krlMemoryMb() {
  return base::numberParameter("krlMemoryMb", "MB", 4.0, 0.1, 10000.0, "Programs"_text,
                               "KRL memory"_text,
                               "Program memory of the controller. Longer programs "
                               "contain a note in their header."_text);
}

std::vector<base::ParameterSpec> krlOptions() {
  return {motionsPerFileOption(), krlMemoryMb()};
}

plan::Program writeKrl(const ProgramInput& input, const base::RunContext& ctx) {
  return KrlWriter(input, ctx).write();
}

} // namespace voluta::program
