#include "base/units.h"
#include "program/common/program_text.h"
#include "program/melfa/melfa.h"
#include "program/melfa/melfa_text.h"
#include "program/melfa/melfa_values.h"
#include "program/program_builder.h"
#include "program/rapid/rapid_tokens.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voluta::program {

namespace {

constexpr std::size_t kMaxDepth = 8;
constexpr double kMaxJointDeg = 5000.0, kMaxMmPerS = 1e5, kMaxSeconds = 1e6;
constexpr int kWorkCoordinates = 8, kOutputsOfWord = 16;
constexpr double kMaxOutput = 1e6;

class MelfaReader {
public:
  MelfaReader(const std::vector<plan::ProgramFile>& files, const process::Tooling& tooling,
              const base::RunContext& ctx)
      : files_(files), ctx_(ctx), out_("melfa", tooling) {}

  plan::ReadProgram read() {
    for (out_.file = 0; out_.file < files_.size(); ++out_.file)
      texts_.push_back(melfaText(files_[out_.file].text, out_, ctx_));
    ran_.assign(files_.size(), false);
    bool complete = !files_.empty() && runFile(0);
    for (std::size_t f = 0; f < texts_.size(); ++f) {
      out_.file = f;
      out_.line = texts_[f].lastLine;
      if (!ran_[f])
        out_.defect("no program calls this file"_text);
      complete = complete && ran_[f];
    }
    complete = complete && !missing_;
    if (nozzle_)
      seeFromHeldWork(out_.program(), *nozzle_);
    return out_.take(complete);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }
  void notUnderstood(std::string_view code) {
    defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
  }

  // Reads the values of variables listed after the program; they are valid from its beginning.
  void takeValues(const MelfaText& text) {
    bool behind = false;
    for (const MelfaStep& step : text.steps) {
      out_.line = step.line;
      const std::string name = MelfaScanner(step.code, variables_).variableName();
      if (behind && !name.starts_with("m_") && !name.starts_with("p_"))
        assign(step.code);
      behind = behind || sameWord(step.code, "end");
    }
  }

  bool runFile(std::size_t file) {
    const MelfaText& text = texts_[file];
    const std::size_t fromFile = std::exchange(out_.file, file), fromLine = out_.line;
    ran_[file] = true;
    variables_.clear();
    out_.beginOutputs();
    continuous_ = false;
    mmPerS_ = 0.0;
    override_ = jointOverride_ = 100.0;
    toolSet_ = false;
    takeValues(text);
    const std::size_t motions = out_.program().motions.size();
    bool sound = runFrom(0, 0);
    stop();
    requireClosed();
    if (!sound) {
      out_.line = text.lastLine;
      defect("the program has no End"_text);
    }
    if (out_.program().motions.size() > motions && !out_.outputsEnded()) {
      defect("the extruder is not switched off after the last motion"_text);
      sound = false;
    }
    out_.file = fromFile;
    out_.line = fromLine;
    return sound;
  }

  // Runs to End, or to the Return of a subroutine (depth > 0). Returns false if neither is found.
  bool runFrom(std::size_t at, std::size_t depth) {
    const MelfaText& text = texts_[out_.file];
    for (; at < text.steps.size(); ++at) {
      out_.line = text.steps[at].line;
      if (at % 4096 == 0)
        ctx_.checkpoint();
      std::string_view rest = text.steps[at].code;
      while (!rest.empty()) {
        const std::string_view code = takeMelfaStatement(rest);
        if (sameWord(code, "end"))
          return true;
        if (depth > 0 && sameWord(code, "return"))
          return true;
        if (!code.empty())
          statement(code, depth);
      }
    }
    return false;
  }

  void statement(std::string_view code, std::size_t depth) {
    if (code.front() == '*')
      return;
    MelfaScanner scanner(code, variables_);
    const std::string word = inSmallLetters(scanner.name());
    if (word == "mov" || word == "mvs" || word == "emvs")
      motion(word, scanner, code);
    else if (word == "spd" || word == "ovrd" || word == "jovrd")
      speed(word, scanner);
    else if (word == "accel")
      acceleration(scanner);
    else if (word == "cnt")
      continuous(scanner);
    else if (word == "tool")
      tool(scanner);
    else if (word == "base")
      base(scanner);
    else if (word == "dly")
      delay(scanner);
    else if (word == "wait")
      awaitInput(scanner, code);
    else if (word == "gosub")
      subroutine(scanner, depth);
    else if (word == "callp")
      call(scanner, depth);
    else if (word == "def")
      definition(scanner);
    else if (assign(code))
      return;
    else if ((word == "open" && !opensScreen(scanner)) || !out_.word(melfaWords(), word))
      unknown(word, code);
    else if (word == "close")
      closeScreen(scanner);
    else if (word == "hlt") {
      requireClosed();
      out_.operatorStop();
    } else if (word == "print" && !show(scanner))
      notUnderstood(code);
  }
  // Other lines lead to machines, which may command. Open "COM1:" As #1
  bool opensScreen(MelfaScanner& scanner) {
    std::string_view line;
    requireClosed();
    return scanner.take('"') && scanner.textBehindQuote(line) && sameWord(line, "com1:") &&
           sameWord(scanner.name(), "as") && scanner.take('#') && scanner.number(screen_) &&
           screen_ == std::floor(screen_);
  }
  // Close #1
  void closeScreen(MelfaScanner& scanner) {
    double line = screen_;
    if (scanner.take('#') && !scanner.number(line))
      line = 0.0;
    if (screen_ == 0.0 || line != screen_ || !scanner.ended())
      defect("'Close' without its 'Open' before it"_text);
    screen_ = 0.0;
  }
  // A line that is open already cannot be opened again.
  void requireClosed() {
    if (std::exchange(screen_, 0.0) != 0.0)
      defect("'Close' is missing behind the text"_text);
  }
  // Print #1,"text"
  bool show(MelfaScanner& scanner) {
    double line = 0.0;
    std::string_view text;
    const bool isText = scanner.take('#') && scanner.number(line) && line == screen_ &&
                        scanner.take(',') && scanner.take('"') && scanner.textBehindQuote(text);
    if (isText)
      out_.show(text);
    return isText;
  }
  void unknown(std::string_view word, std::string_view code) {
    if (word.empty() || code.find('=') != std::string_view::npos)
      notUnderstood(code);
    else
      defect(base::message("'{name}' is not known to the reader"_text, word.substr(0, 40)));
  }

  // Wait M_In(n)=value
  void awaitInput(MelfaScanner& scanner, std::string_view code) {
    double input = 0.0, value = 0.0;
    const bool known = scanner.variableName() == "m_in" && scanner.take('(') &&
                       scanner.number(input) && scanner.take(')') && scanner.take('=') &&
                       scanner.number(value) && scanner.ended();
    if (!known)
      out_.wordAt("Wait", kOutsidePrint);
    else if (input != std::floor(input) || !(std::abs(input) < kMaxOutput) || !isDigital(value))
      notUnderstood(code);
    else if (!out_.awaitInput(melfaOutputOf(input), value > 0.0))
      out_.wordAt("Wait", kOutsidePrint);
  }

  // Defines variable names; their type is determined by their names.
  void definition(MelfaScanner& scanner) {
    const std::string kind = inSmallLetters(scanner.name());
    for (const char* known : {"pos", "jnt", "inte", "long", "float", "double", "char"})
      if (kind == known)
        return;
    defect(base::message("'{name}' is not known to the reader"_text, "Def " + kind.substr(0, 30)));
  }

  // Handles name = value, and assignments to outputs and work coordinates. Returns false if the
  // code is neither, or not understood.
  bool assign(std::string_view code) {
    MelfaScanner scanner(code, variables_);
    const std::string name = scanner.variableName();
    if (name.empty())
      return false;
    if (name.starts_with("m_out") || name == "p_wkcord")
      return indexed(name, scanner);
    if (name.starts_with("m_") || name.starts_with("p_") || name.starts_with("c_") ||
        name.starts_with("j_"))
      return false;
    std::string_view part;
    if (scanner.take('.'))
      part = scanner.name();
    ScriptValue value;
    if (!scanner.take('=') || !scanner.value(value) || !scanner.ended())
      return false;
    if (!part.empty()) {
      const auto known = variables_.find(name);
      return known != variables_.end() && value.kind == ScriptKind::Number &&
             setMelfaPart(known->second, part, value.number);
    }
    const bool list = name.front() == 'p' || name.front() == 'j';
    if (list != (value.kind == ScriptKind::List))
      return false;
    variables_.insert_or_assign(name, std::move(value));
    return true;
  }

  bool indexed(const std::string& name, MelfaScanner& scanner, bool isTriggered = false) {
    double index = 0.0;
    ScriptValue value;
    if (!scanner.take('(') || !scanner.number(index) || !scanner.take(')') || !scanner.take('=') ||
        !scanner.value(value) || !scanner.ended() || index != std::floor(index) ||
        !(index >= 0.0 && index < kMaxOutput))
      return false;
    if (name == "p_wkcord")
      return workCoordinates(index, value);
    if (value.kind != ScriptKind::Number)
      return false;
    output(name, index, value.number, isTriggered);
    return true;
  }
  bool workCoordinates(double index, const ScriptValue& value) {
    const auto pose = melfaPose(value);
    if (!pose || index < 1.0 || index > kWorkCoordinates)
      return false;
    work_[static_cast<std::size_t>(index) - 1] = *pose;
    workAt_[static_cast<std::size_t>(index) - 1] = {out_.file, out_.line};
    return true;
  }
  // isTriggered: at the start of the next motion.
  void output(std::string_view name, double first, double value, bool isTriggered) {
    const double count = name == "m_out"                         ? 1.0
                         : name == "m_outb" || name == "m_out8"  ? 8.0
                         : name == "m_outw" || name == "m_out16" ? 16.0
                                                                 : 32.0;
    const auto touches = [&](double from, double many) {
      return first < from + many && from < first + count;
    };
    const bool isExtruder = (name == "m_out" && first == kMelfaExtruder) ||
                            (count == kOutputsOfWord && first == kMelfaFlow);
    if (isExtruder && !isTriggered)
      out_.statePassingOutput();
    if (name == "m_out" && first == kMelfaExtruder) {
      if (!isDigital(value))
        defect("an output is 0 or 1"_text);
      else
        out_.setExtruder(value > 0.0);
    } else if (count == kOutputsOfWord && first == kMelfaFlow) {
      if (value < 0.0 || value > kMelfaFullFlow || value != std::floor(value))
        defect(base::message("the flow is not an integer from 0 to {most}"_text,
                             base::number(kMelfaFullFlow)));
      else
        out_.flow(value / kMelfaFullFlow);
    } else if (touches(kMelfaExtruder, 1) || touches(kMelfaFlow, kOutputsOfWord)) {
      defect("an output of the extruder is set together with other outputs"_text);
    } else if (name == "m_out" && !isDigital(value)) {
      defect("an output is 0 or 1"_text);
    } else if (name != "m_out" || !out_.toolOutput(melfaOutputOf(first), value > 0.0)) {
      out_.wordAt(name, kOutsidePrint);
    }
  }

  static bool isDigital(double value) { return value == 0.0 || value == 1.0; }

  std::optional<double> numberIn(MelfaScanner& scanner, double minimum, double maximum) {
    double value = 0.0;
    if (!scanner.number(value) || !(value >= minimum) || value > maximum)
      return std::nullopt;
    return value;
  }

  void speed(std::string_view word, MelfaScanner& scanner) {
    const bool isLinear = word == "spd";
    const auto value = numberIn(scanner, isLinear ? 1e-6 : 1.0, isLinear ? kMaxMmPerS : 100.0);
    if (!value || !scanner.ended()) {
      defect(base::message("'{name}' without a sensible value"_text, word));
      return;
    }
    (isLinear ? mmPerS_ : word == "ovrd" ? override_ : jointOverride_) = *value;
    if (word == "jovrd")
      out_.setJointSpeed("JOvrd");
  }

  void acceleration(MelfaScanner& scanner) {
    for (bool more = !scanner.ended(); more; more = scanner.take(','))
      if (const auto value = numberIn(scanner, 0.0, 1000.0); !value || *value != 100.0) {
        defect("accelerations other than the arm's own"_text);
        return;
      }
    if (!scanner.ended())
      defect("accelerations other than the arm's own"_text);
  }

  void stop() {
    if (continuous_ && !out_.program().motions.empty())
      out_.program().motions.back().blendMm = 0.0;
    continuous_ = false;
  }
  void continuous(MelfaScanner& scanner) {
    const auto on = numberIn(scanner, 0.0, 1.0);
    std::optional<double> start, end;
    if (scanner.take(','))
      start = numberIn(scanner, 0.0, kMaxMmPerS);
    if (scanner.take(','))
      end = numberIn(scanner, 0.0, kMaxMmPerS);
    if (!on || *on != std::floor(*on) || !scanner.ended()) {
      defect("'Cnt' is 0, or 1 with two distances"_text);
      return;
    }
    if (*on == 0.0)
      stop();
    continuous_ = *on == 1.0;
    blendMm_ = end ? end : start;
    if (continuous_ && !blendMm_)
      out_.state(plan::FactKind::OpenRounding);
  }

  // Reads a frame in the robot's base or on its flange.
  std::optional<Eigen::Isometry3d> poseIn(MelfaScanner& scanner) {
    ScriptValue value;
    if (!scanner.value(value))
      return std::nullopt;
    return melfaPose(value);
  }
  void tool(MelfaScanner& scanner) {
    const auto pose = poseIn(scanner);
    if (!pose || !scanner.ended()) {
      defect("a tool is a position"_text);
      return;
    }
    Eigen::Isometry3d& known = out_.program().flange_T_tcp;
    if (everSet_ && !pose->isApprox(known, 1e-9))
      defect("a second, different TCP"_text);
    known = *pose;
    toolSet_ = everSet_ = true;
  }
  void base(MelfaScanner& scanner) {
    const auto pose = poseIn(scanner);
    if (!pose || !scanner.ended() || !pose->isApprox(Eigen::Isometry3d::Identity(), 1e-9))
      defect("unsupported base: positions must be in the robot's own base"_text);
    else
      out_.state(plan::FactKind::TargetFrame);
  }

  void delay(MelfaScanner& scanner) {
    const auto seconds = numberIn(scanner, 0.0, kMaxSeconds);
    if (!seconds || !scanner.ended())
      defect("'Dly' without a time in seconds"_text);
    else
      out_.pauseByOutputs(*seconds);
  }

  void subroutine(MelfaScanner& scanner, std::size_t depth) {
    const std::string label = scanner.take('*') ? inSmallLetters(scanner.name()) : "";
    const auto at = texts_[out_.file].labels.find(label);
    if (at == texts_[out_.file].labels.end() || !scanner.ended() || depth >= kMaxDepth) {
      defect(base::message("invalid call of '{name}'"_text, label));
      return;
    }
    const std::size_t line = out_.line;
    const bool back = runFrom(at->second + 1, depth + 1);
    out_.line = line;
    if (!back)
      defect(base::message("invalid call of '{name}'"_text, label));
  }

  void call(MelfaScanner& scanner, std::size_t depth) {
    ScriptValue name;
    if (!scanner.value(name) || name.kind != ScriptKind::Text || !scanner.ended() || depth > 0 ||
        out_.file != 0) {
      defect("unsupported call of another program"_text);
      return;
    }
    const std::string file = inSmallLetters(name.text) + ".prg";
    for (std::size_t f = 1; f < files_.size(); ++f)
      if (inSmallLetters(files_[f].name).ends_with(file)) {
        const ScriptVariables own = std::exchange(variables_, {});
        runFile(f);
        variables_ = own;
        return;
      }
    defect(base::message("the called program {name} is missing"_text, name.text.substr(0, 60)));
    missing_ = true;
  }

  // word target [, separation] [Type 0,0] [Wth outputs]
  void motion(std::string_view word, MelfaScanner& scanner, std::string_view code) {
    requireClosed();
    plan::ProgramMotion m;
    m.jointInterpolated = word == "mov";
    std::size_t coordinates = 0;
    if (word == "emvs") {
      const auto n = numberIn(scanner, 1.0, kWorkCoordinates);
      if (!n || *n != std::floor(*n) || !scanner.take(',')) {
        defect("'EMvs' without work coordinates 1 to 8"_text);
        return;
      }
      coordinates = static_cast<std::size_t>(*n);
    }
    scanner.blanks();
    const bool joints = !scanner.rest.empty() && (scanner.rest.front() | 0x20) == 'j';
    ScriptValue target;
    if (!scanner.value(target)) {
      notUnderstood(code);
      return;
    }
    if (!(joints ? jointTarget(target, m) : poseTarget(target, scanner, m)) ||
        !straightKind(word, coordinates, joints) || !behindTarget(scanner, code))
      return;
    applySpeed(m);
    if (!joints)
      statePosture(target);
    out_.motionByOutputs(std::move(m));
  }
  // States the posture of the next motion.
  void statePosture(const ScriptValue& target) {
    constexpr double kBits = 4294967296.0; // 2^32
    const auto bits = [](double flag) {
      return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::fmod(flag, kBits)) &
                                        0xffffffff);
    };
    plan::ArmPosture posture = kMelfaUsualPosture;
    if (!target.flags.empty())
      posture.structure = bits(target.flags[0]);
    if (target.flags.size() > 1)
      posture.turns = bits(target.flags[1]);
    out_.program().postures.push_back({out_.program().motions.size(), posture});
  }

  bool jointTarget(const ScriptValue& target, plan::ProgramMotion& m) {
    constexpr std::size_t kAxes = 6;
    if (target.kind != ScriptKind::List || target.list.size() < kAxes) {
      defect("target with fewer than six joints"_text);
      return false;
    }
    m.target = plan::TargetKind::Joints;
    for (std::size_t k = 0; k < kAxes; ++k) {
      if (!(std::abs(target.list[k]) <= kMaxJointDeg)) {
        defect("a joint value far outside any limit"_text);
        return false;
      }
      m.joints.push_back(base::degreesToRadians(target.list[k]));
    }
    return true;
  }
  bool poseTarget(const ScriptValue& target, MelfaScanner& scanner, plan::ProgramMotion& m) {
    const auto pose = melfaPose(target);
    double away = 0.0;
    if (!pose || (scanner.take(',') && !scanner.number(away)) || !(std::abs(away) <= kMaxMmPerS)) {
      defect("the target is not a position within a robot's reach"_text);
      return false;
    }
    m.target = plan::TargetKind::FlangePose;
    m.frame_T_tcp = *pose;
    m.frame_T_tcp.translate(Eigen::Vector3d(0.0, 0.0, away));
    if (!toolSet_)
      defect("a position before Tool: its TCP is unknown"_text);
    toolSet_ = true; // Report only once
    return true;
  }

  // Checks that all straight motions are of the same kind: with a stationary nozzle, or a moving
  // one.
  bool straightKind(std::string_view word, std::size_t coordinates, bool joints) {
    if (word == "mov")
      return true;
    if (joints) {
      defect("a straight motion to joints"_text);
      return false;
    }
    if (held_ && *held_ != (coordinates > 0)) {
      defect("'Mvs' and 'EMvs' in one program: only one of them can move the nozzle"_text);
      return false;
    }
    held_ = coordinates > 0;
    if (coordinates == 0)
      return true;
    const auto& nozzle = work_[coordinates - 1];
    if (!nozzle || (nozzle_ && !nozzle->isApprox(*nozzle_, 1e-9))) {
      if (nozzle)
        defect("the work coordinates change: only one nozzle is supported"_text);
      else
        defect("work coordinates that P_WkCord does not set"_text);
      return false;
    }
    if (!nozzle_)
      out_.program().nozzleAt = workAt_[coordinates - 1];
    nozzle_ = nozzle;
    return true;
  }

  bool behindTarget(MelfaScanner& scanner, std::string_view code) {
    while (!scanner.ended()) {
      const std::string word = inSmallLetters(scanner.name());
      if (word == "type") {
        const auto type = numberIn(scanner, 0.0, 0.0);
        if (!type || (scanner.take(',') && !numberIn(scanner, 0.0, 0.0))) {
          defect("'Type' other than 0,0: the long way around, or independent rotation "
                 "of the angles"_text);
          return false;
        }
      } else if (word == "wth") {
        MelfaScanner output(scanner.rest, variables_);
        const std::string name = output.variableName();
        if (name.starts_with("m_out") && indexed(name, output, true))
          return true;
        defect("'Wth' without an output"_text);
        return false;
      } else {
        notUnderstood(code);
        return false;
      }
    }
    return true;
  }

  void applySpeed(plan::ProgramMotion& m) {
    if (m.jointInterpolated) {
      m.jointSpeedRadPerS = 1e-4 * override_ * jointOverride_ * kMelfaJointRadPerS;
      return;
    }
    if (!(mmPerS_ > 0.0))
      defect("a straight motion before any Spd"_text);
    m.speedMmPerS = 0.01 * override_ * (mmPerS_ > 0.0 ? mmPerS_ : kMelfaFastestMmPerS);
    if (continuous_)
      m.blendMm = blendMm_.value_or(0.5 * m.speedMmPerS * m.speedMmPerS / kMelfaMmPerS2);
  }

  const std::vector<plan::ProgramFile>& files_;
  const base::RunContext& ctx_;
  ProgramBuilder out_;
  std::vector<MelfaText> texts_; // Per file of files_
  std::vector<bool> ran_;
  ScriptVariables variables_;
  std::optional<Eigen::Isometry3d> work_[kWorkCoordinates]; // base_T_work coordinates
  plan::ProgramPlace workAt_[kWorkCoordinates];
  std::optional<Eigen::Isometry3d> nozzle_; // Nozzle of the straight motions
  std::optional<bool> held_;                // Straight motions are EMvs
  double mmPerS_ = 0.0, override_ = 100.0, jointOverride_ = 100.0;
  bool continuous_ = false;
  std::optional<double> blendMm_; // nullopt: over the stopping distance
  bool toolSet_ = false, everSet_ = false;
  bool missing_ = false; // A called program is missing
  double screen_ = 0.0;  // number of the line to the pendant; 0: none is open
};

} // namespace

plan::ReadProgram readMelfa(const std::vector<plan::ProgramFile>& files,
                            const process::Tooling& tooling, const base::RunContext& ctx) {
  return MelfaReader(files, tooling, ctx).read();
}

} // namespace voluta::program
