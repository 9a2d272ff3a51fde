#include "base/units.h"
#include "program/common/arm_branch.h"
#include "program/common/program_text.h"
#include "program/common/walk.h"
#include "program/full_flow.h"
#include "program/job_head.h"
#include "program/melfa/melfa.h"
#include "program/melfa/melfa_motions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {
constexpr int kPercentDecimals = 2, kSpeedDigits = 7;
// Relative difference below which speeds count as equal: each change is a step, and volume is
// accurate to 0.1 %.
constexpr double kSameSpeed = 2e-4;
// Program names on the controller have at most 12 characters
constexpr std::size_t kNameCharacters = 9;

class MelfaWriter : private ProgramEmitter {
public:
  MelfaWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), motions_(input, ctx),
        cuts_(cutsOf(input, std::min(motionsPerFile(input.options, kMelfaMotionsPerFile),
                                     kMelfaMotionsPerFile))),
        name_(identifierOf(input.name).substr(0, kNameCharacters)) {
    program_.format = "melfa";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    if (cuts_.size() > 2)
      callParts();
    walkTrajectory(in_, {"melfa", cuts_, &motions_.tcp(), false, true}, *this, ctx_);
    return std::move(program_);
  }

private:
  void step(std::string_view code) {
    out_ += std::to_string(++steps_);
    out_ += ' ';
    out_ += code;
    out_ += "\r\n";
  }
  static std::string frame(const Eigen::Isometry3d& pose) {
    return melfaFrame(pose.translation(), melfaDegrees(pose));
  }

  std::string flags(std::size_t i) const {
    const plan::ArmPosture posture = melfaPosture(in_.cell, program_.foreign, in_.trajectory.at(i));
    return joined(
        {"(", std::to_string(posture.structure), ",", std::to_string(posture.turns), ")"});
  }
  std::string targetOf(std::size_t i) const {
    return melfaPosition(motions_.mm(i), motions_.degrees(i), kMelfaMmDecimals, kMelfaDegDecimals,
                         flags(i));
  }

  std::string partName(std::size_t part) const {
    return cuts_.size() == 2 ? name_ : joined({name_, "_", std::to_string(part)});
  }

  void callParts() {
    out_.clear();
    steps_ = 0;
    about();
    for (std::size_t part = 1; part < cuts_.size(); ++part)
      step(joined({"CallP \"", partName(part), "\""}));
    outputsOff();
    step("End");
    program_.files.push_back({name_ + ".prg", std::move(out_)});
  }

  void beginFile(std::size_t file) override {
    out_.clear();
    out_.reserve(std::min<std::size_t>(motions_.count() * 110 + 4096, 8u << 20));
    steps_ = 0;
    mmPerS_ = 0.0;
    override_.clear();
    blendMm_ = 0.0;
    if (cuts_.size() == 2)
      about();
    else
      remark(joined({"part ", std::to_string(file + 1), " of ", std::to_string(cuts_.size() - 1),
                     ", called by ", name_}));
    step("Tool " + frame(in_.cell.flange_T_moved()));
    step("Base P_NBase");
    if (motions_.holdsWork())
      step("P_WkCord(1)=" + frame(in_.cell.base_T_fixed()));
    step("Ovrd 100");
    step("Accel 100,100");
    step("Cnt 0");
    outputsOff();
  }

  void about() {
    const std::size_t maximum = kMelfaMaxCharacters - 12; // After the number and the mark
    const auto say = [&](std::string_view text) { remark(text); };
    say("Robot program for printing, MELFA-BASIC V");
    if (program_.foreign)
      say("FOREIGN: not the language of the cell's controller; Cartesian targets only");
    for (const std::string& head : headLines(in_, maximum))
      say(head);
    if (motions_.holdsWork()) {
      say("fixed nozzle: Ex-T control, work coordinates 1 are the nozzle's; the TCP is the "
          "plate's");
      say("centre, positions are the plate's in the robot's base");
    } else {
      say("moving nozzle: the TCP is the nozzle's tip, positions are in the robot's base");
    }
    say(joined({"extruder on: output ", std::to_string(kMelfaExtruder), "; flow: outputs ",
                std::to_string(kMelfaFlow), " to ", std::to_string(kMelfaFlow + 15),
                " as a number, ", fullFlowText(fixedText(kMelfaFullFlow, 0), in_.tooling)}));
    for (const std::string& note : toolNotes(in_, [](int k) {
           return joined({"output ", std::to_string(melfaSignal(k))});
         }))
      say(note);
    say(joined({"load assumed: ", fixedText(assumedLoadKg(in_), 3), " kg, to be set in HNDDAT1"}));
  }

  void endFile(std::size_t file) override {
    remark("end");
    outputsOff();
    step("End");
    program_.files.push_back({partName(file + 1) + ".prg", out_});
  }

  void outputsOff() {
    step(joined({"M_Out(", std::to_string(kMelfaExtruder), ")=0"}));
    step(joined({"M_Outw(", std::to_string(kMelfaFlow), ")=0"}));
  }
  void setOutput(int output, bool on) override {
    step(joined({"M_Out(", std::to_string(melfaSignal(output)), on ? ")=1" : ")=0"}));
  }
  void awaitInput(int input, bool on) override {
    step(joined({"Wait M_In(", std::to_string(melfaSignal(input)), on ? ")=1" : ")=0"}));
  }
  // Hlt shows nothing itself.
  void show(std::string_view message) {
    step(joined({"Open \"COM1:\" As #1"}));
    step(joined({"Print #1,\"", message, "\""}));
    step("Close #1");
  }
  void pause(std::string_view message) override {
    show(message);
    step("Hlt");
  }
  void prompt() override {
    if (in_.selectsTool())
      show(startQuestion(in_));
    else
      remark(startQuestion(in_));
    remark("Hlt waits for the operator's start");
    step("Hlt");
  }
  void remark(std::string_view text) override { step(joined({"' ", text})); }
  void flow(std::string_view share) override {
    double value = 0.0;
    parseNumber(share, value);
    std::string code = joined({"M_Outw(", std::to_string(kMelfaFlow),
                               ")=", fixedText(std::round(value * kMelfaFullFlow), 0)});
    if (blendMm_ > 0.0)
      with_ = " Wth " + code;
    else
      step(code);
  }
  void extruder(bool on) override {
    step(joined({"M_Out(", std::to_string(kMelfaExtruder), on ? ")=1" : ")=0"}));
  }
  void wait(double seconds) override { step("Dly " + fixedText(seconds, 3)); }

  void jointMotion(std::size_t i) override {
    const plan::Trajectory& t = in_.trajectory;
    if (std::string text = fixedText(motions_.jointPercent(i), kPercentDecimals);
        text != override_) {
      step("JOvrd " + text);
      override_ = std::move(text);
    }
    if (program_.foreign) {
      step("Mov " + targetOf(i));
      return;
    }
    std::string joints = "J1=(";
    for (int k = 0; k < t.dof; ++k)
      joints += (k ? "," : "") + fixedText(base::radiansToDegrees(t.at(i)[k]), kMelfaFrameDecimals);
    step(joints + ")");
    step("Mov J1");
  }

  void straightMotion(std::size_t i, bool stops) override {
    const double mmPerS = motions_.mmPerS(i);
    if (std::abs(mmPerS - mmPerS_) > kSameSpeed * mmPerS_) {
      mmPerS_ = mmPerS;
      step("Spd " + fixedText(mmPerS, decimalsFor(mmPerS, kSpeedDigits)));
    }
    const double blendMm = stops ? 0.0 : heldBlendMm(i);
    if (blendMm > 0.0 && blendMm != blendMm_) {
      const std::string r = fixedText(blendMm, 3);
      step(joined({"Cnt 1,", r, ",", r}));
      blendMm_ = blendMm;
    }
    step(joined({motions_.holdsWork() ? "EMvs 1," : "Mvs ", targetOf(i), with_}));
    with_.clear();
    if (!(blendMm > 0.0) && blendMm_ > 0.0) {
      step("Cnt 0");
      blendMm_ = 0.0;
    }
  }

  // Each change is a step: keep the current blend if it is close enough.
  double heldBlendMm(std::size_t i) const {
    const double maximum = motions_.blendMm(i);
    return blendMm_ > 0.0 && blendMm_ <= maximum && 2.0 * blendMm_ > maximum ? blendMm_ : maximum;
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  MelfaMotions motions_;
  std::vector<std::size_t> cuts_;
  std::string name_, out_;
  plan::Program program_;
  std::size_t steps_ = 0;
  std::string override_; // As last written
  double mmPerS_ = 0.0;  // As last written
  double blendMm_ = 0.0; // As last written; 0: Cnt 0
  std::string with_;     // Output assignment with which the next motion begins
};

} // namespace

plan::ArmPosture melfaPosture(const robot::Cell& cell, bool foreign, const double* joints) {
  constexpr int kAxes = 6;
  if (foreign || cell.armDof() != kAxes)
    return kMelfaUsualPosture;
  const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(joints, kAxes);
  const ArmBranch arm = armBranch(cell.robot(), q);
  plan::ArmPosture posture;
  posture.structure =
      (arm.behindAxis1 ? 0U : 4U) + (arm.behindLowerArm ? 0U : 2U) + (arm.axis5Negative ? 0U : 1U);
  for (int k = 0; k < kAxes; ++k) {
    const auto n = static_cast<int>(std::round(q[k] / (2.0 * base::kPi)));
    posture.turns |= (static_cast<std::uint32_t>(n) & 0xfU) << (4 * k);
  }
  return posture;
}

std::vector<base::ParameterSpec> melfaOptions() {
  return {motionsPerFileOption()};
}

plan::Program writeMelfa(const ProgramInput& input, const base::RunContext& ctx) {
  return MelfaWriter(input, ctx).write();
}

} // namespace voluta::program
