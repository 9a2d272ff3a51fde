#include "base/units.h"
#include "program/common/arm_branch.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/tape_cut.h"
#include "program/common/tcp_motions.h"
#include "program/common/walk.h"
#include "program/extruder.h"
#include "program/filament.h"
#include "program/full_flow.h"
#include "program/gcode/extruder_axis.h"
#include "program/job_head.h"
#include "program/rapid/rapid.h"
#include "program/rapid/rapid_files.h"
#include "program/rapid/rapid_motions.h"
#include "program/rapid/rapid_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {
constexpr std::string_view kNewLine = "\r\n";
// 1e-8 in a quaternion moves a point of the part 300 mm away by 0.000006 mm.
constexpr int kPositionDecimals = 4, kRotationDecimals = 8;
constexpr int kDegreeDecimals = 6, kSpeedDecimals = 4, kSecondDecimals = 6, kZoneDecimals = 3;
// The volume is accurate to 0.1 %.
constexpr int kPerMmDigits = 5;
constexpr double kSamePerMm = 5e-4;
// Of the predefined v10..v7000.
constexpr double kRotationDegPerS = 500.0;
constexpr std::size_t kExternals = 6;
constexpr int kExternalDecimals = 4; // Resolves one step of a motor with 200 x 16 steps per turn
constexpr double kAxisDegPerS = 1000.0;

std::string moduleName(const std::string& part, std::size_t module) {
  std::string id = programName(part);
  if (module > 0)
    id += joined({"_", std::to_string(module)});
  return id;
}

bool isForOmniCore(const ProgramInput& input) {
  const std::string chosen = chosenOf(rapidModules(), input.options);
  return chosen == "modx" ||
         (chosen == "robot" && input.cell.robot().controllerModel == robot::kOmniCore);
}

class RapidWriter : private ProgramEmitter {
public:
  RapidWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), targets_(motionTargets(input, ctx)),
        motions_(in_, targets_, writtenShare, TcpFrame::Work),
        cuts_(cutsOf(input, motionsPerFile(input.options, kMotionsPerModule))),
        name_(identifierOf(input.name)), object_(in_.cell.rod() ? "wRod"
                                                 : movesPart()  ? "wTable"
                                                 : heldPlate()  ? "wPlate"
                                                                : "wPrint"),
        omniCore_(isForOmniCore(input)), byAxis_(extruderOf(input).byAxis),
        bySpeed_(!byAxis_ && chosenOf(rapidFlow(), input.options) == "speed") {
    program_.format = "rapid";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    placeInWorkFrame(in_, kPositionDecimals, targets_);
    beginMain();
    if (!oneModule()) {
      for (std::size_t part = 1; part < cuts_.size(); ++part)
        callModule(part);
      outputsOff();
      endModule(0);
    }
    walkTrajectory(in_, {"rapid", cuts_, &motions_, false, true}, *this, ctx_);
    if (!byAxis_ || cutsTape(in_) || locksTool(in_))
      program_.files.push_back({name_ + "_EIO.cfg", signals()});
    program_.files.push_back({name_ + ".pgf", moduleListText(fileName(0))});
    return std::move(program_);
  }

private:
  std::string signals() const {
    std::vector<std::string> outputs = toolOutputs(in_, rapidToolSignal);
    if (cutsTape(in_))
      outputs.emplace_back(kRapidCutSignal);
    return signalListText(movesPart()    ? unit()
                          : movesRobot() ? robotUnit()
                                         : std::string(),
                          omniCore_, !byAxis_, outputs);
  }

  // Main contains the motions itself.
  bool oneModule() const { return cuts_.size() == 2; }
  bool heldPlate() const { return in_.cell.nozzleMount() == robot::Mount::World; }
  bool movesPart() const { return in_.cell.axesMovePlatform(); }
  bool movesRobot() const { return in_.cell.axesUnderRobot() > 0; }
  std::string unit() const { return rapidName(in_.cell.externalUnit()); }
  std::string robotUnit() const { return rapidName(in_.cell.robotUnit()); }
  // Returns the position of an external axis [degrees]; a sliding axis [mm].
  double axisAt(std::size_t i, std::size_t axis) const {
    return robot::shownValue(
        in_.cell.externalAxes()[axis].limits.kind,
        in_.trajectory.at(i)[static_cast<std::size_t>(in_.cell.armDof()) + axis]);
  }
  std::size_t axes() const { return in_.cell.externalAxes().size(); }

  void line(std::string_view text) {
    out_ += text;
    out_ += kNewLine;
  }
  void number(double value, int decimals, bool trim = true) {
    appendFixed(out_, value, decimals, trim);
  }
  robot::JointVector jointsAt(std::size_t i) const {
    return Eigen::Map<const Eigen::VectorXd>(in_.trajectory.at(i), in_.trajectory.dof);
  }
  std::string fileName(std::size_t part) const {
    const std::string_view extension = moduleExtension(omniCore_);
    return part == 0 ? joined({name_, extension})
                     : joined({name_, "_", std::to_string(part), extension});
  }

  void beginMain() {
    line(joined({"MODULE ", moduleName(in_.name, 0)}));
    about();
    declareTool();
    declareObject();
    line("  VAR triggdata tFlow;");
    line("  PROC main()");
    line("    ConfL\\Off;");
    line("    ConfJ\\Off;");
    if (!in_.arcs.empty())
      line("    CirPathMode\\ObjectFrame;");
    if (movesRobot())
      line(joined({"    ActUnit ", robotUnit(), ";"}));
    if (movesPart())
      line(joined({"    ActUnit ", unit(), ";"}));
    if (byAxis_)
      line(joined({"    ActUnit ", kRapidExtruderUnit, ";"}));
    outputsOff();
  }
  void beginFile(std::size_t file) override {
    if (oneModule())
      return;
    line(joined({"MODULE ", moduleName(in_.name, file + 1)}));
    line(joined({"  PROC ", procedureName(file + 1), "()"}));
    outputsOff();
  }
  void endFile(std::size_t file) override {
    line("    ! end");
    outputsOff();
    endModule(oneModule() ? 0 : file + 1);
  }
  static std::string procedureName(std::size_t part) {
    return joined({"runPart", std::to_string(part)});
  }
  void endModule(std::size_t part) {
    line("  ENDPROC");
    if (std::exchange(zeroes_, false)) {
      line("  LOCAL PROC zeroExtruder()");
      line(joined({"    UIMsgBox \"", kAxisQuestion, "\";"}));
      line("  ENDPROC");
    }
    line("ENDMODULE");
    program_.files.push_back({fileName(part), std::move(out_)});
    out_.clear();
  }
  void callModule(std::size_t part) {
    const std::string file = joined({"\"HOME:\"\\File:=\"", fileName(part), "\";"});
    line(joined({"    Load\\Dynamic,", file}));
    line(joined({"    %\"", procedureName(part), "\"%;"}));
    line(joined({"    UnLoad ", file}));
  }
  void about() {
    line("  ! Robot program for printing, RAPID");
    if (program_.foreign)
      line("  ! FOREIGN: not the language of the cell's controller; Cartesian targets only");
    for (const std::string& head : headLines(in_))
      line(joined({"  ! ", head}));
    if (heldPlate())
      line("  ! fixed nozzle: a stationary tool, which stands in world, the base while the base "
           "frame "
           "is zero; the arm holds the work object, poses are the nozzle's on it");
    else if (movesPart())
      aboutAxes();
    else
      line("  ! moving nozzle: the TCP is the nozzle's tip, poses are in the plate's work object, "
           "which stands in world, the base while the base frame is zero");
    if (movesRobot())
      aboutTrack();
    if (byAxis_)
      aboutExtruderAxis();
    else
      aboutSignals();
    if (cutsTape(in_))
      line(joined(
          {"  ! cutter of the tape: the signal ", kRapidCutSignal, ", cuts when it turns on"}));
    if (movesRobot())
      line(joined({"  ! expects the mechanical unit ", robotUnit()}));
    if (movesPart())
      line(joined({"  ! expects the mechanical unit ", unit()}));
    aboutDensity();
    if (cuts_.size() > 2)
      line("  ! the modules that it loads are to be put into HOME:");
  }

  void aboutSignals() {
    line(joined({"  ! extruder on: doExtruder; flow: aoFlow, ", fullFlowText("1", in_.tooling)}));
    for (const std::string& note : toolNotes(in_, rapidToolSignal))
      line(joined({"  ! ", note}));
    if (bySpeed_)
      line("  ! in beads aoFlow is the TCP's real speed in mm/s times TriggSpeed's last number");
    line(joined({"  ! expects the signals doExtruder and aoFlow, which goes from 0 to 1: ", name_,
                 "_EIO.cfg"}));
  }
  std::string extruderAxis() const {
    return joined({"eax_", std::string(1, static_cast<char>('a' + axes()))});
  }
  void aboutExtruderAxis() {
    line(joined({"  ! ", axisNote(extruderAxis(), axisCount(in_))}));
    line(joined({"  ! expects the mechanical unit ", kRapidExtruderUnit, " in MOC.cfg"}));
  }

  // With shorter motions, controllers report close positions (event 50078) and corners that they
  // could not plan in time (50024). The plan has slowed such motions to this duration.
  void aboutDensity() {
    std::size_t few = 0;
    for (std::size_t i = 1; i < targets_.size(); ++i)
      few += motions_.seconds(i) > 0.0 && motions_.seconds(i) < (1.0 + kFlowBand) * kRapidMotionS;
    if (few == 0)
      return;
    out_ += joined({"  ! ", std::to_string(few), " motions take "});
    number(kRapidMotionS * 1000.0, 0);
    line(" ms, the least that the controller plans in time");
  }

  void aboutAxes() {
    line(
        joined({"  ! moving nozzle: the TCP is the nozzle's tip, poses are in the work object that "
                "turns with the ",
                in_.cell.rod() ? "rod" : "table"}));
    if (in_.cell.rod()) {
      out_ +=
          joined({"  ! the rod is the mechanical unit ", unit(), ", its angle eax_a, its frame "});
    } else {
      out_ += joined({"  ! the table is on the mechanical unit ", unit(), ":"});
      out_ += axesNote(in_.cell.axesUnderRobot(), axes());
      line("");
      out_ += "  ! its frame, where all of them are at 0, z along the last one: ";
    }
    out_ += rapidFrame(in_.cell.base_T_fixed() * in_.cell.work_T_unit());
    line(" in world, the base while the base frame is zero");
  }

  // The base frame's "moved by" cannot be set by a program.
  void aboutTrack() {
    out_ += joined({"  ! the arm rides on the mechanical unit ", robotUnit(), ":"});
    out_ += axesNote(0, in_.cell.axesUnderRobot());
    line("; the robot's base frame is expected to be moved by it,");
    line("  ! and to be zero with it at 0: world is where the base then stands");
  }
  std::string axesNote(std::size_t first, std::size_t end) const {
    std::string note;
    for (std::size_t k = first; k < end; ++k)
      note += joined({k > first ? ", " : " ", in_.cell.externalAxes()[k].name, " is eax_",
                      std::string(1, static_cast<char>('a' + k))});
    return note;
  }

  void declareObject() {
    if (movesPart())
      line(joined({"  PERS wobjdata ", object_, ":=[FALSE,FALSE,\"", unit(),
                   "\",[[0,0,0],[1,0,0,0]],", rapidFrame(in_.cell.work_T_unit().inverse()), "];"}));
    else
      line(rapidObjectLine(in_, object_));
  }

  void declareTool() {
    line(joined({"  ! load assumed: ", assumedLoadText(in_)}));
    line(rapidToolLine(in_));
  }

  void outputsOff() {
    if (byAxis_)
      return;
    line("    SetDO doExtruder,0;");
    line("    SetAO aoFlow,0;");
    share_.clear();
    perMm_ = 0.0;
  }
  void setOutput(int output, bool on) override {
    line(joined({"    SetDO ", rapidToolSignal(output), on ? ",1;" : ",0;"}));
  }
  void awaitInput(int input, bool on) override {
    line(joined({"    WaitDI ", rapidMarkInput(input), on ? ",1;" : ",0;"}));
  }
  void pause(std::string_view message) override {
    line(joined({"    UIMsgBox \"", message, "\";"}));
  }
  void cut() override {
    line(joined({"    PulseDO\\PLength:=", fixedText(kCutPulseS, 1), ",", kRapidCutSignal, ";"}));
  }
  void prompt() override { line(joined({"    UIMsgBox \"", startQuestion(in_), "\";"})); }
  void remark(std::string_view text) override { line(joined({"    ! ", text})); }
  // Between motions that do not stop, an assignment would run ahead of the arm, so the flow is an
  // event at the point where the next motion begins.
  void flow(std::string_view share) override {
    if (bySpeed_)
      standingShare_ = share; // Each motion of a bead gives its own flow
    else
      sayFlow(share);
  }
  void sayFlow(std::string_view share) {
    if (stands_)
      line(joined({"    SetAO aoFlow,", share, ";"}));
    else
      line(joined({"    TriggEquip tFlow,0\\Start,0\\AOp:=aoFlow,", share, ";"}));
    atStart_ = !stands_;
  }
  // Flow proportional to the TCP's actual speed, from the start of motion i. A motion with hardly
  // any path has no speed to scale with.
  void flowBySpeed(std::size_t i) {
    constexpr double kMinLengthMm = 0.01;
    const double full = in_.tooling.fullFlowMm3PerS();
    const double distance = i > 0 ? motions_.tcpMm(i) : 0.0;
    if (i == 0 || in_.trajectory.move[i - 1] == plan::MoveKind::Joint || distance < kMinLengthMm) {
      if (const std::string share = shareText(motions_.flowMm3PerS(i) / full);
          share != std::exchange(share_, share))
        sayFlow(share);
      perMm_ = 0.0;
      return;
    }
    const double perMm = motionVolumeMm3(in_.trajectory, i) / distance / full;
    if (std::abs(perMm - perMm_) <= kSamePerMm * perMm_)
      return;
    line(joined({"    TriggSpeed tFlow,0\\Start,0,aoFlow,",
                 fixedText(perMm, decimalsFor(perMm, kPerMmDigits)), ";"}));
    perMm_ = perMm;
    share_.clear();
    atStart_ = true;
  }
  void extruder(bool on) override {
    line(on ? "    SetDO doExtruder,1;" : "    SetDO doExtruder,0;");
  }
  void wait(double seconds) override {
    if (bySpeed_ && !standingShare_.empty())
      line(joined({"    SetAO aoFlow,", standingShare_, ";"}));
    out_ += "    WaitTime ";
    number(seconds, 3);
    line(";");
    if (bySpeed_ && !standingShare_.empty())
      line("    SetAO aoFlow,0;");
    standingShare_.clear();
    share_.clear();
    perMm_ = 0.0;
  }

  void zeroAxis() override {
    line("    zeroExtruder;");
    axisMm_ = 0.0;
    zeroes_ = true;
  }
  void extrudeInPlace(double filamentMm, double seconds) override {
    axisMm_ += filamentMm;
    out_ += joined({"    MoveExtJ [", kRapidNoAxes, ","});
    externals(std::nullopt);
    out_ += "],v100\\T:=";
    number(seconds, kSecondDecimals);
    line(",fine;");
  }

  void jointMotion(std::size_t i) override { motion(i, true, 0.0); }
  void straightMotion(std::size_t i, bool stops) override {
    if (byAxis_)
      axisMm_ += motionVolumeMm3(in_.trajectory, i) / filamentArea();
    if (bySpeed_ && isPrint(in_.trajectory, i) && !extruderOf(in_).streams)
      flowBySpeed(i);
    motion(i, false, stops ? 0.0 : motions_.blendMm(i));
  }

  void motion(std::size_t i, bool joint, double blendMm) {
    const plan::Trajectory& t = in_.trajectory;
    if (joint && !program_.foreign) {
      out_ += "    MoveAbsJ [";
      for (int k = 0; k < in_.cell.armDof(); ++k) {
        out_ += k ? ',' : '[';
        number(base::radiansToDegrees(t.at(i)[k]), kDegreeDecimals);
      }
      out_ += "],";
      externals(i);
      out_ += "]\\NoEOffs";
    } else {
      const ArcVia* arc = joint ? nullptr : motions_.arc(i);
      if (arc)
        out_ += atStart_ ? "    TriggC " : "    MoveC ";
      else
        out_ += joint ? "    MoveJ " : atStart_ ? "    TriggL " : "    MoveL ";
      if (arc) {
        const ViaTarget via = viaTarget(in_, targets_, TcpFrame::Work, *arc);
        target(i, via.mm, via.rotation);
        out_ += ',';
      }
      target(i, targets_[i].tcpMm, targets_[i].tcpRotation);
    }
    speed(i, joint);
    if (std::exchange(atStart_, false))
      out_ += ",tFlow";
    zone(blendMm);
    stands_ = !(blendMm > 0.0);
    line(joined({",", kRapidTool, "\\WObj:=", object_, ";"}));
  }

  // A robtarget with the configuration and axes of point i.
  void target(std::size_t i, const Eigen::Vector3d& mm, const Eigen::Quaterniond& rotation) {
    out_ += '[';
    appendRapidPosition(out_, mm, kPositionDecimals);
    out_ += ',';
    appendRapidRotation(out_, rotation, kRotationDecimals);
    configuration(i);
    externals(i);
    out_ += ']';
  }

  // Axes that move part and robot to point i, and the extruder's; without a point they keep their
  // values.
  void externals(std::optional<std::size_t> i) {
    for (std::size_t k = 0; k < kExternals; ++k) {
      out_ += k > 0 ? ',' : '[';
      if (i && k < axes())
        number(axisAt(*i, k), kExternalDecimals);
      else if (byAxis_ && k == axes())
        number(axisMm_, kFilamentDecimals);
      else
        out_ += "9E9";
    }
    out_ += ']';
  }

  // Quarter turns of axes 1, 4 and 6, and which of the eight branches; they have no meaning for
  // another maker's axes.
  void configuration(std::size_t i) {
    const bool known = !program_.foreign && in_.cell.armDof() == 6;
    out_ += ",[";
    for (const int axis : {0, 3, 5}) {
      number(known ? std::floor(in_.trajectory.at(i)[axis] / (0.5 * base::kPi)) : 0.0, 0);
      out_ += ',';
    }
    number(known ? branch(i) : 0, 0);
    out_ += "],";
  }

  // confdata's cfx: 4 with the wrist's centre behind axis 1, 2 with it behind the lower arm, 1 with
  // axis 5 below zero.
  int branch(std::size_t i) const {
    const ArmBranch arm =
        armBranch(in_.cell.robot(),
                  Eigen::Map<const Eigen::VectorXd>(in_.trajectory.at(i), in_.cell.armDof()));
    return (arm.behindAxis1 ? 4 : 0) + (arm.behindLowerArm ? 2 : 0) + (arm.axis5Negative ? 1 : 0);
  }

  void speed(std::size_t i, bool joint) {
    const double s = joint ? motionSeconds(in_.trajectory, i) : motions_.seconds(i);
    const bool timed = s > 0.0 && (joint || motions_.needsTime(i));
    double mmPerS = i == 0 ? kRapidStartMmPerS : in_.process().travelSpeedMmPerS;
    double degPerS = i == 0 ? kRapidStartDegPerS : kRotationDegPerS, axisDegPerS = kAxisDegPerS;
    if (s > 0.0 && !timed) {
      mmPerS = motions_.speedMmPerS(i);
      // Rotations must not limit the motion's speed.
      const double angleRad = targets_[i].tcpRotation.angularDistance(targets_[i - 1].tcpRotation);
      const auto never = [&](double minimum, double rad) {
        return std::max(minimum, std::ceil(1.05 * base::radiansToDegrees(rad) / s));
      };
      degPerS = never(degPerS, angleRad);
      for (std::size_t k = 0; k < axes(); ++k)
        axisDegPerS =
            never(axisDegPerS, base::degreesToRadians(std::abs(axisAt(i, k) - axisAt(i - 1, k))));
    }
    out_ += ",[";
    number(mmPerS, kSpeedDecimals);
    out_ += ',';
    number(degPerS, 0);
    out_ += ",5000,";
    number(axisDegPerS, 0);
    out_ += ']';
    if (timed) {
      out_ += "\\T:=";
      number(s, kSecondDecimals);
    }
  }

  void zone(double radiusMm) {
    if (!(radiusMm > 0.0)) {
      out_ += ",fine";
      return;
    }
    out_ += ",[FALSE";
    for (int k = 0; k < 3; ++k) {
      out_ += ',';
      number(radiusMm, kZoneDecimals);
    }
    out_ += ",1,1,1]";
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  bool stands_ = true;   // The arm is stopped after the last motion
  bool atStart_ = false; // The flow changes where the next motion begins
  std::vector<MotionTarget> targets_;
  TcpMotions motions_;
  plan::Program program_;
  std::vector<std::size_t> cuts_; // Points of module k: cuts_[k - 1] .. cuts_[k]
  std::string name_, object_, out_;
  const bool omniCore_; // The files are for an OmniCore controller
  const bool byAxis_;   // The extruder is an external axis
  double axisMm_ = 0.0;
  bool zeroes_ = false; // In this module
  const bool bySpeed_;
  // As last written: the flow as a share, or per mm of path; and its value while the arm is
  // stopped.
  std::string share_, standingShare_;
  double perMm_ = 0.0;
};

} // namespace

base::ParameterSpec rapidModules() {
  return base::choiceParameter(
      "rapidModules", "robot",
      {{"robot", "according to the robot's controller"_text},
       {"mod", "IRC5: .mod"_text},
       {"modx", "OmniCore: .modx"_text}},
      "Programs"_text, "RAPID modules"_text,
      "Modules and signal list for this controller: IRC5 (RobotWare 6) or OmniCore (RobotWare 7)."_text);
}

base::ParameterSpec rapidFlow() {
  return base::choiceParameter(
      "rapidFlow", "events", {{"events", "events at points"_text}, {"speed", "TCP speed"_text}},
      "Programs"_text, "RAPID: flow controlled by"_text,
      "Events set the analogue output where a motion begins (TriggEquip); by TCP speed, it follows the TCP's actual speed, so that slow corners get no excess (TriggSpeed)."_text);
}

std::vector<base::ParameterSpec> rapidOptions() {
  return {motionsPerFileOption(), rapidModules(), rapidFlow()};
}

plan::Program writeRapid(const ProgramInput& input, const base::RunContext& ctx) {
  return RapidWriter(input, ctx).write();
}

} // namespace voluta::program
