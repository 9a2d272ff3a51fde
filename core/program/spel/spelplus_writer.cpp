#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/rounded_settings.h"
#include "program/common/tcp_motions.h"
#include "program/common/walk.h"
#include "program/extruder.h"
#include "program/full_flow.h"
#include "program/gcode/castelli_serial.h"
#include "program/gcode/gcode_text.h"
#include "program/job_head.h"
#include "program/spel/spelplus.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::program {

namespace {

constexpr int kPositionDecimals = 5, kDegreeDecimals = 5, kFrameDecimals = 6;
constexpr int kSpeedDigits = 6;
constexpr double kMaxDegPerS2 = 5000.0, kMinDegPerS = 0.1; // AccelR, SpeedR
constexpr double kMinMmPerS = 0.1;                         // SpeedS
constexpr double kStartPercent = 10.0;
constexpr double kVolts = 10.0;
constexpr std::string_view kPort = "201"; // the first TCP/IP port
// Share of a rotation on the spot for the ramp at either end.
constexpr double kRotationShare = 0.45;

class SpelplusWriter : private ProgramEmitter {
public:
  SpelplusWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), tcp_(motionTargets(input, ctx)), targets_(tcp_),
        motions_(in_, targets_), cuts_(cutsOf(input, motionsPerFile(input.options, 0))),
        name_(programName(input.name)) {
    program_.format = "spel";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    // The nozzle's path on the part is straight and defines the speed.
    placeInWorkFrame(in_, kPositionDecimals, targets_);
    walkTrajectory(in_, {"spel", cuts_, &motions_, false, true}, *this, ctx_);
    if (!oneFile())
      program_.files.insert(program_.files.begin(), {fileName(0), callingFile()});
    return std::move(program_);
  }

private:
  bool oneFile() const { return cuts_.size() == 2; }
  bool heldPlate() const { return in_.cell.nozzleMount() == robot::Mount::World; }
  bool fourAxes() const { return !program_.foreign && in_.cell.armDof() == 4; }
  // Part 0 calls the others.
  std::string functionName(std::size_t part) const {
    return part == 0 ? name_ : joined({name_, "_", std::to_string(part)});
  }
  std::string fileName(std::size_t part) const { return functionName(part) + ".prg"; }

  void line(std::string_view text) {
    out_ += text;
    out_ += "\r\n";
  }
  void number(double value, int decimals) { appendFixed(out_, value, decimals, true); }

  std::string callingFile() {
    out_.clear();
    line(joined({"Function ", name_}));
    about();
    setUp();
    outputsOff();
    for (std::size_t part = 1; part < cuts_.size(); ++part)
      line(joined({"  Call ", functionName(part)}));
    line("Fend");
    return std::move(out_);
  }

  void about() {
    line("  ' Robot program for printing, SPEL+");
    if (program_.foreign)
      line("  ' FOREIGN: not the language of the cell's controller; Cartesian targets only");
    for (const std::string& head : headLines(in_))
      line(joined({"  ' ", head}));
    line(
        heldPlate()
            ? "  ' fixed nozzle: external control point 1 (an option of the controller); poses are "
              "tool 1's in Base, the work frame on the flange"
            : "  ' moving nozzle: poses are tool 1's in Base, the nozzle's tip");
    line(joined(
        {"  ' ", extruderNote(in_, joined({"extruder on: output 1; flow: analogue output 1, ",
                                           fullFlowText("10 V", in_.tooling)}))}));
    for (const std::string& note : toolNotes(in_, [](int k) {
           return joined({"output ", std::to_string(k + 1)});
         }))
      line(joined({"  ' ", note}));
    line("  ' to be added to a project of RC+, and called or chosen to be run");
  }

  void setUp() {
    line("  Motor On");
    line("  Power Low");
    out_ += "  TLSet 1, ";
    frame(in_.cell.flange_T_moved());
    line("  Tool 1");
    if (heldPlate()) {
      out_ += "  ECPSet 1, ";
      frame(in_.cell.base_T_fixed());
      line("  ECP 1");
    }
    if (!fourAxes())
      line("  AutoLJM On");
    out_ += "  Weight ";
    number(assumedLoadKg(in_), 3);
    line(joined({" ' assumed: ", assumedLoadText(in_)}));
    if (!sends())
      return;
    line(joined({"  SetNet #", kPort, ", \"", kCastelliAddress, "\", ",
                 std::to_string(kCastelliPort), ", CRLF ' the extruder's address, to be set"}));
    line(joined({"  OpenNet #", kPort, " As Client"}));
    line(joined({"  WaitNet #", kPort}));
    if (const auto celsius = in_.process().material.nozzleC)
      send(castelliHeatText(*celsius));
  }
  bool sends() const { return extruderOf(in_).text != nullptr; }
  // Write appends no line end, which the extruder would take for a text.
  void send(std::string_view text) override {
    line(joined({"  Write #", kPort, ", \"", text, "\""}));
  }

  void frame(const Eigen::Isometry3d& pose) {
    coordinates(pose.translation(), Eigen::Quaterniond(pose.linear()), kFrameDecimals,
                kFrameDecimals);
    line("");
  }
  void coordinates(const Eigen::Vector3d& mm, const Eigen::Quaterniond& rotation, int decimals,
                   int degreeDecimals) {
    const Eigen::Vector3d degrees = zyxDegrees(rotation);
    out_ += "XY(";
    for (int k = 0; k < 3; ++k) {
      number(mm[k], decimals);
      out_ += ',';
    }
    for (int k = 0; k < (fourAxes() ? 1 : 3); ++k) {
      out_ += k > 0 ? "," : "";
      number(degrees[k], degreeDecimals);
    }
    out_ += ')';
  }

  // ---- what is said in turn

  void beginFile(std::size_t file) override {
    held_.clear();
    out_.clear();
    line(joined({"Function ", functionName(oneFile() ? 0 : file + 1)}));
    if (oneFile()) {
      about();
      setUp();
    }
    outputsOff();
  }
  void endFile(std::size_t file) override {
    line("  ' end");
    outputsOff();
    if (sends() && in_.process().material.nozzleC && file + 2 == cuts_.size())
      send(castelliHeatText(0));
    line("Fend");
    program_.files.push_back({fileName(oneFile() ? 0 : file + 1), std::move(out_)});
  }
  void outputsOff() {
    if (sends()) {
      send(extruderOf(in_).text(0.0));
      return;
    }
    line("  Off 1");
    line("  AIO_Out 1, 0");
  }
  void setOutput(int output, bool on) override {
    line(joined({on ? "  On " : "  Off ", std::to_string(output + 1)}));
  }
  void awaitInput(int input, bool on) override {
    line(joined({"  Wait Sw(", std::to_string(input + 1), on ? ") = On" : ") = Off"}));
  }
  void pause(std::string_view message) override {
    line(joined({"  Print \"", message, "\""}));
    line("  Pause");
  }
  void prompt() override {
    line(joined({"  Print \"", startQuestion(in_), "\""}));
    line("  Pause");
  }
  void remark(std::string_view text) override { line(joined({"  ' ", text})); }
  void flow(std::string_view share) override {
    double value = 0.0;
    parseNumber(share, value);
    line(joined({"  AIO_Out 1, ", fixedText(kVolts * value, 7)}));
  }
  void extruder(bool on) override { line(on ? "  On 1" : "  Off 1"); }
  void wait(double seconds) override { line(joined({"  Wait ", fixedText(seconds, 3)})); }

  void set(std::string_view name, const std::string& value) {
    std::string& held = held_[std::string(name)];
    if (held == value)
      return;
    held = value;
    line(joined({"  ", name, " ", value}));
  }
  static std::string figure(double value) {
    return fixedText(value, decimalsFor(value, kSpeedDigits));
  }

  void jointMotion(std::size_t i) override {
    const plan::Trajectory& t = in_.trajectory;
    double percent = kStartPercent;
    if (const double s = motionSeconds(t, i); s > 0.0) {
      const double largest = leadingJointRad(in_, i);
      percent =
          std::clamp(std::round(100.0 * base::radiansToDegrees(largest) / s / kSpelplusPtpDegPerS),
                     1.0, 100.0);
    }
    set("Speed", fixedText(percent, 0));
    out_ += "  Go ";
    if (program_.foreign) {
      target(i);
    } else {
      for (int k = 0; k < in_.cell.armDof(); ++k) {
        out_ += k > 0 ? "," : "AglToPls(";
        const bool slides = fourAxes() && k == 2; // in mm
        number(slides ? t.at(i)[k] : base::radiansToDegrees(t.at(i)[k]), kDegreeDecimals);
      }
      out_ += ')';
    }
    line("");
    if (i == 0)
      line("  Power High");
  }
  void target(std::size_t i) {
    if (!fourAxes()) {
      coordinates(tcp_[i].tcpMm, tcp_[i].tcpRotation, kPositionDecimals, kDegreeDecimals);
      return;
    }
    // U continues beyond half a turn, as joint 4 does.
    const double* q = in_.trajectory.at(i);
    const double about = base::radiansToDegrees(q[0] + q[1] + q[3]) +
                         zyxDegrees(Eigen::Quaterniond(in_.cell.flange_T_moved().linear()))[0];
    const double u = zyxDegrees(tcp_[i].tcpRotation)[0];
    out_ += "XY(";
    for (int k = 0; k < 3; ++k) {
      number(tcp_[i].tcpMm[k], kPositionDecimals);
      out_ += ',';
    }
    number(u + 360.0 * std::round((about - u) / 360.0), kDegreeDecimals);
    // Seen from above, the forearm of a right arm turns to the left.
    out_ += q[1] >= 0.0 ? ") /R" : ") /L";
  }

  double rotationDeg(std::size_t i) const {
    return base::radiansToDegrees(
        targets_[i].tcpRotation.angularDistance(targets_[i - 1].tcpRotation));
  }
  bool isTimedByRotation(std::size_t i) const {
    return motions_.needsTime(i) && rotationDeg(i) / motions_.seconds(i) > kMinDegPerS;
  }
  double speedMmPerS(std::size_t i) const {
    const double v = motions_.speedMmPerS(i);
    return std::max(v > 0.0 ? v : in_.process().travelSpeedMmPerS, kMinMmPerS);
  }
  // Returns the acceleration that keeps the corner at the end of motion i within its blend, on both
  // sides. 0: no blend.
  double cornerMmPerS2(std::size_t i, double speed) const {
    const double r = i > 0 ? motions_.blendMm(i) : 0.0;
    return r > 0.0 ? speed * speed / (2.0 * r) : 0.0;
  }
  // Returns AccelS of a motion; above the maximum its corners cannot be blended.
  double accelerationOf(std::size_t i) const {
    const double v = speedMmPerS(i);
    const double a = std::max(cornerMmPerS2(i - 1, v), cornerMmPerS2(i, v));
    return a <= kSpelplusMmPerS2 ? kSpelplusMmPerS2 : steppedUp(a);
  }
  bool canRound(std::size_t i) const {
    if (isTimedByRotation(i)) {
      const double s = motions_.seconds(i);
      return rotationDeg(i) / (2.0 * kRotationShare * s * s) <= kMaxDegPerS2;
    }
    return accelerationOf(i) <= kSpelplusMaxMmPerS2;
  }

  void straightMotion(std::size_t i, bool stops) override {
    const bool byRotation = isTimedByRotation(i);
    if (byRotation) {
      const double s = motions_.seconds(i), degPerS = rotationDeg(i) / s;
      set("SpeedR", figure(degPerS));
      set("AccelR",
          fixedText(std::min(steppedUp(degPerS / (2.0 * kRotationShare * s)), kMaxDegPerS2), 2));
    } else {
      set("SpeedS", figure(speedMmPerS(i)));
      set("AccelS", fixedText(canRound(i) ? accelerationOf(i) : kSpelplusMmPerS2, 2));
    }
    const bool rounds = !stops && motions_.blendMm(i) > 0.0 && canRound(i) && canRound(i + 1);
    out_ += "  Move ";
    target(i);
    out_ += byRotation ? " ROT" : "";
    out_ += heldPlate() ? " ECP" : "";
    line(rounds ? " CP" : "");
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  std::vector<MotionTarget> tcp_, targets_; // of tool 1 in Base; of the nozzle in the work frame
  TcpMotions motions_;
  std::vector<std::size_t> cuts_;
  std::string name_, out_;
  std::map<std::string, std::string> held_;
  plan::Program program_;
};

} // namespace

std::vector<base::ParameterSpec> spelplusOptions() {
  return {motionsPerFileOption()};
}

plan::Program writeSpelplus(const ProgramInput& input, const base::RunContext& ctx) {
  return SpelplusWriter(input, ctx).write();
}

} // namespace voluta::program
