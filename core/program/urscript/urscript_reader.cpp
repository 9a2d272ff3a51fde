#include "base/error.h"
#include "program/common/arc_motion.h"
#include "program/common/open_connections.h"
#include "program/common/program_text.h"
#include "program/common/rotation_vector.h"
#include "program/full_flow.h"
#include "program/program_builder.h"
#include "program/urscript/urscript.h"
#include "program/urscript/urscript_functions.h"
#include "program/urscript/urscript_outputs.h"
#include "program/urscript/urscript_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voluta::program {

namespace {
constexpr double kMaxJointRad = 100.0, kMaxMetres = 100.0, kMaxSpeed = 100.0;

class UrscriptReader {
public:
  UrscriptReader(const process::Tooling& tooling, const base::RunContext& ctx)
      : ctx_(ctx), out_("urscript", tooling) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    out_.expectMotionsOf(files);
    functions_.find(files);
    bool complete = !files.empty();
    for (out_.file = 0; out_.file < files.size(); ++out_.file)
      if (!here().isReached)
        complete = runFile() && complete;
    functions_.refuseBesideParts();
    return out_.take(complete);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }

  using Line = UrscriptFunctions::Line;
  UrscriptFunctions::File& here() { return functions_.file(); }
  const std::vector<Line>& lines() { return here().lines; }

  void begin() {
    here().isReached = true;
    tcpSet_ = false;
    out_.beginOutputs();
  }
  // Each file that is sent to a port runs by itself: whatever ran before it may have set the arm's
  // payload and the outputs' range, and has closed its connections.
  void beginProgram() {
    sockets_.closeAll();
    isFurther_ = programs_++ > 0;
    loadStated_ = rangeStated_ = false;
  }
  // The first program's statements are judged by the replay, which knows what the plan needs.
  void requireStated() {
    if (isFurther_ && !std::exchange(loadStated_, true))
      defect("this file moves the arm before it states the payload"_text);
  }
  bool end() {
    const bool ended = out_.outputsEnded();
    if (!ended)
      defect("the extruder is not switched off after the last motion"_text);
    return ended;
  }

  bool runFile() {
    out_.line = here().last;
    if (here().isPart) {
      defect("nothing in this file is executed"_text);
      return false;
    }
    variables_.clear();
    here().isRun = true;
    beginProgram();
    begin();
    const bool ran = runTop();
    out_.line = here().last;
    return end() && ran;
  }

  // Runs the code outside of functions: definitions, set-up of variables, one call. Text that is
  // sent to a port ends with `end` and runs by itself.
  bool runTop() {
    const std::size_t tops = here().behind.size();
    const bool closed = here().closed, mustCall = here().mustCall;
    bool called = false;
    for (std::size_t i = 0; i < lines().size();) {
      out_.line = lines()[i].number;
      const std::string_view code = lines()[i].code;
      if (const auto definition = here().behind.find(i); definition != here().behind.end()) {
        i = definition->second;
        continue;
      }
      Call call;
      if (UrscriptScanner{code, variables_}.call(call) && functions_.contains(call.name)) {
        if (called)
          defect("a second call outside the functions"_text);
        called = true;
        run(call);
      } else if (code == "end") {
        defect("'end' closes no function"_text);
      } else if (!assign(code)) {
        reportOutside(code);
      }
      ++i;
    }
    if (!lines().empty())
      out_.line = lines().back().number;
    if (tops == 0)
      defect("no function is defined"_text);
    else if (!called && closed && (tops > 1 || mustCall))
      defect("the function is never called"_text);
    if (!called && tops > 0)
      run({.name = here().defined, .arguments = {}, .count = 0});
    return tops > 0 && closed && (called || (tops == 1 && !mustCall));
  }

  void reportOutside(std::string_view code) {
    Call call;
    if (UrscriptScanner{code, variables_}.call(call))
      defect(
          base::message("'{name}' is called outside the function"_text, call.name.substr(0, 40)));
    else
      defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
  }

  void run(const Call& call) {
    constexpr std::size_t kMaxDepth = 16;
    const bool again = std::find(running_.begin(), running_.end(), call.name) != running_.end();
    if (again || running_.size() == kMaxDepth || call.count > 0) {
      if (again)
        defect(base::message("'{name}' calls itself"_text, call.name));
      else
        defect(base::message("invalid call of '{name}'"_text, call.name));
      return;
    }
    const UrscriptFunctions::Function function = functions_.call(call.name);
    running_.emplace_back(call.name);
    const std::size_t callLine = out_.line, callFile = out_.file;
    const bool changesFile = function.file != callFile;
    out_.file = function.file;
    if (changesFile)
      begin();
    for (std::size_t i = function.first; i < function.end;) {
      out_.line = lines()[i].number;
      if (i % 4096 == 0)
        ctx_.checkpoint();
      if (UrscriptFunctions::isDefinition(lines()[i].code))
        functions_.define(i);
      else if (!awaitInput(i, function.end))
        statement(lines()[i++].code);
    }
    if (changesFile) {
      out_.line = here().last;
      end();
    }
    out_.file = callFile;
    out_.line = callLine;
    running_.pop_back();
  }

  // while (get_standard_digital_in(n)!=value): sync() end, in three lines: moves i behind them. The
  // same with a configurable input.
  bool awaitInput(std::size_t& i, std::size_t end) {
    UrscriptScanner scanner{lines()[i].code, variables_};
    if (i + 2 >= end || scanner.name() != "while" || lines()[i + 1].code != "sync()" ||
        lines()[i + 2].code != "end" || !scanner.take('('))
      return false;
    const std::string_view function = scanner.name();
    const bool isConfigurable = function == "get_configurable_digital_in";
    const int first = isConfigurable ? kConfigurableFrom : 0;
    const int last = isConfigurable ? 31 : kConfigurableFrom - 1;
    Value input, value;
    if ((!isConfigurable && function != "get_standard_digital_in") || !scanner.take('(') ||
        !scanner.value(input) || input.kind != ValueKind::Number || !scanner.take(')') ||
        !scanner.take('!') || !scanner.take('=') || !scanner.value(value) ||
        value.kind != ValueKind::Boolean || !scanner.take(')') || !scanner.take(':') ||
        !scanner.ended())
      return false;
    const std::optional<int> number = wholeNumber(input.number, 0, last);
    if (!number || !out_.awaitInput(first + *number, value.number > 0.0))
      return false;
    i += 3;
    return true;
  }

  // [global | local] name = value
  bool assign(std::string_view code) {
    UrscriptScanner scanner{code, variables_};
    std::string_view name = scanner.name();
    if (name == "global" || name == "local")
      name = scanner.name();
    if (name.empty() || !scanner.take('=') ||
        (!scanner.rest.empty() && scanner.rest.front() == '='))
      return false;
    Value value;
    if (!scanner.value(value) || !scanner.ended())
      return false;
    variables_.insert_or_assign(std::string(name), value);
    return true;
  }

  void statement(std::string_view code) {
    Call call;
    if (UrscriptScanner{code, variables_}.call(call)) {
      if (functions_.contains(call.name))
        run(call);
      else
        inFunction(call);
    } else if (!assign(code)) {
      defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
    }
  }

  void inFunction(const Call& call) {
    const std::string_view name = call.name;
    if (name == "movel" || name == "movej" || name == "movep")
      motion(call);
    else if (name == "movec")
      arc(call);
    else if (name == "set_standard_digital_out" || name == "set_digital_out")
      digitalOut(call, 0);
    else if (name == "set_configurable_digital_out")
      digitalOut(call, kConfigurableFrom);
    else if (name == "set_standard_analog_out" || name == "set_analog_out")
      analogOut(call);
    else if (name == "socket_send_string")
      sendText(call);
    else if (name == "socket_open")
      openSocket(call);
    else if (name == "socket_close")
      closeSocket(call);
    else if (name == "set_tcp")
      setTcp(call);
    else if (name == "sleep")
      sleep(call);
    else if (!out_.word(urscriptWords(), name))
      defect(base::message("'{name}' is not known to the reader"_text, name.substr(0, 40)));
    else
      settings(call);
  }

  // Evaluates the arguments of words in the table.
  void settings(const Call& call) {
    const Value* first = call.count > 0 ? &call.arguments[0].value : nullptr;
    if (call.name == "set_payload" || call.name == "set_payload_mass" ||
        call.name == "set_target_payload") {
      loadStated_ = true;
      if (!first || first->kind != ValueKind::Number || !(first->number >= 0.0))
        defect(base::message("'{name}' needs a mass"_text, call.name));
      else
        out_.load(call.name, first->number, centreOf(call.find("cog", 1)));
    } else if (call.name == "set_payload_cog") {
      if (const auto centre = centreOf(first))
        out_.loadCentre(call.name, *centre);
      else
        defect("a payload's centre is no sensible place"_text);
    } else if (call.name == "set_gravity") {
      constexpr double kG = 9.82, kSlack = 0.1;
      if (!first || first->kind != ValueKind::List || first->count != 3 ||
          (Eigen::Vector3d(first->list.data()) - Eigen::Vector3d(0, 0, kG)).norm() > kSlack)
        defect("gravity of an arm that is not upright"_text);
    } else if (call.name == "popup") {
      const Value* blocking = call.find("blocking", 4);
      if (first && first->kind == ValueKind::Text)
        out_.show(first->text);
      out_.operatorStop(blocking && blocking->number > 0.0);
    } else if (call.name == "set_analog_outputdomain" ||
               call.name == "set_standard_analog_output_domain") {
      const Value* domain = call.find("domain", 1);
      if (first && first->number == 0.0) {
        rangeStated_ = true;
        out_.state(plan::FactKind::FlowOutputRange, 0.0,
                   domain && domain->number == 1.0 ? k0To10V : "4 to 20 mA");
      }
    }
  }

  static std::optional<Eigen::Vector3d> centreOf(const Value* value) {
    if (!value || value->kind != ValueKind::List || value->count != 3)
      return std::nullopt;
    return 1000.0 * Eigen::Vector3d(value->list.data());
  }

  bool poseOf(const Value& value, Eigen::Isometry3d& pose) {
    if (value.kind != ValueKind::Pose || value.count != 6) {
      defect("a pose p[x,y,z,rx,ry,rz] is needed"_text);
      return false;
    }
    const Eigen::Vector3d metres(value.list[0], value.list[1], value.list[2]);
    const Eigen::Vector3d rotation(value.list[3], value.list[4], value.list[5]);
    if (metres.cwiseAbs().maxCoeff() > kMaxMetres ||
        rotation.cwiseAbs().maxCoeff() > kMaxJointRad) {
      defect("a pose far outside any robot's reach"_text);
      return false;
    }
    pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotationOf(rotation).toRotationMatrix();
    pose.translation() = metres * 1000.0;
    return true;
  }

  // Returns a named or positional number; `absent` if it is not given. Returns nullopt (and reports
  // a defect) if it is not a number in [0, limit].
  std::optional<double> numberOf(const Call& call, std::string_view key, std::size_t position,
                                 double limit, double absent) {
    const Value* value = call.find(key, position);
    if (!value)
      return absent;
    if (value->kind != ValueKind::Number || !(value->number >= 0.0) || value->number > limit) {
      defect(base::message("argument {key} is not a valid number"_text, key));
      return std::nullopt;
    }
    return value->number;
  }

  bool argumentsKnown(const Call& call) {
    bool seenNamed = false;
    for (std::size_t i = 0; i < call.count; ++i) {
      const std::string_view name = call.arguments[i].name;
      const bool known = name.empty() || name == "a" || name == "v" || name == "t" || name == "r" ||
                         (i == 0 && (name == "q" || name == "pose"));
      bool twice = name.empty() && seenNamed;
      for (std::size_t k = 0; k < i; ++k)
        twice = twice || (!name.empty() && call.arguments[k].name == name);
      seenNamed = seenNamed || (!name.empty() && i > 0);
      if (!known || twice) {
        defect(base::message("an argument of {name} is unknown or given twice"_text, call.name));
        return false;
      }
    }
    return true;
  }

  void motion(const Call& call) {
    requireStated();
    plan::ProgramMotion m;
    if (call.count == 0 || !argumentsKnown(call)) {
      if (call.count == 0)
        defect("a motion without a target"_text);
      return;
    }
    const bool process = call.name == "movep"; // movep(pose, a, v, r): no t
    m.jointInterpolated = call.name == "movej";
    const Value& target = call.arguments[0].value;
    if (target.kind == ValueKind::List) {
      if (target.count < 6) {
        defect("target with fewer than six joints"_text);
        return;
      }
      m.target = plan::TargetKind::Joints;
      for (std::size_t k = 0; k < target.count; ++k)
        if (std::abs(target.list[k]) > kMaxJointRad) {
          defect("a joint value far outside any limit"_text);
          return;
        }
      m.joints.assign(target.list.begin(),
                      target.list.begin() + static_cast<std::ptrdiff_t>(target.count));
    } else {
      m.target = plan::TargetKind::FlangePose;
      if (!poseOf(target, m.frame_T_tcp))
        return;
      if (!tcpSet_)
        defect("a pose before set_tcp: its TCP is unknown"_text);
      tcpSet_ = true; // Report only once
    }
    // The controller's defaults (URScript manual): a 1.2 m/s2 or 1.4 rad/s2, v 0.25 m/s or 1.05
    // rad/s, r 0.
    const auto a = numberOf(call, "a", 1, 1000.0, 1.2);
    const auto v = numberOf(call, "v", 2, kMaxSpeed, m.jointInterpolated ? 1.05 : 0.25);
    const auto t = numberOf(call, "t", process ? call.count : 3, 1e5, 0.0);
    const auto r = numberOf(call, "r", process ? 3 : 4, 10.0, 0.0);
    if (!a || !v || !t || !r)
      return;
    if (!(*a > 0.0) || (!(*v > 0.0) && !(*t > 0.0))) {
      defect("the motion never arrives: no speed or acceleration"_text);
      return;
    }
    m.durationS = *t;
    m.blendMm = *r * 1000.0;
    if (!(*t > 0.0)) { // t takes precedence over both
      (m.jointInterpolated ? m.jointSpeedRadPerS : m.speedMmPerS) =
          m.jointInterpolated ? *v : *v * 1000.0;
      (m.jointInterpolated ? m.jointAccelerationRadPerS2 : m.accelerationMmPerS2) =
          m.jointInterpolated ? *a : *a * 1000.0;
    }
    last_ = m.target == plan::TargetKind::FlangePose ? std::optional(m.frame_T_tcp) : std::nullopt;
    out_.motionByOutputs(std::move(m));
  }

  // movec(pose_via, pose_to, a, v, r, mode): mode 0 turns the tool evenly towards the target.
  void arc(const Call& call) {
    requireStated();
    plan::ProgramMotion m;
    m.target = plan::TargetKind::FlangePose;
    Eigen::Isometry3d via;
    if (call.count < 2) {
      defect("movec needs two poses"_text);
      return;
    }
    if (!poseOf(call.arguments[0].value, via) || !poseOf(call.arguments[1].value, m.frame_T_tcp))
      return;
    for (std::size_t i = 2; i < call.count; ++i)
      if (const std::string_view name = call.arguments[i].name;
          !name.empty() && name != "a" && name != "v" && name != "r" && name != "mode") {
        defect(base::message("an argument of {name} is unknown or given twice"_text, call.name));
        return;
      }
    const auto a = numberOf(call, "a", 2, 1000.0, 1.2);
    const auto v = numberOf(call, "v", 3, kMaxSpeed, 0.25);
    const auto r = numberOf(call, "r", 4, 10.0, 0.0);
    const auto mode = numberOf(call, "mode", 5, 1.0, 0.0);
    if (!a || !v || !r || !mode)
      return;
    if (!(*a > 0.0) || !(*v > 0.0)) {
      defect("the motion never arrives: no speed or acceleration"_text);
      return;
    }
    if (*mode != 0.0)
      defect("the tool does not turn evenly along its way"_text);
    if (!last_ || !tcpSet_) {
      defect("an arc from a position that is not known"_text);
      return;
    }
    if (auto wrong = setArc(last_->translation(), via.translation(), m)) {
      defect(std::move(*wrong));
      return;
    }
    m.blendMm = *r * 1000.0;
    m.speedMmPerS = *v * 1000.0;
    m.accelerationMmPerS2 = *a * 1000.0;
    last_ = m.frame_T_tcp;
    out_.motionByOutputs(std::move(m));
  }

  // Reads the two arguments of an output call. Returns false (and reports a defect) if they are not
  // of this kind.
  bool outputOf(const Call& call, ValueKind kind, int& channel, double& value) {
    const bool isCall = call.count == 2 && call.arguments[0].value.kind == ValueKind::Number &&
                        call.arguments[1].value.kind == kind;
    const std::optional<int> output =
        isCall ? wholeNumber(call.arguments[0].value.number, 0, 31) : std::nullopt;
    if (!output) {
      defect("an output needs a number and a value"_text);
      return false;
    }
    channel = *output;
    value = call.arguments[1].value.number;
    return true;
  }
  // firstOutput: the number of ProgramEmitter for output 0 of this kind.
  void digitalOut(const Call& call, int firstOutput) {
    int channel = 0;
    double value = 0.0;
    if (!outputOf(call, ValueKind::Boolean, channel, value))
      return;
    if (firstOutput > 0) {
      if (!out_.toolOutput(firstOutput + channel, value > 0.0))
        out_.wordAt(call.name, kOutsidePrint);
    } else if (channel == 0) {
      out_.setExtruder(value > 0.0);
    } else if (channel == kCutOutput) {
      out_.setCutter(value > 0.0);
    } else if (channel > kCutOutput || !out_.toolOutput(channel, value > 0.0)) {
      out_.wordAt(call.name, kOutsidePrint);
    }
  }
  void analogOut(const Call& call) {
    int channel = 0;
    double value = 0.0;
    if (!outputOf(call, ValueKind::Number, channel, value))
      return;
    if (channel != 0) {
      out_.wordAt(call.name, kOutsidePrint);
      return;
    }
    if (value < 0.0 || value > 1.0) {
      defect("an analogue output outside 0..1"_text);
      return;
    }
    if (value > 0.0) {
      out_.need(plan::FactKind::FlowOutputRange);
      if (isFurther_ && !std::exchange(rangeStated_, true))
        defect("this file sets the flow before it states the range of the output"_text);
    }
    out_.flow(value);
  }
  // Returns the name of a socket at that place; without one, a controller takes socket_0.
  static std::string_view socketOf(const Call& call, std::size_t position) {
    const Value* name = call.find("socket_name", position);
    return name && name->kind == ValueKind::Text ? name->text : "socket_0";
  }
  // socket_open(address, port, socket_name)
  void openSocket(const Call& call) {
    out_.word(urscriptWords(), call.name);
    const Value *address = call.find("address", 0), *port = call.find("port", 1);
    const auto number = port && port->kind == ValueKind::Number
                            ? wholeNumber(port->number, 1, 65535)
                            : std::nullopt;
    if (!address || address->kind != ValueKind::Text || !number)
      defect("a connection needs an address and a port"_text);
    else
      sockets_.open(socketOf(call, 2), joined({address->text, ":", std::to_string(*number)}));
  }
  void closeSocket(const Call& call) {
    out_.word(urscriptWords(), call.name);
    sockets_.close(socketOf(call, 0));
  }
  void sendText(const Call& call) {
    if (call.count == 0 || call.arguments[0].value.kind != ValueKind::Text)
      defect("a text to be sent is needed"_text);
    else if (const auto to = sockets_.destination(socketOf(call, 1)))
      out_.send(call.arguments[0].value.text, *to);
    else
      defect(notOpen(socketOf(call, 1)));
  }
  void setTcp(const Call& call) {
    Eigen::Isometry3d tcp;
    if (call.count != 1 || !poseOf(call.arguments[0].value, tcp)) {
      if (call.count != 1)
        defect("set_tcp needs a pose"_text);
      return;
    }
    Eigen::Isometry3d& known = out_.program().flange_T_tcp;
    if (everSet_ && !tcp.isApprox(known, 1e-9))
      defect("a second, different TCP"_text);
    known = tcp;
    tcpSet_ = everSet_ = true;
  }
  void sleep(const Call& call) {
    if (call.count != 1 || call.arguments[0].value.kind != ValueKind::Number ||
        !(call.arguments[0].value.number >= 0.0))
      defect("sleep needs a time in seconds"_text);
    else
      out_.pauseByOutputs(call.arguments[0].value.number);
  }

  const base::RunContext& ctx_;
  ProgramBuilder out_;
  UrscriptFunctions functions_{out_};
  UrscriptVariables variables_;
  OpenConnections sockets_;
  std::size_t programs_ = 0; // that began
  bool isFurther_ = false;   // another program ran before this one
  bool loadStated_ = false, rangeStated_ = false;
  std::vector<std::string> running_; // Functions, the innermost last
  bool tcpSet_ = false, everSet_ = false;
  std::optional<Eigen::Isometry3d> last_; // Target of the last motion if it was a pose
};

} // namespace

plan::ReadProgram readUrscript(const std::vector<plan::ProgramFile>& files,
                               const process::Tooling& tooling, const base::RunContext& ctx) {
  return UrscriptReader(tooling, ctx).read(files);
}

} // namespace voluta::program
