#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/program_text.h"
#include "program/common/script_values.h"
#include "program/common/tcp_motions.h"
#include "program/program_builder.h"
#include "program/rapid/rapid_tokens.h"
#include "program/stream/pvt_velocities.h"
#include "program/tmscript/tmscript.h"
#include "program/tmscript/tmscript_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voluta::program {

namespace {

constexpr std::size_t kNumbers = 6;
constexpr int kMaxChannel = 255;
constexpr double kMaxMm = 1e5, kMaxDeg = 1e5, kMaxMmPerS = 1e4, kMaxSeconds = 1e6;
// Tolerated deviation of a cubic from its line, and from even motion along it, beyond that of
// starting and stopping.
constexpr double kMaxAcrossMm = 0.05, kMaxAlongShare = 0.25;

enum class Block { None, Joints, Poses };

std::string_view withoutRemark(std::string_view code) {
  return trimmed(code.substr(0, findUnquoted(code, "//")));
}

class TmscriptReader {
public:
  TmscriptReader(const process::Tooling& tooling, const base::RunContext& ctx)
      : ctx_(ctx), out_("tmscript", tooling) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    out_.expectMotionsOf(files);
    bool complete = !files.empty();
    for (out_.file = 0; out_.file < files.size(); ++out_.file)
      complete = readFile(files[out_.file].text) && complete;
    return out_.take(complete);
  }

private:
  struct Arguments {
    std::string text;            // First argument, if it is text
    std::vector<double> numbers; // All others, with lists flattened
  };

  void defect(base::Message reason) { out_.defect(std::move(reason)); }
  void notUnderstood(std::string_view code) {
    defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
  }

  bool readFile(std::string_view text) {
    variables_.clear();
    out_.beginOutputs();
    block_ = Block::None;
    last_.reset();
    passed_.reset();
    left_ = false;
    tcpSet_ = false;
    base_T_frame_ = Eigen::Isometry3d::Identity();
    out_.line = 1;
    std::string_view rest = text;
    while (!rest.empty()) {
      if (out_.line % 4096 == 0)
        ctx_.checkpoint();
      const std::size_t blanks = rest.find_first_not_of(" \t");
      if (blanks != std::string_view::npos && rest[blanks] == '$')
        takeFrame(rest);
      else
        statement(withoutRemark(trimmed(rest.substr(0, rest.find('\n')))));
      behindLine(rest);
    }
    for (const TmFrameGap& gap : std::exchange(numbers_, {}).gaps())
      out_.defectAt(gap.line, base::message("frame {id} follows frame {before}: frames are missing "
                                            "or in another order"_text,
                                            gap.id, gap.before));
    out_.line = std::max<std::size_t>(out_.line, 2) - 1;
    if (text.find('\n') != std::string_view::npos && text.find('\r') == std::string_view::npos)
      defect("lines end with LF only: a listen node needs CR LF"_text);
    if (!left_)
      defect("ScriptExit() is missing at the end"_text);
    if (!out_.outputsEnded())
      defect("the extruder is not switched off after the last motion"_text);
    return left_ && out_.outputsEnded();
  }

  void behindLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++out_.line;
  }

  // Leaves `rest` in the frame's last line.
  void takeFrame(std::string_view& rest) {
    rest.remove_prefix(rest.find('$'));
    const TmFrame frame = takeTmFrame(rest);
    numbers_.add(frame.id, out_.line);
    if (!frame.sound)
      defect(frame.reason);
    std::string_view script = frame.script;
    while (!script.empty()) {
      const std::size_t end = script.find('\n');
      statement(withoutRemark(trimmed(script.substr(0, end))));
      if (end == std::string_view::npos)
        break;
      script.remove_prefix(end + 1);
      ++out_.line;
    }
    left_ = left_ && frame.sound; // A listen node accepts no other frames
    rest.remove_prefix(frame.length);
    if (!trimmed(rest.substr(0, rest.find('\n'))).empty())
      defect("text after a frame"_text);
  }

  void statement(std::string_view code) {
    if (code.empty())
      return;
    if (left_)
      defect("text after the end"_text);
    ScriptScanner scanner(code, variables_, '{');
    const std::string word(scanner.name());
    if (block_ != Block::None && needsRest(word))
      defect(base::message("'{name}' between PVTEnter and PVTExit"_text, word));
    if (word == "IO") {
      output(scanner, code);
      return;
    }
    if (word == "while") {
      awaitInput(scanner, code);
      return;
    }
    if (assign(code))
      return;
    std::vector<ScriptValue> values;
    Arguments arguments;
    const bool isCall =
        !word.empty() && scanner.take('(') && scanner.arguments(values) && scanner.ended();
    if (isCall && word == "ListenSend" && show(values))
      return;
    if (!isCall || !flatten(values, arguments)) {
      notUnderstood(code);
      return;
    }
    if (word == "PVTEnter")
      enter(arguments);
    else if (word == "PVTPoint")
      point(arguments);
    else if (word == "PVTExit")
      exit();
    else if (word == "PTP")
      jointMotion(arguments);
    else if (word == "Line" || word == "PLine")
      straightMotion(arguments);
    else if (word == "ChangeTCP")
      changeTcp(arguments);
    else if (word == "ChangeBase")
      changeBase(arguments);
    else if (word == "ChangeLoad")
      changeLoad(arguments.numbers);
    else if (word == "ScriptExit")
      leave();
    else if (!out_.word(tmscriptWords(), word))
      defect(base::message("'{name}' is not known to the reader"_text, word.substr(0, 40)));
    else if (word == "Pause")
      pause();
    else if (word == "WaitQueueTag" ||
             (word == "QueueTag" && !arguments.numbers.empty() && arguments.numbers.back() == 1.0))
      isQueueDone_ = true;
  }

  // while(IO["ControlBox"].DI[n]==value){Sleep(ms)}: waits while the input has the other value
  void awaitInput(ScriptScanner& scanner, std::string_view code) {
    std::string_view module;
    double channel = 0.0, value = 0.0, ms = 0.0;
    const bool known = scanner.take('(') && scanner.name() == "IO" && scanner.take('[') &&
                       scanner.take('"') && scanner.textBehindQuote(module) &&
                       module == "ControlBox" && scanner.take(']') && scanner.take('.') &&
                       scanner.name() == "DI" && scanner.take('[') && scanner.number(channel) &&
                       scanner.take(']') && scanner.take('=') && scanner.take('=') &&
                       scanner.number(value) && scanner.take(')') && scanner.take('{') &&
                       scanner.name() == "Sleep" && scanner.take('(') && scanner.number(ms) &&
                       scanner.take(')') && scanner.take('}') && scanner.ended();
    const std::optional<int> input = wholeNumber(channel, 0, kMaxChannel);
    if (!known || !input || (value != 0.0 && value != 1.0) ||
        !out_.awaitInput(*input, value == 0.0))
      notUnderstood(code);
    else if (!isQueueDone_ && !out_.program().motions.empty())
      defect("an input is read while motions are queued"_text);
  }

  // ListenSend(number, text); returns whether it is that.
  bool show(const std::vector<ScriptValue>& values) {
    constexpr double kSender = 90.0; // others reach nobody who shows them
    if (values.size() != 2 || values[0].kind != ScriptKind::Number ||
        values[1].kind != ScriptKind::Text || values[0].number != kSender)
      return false;
    out_.word(tmscriptWords(), "ListenSend");
    out_.show(values[1].text);
    isShown_ = true;
    return true;
  }

  // A text is shown for a stop, which comes before the next motion.
  void requireStop() {
    if (std::exchange(isShown_, false))
      defect("a text is shown without a stop"_text);
  }

  // Unlike motions and outputs, a pause is not queued.
  void pause() {
    if (!isQueueDone_ && !out_.program().motions.empty())
      earlyPause_ = out_.line;
    if (!std::exchange(isShown_, false))
      defect("a stop shows no text"_text);
    out_.operatorStop();
  }

  void leave() {
    if (block_ != Block::None)
      defect("'PVTExit' is missing before the end"_text);
    left_ = true;
  }

  static bool flatten(const std::vector<ScriptValue>& values, Arguments& into) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const ScriptValue& v = values[i];
      if (v.kind == ScriptKind::Text && i > 0)
        return false;
      if (v.kind == ScriptKind::Text)
        into.text = v.text;
      else if (v.kind == ScriptKind::List)
        into.numbers.insert(into.numbers.end(), v.list.begin(), v.list.end());
      else
        into.numbers.push_back(v.number);
    }
    return true;
  }

  // [type [[]]] name = value
  bool assign(std::string_view code) {
    ScriptScanner scanner(code, variables_, '{');
    std::string_view name = scanner.name();
    for (const char* type : {"var", "int", "float", "double", "bool", "string", "byte"})
      if (name == type) {
        if (scanner.take('[') && !scanner.take(']'))
          return false;
        name = scanner.name();
        break;
      }
    ScriptValue value;
    if (name.empty() || !scanner.take('=') || !scanner.value(value) || !scanner.ended())
      return false;
    variables_.insert_or_assign(inSmallLetters(name), std::move(value));
    return true;
  }

  // ["module"].kind[n] = value
  void output(ScriptScanner& scanner, std::string_view code) {
    std::string_view module;
    double channel = 0.0, value = 0.0;
    if (!scanner.take('[') || !scanner.take('"') || !scanner.textBehindQuote(module) ||
        !scanner.take(']') || !scanner.take('.')) {
      notUnderstood(code);
      return;
    }
    const std::string kind(scanner.name());
    if (!scanner.take('[') || !scanner.number(channel) || !scanner.take(']') ||
        !scanner.take('=') || !scanner.number(value) || !scanner.ended()) {
      notUnderstood(code);
      return;
    }
    const bool digital = kind == "DO" || kind == "InstantDO";
    const std::optional<int> number = wholeNumber(channel, 0, kMaxChannel);
    if ((!digital && kind != "AO" && kind != "InstantAO") || !number) {
      notUnderstood(code);
      return;
    }
    const bool isTool = module == "ControlBox" && kind == "DO" && (value == 0.0 || value == 1.0) &&
                        out_.toolOutput(*number, value > 0.0);
    if (isTool)
      return;
    if (digital && value != 0.0 && value != 1.0)
      defect("an output is 0 or 1"_text);
    else if (module != "ControlBox" || channel != 0.0)
      out_.wordAt(kind, kOutsidePrint);
    else if (kind.starts_with("Instant") && !out_.program().motions.empty())
      defect("an immediate output, not synchronized with the motions"_text);
    else if (digital)
      setExtruder(value > 0.0);
    else if (value < 0.0 || value > kTmFullVolts)
      defect("an analogue output outside 0 to 10 V"_text);
    else
      out_.flow(value / kTmFullVolts);
  }

  void setExtruder(bool on) {
    out_.setExtruder(on);
    if (!on)
      passed_.reset();
  }

  static std::optional<Eigen::Isometry3d> poseOf(const PvtVector& numbers) {
    if (!(numbers.head<3>().cwiseAbs().maxCoeff() <= kMaxMm) ||
        !(numbers.tail<3>().cwiseAbs().maxCoeff() <= kMaxDeg))
      return std::nullopt;
    Eigen::Isometry3d pose(rotationOfXyz(numbers.tail<3>() * base::degreesToRadians(1.0)));
    pose.pretranslate(Eigen::Vector3d(numbers.head<3>()));
    return pose;
  }
  std::optional<Eigen::Isometry3d> poseIn(const std::vector<double>& numbers) {
    if (numbers.size() < kNumbers)
      return std::nullopt;
    return poseOf(PvtVector(numbers.data()));
  }

  void changeTcp(const Arguments& a) {
    const auto pose = poseIn(a.numbers);
    if (!pose || !a.text.empty()) {
      defect("a tool known only to the robot: give its numbers"_text);
      return;
    }
    Eigen::Isometry3d& known = out_.program().flange_T_tcp;
    if (everSet_ && !pose->isApprox(known, 1e-9))
      defect("a second, different TCP"_text);
    if (everSet_ && block_ != Block::None)
      defect("'ChangeTCP' between PVTEnter and PVTExit"_text);
    known = *pose;
    tcpSet_ = everSet_ = true;
    if (a.numbers.size() > kNumbers)
      changeLoad({a.numbers[kNumbers]});
  }
  void changeLoad(const std::vector<double>& numbers) {
    if (numbers.size() != 1 || !(numbers[0] >= 0.0))
      defect("load without a mass"_text);
    else
      out_.load("ChangeTCP", numbers[0]);
  }
  void changeBase(const Arguments& a) {
    const auto pose = a.text == "RobotBase" && a.numbers.empty()
                          ? std::optional(Eigen::Isometry3d::Identity())
                          : poseIn(a.numbers);
    if (!pose || (!a.text.empty() && a.text != "RobotBase")) {
      defect("a base known only to the robot: give its numbers"_text);
      return;
    }
    out_.state(plan::FactKind::TargetFrame);
    base_T_frame_ = *pose;
    last_.reset();
    passed_.reset();
  }

  void enter(const Arguments& a) {
    requireStop();
    if (a.numbers.size() != 1 || (a.numbers[0] != 0.0 && a.numbers[0] != 1.0)) {
      defect("'PVTEnter' needs 0 (joints) or 1 (poses)"_text);
      return;
    }
    if (block_ != Block::None)
      defect("'PVTEnter' without PVTExit before it"_text);
    block_ = a.numbers[0] == 0.0 ? Block::Joints : Block::Poses;
    velocity_ = PvtVector::Zero();
    first_ = true;
  }
  void exit() {
    if (block_ == Block::None)
      defect("'PVTExit' without PVTEnter before it"_text);
    else if (velocity_.norm() > 0.0)
      defect("the velocity at the last PVT point is not 0"_text);
    block_ = Block::None;
  }

  void point(const Arguments& a) {
    if (block_ == Block::None) {
      defect("'PVTPoint' without PVTEnter before it"_text);
      return;
    }
    if (a.numbers.size() != 2 * kNumbers + 1 || !a.text.empty()) {
      defect("'PVTPoint' needs six positions, six velocities and a time in seconds"_text);
      return;
    }
    const PvtVector numbers(a.numbers.data()), velocity(a.numbers.data() + kNumbers);
    const double seconds = a.numbers.back();
    if (!(seconds > 0.0) || seconds > kMaxSeconds || !(velocity.cwiseAbs().maxCoeff() < kMaxDeg)) {
      defect("'PVTPoint' with an invalid time or velocity"_text);
      return;
    }
    const bool stands = std::exchange(first_, false) && last_ && last_->joints == joints() &&
                        last_->numbers == numbers && velocity.norm() == 0.0;
    if (stands) {
      out_.pauseByOutputs(seconds);
      isQueueDone_ = false;
      passed_.reset();
      return;
    }
    std::optional<PvtMotion> motion;
    if (last_ && last_->joints == joints())
      motion = PvtMotion{.displacement = numbers - last_->numbers, .seconds = seconds};
    if (motion)
      checkVelocities(*motion, velocity);
    velocity_ = velocity;
    plan::ProgramMotion m;
    m.durationS = seconds;
    moveTo(numbers, joints(), std::move(m));
    passPoint(motion, velocity);
  }

  // The flow is constant along a motion: within a bead the arm must pass each point at the velocity
  // that suits the motions to and from it. In travels it must not go back.
  void passPoint(const std::optional<PvtMotion>& motion, const PvtVector& velocity) {
    const bool known = motion && block_ == Block::Poses && !out_.program().motions.empty();
    const bool prints = known && out_.program().motions.back().extruding;
    if (known && passed_ && passed_->prints == prints)
      checkVelocity(*passed_, *motion);
    passed_ = known ? std::optional(Passed{*motion, velocity, out_.line, prints}) : std::nullopt;
  }
  struct Passed {
    PvtMotion to;
    PvtVector velocity;
    std::size_t line;
    bool prints;
  };
  void checkVelocity(const Passed& point, const PvtMotion& from) {
    const PvtFit fit = pvtFit(point.velocity, point.to, from, kBlendToleranceMm);
    if (point.prints && !fit.isSpeedSuitable)
      out_.defectAt(point.line,
                    base::message("the arm passes this point at {stated:.1f} mm/s with unchanged "
                                  "flow; the path requires {suits:.1f} mm/s"_text,
                                  base::number(fit.statedMmPerS), base::number(fit.suitsMmPerS)));
    else if (fit.reverses || (point.prints && !fit.isDirectionSuitable))
      out_.defectAt(point.line, "the velocity at this point leads off the path"_text);
  }
  bool joints() const { return block_ == Block::Joints; }

  void checkVelocities(const PvtMotion& motion, const PvtVector& to) {
    bool fits = true;
    if (block_ == Block::Poses) {
      const PvtDeviation off = pvtDeviation(motion, velocity_, to);
      fits = off.acrossMm <= kMaxAcrossMm && off.alongShare <= kMaxAlongShare;
    }
    for (int k = joints() ? 0 : 3; k < 6; ++k)
      fits = fits && pvtTurnsEvenly(motion, k, velocity_[k], to[k]);
    if (!fits)
      defect("the velocities lead off the path to this point"_text);
    if (block_ == Block::Poses && motion.displacement.tail<3>().cwiseAbs().maxCoeff() > 180.0)
      defect("an angle rotates the long way around"_text);
  }

  void moveTo(const PvtVector& numbers, bool joints, plan::ProgramMotion m) {
    if (joints) {
      if (!(numbers.cwiseAbs().maxCoeff() <= kMaxDeg)) {
        defect("a joint value far outside any limit"_text);
        return;
      }
      m.target = plan::TargetKind::Joints;
      for (std::size_t k = 0; k < kNumbers; ++k)
        m.joints.push_back(base::degreesToRadians(numbers[static_cast<Eigen::Index>(k)]));
    } else {
      const auto pose = poseOf(numbers);
      if (!pose) {
        defect("a pose far outside any robot's reach"_text);
        return;
      }
      m.target = plan::TargetKind::FlangePose;
      m.frame_T_tcp = base_T_frame_ * *pose;
      if (!tcpSet_)
        defect("a pose before ChangeTCP: its TCP is unknown"_text);
      tcpSet_ = true; // Report only once
    }
    last_ = Last{joints, numbers};
    isQueueDone_ = false;
    if (earlyPause_)
      out_.defectAt(*std::exchange(earlyPause_, std::nullopt),
                    "'Pause' does not wait for the motions before it (QueueTag)"_text);
    out_.motionByOutputs(std::move(m));
  }

  // Target, speed, acceleration time [ms], blend, precise positioning off. Returns nullopt (and
  // reports a defect) if the arguments are not a motion.
  struct Motion {
    PvtVector numbers;
    bool joints, speedInMm, blendInMm;
    double speed, rampMs, blend;
  };
  std::optional<Motion> motionOf(const Arguments& a) {
    passed_.reset();
    if (block_ != Block::None) {
      defect("another motion between PVTEnter and PVTExit"_text);
      return std::nullopt;
    }
    const bool known = a.text.size() == 3 && (a.text[0] == 'J' || a.text[0] == 'C') &&
                       (a.text[1] == 'P' || a.text[1] == 'A') &&
                       (a.text[2] == 'P' || a.text[2] == 'R');
    // Poses may include the arm's configuration, three more numbers.
    const std::size_t behind = a.numbers.size() - kNumbers;
    if (!known || a.numbers.size() < kNumbers + 3 || (behind != 3 && behind != 4)) {
      defect("the numbers of the motion do not match its letters"_text);
      return std::nullopt;
    }
    Motion m{PvtVector(a.numbers.data()),
             a.text[0] == 'J',
             a.text[1] == 'A',
             a.text[2] == 'R',
             a.numbers[kNumbers],
             a.numbers[kNumbers + 1],
             a.numbers[kNumbers + 2]};
    const auto whole = [](double value, double limit) {
      return value >= 0.0 && value <= limit && value == std::floor(value);
    };
    if (!whole(m.speed, m.speedInMm ? kMaxMmPerS : 100.0) || !(m.speed > 0.0) ||
        !whole(m.rampMs, kMaxSeconds) || !whole(m.blend, m.blendInMm ? kMaxMm : 100.0)) {
      defect("speed, acceleration time and blend must be integers"_text);
      return std::nullopt;
    }
    return m;
  }

  void jointMotion(const Arguments& a) {
    requireStop();
    const auto found = motionOf(a);
    if (!found)
      return;
    if (found->speedInMm) {
      defect("'PTP' in millimetres per second"_text);
      return;
    }
    plan::ProgramMotion m;
    m.jointInterpolated = true;
    if (found->speed >= kTmMinPercent || out_.program().motions.empty())
      m.jointSpeedRadPerS = 0.01 * found->speed * kTmJointRadPerS;
    moveTo(found->numbers, found->joints, std::move(m));
  }

  void straightMotion(const Arguments& a) {
    requireStop();
    const auto found = motionOf(a);
    if (!found)
      return;
    if (!found->speedInMm || (found->joints && found->blendInMm)) {
      defect("a straight motion in percent of an unknown speed"_text);
      return;
    }
    plan::ProgramMotion m;
    m.speedMmPerS = found->speed;
    if (found->rampMs > 0.0)
      m.accelerationMmPerS2 = 1000.0 * found->speed / found->rampMs;
    // A percentage refers to half of the distance.
    if (found->blendInMm)
      m.blendMm = found->blend;
    else if (last_ && !last_->joints && !found->joints)
      m.blendMm = 0.005 * found->blend * (found->numbers - last_->numbers).head<3>().norm();
    moveTo(found->numbers, found->joints, std::move(m));
  }

  // Target of the last motion.
  struct Last {
    bool joints;
    PvtVector numbers;
  };

  const base::RunContext& ctx_;
  ProgramBuilder out_;
  ScriptVariables variables_;
  Eigen::Isometry3d base_T_frame_ = Eigen::Isometry3d::Identity();
  std::optional<Last> last_;
  Block block_ = Block::None;
  PvtVector velocity_ = PvtVector::Zero(); // At the last PVT point
  std::optional<Passed> passed_;           // The last point
  TmFrameNumbers numbers_;                 // of the file
  bool first_ = false;                     // The next point is the first of the block
  bool left_ = false, tcpSet_ = false, everSet_ = false;
  bool isQueueDone_ = false;              // the arm has reached its last target
  bool isShown_ = false;                  // a text, for the next stop
  std::optional<std::size_t> earlyPause_; // line of a pause before it has
};

} // namespace

plan::ReadProgram readTmscript(const std::vector<plan::ProgramFile>& files,
                               const process::Tooling& tooling, const base::RunContext& ctx) {
  return TmscriptReader(tooling, ctx).read(files);
}

bool looksLikeTmscript(std::string_view text) {
  const std::string_view head = text.substr(0, 16384);
  return head.find("$TMSCT,") != std::string_view::npos ||
         head.find("PTP(\"") != std::string_view::npos ||
         head.find("PVTPoint(") != std::string_view::npos;
}

} // namespace voluta::program
