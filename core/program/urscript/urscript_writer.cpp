#include "base/error.h"
#include "base/units.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/rotation_vector.h"
#include "program/common/tape_cut.h"
#include "program/common/tcp_motions.h"
#include "program/common/walk.h"
#include "program/extruder.h"
#include "program/full_flow.h"
#include "program/gcode/castelli_serial.h"
#include "program/gcode/gcode_text.h"
#include "program/job_head.h"
#include "program/urscript/urscript.h"
#include "program/urscript/urscript_outputs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::program {

namespace {
// Returns e.g. "standard_digital_out(5".
std::string urscriptSignal(int signal, std::string_view direction) {
  const bool isStandard = signal < kConfigurableFrom;
  return joined({isStandard ? "standard_digital_" : "configurable_digital_", direction, "(",
                 std::to_string(isStandard ? signal : signal - kConfigurableFrom)});
}
} // namespace

namespace {
// 1e-7 m is 0.0001 mm; 1e-7 rad moves a point of the part at 300 mm by 0.00003 mm.
constexpr int kPoseDecimals = 7;
constexpr int kTcpDecimals = 9;
constexpr int kSpeedDecimals = 7;
constexpr int kBlendDecimals = 6;
constexpr double kMaxAccelerationMPerS2 = 10.0;
constexpr double kStartRadPerS2 = 0.5;
// Factor of distance / time^2: accelerating half of the time, decelerating the other half
constexpr double kRampsOnly = 4.0;
constexpr std::string_view kSocket = "extruder";

class UrscriptWriter : private ProgramEmitter {
public:
  UrscriptWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), forPort_(chosenOf(urscriptForm(), input.options) == "port"), ctx_(ctx),
        targets_(motionTargets(input, ctx)), motions_(in_, targets_) {
    program_.format = "urscript";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    roundTargets();
    const Walk walk{"urscript", cutsOf(in_, motionsPerFile(in_.options, kMotionsPerScript)),
                    &motions_, forPort_, true};
    parts_ = walk.cuts.size() - 1;
    walkTrajectory(in_, walk, *this, ctx_);
    if (parts_ > 1 && !forPort_)
      program_.files.insert(program_.files.begin(), {fileName(0), callingFile()});
    return std::move(program_);
  }

private:
  void line(std::string_view text) {
    out_ += text;
    out_ += '\n';
  }
  void number(std::string_view before, double value, int decimals) {
    out_ += before;
    appendFixed(out_, value, decimals, true);
  }

  void roundTargets() {
    rotation_.resize(targets_.size());
    Eigen::Vector3d previous = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      previous = rotationVectorNear(targets_[i].tcpRotation, previous);
      rotation_[i] = previous;
      for (int k = 0; k < 3; ++k)
        targets_[i].tcpMm[k] = roundedTo(targets_[i].tcpMm[k] / 1000.0, kPoseDecimals) * 1000.0;
    }
  }
  double tcpSpeed(std::size_t i) const { // [m/s]; 0 where it is undefined
    return motions_.speedMmPerS(i) / 1000.0;
  }

  void pose(const Eigen::Vector3d& mm, const Eigen::Vector3d& rotation, int decimals) {
    out_ += "p[";
    for (int k = 0; k < 3; ++k) {
      appendFixed(out_, mm[k] / 1000.0, decimals);
      out_ += ',';
    }
    for (int k = 0; k < 3; ++k) {
      appendFixed(out_, rotation[k], decimals);
      out_ += k < 2 ? "," : "]";
    }
  }

  // Part 0: the function that calls the others, or the whole program.
  std::string functionName(std::size_t part) const {
    const std::string name = programName(in_.name);
    return part == 0 ? name : joined({name, "_", std::to_string(part)});
  }
  std::string fileName(std::size_t part) const {
    return joined({part == 0 ? identifierOf(in_.name) : functionName(part), ".script"});
  }

  // For file nodes: the nodes of the parts precede it, so that their functions are known.
  std::string callingFile() {
    out_.clear();
    line(joined({"def ", functionName(0), "():"}));
    line(joined({"  ", kCalledNote, ", as a file node wants it"}));
    about();
    line("  # file nodes before this one, so that what they define is known to it:");
    for (std::size_t part = 1; part <= parts_; ++part)
      line(joined({"  # ", fileName(part)}));
    for (std::size_t part = 1; part <= parts_; ++part)
      line(joined({"  ", functionName(part), "()"}));
    line("end");
    line(joined({functionName(0), "()"}));
    return std::move(out_);
  }

  void beginFile(std::size_t file) override {
    const bool alone = parts_ == 1;
    part_ = alone ? 0 : file + 1;
    out_.clear();
    out_.reserve(std::min<std::size_t>(targets_.size() * 110 + 4096, 64u << 20));
    line(joined({"def ", functionName(part_), "():"}));
    if (forPort_)
      line("  # for ports 30001 and 30002: sent, it runs by itself");
    else
      line(alone ? joined({"  ", kCalledNote, ", as a file node wants it"})
                 : joined({"  ", kPartNote, functionName(0)}));
    if (!alone)
      line(joined({"  # file ", std::to_string(file + 1), " of ", std::to_string(parts_)}));
    if (forPort_ && file + 1 < parts_)
      line(joined({"  ", kNextNote, fileName(part_ + 1)}));
    if (alone || (forPort_ && file == 0))
      about();
    const robot::Cell& cell = in_.cell;
    out_ += "  set_tcp(";
    const Eigen::Isometry3d& tcp = cell.flange_T_moved();
    pose(tcp.translation(), rotationVector(Eigen::Quaterniond(tcp.linear())), kTcpDecimals);
    line(")");
    number("  set_payload(", assumedLoadKg(in_), 3);
    out_ += ",[";
    for (int k = 0; k < 3; ++k)
      number(k ? "," : "", tcp.translation()[k] / 1000.0, 4);
    line(joined({"]) # assumed: ", assumedLoadText(in_)}));
    if (!sends()) {
      line("  set_analog_outputdomain(0,1) # 0 to 10 V");
      outputsOff();
      return;
    }
    line(joined({"  socket_open(\"", kCastelliAddress, "\",", std::to_string(kCastelliPort), ",\"",
                 kSocket, "\") # the extruder's address, to be set"}));
    outputsOff();
    if (const auto celsius = in_.process().material.nozzleC; celsius && file == 0)
      send(castelliHeatText(*celsius));
  }
  bool sends() const { return extruderOf(in_).text != nullptr; }
  void outputsOff() {
    if (sends()) {
      send(extruderOf(in_).text(0.0));
      return;
    }
    line("  set_standard_digital_out(0,False)");
    line("  set_standard_analog_out(0,0)");
  }
  void send(std::string_view text) override {
    line(joined({"  socket_send_string(\"", text, "\",\"", kSocket, "\")"}));
  }

  void about() {
    const robot::Cell& cell = in_.cell;
    line("  # Robot program for printing, URScript");
    if (program_.foreign)
      line("  # FOREIGN: the cell's robot is no Universal Robot; Cartesian targets only");
    for (const std::string& head : headLines(in_))
      line(joined({"  # ", head}));
    line(cell.nozzleMount() == robot::Mount::World
             ? "  # fixed nozzle: the TCP is the plate's centre, poses are the plate's in Base"
             : "  # moving nozzle: the TCP is the nozzle's tip");
    line(joined(
        {"  # ",
         extruderNote(in_, joined({"extruder on: digital output 0; flow: analogue output 0, ",
                                   fullFlowText("1", in_.tooling)}))}));
    for (const std::string& note : toolNotes(in_, [](int k) {
           return k < kConfigurableFrom
                      ? joined({"digital output ", std::to_string(k)})
                      : joined({"configurable output ", std::to_string(k - kConfigurableFrom)});
         }))
      line(joined({"  # ", note}));
    aboutCutter();
  }

  void aboutCutter() {
    if (cutsTape(in_))
      line(joined({"  # cutter of the tape: digital output ", std::to_string(kCutOutput),
                   ", cuts when it turns on, is drawn back when it turns off"}));
  }

  void setOutput(int output, bool on) override {
    line(joined({"  set_", urscriptSignal(output, "out"), on ? ",True)" : ",False)"}));
  }
  void awaitInput(int input, bool on) override {
    line(joined({"  while (get_", urscriptSignal(input, "in"), on ? ")!=True):" : ")!=False):"}));
    line("    sync()");
    line("  end");
  }
  void pause(std::string_view message) override {
    line(joined({"  popup(\"", message, "\",title=\"Voluta\",blocking=True)"}));
  }
  void cut() override {
    line(joined({"  set_standard_digital_out(", std::to_string(kCutOutput), ",True) # cuts"}));
    wait(kCutPulseS);
    line(joined({"  set_standard_digital_out(", std::to_string(kCutOutput), ",False)"}));
  }
  void prompt() override {
    line(joined({"  popup(\"", startQuestion(in_), "\",title=\"Voluta\",blocking=True)"}));
  }
  void endFile(std::size_t file) override {
    line("  # end");
    outputsOff();
    if (sends() && in_.process().material.nozzleC && file + 1 == parts_)
      send(castelliHeatText(0));
    if (sends())
      line(joined({"  socket_close(\"", kSocket, "\")"}));
    line("end");
    if (!forPort_ && parts_ == 1)
      line(joined({functionName(0), "()"}));
    program_.files.push_back({fileName(part_), out_});
  }

  void remark(std::string_view text) override { line(joined({"  # ", text})); }
  void flow(std::string_view share) override {
    line(joined({"  set_standard_analog_out(0,", share, ")"}));
  }
  void extruder(bool on) override {
    line(on ? "  set_standard_digital_out(0,True)" : "  set_standard_digital_out(0,False)");
  }
  void wait(double seconds) override {
    number("  sleep(", seconds, 3);
    line(")");
  }

  void jointMotion(std::size_t i) override {
    const plan::Trajectory& t = in_.trajectory;
    double acceleration = i > 0 ? in_.cell.travelAcceleration() : kStartRadPerS2;
    double speed = kStartRadPerS;
    if (const double s = motionSeconds(t, i); s > 0.0) {
      const double largest = leadingJointRad(in_, i);
      // A section of a longer motion stops at its end here, whereas the plan continues.
      if (program_.foreign)
        acceleration =
            std::max(acceleration, std::min(kRampsOnly * largest / (s * s), armRadPerS2()));
      if (largest > 1e-6)
        speed = rampedSpeed(largest, s, acceleration);
    }
    out_ += "  movej(";
    if (program_.foreign) {
      pose(targets_[i].tcpMm, rotation_[i], kPoseDecimals);
    } else {
      for (int k = 0; k < t.dof; ++k) {
        out_ += k ? ',' : '[';
        appendFixed(out_, t.at(i)[k], kPoseDecimals);
      }
      out_ += ']';
    }
    number(",a=", acceleration, 3);
    number(",v=", speed, kSpeedDecimals);
    line(")");
  }

  // Returns the minimum planned acceleration limit of the arm's joints.
  double armRadPerS2() const {
    double minimum = std::numeric_limits<double>::infinity();
    for (const robot::JointLimits& limits : in_.cell.robot().limits)
      if (limits.kind == robot::JointKind::Turning)
        minimum = std::min(minimum, limits.acceleration);
    return minimum;
  }

  void straightMotion(std::size_t i, bool stops) override {
    const double s = motions_.seconds(i), speed = tcpSpeed(i);
    // Enough to change to this speed from that of the last motion within half of this one, and to
    // blend its corner. An arc, which takes no time, keeps the planned acceleration at corners.
    const ArcVia* arc = motions_.arc(i);
    double acceleration =
        std::max(in_.process().accelerationMmPerS2, arc ? 0.0 : motions_.blendMmPerS2(i)) / 1000.0;
    if (s > 0.0)
      acceleration = std::max(acceleration, 2.0 * std::abs(speed - tcpSpeed(i - 1)) / s);
    acceleration = std::clamp(acceleration, 0.01, kMaxAccelerationMPerS2);

    if (arc) {
      out_ += "  movec(";
      const ViaTarget via = viaTarget(in_, targets_, TcpFrame::Base, *arc);
      pose(via.mm, rotationVectorNear(via.rotation, rotation_[i]), kPoseDecimals);
      out_ += ',';
    } else {
      out_ += "  movel(";
    }
    pose(targets_[i].tcpMm, rotation_[i], kPoseDecimals);
    number(",a=", acceleration, 2);
    if (arc && speed > 0.0)
      number(",v=", speed, kSpeedDecimals);
    else if (s > 0.0)
      number(",t=", s, 6);
    else
      number(",v=", in_.process().travelSpeedMmPerS / 1000.0, kSpeedDecimals);
    if (const double r = stops ? 0.0 : motions_.blendMm(i); r > 0.0)
      number(",r=", r / 1000.0, kBlendDecimals);
    line(")");
  }

  const ProgramInput& in_;
  const bool forPort_;
  const base::RunContext& ctx_;
  std::vector<MotionTarget> targets_;
  TcpMotions motions_;
  std::vector<Eigen::Vector3d> rotation_;
  plan::Program program_;
  std::string out_;
  std::size_t parts_ = 1, part_ = 0;
};

} // namespace

base::ParameterSpec urscriptForm() {
  return base::choiceParameter(
      "urscriptForm", "node", {{"node", "a file node"_text}, {"port", "a port"_text}},
      "Programs"_text, "URScript for"_text,
      "In a PolyScope file node the function must be called after its end. "
      "Text sent to port 30001 or 30002 runs by itself and must not call "
      "it."_text);
}

std::vector<base::ParameterSpec> urscriptOptions() {
  return {motionsPerFileOption(), urscriptForm()};
}

plan::Program writeUrscript(const ProgramInput& input, const base::RunContext& ctx) {
  return UrscriptWriter(input, ctx).write();
}

} // namespace voluta::program
