#include "base/units.h"
#include "program/common/arc_motion.h"
#include "program/common/procedures.h"
#include "program/common/program_text.h"
#include "program/krl/krl.h"
#include "program/krl/krl_externals.h"
#include "program/krl/krl_speeds.h"
#include "program/krl/krl_text.h"
#include "program/krl/krl_values.h"
#include "program/program_builder.h"
#include "program/rapid/rapid_tokens.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kExtruder = "$out[1]", kFlow = "$anout[1]";
constexpr double kMaxDegrees = 6000.0, kMaxSeconds = 1e5;

std::string rootOf(std::string_view path) {
  return std::string(path.substr(0, path.find_first_of(".[")));
}

constexpr Procedures::Words kStructure = {kKrlSyntax, krlPart};

// Types whose names may begin a declaration without DECL.
bool isType(LineCursor line) {
  constexpr std::array kTypes = {"int",   "real", "bool",   "char", "pos",
                                 "e6pos", "axis", "e6axis", "frame"};
  std::string word, name;
  return line.takeName(word) && std::find(kTypes.begin(), kTypes.end(), word) != kTypes.end() &&
         line.takeName(name);
}

class KrlReader {
public:
  KrlReader(const process::Tooling& tooling, const base::RunContext& ctx)
      : out_("krl", tooling), procedures_(kStructure, out_, ctx) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    out_.expectMotionsOf(files);
    out_.beginOutputs();
    const auto wholly = [&](auto parse) {
      return [this, parse](std::string_view code) { whole(code, parse); };
    };
    bool complete =
        procedures_.find(files, wholly([this](LineCursor& line) { return outside(line); }));
    reportOtherNames(files, out_);
    if (openData_) {
      out_.file = dataFile_;
      out_.defect("ENDDAT is missing: the file was cut short"_text);
    }
    const Procedures::Statement run = wholly([this](LineCursor& line) { return statement(line); });
    complete = procedures_.run(run) && complete && !openData_;
    const bool off = externals_.extruder() || out_.outputsEnded();
    if (!off)
      out_.defect("the extruder is not switched off after the last motion"_text);
    return out_.take(complete && !missing_ && off);
  }

private:
  bool fail(base::Message reason) {
    reason_ = std::move(reason);
    return false;
  }
  template <typename Parse> void whole(std::string_view code, Parse parse) {
    LineCursor line(code, kKrlSyntax);
    reason_ = {};
    if (parse(line) && (reason_.empty() && line.ended()))
      return;
    if (reason_.empty())
      reason_ = base::message("not understood: '{code}'"_text, code.substr(0, 60));
    out_.defect(std::move(reason_));
  }
  static bool takeRest(LineCursor& line) {
    line = LineCursor({}, kKrlSyntax);
    return true;
  }

  // ---- outside of procedures: headers, data lists

  bool outside(LineCursor& line) {
    std::string name;
    if (line.takeMark('&')) {
      const bool header = line.takeName(name) && (name == "access" || name == "rel" ||
                                                  name == "comment" || name == "param");
      return header && takeRest(line);
    }
    if (line.takeWord("defdat")) {
      openData_ = true;
      dataFile_ = out_.file;
      return line.takeName(name) && (line.takeWord("public"), true);
    }
    if (line.takeWord("enddat"))
      return std::exchange(openData_, false);
    if (line.isWord("decl") || isType(line))
      return declaration(line);
    if (line.isWord("ext") || line.isWord("extfct"))
      return takeRest(line);
    if (openData_ && takeKrlPath(line, name) && line.takeMark('='))
      return assignment(name, line);
    return fail("a statement outside the procedure"_text);
  }

  // ---- statements

  bool statement(LineCursor& line) {
    if (line.isWord("decl") || isType(line))
      return declaration(line);
    line.takeWord("global");
    std::string word;
    if (!takeKrlPath(line, word))
      return false;
    if (line.takeMark('='))
      return assignment(word, line);
    if (word == "continue") {
      out_.wordAt("CONTINUE", kOutsidePrint);
      return aheadOfArm_ = true;
    }
    if (word == "ptp" || word == "lin" || word == "sptp" || word == "slin" || word == "circ")
      return motion(word, line);
    if (word == "trigger")
      return trigger(line);
    if (word == "wait")
      return wait(line);
    if (word == "signal")
      return signal(line);
    if (word == "bas")
      return basis(line);
    if (procedures_.contains(word)) {
      if (!line.takeMark('(') || !line.takeMark(')') || !line.ended())
        return false;
      return word == inSmallLetters(kKrlZero) ? zeroExtruder() : procedures_.call(word);
    }
    if (line.isMark('(') && LineCursor(line.rest().substr(1), kKrlSyntax).isMark(')'))
      return missing_ = true,
             fail(base::message("the module with {procedure} is missing"_text, word.substr(0, 40)));
    if (word == "pulse")
      return pulse(line);
    if (word == "halt" && zeroing_)
      return line.ended();
    if (!out_.word(krlWords(), word))
      return fail(base::message("'{word}' is not known to the reader"_text, word.substr(0, 40)));
    if (word == "halt") {
      out_.operatorStop();
      return line.ended();
    }
    if (std::string_view text; word == "msgnotify" && line.takeMark('(') && line.takeText(text))
      out_.show(text);
    return takeRest(line);
  }

  // PULSE($OUT[n],TRUE,seconds)
  bool pulse(LineCursor& line) {
    std::string path;
    if (!line.takeMark('(') || !takeKrlPath(line, path))
      return false;
    if (path != inSmallLetters(kKrlCutOutput))
      return out_.wordAt("PULSE", kOutsidePrint), takeRest(line);
    double seconds = 0.0;
    if (!line.takeMark(',') || !line.takeWord("true") || !line.takeMark(',') ||
        !variables_.takeNumber(line, seconds) || !line.takeMark(')'))
      return false;
    out_.cutFor(seconds);
    return true;
  }

  bool zeroExtruder() {
    zeroing_ = true;
    const bool known = procedures_.call(inSmallLetters(kKrlZero));
    zeroing_ = false;
    stopAdvance();
    out_.zeroAxis();
    externals_.zeroExtruder();
    return known;
  }

  // DECL TYPE name [= value] {, name [= value]}
  bool declaration(LineCursor& line) {
    line.takeWord("decl");
    line.takeWord("global");
    line.takeWord("const");
    std::string type, path;
    if (!line.takeName(type))
      return false;
    do {
      if (!takeKrlPath(line, path) || path.front() == '$')
        return false;
      declared_.insert(rootOf(path));
      KrlValue value;
      if (line.takeMark('=')) {
        if (!variables_.takeValue(line, value))
          return false;
        variables_.set(path, value);
      }
    } while (line.takeMark(','));
    return true;
  }

  // SIGNAL name $OUT[n]
  bool signal(LineCursor& line) {
    std::string name, path;
    if (!line.takeName(name) || !takeKrlPath(line, path))
      return false;
    signals_[name] = path;
    if (!line.takeWord("to"))
      return true;
    out_.wordAt(name, kOutsidePrint);
    return takeRest(line);
  }

  bool assignment(std::string path, LineCursor& line) {
    if (const auto named = signals_.find(path); named != signals_.end())
      path = named->second;
    const std::string root = rootOf(path);
    if (root == "$base" && line.isWord("ek"))
      return externalBase(line);
    KrlValue value;
    const std::string_view said = line.rest();
    if (!variables_.takeValue(line, value)) {
      // Data of inline forms, which only the forms' own procedures read.
      if (root != "pdat_act" && root != "ldat_act")
        return fail(base::message("not understood: '{code}'"_text, said.substr(0, 60)));
      return out_.wordAt(root, kAnywhere), takeRest(line);
    }
    if (root == "$out" || root == "$anout")
      return line.ended() && output(path, value);
    if (root == "$ov_pro" && value.numbers[""] != 100.0)
      return fail(
          base::message("'{word}' slows the arm: the flow would not follow"_text, "$OV_PRO"_name));
    if (root == "$ipo_mode" && value.words[""] != "base" && value.words[""] != "tcp")
      return fail("$IPO_MODE must be #BASE or #TCP"_text);
    if (root == "$circ_type" && value.words[""] != "base")
      return fail("the tool does not turn evenly along its way"_text);
    if (root == "$ori_type" && value.words[""] != "var")
      return fail("the tool does not turn evenly along its way"_text);
    if (root == "$vel_axis")
      out_.wordAt(path, kSetUp);
    if (root == "$vel_extax") {
      variables_.set(path, value);
      if (externals_.extruder())
        return true; // the reader tracks it
    }
    if (!declared_.contains(root) && !isState(root) && !out_.word(krlWords(), root))
      return fail(base::message("'{word}' is not known to the reader"_text, root.substr(0, 40)));
    if (root == "$advance")
      out_.wordAt("$ADVANCE", kSetUp);
    if (root == "$base" || root == "$tool" || root == "$ipo_mode")
      frameSet(root);
    if (root == "$load" && value.numbers.contains("m")) {
      if (!(value.numbers["m"] >= 0.0 && value.numbers["m"] < 1e5))
        return fail("a mass is no sensible number"_text);
      const auto x = krlNumber(value, "cm.x"), y = krlNumber(value, "cm.y"),
                 z = krlNumber(value, "cm.z");
      out_.load("$LOAD", value.numbers["m"],
                x && y && z ? std::optional(Eigen::Vector3d(*x, *y, *z)) : std::nullopt);
    }
    variables_.set(path, value);
    return true;
  }
  // Variables the reader tracks wherever they change.
  static bool isState(const std::string& root) {
    constexpr std::array kState = {"$base", "$tool",     "$ipo_mode", "$load",     "$vel",   "$acc",
                                   "$apo",  "$vel_axis", "$advance",  "$ori_type", "$ov_pro"};
    return std::find(kState.begin(), kState.end(), root) != kState.end();
  }
  void frameSet(const std::string& root) {
    framesChanged_ = true;
    if (root == "$base")
      turnsWithAxis_ = false;
  }

  // EK(MACHINE_DEF[n].ROOT, MACHINE_DEF[n].MECH_TYPE, frame)
  bool externalBase(LineCursor& line) {
    std::string path;
    KrlValue frame;
    line.takeWord("ek");
    if (!line.takeMark('('))
      return false;
    for (int part = 0; part < 2; ++part) { // ROOT, MECH_TYPE
      if (!takeKrlPath(line, path) || !line.takeMark(','))
        return false;
      out_.state(plan::FactKind::MechanicalUnit, 0.0, path.substr(0, path.find('.')));
    }
    if (!variables_.takeValue(line, frame) || !line.takeMark(')'))
      return false;
    frameSet("$base");
    variables_.set("$base", frame);
    turnsWithAxis_ = true;
    return true;
  }

  bool output(const std::string& path, const KrlValue& value) {
    const auto number = value.numbers.find("");
    if (number == value.numbers.end())
      return false;
    if (std::exchange(aheadOfArm_, false) && moved_)
      return fail("an output after CONTINUE runs ahead of the arm"_text);
    if (path == kExtruder || path == kFlow)
      out_.statePassingOutput();
    stopAdvance();
    return setOutput(path, number->second);
  }
  // A statement outside the advance run makes the arm stop at its last target.
  void stopAdvance() {
    if (moved_)
      out_.program().motions.back().blendMm = 0.0;
  }
  bool setOutput(const std::string& path, double value) {
    if (rootOf(path) == "$out" && value != 0.0 && value != 1.0)
      return fail("a digital output must be 0 or 1"_text);
    if (path == kExtruder) {
      out_.setExtruder(value == 1.0);
    } else if (path == kFlow) {
      if (!(value >= 0.0 && value <= 1.0))
        return fail("an analogue output outside 0..1"_text);
      out_.flow(value);
    } else if (const int tool = krlToolOf(path); tool < 1 || !out_.toolOutput(tool, value == 1.0)) {
      out_.wordAt(path, kOutsidePrint);
    }
    return true;
  }

  // TRIGGER WHEN DISTANCE=0 DELAY=0 DO output=value: takes effect at the start of the next motion.
  bool trigger(LineCursor& line) {
    double distance = 0.0, delay = 0.0;
    std::string path;
    KrlValue value;
    if (!line.takeWord("when") || !line.takeWord("distance") || !line.takeMark('=') ||
        !variables_.takeNumber(line, distance) || !line.takeWord("delay") || !line.takeMark('=') ||
        !variables_.takeNumber(line, delay) || !line.takeWord("do") || !takeKrlPath(line, path) ||
        !line.takeMark('=') || !variables_.takeValue(line, value) || !value.numbers.contains(""))
      return false;
    if (distance != 0.0 || delay != 0.0)
      return fail("only triggers at the start of a motion are supported"_text);
    if (const auto named = signals_.find(path); named != signals_.end())
      path = named->second;
    if (rootOf(path) != "$out" && rootOf(path) != "$anout")
      return false;
    triggers_.emplace_back(path, value.numbers[""]);
    return true;
  }

  bool wait(LineCursor& line) {
    stopAdvance();
    double seconds = 0.0;
    if (line.takeWord("for")) {
      int input = 0;
      bool on = false;
      std::string path;
      if (LineCursor ahead = line;
          ahead.takeName(path) && ahead.isMark('[') && !takeKrlPath(ahead = line, path))
        return false; // a fraction as number
      if (LineCursor ahead = line; takeKrlInput(ahead, input, on) && out_.awaitInput(input, on))
        return takeRest(line);
      return out_.wordAt("wait for", kOutsidePrint), takeRest(line);
    }
    if (!line.takeWord("sec") || !variables_.takeNumber(line, seconds) || !line.ended())
      return false;
    if (!(seconds >= 0.0 && seconds <= kMaxSeconds))
      return fail("WAIT SEC needs a number of seconds"_text);
    out_.pauseByOutputs(seconds);
    return true;
  }

  // BAS (#WORD, number): the effect of the standard procedure on every controller.
  bool basis(LineCursor& line) {
    std::string word;
    double number = 0.0;
    if (!line.takeMark('(') || !line.takeMark('#') || !line.takeName(word))
      return false;
    const bool given = line.takeMark(',');
    if ((given && !variables_.takeNumber(line, number)) || !line.takeMark(')'))
      return false;
    if (word == "vel_ptp" && number > 0.0 && number <= 100.0) {
      out_.setJointSpeed("BAS #VEL_PTP");
      for (int axis = 1; axis <= 6; ++axis)
        for (const char* of : {"$vel_axis[", "$vel_extax["})
          variables_.set(of + std::to_string(axis) + "]", number);
    } else if (word == "vel_cp" && given) {
      variables_.set("$vel.cp", number);
    } else if ((word == "tool" || word == "base") && number == std::floor(number)) {
      const std::string list = word + "_data[" + std::to_string(static_cast<int>(number)) + "]";
      const KrlValue frame = variables_.below(number == 0.0 ? "$nullframe" : list);
      if (frame.numbers.empty())
        return fail(base::message("'{word}' is a frame that only the controller knows"_text, list));
      variables_.set("$" + word, frame);
      frameSet("$" + word);
    } else if (word == "initmov") {
      out_.wordAt("BAS #INITMOV", kSetUp);
    } else if (word == "acc_cp" || word == "acc_ptp" || word == "ptp_params" || word == "ptp_dat" ||
               word == "frames") {
      out_.wordAt("BAS #" + word, kSetUp);
    } else {
      return fail(
          base::message("'{word}' is not known to the reader"_text, "BAS #" + word.substr(0, 30)));
    }
    return true;
  }

  // ---- motions
  bool motion(const std::string& word, LineCursor& line) {
    KrlValue target;
    via_.reset();
    if (word == "circ" && (!variables_.takeValue(line, via_.emplace()) || !line.takeMark(',')))
      return false;
    if (!variables_.takeValue(line, target))
      return false;
    plan::ProgramMotion m;
    m.jointInterpolated = word == "ptp" || word == "sptp";
    bool rounds = false, known = true;
    for (std::string more; known && line.takeName(more);) {
      if (more == "with")
        return motionWith(word, target, rounds, line);
      known = more == "c_dis";
      rounds = known;
      if (!known)
        return fail(base::message("how '{word}' rounds a corner is not known to the reader"_text,
                                  more.substr(0, 40)));
    }
    return line.ended() && finish(std::move(m), target, rounds);
  }

  // WITH $VEL.CP=0.1, $APO={CDIS 1}: for this motion only.
  bool motionWith(const std::string& word, const KrlValue& target, bool rounds, LineCursor& line) {
    const KrlVariables kept = variables_;
    std::string path;
    do {
      KrlValue value;
      if (!takeKrlPath(line, path) || !line.takeMark('=') || !variables_.takeValue(line, value))
        return variables_ = kept, false;
      if (const std::string root = rootOf(path); root != "$vel" && root != "$acc" && root != "$apo")
        return variables_ = kept,
               fail(base::message("'{word}' is not known to the reader"_text, path.substr(0, 40)));
      variables_.set(path, value);
    } while (line.takeMark(','));
    rounds = line.takeWord("c_dis") || rounds;
    plan::ProgramMotion m;
    m.jointInterpolated = word == "sptp";
    const bool moved = line.ended() && finish(std::move(m), target, rounds);
    variables_ = kept;
    return moved;
  }

  bool finish(plan::ProgramMotion m, const KrlValue& target, bool rounds) {
    aheadOfArm_ = false;
    if (const auto mm = externals_.extruderAlone(target))
      return m.jointInterpolated && !rounds && feed(*mm);
    if (!targetOf(m, target))
      return false;
    if (via_ && !arcOf(m, *via_))
      return false;
    auto wrong = krlSpeed(variables_, lastKind_ == m.target ? last_ : std::nullopt, m);
    if (!wrong && rounds)
      wrong = krlBlend(variables_, m);
    if (wrong)
      return fail(std::move(*wrong));
    last_ = m.target == plan::TargetKind::Joints ? std::nullopt : std::optional(m.frame_T_tcp);
    lastKind_ = m.target;
    for (const auto& [path, value] : std::exchange(triggers_, {}))
      if (!setOutput(path, value))
        return false;
    const bool byAxis = externals_.extruder().has_value();
    if (byAxis && externals_.extruderIsSlowed())
      return fail("the extruder's axis is slowed: the arm would wait for it"_text);
    moved_ = true;
    if (byAxis)
      out_.motionByAxis(std::move(m), externals_.extruderMm());
    else
      out_.motionByOutputs(std::move(m));
    return true;
  }

  // A motion of the extruder's axis alone.
  bool feed(double mm) {
    const auto seconds = externals_.feed(mm);
    if (!seconds)
      return fail("an invalid speed"_text);
    stopAdvance();
    out_.pauseByAxis(*seconds, mm);
    return true;
  }

  bool targetOf(plan::ProgramMotion& m, const KrlValue& target) {
    const bool axes = krlNumber(target, kKrlAxes[0]).has_value();
    if (!framesOf(m))
      return false;
    if (auto wrong = externals_.take(target, turnsWithAxis_, m))
      return fail(std::move(*wrong));
    if (!axes)
      return poseOf(m, target);
    m.target = plan::TargetKind::Joints;
    if (!m.jointInterpolated)
      return fail("axes cannot be the target of a straight motion"_text);
    for (const std::string_view name : kKrlAxes) {
      const auto degrees = krlNumber(target, name);
      if (!degrees)
        return fail("not all axes are given"_text);
      if (!(std::abs(*degrees) <= kMaxDegrees))
        return fail("a joint value far outside any limit"_text);
      m.joints.push_back(base::degreesToRadians(*degrees));
    }
    m.joints.insert(m.joints.end(), m.externals.begin(), m.externals.end());
    return true;
  }

  bool arcOf(plan::ProgramMotion& m, const KrlValue& via) {
    const bool place = krlNumber(via, "x") && krlNumber(via, "y") && krlNumber(via, "z");
    const auto pose = krlFrame(via);
    if (!place)
      return fail("a coordinate is missing, and the arm's position is not known"_text);
    if (!pose || m.target == plan::TargetKind::Joints)
      return fail("a position far outside any robot's reach"_text);
    if (!last_ || lastKind_ != m.target)
      return fail("an arc from a position that is not known"_text);
    auto wrong = setArc(last_->translation(), (frame_T_base_ * *pose).translation(), m);
    return !wrong || fail(std::move(*wrong));
  }

  // Takes the current $TOOL and $BASE, which determine the motion's kind of target.
  bool framesOf(plan::ProgramMotion& m) {
    const auto base = krlFrame(variables_.below("$base"));
    const auto tool = krlFrame(variables_.below("$tool"));
    if (!base || !tool)
      return fail(base::message("{frame} is not set before this motion"_text,
                                base ? "$TOOL"_name : "$BASE"_name));
    const std::string_view mode = variables_.word("$ipo_mode");
    const bool held = mode == "tcp";
    if (held && turnsWithAxis_)
      return fail("a work object moved by both robot and external axis is not supported"_text);
    if (!out_.tool(*tool, held ? base : std::nullopt))
      return fail("a second, different tool"_text);
    m.target = held             ? plan::TargetKind::WorkPose
               : turnsWithAxis_ ? plan::TargetKind::UnitPose
                                : plan::TargetKind::FlangePose;
    frame_T_base_ = held ? Eigen::Isometry3d::Identity() : *base;
    return true;
  }

  // Missing coordinates keep their last values.
  bool poseOf(plan::ProgramMotion& m, const KrlValue& target) {
    const bool whole = std::all_of(kKrlPose.begin(), kKrlPose.end(),
                                   [&](std::string_view name) { return krlNumber(target, name); });
    KrlValue full = target;
    if (!whole) {
      if (!last_ || framesChanged_ || lastKind_ != m.target)
        return fail("a coordinate is missing, and the arm's position is not known"_text);
      for (std::size_t k = 0; k < kKrlPose.size(); ++k)
        full.numbers.try_emplace(std::string(kKrlPose[k]), lastParts_[k]);
    }
    const auto pose = krlFrame(full);
    if (!pose)
      return fail("a position far outside any robot's reach"_text);
    for (std::size_t k = 0; k < kKrlPose.size(); ++k)
      lastParts_[k] = *krlNumber(full, kKrlPose[k]);
    framesChanged_ = false;
    m.frame_T_tcp = frame_T_base_ * *pose;
    return true;
  }

  ProgramBuilder out_;
  bool missing_ = false; // a called file is missing
  Procedures procedures_;
  KrlVariables variables_;
  base::Message reason_;
  std::set<std::string, std::less<>> declared_;
  std::map<std::string, std::string, std::less<>> signals_; // maps to $OUT[n]
  bool openData_ = false;                                   // DEFDAT without its ENDDAT
  std::size_t dataFile_ = 0;
  bool aheadOfArm_ = false; // after CONTINUE
  bool moved_ = false;
  bool zeroing_ = false;       // in the module where the operator sets the extruder's axis to 0
  bool turnsWithAxis_ = false; // $BASE is an external axis' frame
  bool framesChanged_ = false; // since the last pose
  Eigen::Isometry3d frame_T_base_ = Eigen::Isometry3d::Identity();
  KrlExternals externals_{variables_};
  std::array<double, 6> lastParts_{};
  std::optional<Eigen::Isometry3d> last_; // frame_T_tcp of the last motion if it was a pose
  std::optional<KrlValue> via_;           // of a CIRC
  plan::TargetKind lastKind_ = plan::TargetKind::FlangePose;
  std::vector<std::pair<std::string, double>> triggers_; // of the next motion
};

} // namespace

plan::ReadProgram readKrl(const std::vector<plan::ProgramFile>& files,
                          const process::Tooling& tooling, const base::RunContext& ctx) {
  return KrlReader(tooling, ctx).read(files);
}

} // namespace voluta::program
