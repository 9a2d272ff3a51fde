#include "base/units.h"
#include "program/common/open_connections.h"
#include "program/common/procedures.h"
#include "program/common/program_text.h"
#include "program/program_builder.h"
#include "program/spel/spelplus.h"
#include "program/spel/spelplus_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace voluta::program {

namespace {

constexpr double kVolts = 10.0, kMaxSpeed = 1e5, kMaxSeconds = 1e5, kMaxNumber = 15.0;
constexpr double kNoMotionMm = 1e-4,
                 kNoRotationDeg = 1e-3; // smaller motions are none for the controller
constexpr int kMaxPort = 255;
constexpr Procedures::Words kStructure = {kSpelplusSyntax, spelplusPart};

class SpelplusReader {
public:
  SpelplusReader(const process::Tooling& tooling, const base::RunContext& ctx)
      : out_("spel", tooling), procedures_(kStructure, out_, ctx) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    out_.beginOutputs();
    bool complete =
        procedures_.find(files, [this](std::string_view code) { statements(code, true); });
    const Procedures::Statement run = [this](std::string_view code) { statements(code, false); };
    complete = procedures_.run(run) && complete;
    if (!out_.outputsEnded())
      out_.defect("the extruder is not switched off after the last motion"_text);
    return out_.take(complete && !missing_ && out_.outputsEnded());
  }

private:
  bool fail(base::Message reason) {
    reason_ = std::move(reason);
    return false;
  }

  // Processes the statements of a line, separated by semicolons.
  void statements(std::string_view code, bool outside) {
    while (!code.empty()) {
      const std::size_t end = std::min(findUnquoted(code, ";"), code.size());
      if (const std::string_view one = trimmed(code.substr(0, end)); !one.empty())
        whole(one, outside);
      code.remove_prefix(std::min(end + 1, code.size()));
    }
  }
  void whole(std::string_view code, bool outside) {
    LineCursor line(code, kSpelplusSyntax);
    reason_ = {};
    if ((outside ? declaredOutside(line) : statement(line)) && line.ended())
      return;
    if (reason_.empty())
      reason_ = base::message("not understood: '{code}'"_text, code.substr(0, 60));
    out_.defect(std::move(reason_));
  }
  static bool takeRest(LineCursor& line) {
    line = LineCursor({}, kSpelplusSyntax);
    return true;
  }

  bool declaredOutside(LineCursor& line) {
    line.takeWord("global");
    line.takeWord("preserve");
    return declaration(line) || fail("a statement outside the procedure"_text);
  }

  bool statement(LineCursor& line) {
    if (isType(line))
      return declaration(line);
    const std::string_view said = line.rest();
    std::string word;
    if (!line.takeName(word))
      return false;
    if (line.takeMark('='))
      return assignment(word, line);
    if (word == "call" && !line.takeName(word))
      return false;
    if (procedures_.contains(word)) {
      if (line.takeMark('(') && !line.takeMark(')'))
        return false;
      return line.ended() && procedures_.call(word);
    }
    if (said.size() > 5 && word != "call" && LineCursor(said, kSpelplusSyntax).isWord("call"))
      return missing_ = true,
             fail(base::message("the module with {procedure} is missing"_text, word.substr(0, 40)));
    if (word == "go" || word == "move")
      return motion(word == "go", line);
    if (word == "on" || word == "off")
      return digital(word == "on", line);
    if (word == "aio_out")
      return analogue(line);
    if (word == "write" && line.isMark('#'))
      return send(line);
    if (word == "wait")
      return wait(line);
    if (word == "power" || word == "motor" || word == "cp")
      return state(word, line);
    if (word == "tlset" || word == "local" || word == "ecpset")
      return frame(word == "tlset" ? tools_ : word == "local" ? locals_ : points_, line);
    if (word == "tool" || word == "ecp")
      return word == "tool" ? choose(tools_, tool_, line) : choose(points_, ecp_, line);
    if (word == "speed" || word == "speeds" || word == "speedr" || word == "accels" ||
        word == "accelr")
      return setting(word, line);
    if (word == "weight")
      return load(line);
    if (!out_.word(spelplusWords(), word))
      return fail(base::message("'{word}' is not known to the reader"_text, word.substr(0, 40)));
    if (word == "opennet" || word == "closenet")
      return connection(word == "opennet", line);
    std::string_view text;
    if ((word == "print" || word == "msgbox") && line.takeText(text))
      out_.show(text);
    if (word == "pause" || word == "msgbox")
      out_.operatorStop();
    return takeRest(line);
  }

  static bool isType(LineCursor line) {
    static constexpr std::array<std::string_view, 8> kTypes = {
        "real", "double", "integer", "long", "short", "boolean", "byte", "int32"};
    std::string type;
    return line.takeName(type) && std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
  }
  // TYPE name {, name}
  bool declaration(LineCursor& line) {
    std::string name;
    if (!isType(line) || !line.takeName(name))
      return false;
    do {
      if (!line.takeName(name))
        return false;
      variables_.numbers[name] = 0.0;
    } while (line.takeMark(','));
    return true;
  }
  // After name =.
  bool assignment(const std::string& name, LineCursor& line) {
    const bool isPoint = name.size() > 1 && name.front() == 'p' &&
                         name.find_first_not_of("0123456789", 1) == std::string::npos;
    if (isPoint) {
      SpelplusPoint point;
      if (!variables_.takePoint(line, point))
        return false;
      variables_.points[name] = point;
      return true;
    }
    const auto known = variables_.numbers.find(name);
    if (known == variables_.numbers.end())
      return fail(base::message("'{word}' is not known to the reader"_text, name.substr(0, 40)));
    double value = 0.0;
    if (!variables_.takeNumber(line, value))
      return false;
    known->second = value;
    return true;
  }

  // ---- outputs and settings

  bool digital(bool on, LineCursor& line) {
    double port = 0.0;
    std::string label;
    const bool isNamed = line.takeName(label);
    const bool isPort = !isNamed && variables_.takeNumber(line, port);
    const std::optional<int> number = wholeNumber(port, 0, kMaxPort);
    if (isPort && !number)
      return fail("an output needs a number and a value"_text);
    if (isPort && line.ended() && *number >= 2 && out_.toolOutput(*number - 1, on))
      return true;
    if (isNamed || (isPort && port != 1.0))
      return out_.wordAt("output", kOutsidePrint), takeRest(line);
    if (port != 1.0)
      return false;
    if (!line.ended())
      return fail("only the persistent forms of output commands are supported"_text);
    out_.setExtruder(on);
    return true;
  }
  bool analogue(LineCursor& line) {
    double channel = 0.0, volts = 0.0;
    if (!variables_.takeNumber(line, channel) || !line.takeMark(',') ||
        !variables_.takeNumber(line, volts))
      return false;
    if (!wholeNumber(channel, 0, kMaxPort))
      return fail("an output needs a number and a value"_text);
    if (channel != 1.0)
      return out_.wordAt("AIO_Out", kOutsidePrint), true;
    if (!(volts >= 0.0 && volts <= kVolts))
      return fail("an analogue output outside 0 to 10 V"_text);
    out_.flow(volts / kVolts);
    return true;
  }
  // OpenNet #201 As Client; CloseNet #201
  bool connection(bool opens, LineCursor& line) {
    double port = 0.0;
    if (!line.takeMark('#') || !line.takeNumber(port))
      return false;
    const std::optional<int> number = wholeNumber(port, 0, kMaxPort);
    if (!number)
      return false;
    if (opens)
      ports_.open(joined({"#", std::to_string(*number)}), {});
    else
      ports_.close(joined({"#", std::to_string(*number)}));
    return takeRest(line);
  }
  // Write #201, "text"
  bool send(LineCursor& line) {
    double port = 0.0;
    std::string_view text;
    if (!line.takeMark('#') || !line.takeNumber(port) || !line.takeMark(',') ||
        !line.takeText(text))
      return false;
    const std::optional<int> number = wholeNumber(port, 0, kMaxPort);
    if (!number)
      return false;
    const std::string name = joined({"#", std::to_string(*number)});
    if (!ports_.destination(name))
      return fail(notOpen(name));
    out_.send(text, name);
    return true;
  }
  // Sw(n) = On
  bool awaitInput(LineCursor& line) {
    double port = 0.0;
    std::string value;
    if (!line.takeWord("sw") || !line.takeMark('(') || !line.takeNumber(port) ||
        !line.takeMark(')') || !line.takeMark('=') || !line.takeName(value) ||
        (value != "on" && value != "off") || !line.ended())
      return false;
    const std::optional<int> number = wholeNumber(port, 1, kMaxPort);
    return number && out_.awaitInput(*number - 1, value == "on");
  }
  bool wait(LineCursor& line) {
    double seconds = 0.0;
    if (LineCursor input = line; awaitInput(input))
      return takeRest(line);
    LineCursor ahead = line;
    if (!variables_.takeNumber(ahead, seconds) || !ahead.ended())
      return out_.wordAt("Wait", kOutsidePrint), takeRest(line);
    if (!(seconds >= 0.0 && seconds <= kMaxSeconds))
      return fail("Wait needs a number of seconds"_text);
    line = ahead;
    out_.pauseByOutputs(seconds);
    return true;
  }
  bool state(const std::string& word, LineCursor& line) {
    std::string how;
    if (!line.takeName(how))
      return false;
    if (word == "power") {
      powerHigh_ = how == "high";
      out_.state(plan::FactKind::FullPower, powerHigh_ ? 1.0 : 0.0);
      return powerHigh_ || how == "low";
    }
    if (how != "on" && how != "off")
      return false;
    if (word == "cp") {
      rounds_ = how == "on";
    } else {
      // Motor On resets the settings to the robot's defaults.
      powerHigh_ = rounds_ = false;
      settings_.clear();
      out_.wordAt("Motor", how == "on" ? std::uint8_t{kSetUp} : std::uint8_t{kAtEnd});
    }
    return true;
  }
  using Frames = std::array<std::optional<Eigen::Isometry3d>, 16>;
  bool number(std::size_t& number, LineCursor& line) {
    double value = 0.0;
    if (!variables_.takeNumber(line, value) ||
        !(value >= 0.0 && value <= kMaxNumber && value == std::floor(value)))
      return false;
    number = static_cast<std::size_t>(value);
    return true;
  }
  bool frame(Frames& frames, LineCursor& line) {
    std::size_t n = 0;
    SpelplusPoint point;
    if (!number(n, line) || n == 0 || !line.takeMark(',') || !variables_.takePoint(line, point) ||
        !point.joints.empty())
      return false;
    frames[n] = point.pose();
    return true;
  }
  bool choose(const Frames& frames, std::size_t& chosen, LineCursor& line) {
    if (!number(chosen, line))
      return false;
    return chosen == 0 || frames[chosen] ||
           fail("a tool, local or control point that only the controller knows"_text);
  }
  // Uses the smaller of the values for acceleration and deceleration.
  bool setting(const std::string& word, LineCursor& line) {
    double minimum = 0.0, value = 0.0;
    if (!variables_.takeNumber(line, minimum))
      return false;
    while (line.takeMark(',')) {
      if (!variables_.takeNumber(line, value))
        return false;
      minimum = word == "accels" || word == "accelr" ? std::min(minimum, value) : minimum;
    }
    if (!(minimum > 0.0 && minimum <= (word == "speed" ? 100.0 : kMaxSpeed)))
      return fail("an invalid speed"_text);
    settings_[word] = minimum;
    if (word == "speed")
      out_.setJointSpeed("Speed");
    return true;
  }
  bool load(LineCursor& line) {
    double kg = 0.0;
    if (!variables_.takeNumber(line, kg))
      return false;
    out_.load("Weight", kg);
    out_.wordAt("Weight", kSetUp);
    return line.takeMark(',') ? takeRest(line) : true;
  }
  double set(std::string_view word) const { // 0 if it is not set
    const auto known = settings_.find(word);
    return known == settings_.end() ? 0.0 : known->second;
  }

  // ---- motions

  bool motion(bool byJoints, LineCursor& line) {
    SpelplusPoint point;
    if (!variables_.takePoint(line, point))
      return false;
    bool turns = false, external = false, rounds = rounds_;
    for (std::string word; line.takeName(word);) {
      if (word == "rot")
        turns = true;
      else if (word == "ecp")
        external = true;
      else if (word == "cp")
        rounds = true;
      else if (word != "ljm")
        return fail(base::message("'{word}' is not known to the reader"_text, word.substr(0, 40)));
    }
    if (!line.ended())
      return false;
    plan::ProgramMotion m;
    m.jointInterpolated = byJoints;
    if (!targetOf(m, point))
      return false;
    if (byJoints && (turns || external || rounds))
      return fail(base::message("how '{word}' rounds a corner is not known to the reader"_text,
                                "Go CP"_name));
    if (!byJoints && external != (ecp_ != 0))
      return fail("either the tool's path or that of the external control point is straight, "
                  "not both"_text);
    if (!(byJoints ? percentOf(m) : speedOf(m, turns, rounds)))
      return false;
    last_ = m.target == plan::TargetKind::Joints ? std::nullopt : std::optional(m.frame_T_tcp);
    lastKind_ = m.target;
    out_.motionByOutputs(std::move(m));
    return true;
  }

  bool targetOf(plan::ProgramMotion& m, const SpelplusPoint& point) {
    if ((tool_ != 0 && !tools_[tool_]) || (ecp_ != 0 && !points_[ecp_]) ||
        (point.local != 0 && !locals_[static_cast<std::size_t>(point.local)]))
      return fail("a tool, local or control point that only the controller knows"_text);
    const Eigen::Isometry3d tool = tool_ != 0 ? *tools_[tool_] : Eigen::Isometry3d::Identity();
    const std::optional<Eigen::Isometry3d> nozzle = ecp_ != 0 ? points_[ecp_] : std::nullopt;
    if (!out_.tool(tool, nozzle))
      return fail("a second, different tool"_text);
    if (!point.joints.empty()) {
      m.target = plan::TargetKind::Joints;
      if (!m.jointInterpolated)
        return fail("joints of a straight motion may be reached in another posture"_text);
      for (std::size_t k = 0; k < point.joints.size(); ++k) {
        const bool slides = point.joints.size() == 4 && k == 2; // in mm
        m.joints.push_back(slides ? point.joints[k] : base::degreesToRadians(point.joints[k]));
      }
      return true;
    }
    Eigen::Isometry3d base_T_tcp = point.pose();
    if (point.local != 0)
      base_T_tcp = *locals_[static_cast<std::size_t>(point.local)] * base_T_tcp;
    m.elbow = point.elbow;
    m.target = nozzle ? plan::TargetKind::WorkPose : plan::TargetKind::FlangePose;
    m.frame_T_tcp = nozzle ? Eigen::Isometry3d(base_T_tcp.inverse() * *nozzle) : base_T_tcp;
    return true;
  }

  bool percentOf(plan::ProgramMotion& m) {
    m.jointSpeedRadPerS = base::degreesToRadians(kSpelplusPtpDegPerS) * set("speed") / 100.0;
    return true;
  }

  bool speedOf(plan::ProgramMotion& m, bool turns, bool rounds) {
    if (!powerHigh_)
      return fail("Power Low limits the speed: Power High is missing"_text);
    const std::string_view speed = turns ? "speedr" : "speeds",
                           acceleration = turns ? "accelr" : "accels";
    const double v = set(speed), a = set(acceleration);
    if (!(v > 0.0) || (rounds && !(a > 0.0)))
      return fail(base::message("{frame} is not set before this motion"_text,
                                std::string(v > 0.0 ? acceleration : speed)));
    double distance = 0.0, angle = 0.0;
    const bool known = last_ && lastKind_ == m.target;
    if (known) {
      distance = (m.frame_T_tcp.translation() - last_->translation()).norm();
      angle = base::radiansToDegrees(Eigen::Quaterniond(m.frame_T_tcp.linear())
                                         .angularDistance(Eigen::Quaterniond(last_->linear())));
    }
    if (turns && !(angle > kNoRotationDeg))
      return fail("ROT, but the tool does not turn"_text);
    if (!turns && known && distance < kNoMotionMm && angle > kNoRotationDeg)
      return fail("a pure rotation needs ROT"_text);
    const double ramp = a > 0.0 ? v * v / (2.0 * a) : 0.0; // mm, or degrees
    if (turns)
      m.durationS = angle / v;
    else
      m.speedMmPerS = v;
    if (!turns)
      m.accelerationMmPerS2 = a < kSpelplusMmPerS2 ? a : 0.0;
    if (rounds)
      m.blendMm = turns ? ramp / angle * distance : ramp;
    return true;
  }

  ProgramBuilder out_;
  bool missing_ = false; // file of a called function
  Procedures procedures_;
  SpelplusVariables variables_;
  OpenConnections ports_;
  base::Message reason_;
  Frames tools_, locals_, points_; // points: external control points
  std::size_t tool_ = 0, ecp_ = 0;
  std::map<std::string, double, std::less<>> settings_; // by the words that set speeds
  bool powerHigh_ = false, rounds_ = false;
  std::optional<Eigen::Isometry3d> last_; // frame_T_tcp of the last motion, if it was a pose
  plan::TargetKind lastKind_ = plan::TargetKind::FlangePose;
};

} // namespace

plan::ReadProgram readSpelplus(const std::vector<plan::ProgramFile>& files,
                               const process::Tooling& tooling, const base::RunContext& ctx) {
  return SpelplusReader(tooling, ctx).read(files);
}

} // namespace voluta::program
