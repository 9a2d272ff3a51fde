#include "base/units.h"
#include "plan/marks.h"
#include "program/common/extruder_outputs.h"
#include "program/common/program_text.h"
#include "program/program_builder.h"
#include "program/rapid/rapid.h"
#include "program/rapid/rapid_data.h"
#include "program/rapid/rapid_files.h"
#include "program/rapid/rapid_motions.h"
#include "program/rapid/rapid_text.h"
#include "program/rapid/rapid_tokens.h"
#include "program/rapid/rapid_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace voluta::program {

namespace {
constexpr double kMaxSeconds = 1e5;
// The procedure that sets the extruder's axis to 0, as named by the writer.
constexpr std::string_view kZero = "zeroextruder";
// Maximum share per mm/s of a flow proportional to the speed; rounding allowance of the total.
constexpr double kMaxPerMm = 1e3, kShareSlack = 1e-3;

class RapidReader : private RapidValues {
public:
  RapidReader(const process::Tooling& tooling, const base::RunContext& ctx)
      : ctx_(ctx), out_("rapid", tooling), fullFlowMm3PerS_(tooling.fullFlowMm3PerS()) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    out_.expectMotionsOf(files);
    bool complete = true;
    for (out_.file = 0; out_.file < files.size(); ++out_.file) {
      ctx_.checkpoint();
      const plan::ProgramFile& file = files[out_.file];
      out_.line = 1;
      reportLineEnds(file.text, out_);
      if (isSignalList(file.text))
        continue;
      if (isModuleList(file.text))
        complete = readModuleList(file.text, files, out_) && complete;
      else
        complete = readModule(file) && complete;
    }
    out_.file = files.empty() ? 0 : files.size() - 1;
    if (modules_ == 0 || modules_ - 1 < calls_.size()) {
      defect(modules_ == 0 ? "no module"_text
                           : base::message("the module with {procedure} is missing"_text,
                                           calls_[modules_ - 1].procedure));
      complete = false;
    }
    return out_.take(complete);
  }

private:
  struct Call {
    std::string procedure, file;
  };
  void defect(base::Message reason) { out_.defect(std::move(reason)); }

  // ---- Structure

  // A procedure's body, which is read when it is called.
  struct Procedure {
    RapidTokens tokens;
    RapidToken token;
    bool ended = false;
  };

  bool readModule(const plan::ProgramFile& file) {
    const std::string_view text = behindHeader(file.text);
    const std::string_view head(file.text.data(), file.text.size() - text.size());
    tokens_ =
        RapidTokens(text, 1 + static_cast<std::size_t>(std::count(head.begin(), head.end(), '\n')));
    textEnd_ = file.text.data() + file.text.size();
    advance();
    out_.beginOutputs();
    procedures_.clear();
    std::string name;
    out_.line = token_.line;
    bool ended = false, procedureEnded = true;
    if (!takeWord("module") || !takeName(name))
      defect("a module must begin with MODULE and its name"_text);
    if (!takeAttributes())
      defect("invalid module attributes"_text);
    while (!ended && token_.kind != RapidTokenKind::End) {
      out_.line = token_.line;
      const bool isLocal = takeWord("local");
      if (takeWord("endmodule"))
        ended = true;
      else if (takeWord("proc"))
        procedureEnded = procedure(isLocal) && procedureEnded;
      else if (isWord("pers") || isWord("const") || isWord("var"))
        whole([&] { return declaration(false); });
      else if (takeWord("endproc"))
        defect("ENDPROC without a procedure"_text);
      else
        whole([&] { return fail("a statement outside the procedure"_text); });
    }
    out_.line = token_.line;
    if (ended && token_.kind != RapidTokenKind::End)
      defect("text after ENDMODULE"_text);
    if (!ended)
      defect("ENDMODULE is missing: the file was cut short"_text);
    const std::size_t last = out_.line;
    const bool runs = runEntry(file.name);
    out_.line = last;
    const bool off = motions_.hasExtruder() || out_.outputsEnded();
    if (!off)
      defect("the extruder is not switched off after the last motion"_text);
    if (!loaded_.empty())
      defect(base::message("'{loaded}' is not unloaded"_text, loaded_));
    ++modules_;
    return ended && procedureEnded && runs && off && loaded_.empty();
  }

  // Reads a procedure after PROC. Returns false if it has no end.
  bool procedure(bool isLocal) {
    std::string name;
    if (!takeName(name) || !takeMark('(') || !takeMark(')'))
      defect("not a valid procedure header"_text);
    // The first module stays loaded.
    if (modules_ == 0 && !isLocal)
      ofFirst_.insert(name);
    else if (!isLocal && ofFirst_.contains(name))
      defect(base::message("the first module declares '{procedure}', too"_text, name));
    Procedure body{tokens_, token_};
    while (token_.kind != RapidTokenKind::End && !isWord("endmodule") && !isWord("endproc"))
      advance();
    body.ended = isWord("endproc");
    out_.line = token_.line;
    if (!takeWord("endproc"))
      defect("the procedure has no ENDPROC"_text);
    const bool ended = body.ended;
    if (!procedures_.try_emplace(name, std::move(body)).second)
      defect("a name is declared twice"_text);
    return ended;
  }

  // Runs main of the first module, or the procedure of a later one that main calls.
  bool runEntry(std::string_view file) {
    if (procedures_.empty())
      defect("the module has no procedure"_text);
    const bool later = modules_ > 0, called = later && modules_ - 1 < calls_.size();
    const std::string name = called ? calls_[modules_ - 1].procedure : "main";
    const bool here = procedures_.contains(name) && later == called &&
                      (!called || file.ends_with(calls_[modules_ - 1].file));
    if (!here && !procedures_.empty())
      defect(later ? "this is not the module that main runs next"_text
                   : "the first module has no procedure main"_text);
    if (here)
      run(name);
    else if (!procedures_.empty())
      run(procedures_.begin()->first); // Runs it anyway, to find other defects
    return here;
  }

  void run(const std::string& name) {
    constexpr std::size_t kMaxCalls = 16;
    if (std::find(running_.begin(), running_.end(), name) != running_.end() ||
        running_.size() == kMaxCalls) {
      defect(base::message("'{name}' calls itself"_text, name));
      return;
    }
    running_.push_back(name);
    const RapidTokens tokens = tokens_;
    const RapidToken token = token_;
    tokens_ = procedures_.at(name).tokens;
    token_ = procedures_.at(name).token;
    while (token_.kind != RapidTokenKind::End && !isWord("endmodule") && !isWord("endproc")) {
      out_.line = token_.line;
      if (++statements_ % 4096 == 0)
        ctx_.checkpoint();
      whole([&] { return statement(); });
    }
    tokens_ = tokens;
    token_ = token;
    running_.pop_back();
  }

  // Runs the parser of one statement. If it fails, reports why and continues after the semicolon.
  template <typename Parse> void whole(Parse parse) {
    const char* begin = token_.begin;
    reason_ = {};
    closed_ = false;
    if (parse())
      return;
    if (reason_.empty()) {
      const std::string_view code(begin, static_cast<std::size_t>(textEnd_ - begin));
      reason_ =
          base::message("not understood: '{code}'"_text,
                        code.substr(0, std::min<std::size_t>(60, code.find_first_of("\r\n"))));
    }
    defect(std::move(reason_));
    while (!closed_ && token_.kind != RapidTokenKind::End && !isWord("endproc") &&
           !isWord("endmodule")) {
      closed_ = isMark(';');
      advance();
    }
  }

  // ---- Statements

  bool statement() {
    if (isMark('%'))
      return call();
    std::string word;
    if (isWord("var") || isWord("const"))
      return declaration(true);
    if (!takeName(word))
      return false;
    if (isMark(':'))
      return assignment(word);
    if (procedures_.contains(word)) {
      if (!takeEnd())
        return false;
      zeroing_ = word == kZero;
      run(word);
      if (std::exchange(zeroing_, false))
        out_.zeroAxis();
      closed_ = true;
      return true;
    }
    if (word == "triggequip")
      return triggEquip();
    if (word == "triggspeed")
      return triggSpeed();
    if (word == "movel" || word == "movej" || word == "moveabsj" || word == "triggl" ||
        word == "movec" || word == "triggc")
      return motion(word);
    if (word == "setdo")
      return output("doextruder", [&](double v) { return digital(v); });
    if (word == "setao")
      return output("aoflow", [&](double v) { return analogue(v); });
    if (word == "cirpathmode")
      return takeMark('\\') && ((takeWord("objectframe") && takeEnd()) ||
                                fail("the tool does not turn evenly along its way"_text));
    if (word == "confl" || word == "confj")
      return supervision(word == "confl" ? linearOff_ : jointOff_);
    if (word == "actunit" || word == "deactunit")
      return unit(word == "actunit");
    if (word == "load" || word == "unload")
      return load(word == "load");
    if (word == "moveextj")
      return moveExtruder();
    if (word == "uimsgbox" && zeroing_)
      return skipStatement();
    if (word == "pulsedo")
      return pulse();
    double number = 0.0;
    if (word == "waittime")
      return wait();
    if (word == "waitdi")
      return awaitInput();
    if (word == "accset" || word == "velset")
      return takeNumberToken(number) && takeMark(',') && fullSpeed(word, number) &&
             takeNumberToken(number) && takeEnd() && out_.word(rapidWords(), word);
    if (word == "singarea" && !isMark('\\'))
      return false;
    if (!out_.word(rapidWords(), word))
      return fail(base::message("'{word}' is not known to the reader"_text, word.substr(0, 40)));
    if (word == "singarea" && (advance(), !isWord("off")))
      return fail("near singular poses the arm would deviate from the planned orientation"_text);
    return word == "uimsgbox" || word == "tpreadfk" || word == "tpreadnum" || word == "stop"
               ? operatorStop()
               : skipStatement();
  }

  // PulseDO [\High] [\PLength:=seconds,] signal;
  bool pulse() {
    double seconds = 0.2; // the controller's default
    std::string signal;
    while (takeMark('\\'))
      if (!takeWord("high") && (!takeWord("plength") || !takeAssign() || !takeNumberToken(seconds)))
        return false;
    takeMark(',');
    if (!takeName(signal) || !takeEnd())
      return false;
    if (signal == inSmallLetters(kRapidCutSignal))
      out_.cutFor(seconds);
    else
      out_.wordAt("PulseDO", kOutsidePrint);
    return true;
  }

  bool operatorStop() {
    bool endsByItself = false;
    if (token_.kind == RapidTokenKind::Text)
      out_.show(token_.text);
    for (; token_.kind != RapidTokenKind::End && !isMark(';'); advance())
      for (const std::string_view word : {"maxtime", "dibreak", "dobreak", "persboolbreak"})
        endsByItself = endsByItself || isWord(word);
    out_.operatorStop(!endsByItself);
    return skipStatement();
  }

  // WaitDI signal,value;
  bool awaitInput() {
    constexpr std::string_view kMarkSignal = "dimark";
    double value = 0.0;
    std::string name;
    if (!takeName(name))
      return false;
    const std::optional<int> number = numberBehind(name, kMarkSignal, 1, plan::kMarkSignals);
    if (!number)
      return out_.wordAt("WaitDI", kOutsidePrint), skipStatement();
    return takeMark(',') && takeNumberToken(value) && takeEnd() && isDigital(value) &&
           out_.awaitInput(kMarkOutput - 1 + *number, value == 1.0);
  }

  // Returns the number in the name of a signal, e.g. of doMark2.
  static std::optional<int> numberBehind(std::string_view name, std::string_view begin, int minimum,
                                         int maximum) {
    return name.starts_with(begin) ? parseWholeNumber(name.substr(begin.size()), minimum, maximum)
                                   : std::nullopt;
  }
  bool isDigital(double value) {
    return value == 0.0 || value == 1.0 || fail("a digital output must be 0 or 1"_text);
  }

  bool wait() {
    double seconds = 0.0;
    if (takeMark('\\') && (!takeWord("inpos") || !takeMark(',')))
      return false;
    if (!takeNumberToken(seconds) || !takeEnd())
      return false;
    if (!(seconds >= 0.0))
      return fail("WaitTime without a time in seconds"_text);
    if (perMm_ > 0.0)
      out_.flow(0.0);
    out_.pauseByOutputs(seconds);
    return true;
  }
  bool fullSpeed(std::string_view word, double percent) {
    return percent == 100.0 ||
           fail(base::message("'{word}' slows the arm: the flow would not follow"_text, word));
  }
  // Skips to the end of the statement, past its semicolon.
  bool skipStatement() {
    while (token_.kind != RapidTokenKind::End && !isWord("endproc") && !isWord("endmodule")) {
      closed_ = isMark(';');
      advance();
      if (closed_)
        return true;
    }
    return false;
  }

  template <typename Take> bool output(std::string_view signal, Take take) {
    std::string name;
    double value = 0.0;
    if (!takeName(name) || !takeMark(',') || !takeNumberToken(value) || !takeEnd())
      return false;
    if (name == signal)
      return take(value);
    constexpr int kMaxTools = 255;
    const std::optional<int> mark = numberBehind(name, "domark", 1, plan::kMarkSignals),
                             tool = numberBehind(name, "dotool", 2, kMaxTools);
    const int own = name == "dotoollocked" ? kChangerOutput
                    : mark                 ? kMarkOutput - 1 + *mark
                    : tool                 ? *tool - 1
                                           : 0;
    if (own > 0 && !isDigital(value))
      return false;
    if (own == 0 || !out_.toolOutput(own, value == 1.0))
      out_.wordAt(name, kOutsidePrint);
    return true;
  }
  bool digital(double value) {
    if (!isDigital(value))
      return false;
    out_.statePassingOutput();
    extruderOn_ = value == 1.0;
    out_.setExtruder(extruderOn_);
    return true;
  }
  bool analogue(double value) {
    if (!(value >= 0.0 && value <= 1.0))
      return fail("an analogue output outside 0..1"_text);
    out_.statePassingOutput();
    out_.flow(value);
    perMm_ = 0.0;
    return true;
  }

  // TriggEquip name,0\Start,0\AOp:=aoFlow,share: the flow from the start of a TriggL.
  bool triggEquip() {
    std::string name, signal;
    double mm = 0.0, lag = 0.0, share = 0.0;
    const std::string_view at = token_.text;
    if (!takeName(name) || !takeMark(',') || !takeNumberToken(mm) || !takeMark('\\') ||
        !takeWord("start") || !takeMark(',') || !takeNumberToken(lag) || !takeMark('\\') ||
        !takeWord("aop") || !takeAssign() || !takeName(signal) || !takeMark(',') ||
        !takeNumberToken(share) || !takeEnd())
      return false;
    if (!(share >= 0.0 && share <= 1.0))
      return fail("an analogue output outside 0..1"_text);
    return defineTrigg(name, at, mm == 0.0 && lag == 0.0 && signal == "aoflow", {share});
  }
  bool defineTrigg(const std::string& name, std::string_view asWritten, bool read,
                   std::vector<double> numbers) {
    const auto known = declared_.find(name);
    if (known == declared_.end() || known->second.type != "triggdata")
      return fail(base::message("'{name}' is not declared as {type}"_text, asWritten.substr(0, 40),
                                "triggdata"_name));
    if (!read)
      return fail("flow changes are only supported at the start of a motion"_text);
    known->second.data.numbers = std::move(numbers);
    return true;
  }

  // TriggSpeed name,0\Start,0,aoFlow,scale: aoFlow is scale times the TCP's speed in mm/s, from the
  // start of a TriggL until it is set again.
  bool triggSpeed() {
    std::string name, signal;
    double mm = 0.0, lag = 0.0, scale = 0.0;
    const std::string_view at = token_.text;
    if (!takeName(name) || !takeMark(',') || !takeNumberToken(mm) || !takeMark('\\') ||
        !takeWord("start") || !takeMark(',') || !takeNumberToken(lag) || !takeMark(',') ||
        !takeName(signal) || !takeMark(',') || !takeNumberToken(scale) || !takeEnd())
      return false;
    if (!(scale > 0.0 && scale <= kMaxPerMm))
      return fail("an invalid flow per speed"_text);
    return defineTrigg(name, at, mm == 0.0 && lag == 0.0 && signal == "aoflow", {0.0, scale});
  }
  // A flow proportional to the speed gives an amount per path length, at any speed.
  bool flowBySpeed(plan::ProgramMotion& m) {
    if (!extruderOn_ || perMm_ == 0.0)
      return true;
    const std::optional<double> distance = motions_.tcpLengthMm(m);
    if (!distance)
      return fail("a flow proportional to the speed in a motion of unknown length"_text);
    const double fastest = m.durationS > 0.0 ? *distance / m.durationS : m.speedMmPerS;
    if (perMm_ * fastest > 1.0 + kShareSlack)
      return fail("an analogue output outside 0..1"_text);
    out_.flow(std::min(1.0, perMm_ * fastest));
    m.volumeMm3 = perMm_ * *distance * fullFlowMm3PerS_;
    return true;
  }

  bool supervision(bool& off) {
    std::string state;
    if (!takeMark('\\') || !takeName(state) || !takeEnd())
      return false;
    off = state == "off";
    return off || state == "on";
  }

  bool unit(bool active) {
    std::string name;
    if (!takeName(name) || !takeEnd())
      return false;
    if (active)
      out_.state(plan::FactKind::MechanicalUnit, 0.0, name);
    else
      out_.wordAt("DeactUnit", kBeforeMotion | kAtEnd);
    motions_.unit(name, active);
    return true;
  }

  // Load\Dynamic,"HOME:"\File:="part_1.mod"; its procedure is then called by %"name"%.
  bool load(bool loads) {
    std::string folder, file;
    if (loads && takeMark('\\') && (!takeWord("dynamic") || !takeMark(',')))
      return false;
    if (!takeText(folder) || !takeMark('\\') || !takeWord("file") || !takeAssign() ||
        !takeText(file) || !takeEnd())
      return false;
    if (loads && !loaded_.empty())
      return fail(base::message("'{loaded}' is not unloaded"_text, loaded_));
    if (!loads && (loaded_ != file || !called_))
      return fail("UnLoad of a module that was not loaded and run"_text);
    loaded_ = loads ? file : "";
    called_ = false;
    return !file.empty();
  }
  bool call() {
    std::string name;
    if (!takeMark('%') || !takeText(name) || !takeMark('%') || !takeEnd())
      return false;
    if (loaded_.empty() || called_ || modules_ > 0)
      return fail("a call of a module that is not loaded"_text);
    called_ = true;
    calls_.push_back({inSmallLetters(name), loaded_});
    return true;
  }

  bool motion(const std::string& word) {
    RapidMotionData data;
    data.absolute = word == "moveabsj";
    data.object = *predeclaredRapid("wobjdata", "wobj0");
    data.toolLine = toolLine_;
    plan::ProgramMotion m;
    m.jointInterpolated = word == "movej" || data.absolute;
    const bool triggers = word == "triggl" || word == "triggc";
    RapidData trigg;
    if ((word == "movec" || word == "triggc") &&
        (!value("robtarget", data.via.emplace()) || !takeMark(',')))
      return false;
    if (!value(data.absolute ? "jointtarget" : "robtarget", data.target))
      return false;
    if (data.absolute && takeMark('\\') && !takeWord("noeoffs"))
      return false;
    if (!takeMark(',') || !value("speeddata", data.speed) || !takeTime(data.timed, m.durationS))
      return false;
    if (triggers && (!takeMark(',') || !value("triggdata", trigg)))
      return false;
    if (triggers && trigg.numbers.empty())
      return fail("a TriggL before its TriggEquip"_text);
    if (!takeMark(',') || !value("zonedata", data.zone) || !takeMark(',') ||
        !value("tooldata", data.tool))
      return false;
    if (takeMark(',') && !isMark('\\')) // RoboDK writes a comma there
      return false;
    if (takeMark('\\') && (!takeWord("wobj") || !takeAssign() || !value("wobjdata", data.object)))
      return false;
    if (!takeEnd() || !motions_.fill(data, m, reason_))
      return false;
    if (!trigg.numbers.empty()) {
      out_.flow(trigg.numbers[0]);
      perMm_ = trigg.numbers.size() > 1 ? trigg.numbers[1] : 0.0;
    }
    if (!flowBySpeed(m))
      return false;
    if (!data.absolute && !(m.jointInterpolated ? jointOff_ : linearOff_))
      defect("configuration supervision is on: ConfL\\Off, ConfJ\\Off"_text);
    motions_.done(m);
    if (const auto mm = motions_.extruderMm())
      out_.motionByAxis(std::move(m), *mm);
    else
      out_.motionByOutputs(std::move(m));
    return true;
  }

  // Reads an optional \T:=seconds.
  bool takeTime(bool& timed, double& seconds) {
    timed = takeMark('\\');
    return !timed || (takeWord("t") && takeAssign() && takeNumberToken(seconds));
  }

  // MoveExtJ jointtarget, speed\T:=seconds, zone: moves the extruder's axis alone.
  bool moveExtruder() {
    RapidData target, speed, zone;
    bool timed = false;
    double seconds = 0.0;
    if (!value("jointtarget", target) || !takeMark(',') || !value("speeddata", speed) ||
        !takeTime(timed, seconds) || !takeMark(',') || !value("zonedata", zone) || !takeEnd())
      return false;
    const std::optional<double> mm = motions_.extruderAlone(target.numbers);
    if (!mm || !timed)
      return fail(
          "external axes that move alone are only supported for the extruder, with a time"_text);
    if (!(seconds > 0.0 && seconds <= kMaxSeconds))
      return fail("an invalid time"_text);
    out_.pauseByAxis(seconds, *mm);
    return true;
  }

  const base::RunContext& ctx_;
  ProgramBuilder out_;
  std::size_t modules_ = 0, statements_ = 0;
  const char* textEnd_ = nullptr;
  std::vector<Call> calls_;                                  // By main, in order
  std::string loaded_;                                       // Loaded file
  bool called_ = false;                                      // The loaded file was run
  std::map<std::string, Procedure, std::less<>> procedures_; // Of the module
  std::set<std::string, std::less<>> ofFirst_; // global procedures of the first module
  std::vector<std::string> running_;
  bool linearOff_ = false, jointOff_ = false;
  RapidMotions motions_{out_};
  bool zeroing_ = false; // The extruder's axis is being set to 0 by the operator
  double perMm_ = 0.0;   // Share of the full flow per mm/s, while it is proportional to the speed
  bool extruderOn_ = false;
  const double fullFlowMm3PerS_;
};

} // namespace

plan::ReadProgram readRapid(const std::vector<plan::ProgramFile>& files,
                            const process::Tooling& tooling, const base::RunContext& ctx) {
  return RapidReader(tooling, ctx).read(files);
}

} // namespace voluta::program
