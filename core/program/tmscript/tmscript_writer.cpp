#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/tcp_motions.h"
#include "program/common/walk.h"
#include "program/full_flow.h"
#include "program/job_head.h"
#include "program/own_lines.h"
#include "program/stream/pvt_velocities.h"
#include "program/tmscript/tmscript.h"
#include "program/tmscript/tmscript_frames.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
constexpr int kMmDecimals = 4, kDegDecimals = 5, kVelocityDecimals = 3, kSecondDecimals = 6;
constexpr int kJointDecimals = 6, kFrameDecimals = 6, kVoltDecimals = 8;
constexpr double kMinSeconds = 1e-3;
constexpr std::string_view kRampMs = "500";

class TmscriptWriter : private ProgramEmitter {
public:
  TmscriptWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), targets_(motionTargets(input, ctx)), motions_(in_, targets_) {
    program_.format = "tmscript";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    roundTargets();
    walkTrajectory(in_, {"tmscript", cutsOf(in_, 0), &motions_, false, true, true}, *this, ctx_);
    return std::move(program_);
  }

private:
  void roundTargets() {
    numbers_.resize(targets_.size());
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const Eigen::Quaterniond& rotation = targets_[i].tcpRotation;
      angles = i == 0 ? xyzAngles(rotation) : xyzAnglesNear(rotation, angles);
      for (int k = 0; k < 3; ++k) {
        targets_[i].tcpMm[k] = roundedTo(targets_[i].tcpMm[k], kMmDecimals);
        numbers_[i][k] = targets_[i].tcpMm[k];
        numbers_[i][k + 3] = roundedTo(base::radiansToDegrees(angles[k]), kDegDecimals);
      }
    }
  }

  void line(std::string_view text) {
    out_ += text;
    out_ += "\r\n";
  }
  void frame(std::string_view script) { out_ += tmFrame(std::to_string(++frames_), script); }
  static std::string listed(const PvtVector& values, int mmDecimals, int degDecimals) {
    std::string text;
    for (int k = 0; k < 6; ++k)
      text += (k ? "," : "") + fixedText(values[k], k < 3 ? mmDecimals : degDecimals);
    return text;
  }

  void beginFile(std::size_t) override {
    out_.clear();
    out_.reserve(std::min<std::size_t>(targets_.size() * 150 + 4096, 64u << 20));
    about();
    const Eigen::Isometry3d& tcp = in_.cell.flange_T_moved();
    PvtVector numbers;
    numbers << tcp.translation(),
        xyzAngles(Eigen::Quaterniond(tcp.linear())) * base::radiansToDegrees(1.0);
    frame("ChangeBase(\"RobotBase\")");
    frame(joined({"ChangeTCP({", listed(numbers, kFrameDecimals, kFrameDecimals), "},",
                  fixedText(assumedLoadKg(in_), 3), ")"}));
    outputsOff();
  }

  void about() {
    remark("Robot program for printing, TMscript: frames for a listen node, port 5890");
    remark("send a frame, wait for its OK, keep few in the queue; lines with // are not sent");
    if (program_.foreign)
      remark("FOREIGN: not the language of the cell's controller; Cartesian targets only");
    for (const std::string& head : headLines(in_))
      remark(head);
    remark(in_.cell.nozzleMount() == robot::Mount::World
               ? "fixed nozzle: the TCP is the plate's centre, poses are the plate's in RobotBase"
               : "moving nozzle: the TCP is the nozzle's tip, poses are in RobotBase");
    remark(joined(
        {"extruder on: DO 0 of the control box; flow: AO 0, ", fullFlowText("10 V", in_.tooling)}));
    for (const std::string& note : toolNotes(in_, [](int k) {
           return joined({"DO ", std::to_string(k)});
         }))
      remark(note);
    remark("the pendant shows no text at a stop: before it the text goes to the sender of the");
    remark("frames ($TMSTA 90), which has to show it");
  }

  void endFile(std::size_t) override {
    leave();
    remark("end");
    outputsOff();
    frame("ScriptExit()");
    program_.files.push_back({identifierOf(in_.name) + ".tmscript", std::move(out_)});
  }

  void outputsOff() {
    frame("IO[\"ControlBox\"].DO[0]=0");
    frame("IO[\"ControlBox\"].AO[0]=0");
  }
  void setOutput(int output, bool on) override {
    leave();
    frame(joined({"IO[\"ControlBox\"].DO[", std::to_string(output), on ? "]=1" : "]=0"}));
  }
  // The input is read as soon as the statement is, so the queue has to be done by then.
  void awaitInput(int input, bool on) override {
    leave();
    frame("QueueTag(1,1)");
    frame(joined({"while(IO[\"ControlBox\"].DI[", std::to_string(input),
                  on ? "]==0){Sleep(10)}" : "]==1){Sleep(10)}"}));
  }
  void pause(std::string_view message) override {
    leave();
    frame("QueueTag(1,1)");
    show(message);
    frame("Pause()");
  }
  void prompt() override {
    show(startQuestion(in_));
    frame("Pause()");
  }
  void show(std::string_view message) { frame(joined({"ListenSend(90,\"", message, "\")"})); }
  void ownLine(std::string_view code) override {
    leave();
    frame(kTmSettles); // the queue has to be done
    remark(kOwnLineMark);
    frame(code);
  }
  void remark(std::string_view text) override { line(joined({"// ", text})); }
  void flow(std::string_view share) override {
    double value = 0.0;
    parseNumber(share, value);
    frame("IO[\"ControlBox\"].AO[0]=" + fixedText(value * kTmFullVolts, kVoltDecimals));
  }
  void extruder(bool on) override {
    frame(on ? "IO[\"ControlBox\"].DO[0]=1" : "IO[\"ControlBox\"].DO[0]=0");
  }

  void enter() {
    if (!within_)
      frame("PVTEnter(1)");
    within_ = true;
  }
  void leave() {
    if (within_)
      frame("PVTExit()");
    within_ = false;
  }
  void point(std::string_view numbers, std::string_view velocity, double seconds) {
    frame(joined(
        {"PVTPoint(", numbers, ",", velocity, ",", fixedText(seconds, kSecondDecimals), ")"}));
  }

  // Where the arm is stationary at the first point.
  void wait(double seconds) override {
    leave();
    frame(program_.foreign ? "PVTEnter(1)" : "PVTEnter(0)");
    point(target(at_), listed(PvtVector::Zero(), 0, 0), seconds);
    frame("PVTExit()");
  }

  std::string target(std::size_t i) const {
    if (program_.foreign)
      return listed(numbers_[i], kMmDecimals, kDegDecimals);
    std::string text;
    for (int k = 0; k < in_.trajectory.dof; ++k)
      text += (k ? "," : "") +
              fixedText(base::radiansToDegrees(in_.trajectory.at(i)[k]), kJointDecimals);
    return text;
  }

  void jointMotion(std::size_t i) override {
    at_ = i;
    const plan::Trajectory& t = in_.trajectory;
    double percent = kTmStartPercent;
    if (const double s = motionSeconds(t, i); s > 0.0) {
      const double largest = leadingJointRad(in_, i);
      percent = std::clamp(100.0 * largest / s / kTmJointRadPerS, 1.0, 100.0);
    }
    leave();
    frame(joined({program_.foreign ? "PTP(\"CPP\"," : "PTP(\"JPP\",", target(i), ",",
                  fixedText(percent, 0), ",", kRampMs, ",0,false)"}));
  }

  void straightMotion(std::size_t i, bool stops) override {
    at_ = i;
    enter();
    const PvtMotion in = motion(i);
    PvtVector velocity = PvtVector::Zero();
    if (!stops && in_.trajectory.move[i + 1] == in_.trajectory.move[i])
      velocity = pvtVelocity(in, motion(i + 1), kBlendToleranceMm);
    point(listed(numbers_[i], kMmDecimals, kDegDecimals),
          listed(velocity, kVelocityDecimals, kVelocityDecimals), in.seconds);
  }

  PvtMotion motion(std::size_t i) const {
    double seconds = motions_.seconds(i);
    if (!(seconds > 0.0))
      seconds = motions_.tcpMm(i) / in_.process().travelSpeedMmPerS;
    return {.displacement = numbers_[i] - numbers_[i - 1],
            .seconds = std::max(seconds, kMinSeconds)};
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  std::vector<MotionTarget> targets_;
  TcpMotions motions_;
  std::size_t at_ = 0;             // Current point
  std::vector<PvtVector> numbers_; // Targets as written
  plan::Program program_;
  std::string out_;
  std::size_t frames_ = 0;
  bool within_ = false; // PVTEnter has been written
};

} // namespace

plan::Program writeTmscript(const ProgramInput& input, const base::RunContext& ctx) {
  return TmscriptWriter(input, ctx).write();
}

} // namespace voluta::program
