#include "program/gcode/gcode_rapid.h"

#include "base/error.h"
#include "base/units.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/same_text.h"
#include "program/common/tcp_motions.h"
#include "program/gcode/gcode_rapid_text.h"
#include "program/job_head.h"
#include "program/rapid/rapid.h"
#include "program/rapid/rapid_files.h"
#include "program/rapid/rapid_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace voluta::program {

namespace {

constexpr std::string_view kNone = "none", kRapid = "rapid", kObject = "wPlate",
                           kTitle = "  ! Reads extended G-code on the controller, RAPID",
                           kFile = "  CONST string sFile:=\"", kFull = "  CONST num nFullFlow:=",
                           kByJoints = "  CONST bool bByJoints:=", kJoints = "  CONST jointtarget ";
constexpr int kPositionDecimals = 4, kRotationDecimals = 8, kDegreeDecimals = 6, kFlowDecimals = 3;

std::string withCrLf(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += c == '\n' ? std::string_view("\r\n") : std::string_view(&c, 1);
  return out;
}

} // namespace

base::ParameterSpec gcodeRunner() {
  return base::choiceParameter(
      "gcodeRunner", std::string(kNone),
      {{std::string(kNone), "nothing"_text}, {std::string(kRapid), "a RAPID module (ABB)"_text}},
      "Programs"_text, "companion reader for extended G-code"_text,
      "Extended G-code: also writes a RAPID module that reads the file on an ABB "
      "controller and runs arm and extruder."_text);
}

bool wantsRapidRunner(const ProgramOptions& options) {
  return chosenOf(gcodeRunner(), options) == kRapid;
}

std::string rapidRunnerName(const ProgramInput& input) {
  const bool omniCore = input.cell.robot().controllerModel == robot::kOmniCore;
  return joined({identifierOf(input.name), "_gcode", moduleExtension(omniCore)});
}

plan::ProgramFile rapidRunner(const ProgramInput& input, std::string_view gcodeFile,
                              const base::RunContext& ctx) {
  if (!input.cell.externalAxes().empty())
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("a module that reads G-code cannot move the {axis} of cell {cell}: G-code "
                      "does not state its position"_text,
                      input.cell.externalAxes().front().name, input.cell.id()),
        {}, "choose rapid"_text);
  // Its module knows no words of stops, tools and outputs, and would end the print at the first
  // one.
  const auto isKnown = [](const plan::TrajectoryEvent& event) {
    return event.kind == plan::EventKind::Purge || event.kind == plan::EventKind::Shot;
  };
  if (input.selectsTool() || !std::ranges::all_of(input.trajectory.events, isKnown))
    throw base::Error(
        base::ErrorCode::Usage,
        "a module that reads G-code has no commands for stops, waits, tools and outputs"_text, {},
        "choose rapid"_text);
  const bool own = input.cell.robot().controller == "rapid";
  std::vector<MotionTarget> targets = motionTargets(input, ctx);
  placeInWorkFrame(input, kPositionDecimals, targets);
  std::string out;
  const auto line = [&](std::string_view text) { out += joined({text, "\n"}); };
  line(joined({"MODULE ", programName(input.name), "_gcode"}));
  line(kTitle);
  for (const std::string& head : headLines(input))
    line(joined({"  ! ", head}));
  line(
      "  ! expects the G-code in HOME:, the signals doExtruder and aoFlow, which goes from 0 to 1");
  line("  ! heats nothing: the nozzle is hot when it starts");
  line(joined({"  ! load assumed: ", assumedLoadText(input)}));
  line(rapidToolLine(input));
  line(rapidObjectLine(input, kObject));
  out += "  CONST robtarget pStart:=[";
  appendRapidPosition(out, targets.front().tcpMm, kPositionDecimals);
  out += ',';
  appendRapidRotation(out, targets.front().tcpRotation, kRotationDecimals);
  line(joined({",[0,0,0,0],", kRapidNoAxes, "];"}));
  out += joined({kJoints, "jStart:=["});
  for (int k = 0; k < 6; ++k) {
    out += k ? ',' : '[';
    appendFixed(out, own ? base::radiansToDegrees(input.trajectory.at(0)[k]) : 0.0, kDegreeDecimals,
                true);
  }
  line(joined({"],", kRapidNoAxes, "];"}));
  line(joined({kByJoints, own ? "TRUE;" : "FALSE;"}));
  line(joined({kFile, gcodeFile, "\";"}));
  line(joined({kFull, fixedText(input.tooling.fullFlowMm3PerS(), kFlowDecimals), ";"}));
  out += rapidGcodeSame();
  return {rapidRunnerName(input), withCrLf(out)};
}

bool isRapidRunner(std::string_view text) {
  return text.starts_with("MODULE ") && text.substr(0, 400).find(kTitle) != std::string_view::npos;
}

// Its data are read by the RAPID reader, followed by a motion to the start.
void readRapidRunner(std::string_view text, const process::Tooling& tooling, ProgramBuilder& out,
                     const base::RunContext& ctx) {
  const std::size_t body = text.find(rapidGcodeSameBegin());
  if (body == std::string_view::npos) {
    out.line = 1;
    out.defect("this is not the module that reads G-code"_text);
    return;
  }
  // Lines that the RAPID reader does not know.
  constexpr std::string_view kOwn[] = {kFull, kFile, kByJoints, kJoints};
  int found[std::size(kOwn)] = {};
  const double fullFlow = tooling.fullFlowMm3PerS();
  std::string head;
  LineReader lines(text.substr(0, body));
  for (std::string_view line; lines.next(line);) {
    out.line = lines.number();
    double full = 0.0;
    std::string_view rest = line;
    if (line.starts_with(kFull)) {
      rest.remove_prefix(kFull.size());
      if (!takeNumber(rest, full) || rest != ";" || std::abs(full - fullFlow) > 1e-3 * fullFlow)
        out.defect("the full flow is not the process's"_text);
    }
    bool ours = false;
    for (std::size_t k = 0; k < std::size(kOwn); ++k)
      if (line.starts_with(kOwn[k])) {
        ours = true;
        ++found[k];
      }
    head += joined({ours ? "" : line, "\r\n"});
  }
  if (std::ranges::any_of(found, [](int count) { return count != 1; }))
    out.defect("the job's file, start or full flow is missing or given twice"_text);
  const std::size_t first = lines.number() + 1;
  head += joined({"  PROC main()\r\n    ConfL\\Off;\r\n    ConfJ\\Off;\r\n    SetDO "
                  "doExtruder,0;\r\n    SetAO aoFlow,0;\r\n    MoveJ "
                  "pStart,v50,fine,",
                  kRapidTool, "\\WObj:=", kObject,
                  ";\r\n    SetDO doExtruder,0;\r\n    SetAO aoFlow,0;\r\n  ENDPROC\r\n"
                  "ENDMODULE\r\n"});
  for (const plan::ProgramDefect& defect : readRapid({{"head.mod", head}}, tooling, ctx).defects) {
    out.line = std::min(defect.line, first);
    out.defect(defect.reason);
  }
  reportOtherText(text.substr(body), rapidGcodeSame(), first, out);
}

} // namespace voluta::program
