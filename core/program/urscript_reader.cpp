#include "base/error.h"
#include "program/program_builder.h"
#include "program/rotation_vector.h"
#include "program/text.h"
#include "program/urscript.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace voluta::program {

namespace {
enum class ValueKind { None, Number, List, Pose, Boolean, Text };

struct Value {
  ValueKind kind = ValueKind::None;
  double number = 0.0; // Number; Boolean as 0 or 1
  std::array<double, 8> list{};
  std::size_t count = 0; // of list
};

struct Argument {
  std::string_view name; // empty: positional
  Value value;
};

struct Call {
  std::string_view name;
  std::array<Argument, 8> arguments;
  std::size_t count = 0;

  // The argument called `key`, or the positional one at `position`; nullptr when it isn't given.
  const Value* find(std::string_view key, std::size_t position) const {
    for (std::size_t i = 0; i < count; ++i)
      if (arguments[i].name == key || (arguments[i].name.empty() && i == position))
        return &arguments[i].value;
    return nullptr;
  }
};

bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isNamePart(char c) {
  return isNameStart(c) || (c >= '0' && c <= '9');
}

// Reads one statement from left to right; every function moves `rest` behind what it took.
struct Scanner {
  std::string_view rest;

  void blanks() {
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t'))
      rest.remove_prefix(1);
  }
  bool take(char c) {
    blanks();
    if (rest.empty() || rest.front() != c)
      return false;
    rest.remove_prefix(1);
    return true;
  }
  std::string_view name() {
    blanks();
    std::size_t n = 0;
    if (!rest.empty() && isNameStart(rest.front()))
      while (n < rest.size() && isNamePart(rest[n]))
        ++n;
    const std::string_view found = rest.substr(0, n);
    rest.remove_prefix(n);
    return found;
  }
  bool list(Value& value) { // behind '['
    if (take(']'))
      return true;
    do {
      blanks();
      if (value.count == value.list.size() || !takeNumber(rest, value.list[value.count]))
        return false;
      ++value.count;
    } while (take(','));
    return take(']');
  }
  bool quoted() { // behind '"'
    const std::size_t end = rest.find('"');
    if (end == std::string_view::npos)
      return false;
    rest.remove_prefix(end + 1);
    return true;
  }
  bool value(Value& value) {
    blanks();
    if (rest.size() >= 2 && rest[0] == 'p' && rest[1] == '[') {
      rest.remove_prefix(2);
      value.kind = ValueKind::Pose;
      return list(value);
    }
    if (take('[')) {
      value.kind = ValueKind::List;
      return list(value);
    }
    if (take('"')) {
      value.kind = ValueKind::Text;
      return quoted();
    }
    if (!rest.empty() && isNameStart(rest.front())) {
      const std::string_view word = name();
      value.kind = ValueKind::Boolean;
      value.number = word == "True" || word == "true" ? 1.0 : 0.0;
      return value.number > 0.0 || word == "False" || word == "false";
    }
    value.kind = ValueKind::Number;
    return takeNumber(rest, value.number);
  }
  bool argument(Argument& argument) {
    const std::string_view before = rest;
    const std::string_view key = name();
    if (!key.empty() && take('=')) {
      argument.name = key;
    } else {
      rest = before;
    }
    return value(argument.value);
  }
  // name(arguments) and nothing behind it.
  bool call(Call& call) {
    call.name = name();
    if (call.name.empty() || !take('('))
      return false;
    if (!take(')')) {
      do {
        if (call.count == call.arguments.size() || !argument(call.arguments[call.count]))
          return false;
        ++call.count;
      } while (take(','));
      if (!take(')'))
        return false;
    }
    blanks();
    return rest.empty();
  }
};

// The line without its comment; '#' inside a string is none.
std::string_view withoutComment(std::string_view line) {
  bool inString = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"')
      inString = !inString;
    else if (line[i] == '#' && !inString)
      return line.substr(0, i);
  }
  return line;
}

constexpr double kMaxJointRad = 100.0, kMaxMetres = 100.0, kMaxSpeed = 100.0;

class UrscriptReader {
public:
  UrscriptReader(const process::Process& process, const base::RunContext& ctx)
      : ctx_(ctx), out_("urscript", process) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    bool complete = !files.empty();
    for (out_.file = 0; out_.file < files.size(); ++out_.file)
      complete = readFile(files[out_.file].text) && complete;
    return out_.take(complete);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }

  bool readFile(std::string_view text) {
    defined_ = {};
    inside_ = called_ = closed_ = mustCall_ = false;
    tcpSet_ = false;
    out_.beginOutputs();
    LineReader lines(text);
    std::string_view line;
    while (lines.next(line)) {
      out_.line = lines.number();
      if (out_.line % 4096 == 0)
        ctx_.checkpoint();
      const std::string_view code = trimmed(withoutComment(line));
      mustCall_ = mustCall_ || trimmed(line).starts_with(kCalledNote);
      if (!code.empty())
        statement(code);
    }
    if (inside_)
      defect(base::message("the function '{defined}' has no end"_text, defined_));
    else if (defined_.empty())
      defect("no function is defined"_text);
    else if (!called_ && mustCall_)
      defect("the function is never called"_text);
    if (!out_.outputsEnded())
      defect("the extruder is not set off behind the last motion"_text);
    return closed_ && (called_ || !mustCall_) && out_.outputsEnded();
  }

  void statement(std::string_view code) {
    Scanner scanner{code};
    const std::string_view word = scanner.name();
    if (word == "def" || word == "sec") {
      define(scanner);
      return;
    }
    if (word == "end") {
      scanner.blanks();
      if (!inside_ || !scanner.rest.empty())
        defect("'end' closes no function"_text);
      closed_ = inside_;
      inside_ = false;
      return;
    }
    Call call;
    if (!Scanner{code}.call(call)) {
      defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
      return;
    }
    if (!inside_) {
      if (closed_ && call.name == defined_ && call.count == 0 && !called_)
        called_ = true;
      else
        defect(
            base::message("'{name}' is called outside the function"_text, call.name.substr(0, 40)));
      return;
    }
    inFunction(call);
  }

  void define(Scanner& scanner) {
    const std::string_view name = scanner.name();
    const bool header =
        !name.empty() && scanner.take('(') && scanner.take(')') && scanner.take(':');
    scanner.blanks();
    if (!header || !scanner.rest.empty())
      defect("not the head of a function"_text);
    else if (inside_ || !defined_.empty())
      defect("a second function; only one is read"_text);
    if (header && !inside_ && defined_.empty()) {
      defined_ = name;
      inside_ = true;
      closed_ = false;
    }
  }

  void inFunction(const Call& call) {
    const std::string_view name = call.name;
    if (name == "movel" || name == "movej" || name == "movep")
      motion(call);
    else if (name == "set_standard_digital_out" || name == "set_digital_out")
      digitalOut(call);
    else if (name == "set_standard_analog_out" || name == "set_analog_out")
      analogOut(call);
    else if (name == "set_tcp")
      setTcp(call);
    else if (name == "sleep")
      sleep(call);
    else if (!out_.word(urscriptWords(), name))
      defect(base::message("'{name}' is not known to the reader"_text, name.substr(0, 40)));
    else
      settings(call);
  }

  // Of words that the table knows, what their values mean.
  void settings(const Call& call) {
    const Value* first = call.count > 0 ? &call.arguments[0].value : nullptr;
    if (call.name == "set_payload" || call.name == "set_payload_mass" ||
        call.name == "set_target_payload") {
      if (!first || first->kind != ValueKind::Number || !(first->number >= 0.0))
        defect(base::message("'{name}' needs a mass"_text, call.name));
      else
        out_.load(call.name, first->number);
    } else if (call.name == "set_gravity") {
      constexpr double kG = 9.82, kSlack = 0.1;
      if (!first || first->kind != ValueKind::List || first->count != 3 ||
          (Eigen::Vector3d(first->list.data()) - Eigen::Vector3d(0, 0, kG)).norm() > kSlack)
        defect("gravity other than that of an arm that stands upright"_text);
    }
  }

  bool poseOf(const Value& value, Eigen::Isometry3d& pose) {
    if (value.kind != ValueKind::Pose || value.count != 6) {
      defect("a pose p[x,y,z,rx,ry,rz] is needed"_text);
      return false;
    }
    const Eigen::Vector3d metres(value.list[0], value.list[1], value.list[2]);
    const Eigen::Vector3d turn(value.list[3], value.list[4], value.list[5]);
    if (metres.cwiseAbs().maxCoeff() > kMaxMetres || turn.cwiseAbs().maxCoeff() > kMaxJointRad) {
      defect("a pose far outside any robot's reach"_text);
      return false;
    }
    pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotationOf(turn).toRotationMatrix();
    pose.translation() = metres * 1000.0;
    return true;
  }

  // A named or positional number; `absent` when it isn't given. nullopt (and a defect): no number
  // in [0, limit].
  std::optional<double> numberOf(const Call& call, std::string_view key, std::size_t position,
                                 double limit, double absent) {
    const Value* value = call.find(key, position);
    if (!value)
      return absent;
    if (value->kind != ValueKind::Number || !(value->number >= 0.0) || value->number > limit) {
      defect(base::message("argument {key} is no sensible number"_text, key));
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
        defect("a target of fewer than six joints"_text);
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
        defect("a pose before set_tcp: whose pose is it?"_text);
      tcpSet_ = true; // said once
    }
    // The controller's defaults (URScript manual): a 1.2 m/s2 or 1.4 rad/s2, v 0.25 m/s or
    // 1.05 rad/s, r 0.
    const auto a = numberOf(call, "a", 1, 1000.0, 1.2);
    const auto v = numberOf(call, "v", 2, kMaxSpeed, m.jointInterpolated ? 1.05 : 0.25);
    const auto t = numberOf(call, "t", process ? call.count : 3, 1e5, 0.0);
    const auto r = numberOf(call, "r", process ? 3 : 4, 10.0, 0.0);
    if (!a || !v || !t || !r)
      return;
    if (!(*a > 0.0) || (!(*v > 0.0) && !(*t > 0.0))) {
      defect("a motion that never gets anywhere: no speed or acceleration"_text);
      return;
    }
    m.durationS = *t;
    m.blendMm = *r * 1000.0;
    if (!(*t > 0.0)) { // which rules over both
      (m.jointInterpolated ? m.jointSpeedRadPerS : m.speedMmPerS) =
          m.jointInterpolated ? *v : *v * 1000.0;
      (m.jointInterpolated ? m.jointAccelerationRadPerS2 : m.accelerationMmPerS2) =
          m.jointInterpolated ? *a : *a * 1000.0;
    }
    out_.motionByOutputs(std::move(m));
  }

  // The two arguments of an output call; false (and a defect) when they are none of this kind.
  bool outputOf(const Call& call, ValueKind kind, int& channel, double& value) {
    if (call.count != 2 || call.arguments[0].value.kind != ValueKind::Number ||
        call.arguments[1].value.kind != kind || call.arguments[0].value.number < 0.0 ||
        call.arguments[0].value.number > 31.0) {
      defect("an output needs its number and a value"_text);
      return false;
    }
    channel = static_cast<int>(call.arguments[0].value.number);
    value = call.arguments[1].value.number;
    return true;
  }
  void digitalOut(const Call& call) {
    int channel = 0;
    double value = 0.0;
    if (!outputOf(call, ValueKind::Boolean, channel, value))
      return;
    if (channel == 0)
      out_.turn(value > 0.0);
    else
      out_.wordAt(call.name, kAside);
  }
  void analogOut(const Call& call) {
    int channel = 0;
    double value = 0.0;
    if (!outputOf(call, ValueKind::Number, channel, value))
      return;
    if (channel != 0) {
      out_.wordAt(call.name, kAside);
      return;
    }
    if (value < 0.0 || value > 1.0) {
      defect("an analogue output outside 0..1"_text);
      return;
    }
    out_.flow(value);
  }
  void setTcp(const Call& call) {
    Eigen::Isometry3d tcp;
    if (call.count != 1 || !poseOf(call.arguments[0].value, tcp)) {
      if (call.count != 1)
        defect("set_tcp needs one pose"_text);
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
      defect("sleep needs its seconds"_text);
    else
      out_.pauseByOutputs(call.arguments[0].value.number);
  }

  const base::RunContext& ctx_;
  ProgramBuilder out_;
  std::string_view defined_;
  bool inside_ = false, closed_ = false, called_ = false;
  bool mustCall_ = false; // the text says that it calls its function
  bool tcpSet_ = false, everSet_ = false;
};

} // namespace

plan::ReadProgram readUrscript(const std::vector<plan::ProgramFile>& files,
                               const process::Process& process, const base::RunContext& ctx) {
  return UrscriptReader(process, ctx).read(files);
}

bool looksLikeUrscript(std::string_view text) {
  const std::string_view head = text.substr(0, 16384);
  return (head.starts_with("def ") || head.find("\ndef ") != std::string_view::npos) &&
         (head.find("movel(") != std::string_view::npos ||
          head.find("movej(") != std::string_view::npos ||
          head.find("movep(") != std::string_view::npos);
}

bool mayBeMissingInUrscript(const std::vector<std::string>& lines, std::size_t i) {
  return lines[i].find("set_payload") != std::string::npos ||
         lines[i].find("set_analog_outputdomain") != std::string::npos ||
         lines[i].find("sleep(") != std::string::npos ||
         lines[i].find("popup(") != std::string::npos || primes(lines, i);
}

} // namespace voluta::program
