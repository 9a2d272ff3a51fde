#include "program/melfa/melfa_datalink.h"

#include "base/units.h"
#include "program/common/program_text.h"
#include "program/common/text_rows.h"
#include "program/full_flow.h"
#include "program/job_head.h"
#include "program/melfa/melfa.h"
#include "program/melfa/melfa_motions.h"
#include "program/melfa/melfa_taking.h"
#include "program/melfa/melfa_text.h"
#include "program/melfa/melfa_values.h"
#include "program/stream/link_files.h"
#include "program/stream/link_writer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kId = "melfa-datalink", kTitle = "lines for a data link, MELFA-BASIC V",
                           kProgramNote = "# taken by ", kSenderNote = "# sent by ",
                           kTakes = "' Takes lines by data link", kOpen = "Open \"COM";
constexpr MelfaTaking kTaking{"' Takes lines by data link, MELFA-BASIC V", kOpen, "3:"};
constexpr std::size_t kNameCharacters = 7; // 12 with "_link"
constexpr LinkForm kForm{.header = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,mm_per_s,flow,blend_mm",
                         .fullFlow = kMelfaFullFlow,
                         .wholeFlow = true,
                         .jointRadPerS = kMelfaJointRadPerS,
                         .mmDecimals = kMelfaMmDecimals,
                         .degDecimals = kMelfaDegDecimals,
                         .frameDecimals = kMelfaFrameDecimals,
                         .pose = melfaPose};

// The same for every job. The controller buffers only a few lines, so that it always knows the next
// ones without overflowing.
constexpr std::string_view kSender = R"(#!/usr/bin/env python3
"""Sends the lines of a print to a MELFA controller by data link.

python3 NAME_link.py NAME.lines ADDRESS_OF_THE_ROBOT [PORT]

The controller listens once its program has come to Open, and answers each line.
"""
import socket
import sys
import time

PORT, AHEAD, START_S, ANSWER_S = 10003, 16, 600, 600


def lines(path):
    with open(path, encoding="ascii") as stream:
        for line in stream:
            line = line.split("#")[0].replace(" ", "").strip()
            if line[:1] in tuple("-0123456789"):
                yield line + "\r"


def connected(robot, port):
    end = time.monotonic() + START_S  # an operator starts the program meanwhile
    while True:
        try:
            return socket.create_connection((robot, port), 10)
        except OSError:
            if time.monotonic() > end:
                sys.exit("nobody listens: is the program at Open?")
            time.sleep(1)


def main(path, robot, port=PORT):
    with connected(robot, int(port)) as link:
        link.settimeout(ANSWER_S)
        waiting = 0
        for line in lines(path):
            link.sendall(line.encode("ascii"))
            waiting += 1
            while waiting >= AHEAD:
                waiting -= answers(link)
        while waiting > 0:
            waiting -= answers(link)


def answers(link):
    text = link.recv(1024)
    if not text:
        sys.exit("the controller has closed the link")
    return text.count(b"\r")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
)";

Eigen::Vector3d mmOf(const LinkFrame& frame) {
  return Eigen::Vector3d(frame.data());
}
Eigen::Vector3d degreesOf(const LinkFrame& frame) {
  return Eigen::Vector3d(frame.data() + 3);
}

void add(std::vector<std::string>& steps, std::initializer_list<std::string> more) {
  std::ranges::copy(more, std::back_inserter(steps));
}

// Returns the steps of the program that receives the lines, one statement per step. "" is a
// placeholder for the COM number.
std::vector<std::string> stepsFor(const Link& link) {
  const std::string out = std::to_string(kMelfaExtruder), flow = std::to_string(kMelfaFlow);
  const std::string on = joined({"M_Out(", out, ")=1"}), off = joined({"M_Out(", out, ")=0"});
  const std::string none = joined({"M_Outw(", flow, ")=0"}),
                    number = joined({"M_Outw(", flow, ")"});
  const bool joints = link.start.blend == kLinkByJoints;
  std::string start = "(";
  for (std::size_t k = 0; k < link.start.target.size(); ++k)
    start += (k > 0 ? "," : "") + fixedText(link.start.target[k], kMelfaFrameDecimals);
  std::vector<std::string> steps = {"Tool " + melfaFrame(mmOf(link.tool), degreesOf(link.tool)),
                                    "Base P_NBase"};
  if (link.nozzle)
    steps.push_back("P_WkCord(1)=" + melfaFrame(mmOf(*link.nozzle), degreesOf(*link.nozzle)));
  add(steps, {"Ovrd 100", "Accel 100,100", "Cnt 0", off, none, "Hlt",
              joined({"JOvrd ", fixedText(link.start.speed, 2)})});
  if (joints)
    add(steps, {joined({"J1=", start, ")"}), "Mov J1", "P1=JtoP(J1)"});
  else
    add(steps, {joined({"P1=", start, ")(7,0)"}), "Mov P1"});
  add(steps, {joined({kOpen, "\" As #1"}), "*OPENS", "If M_Open(1)<>1 Then GoTo *OPENS",
              "Def Act 1,M_Open(1)<>1 GoTo *LOST", "Act 1=1", "*TAKES",
              "Input #1,M1,M2,M3,M4,M5,M6,M7,M8,M9", "If M7=0 Then GoTo *DONE",
              "If M7<0 Then GoTo *STAYS", "If M9<0 Then GoTo *JOINTS", "GoSub *POSE", "Spd M7"});
  add(steps, {"If M9>0 Then", "Cnt 1,M9,M9", "EndIf", "If M8=0 Then", off, "EndIf", "If M8>0 Then",
              on, "EndIf", joined({link.nozzle ? "EMvs 1,P1" : "Mvs P1", " Wth ", number, "=M8"}),
              "If M9=0 Then", "Cnt 0", "EndIf", "Print #1,M7", "GoTo *TAKES"});
  add(steps, {"*JOINTS", off, none, "JOvrd M7"});
  if (joints) {
    for (int k = 1; k <= 6; ++k)
      steps.push_back(joined({"J1.J", std::to_string(k), "=Rad(M", std::to_string(k), ")"}));
    add(steps, {"Mov J1", "P1=JtoP(J1)"});
  } else {
    add(steps, {"GoSub *POSE", "Mov P1"});
  }
  add(steps, {"Print #1,M7", "GoTo *TAKES", "*STAYS", number + "=M8", "If M8>0 Then", on, "EndIf",
              "Dly -M7", off, "Print #1,M7", "GoTo *TAKES"});
  add(steps, {"*DONE", "Print #1,M7", "*LOST", off, none, "Act 1=0", "Close #1", "End"});
  steps.emplace_back("*POSE");
  for (int k = 1; k <= 3; ++k)
    steps.push_back(joined({"P1.", std::string(1, "XYZ"[k - 1]), "=M", std::to_string(k)}));
  for (int k = 4; k <= 6; ++k)
    steps.push_back(
        joined({"P1.", std::string(1, "ABC"[k - 4]), "=Rad(M", std::to_string(k), ")"}));
  steps.emplace_back("Return");
  return steps;
}

std::string outputsNote(const process::Tooling& tooling) {
  return joined({"extruder on: output ", std::to_string(kMelfaExtruder), "; flow: outputs ",
                 std::to_string(kMelfaFlow), " to ", std::to_string(kMelfaFlow + 15),
                 " as a number, ", fullFlowText(fixedText(kMelfaFullFlow, 0), tooling)});
}

std::string programText(const ProgramInput& in, const Link& link) {
  std::vector<std::string> notes{outputsNote(in.tooling)};
  if (link.nozzle)
    notes.emplace_back("fixed nozzle: Ex-T control, work coordinates 1 are the nozzle's");
  notes.emplace_back(
      "COM3 is the network: COMDEV's third OPT13, its CPRCE13 2, port 10003, the robot serves");
  notes.emplace_back(kStartQuestion);
  return melfaTakingText(in, kTaking, notes, stepsFor(link));
}

bool isTaking(std::string_view text) {
  return text.substr(0, 16384).find(kTakes) != std::string_view::npos;
}

void readTaking(std::string_view text, const Link& link, ProgramBuilder& out) {
  readMelfaTaking(
      text, kTaking, stepsFor(link),
      [](std::string_view rest) -> std::size_t { // COM1: to COM8:
        return rest.size() > 1 && rest[0] >= '1' && rest[0] <= '8' && rest[1] == ':' ? 2 : 0;
      },
      kOtherTaking, out);
}

LinkFrame frameOf(const Eigen::Isometry3d& pose) {
  return linkFrame(pose.translation(), melfaDegrees(pose), kForm);
}

} // namespace

const LinkForm& melfaLinkForm() {
  return kForm;
}

plan::Program writeMelfaDatalink(const ProgramInput& input, const base::RunContext& ctx) {
  const MelfaMotions motions(input, ctx);
  const std::string name = identifierOf(input.name),
                    taking = joined({name.substr(0, kNameCharacters), "_link.prg"}),
                    sender = name + "_link.py";
  LinkHead head{kId,
                {std::string(kTitle), joined({kProgramNote.substr(2), taking}),
                 joined({kSenderNote.substr(2), sender})},
                {}};
  if (input.foreign)
    head.remarks.emplace_back(
        "FOREIGN: not the language of the cell's controller; Cartesian targets only");
  std::ranges::copy(headLines(input), std::back_inserter(head.remarks));
  head.remarks.push_back(outputsNote(input.tooling));
  head.frames.tool = frameOf(input.cell.flange_T_moved());
  if (motions.holdsWork())
    head.frames.nozzle = frameOf(input.cell.base_T_fixed());
  LinkText lines = writeLinkRows(input, kForm, motions, head, ctx);
  plan::Program program;
  program.format = kId;
  program.foreign = input.foreign;
  program.files = {{name + ".lines", std::move(lines.text)},
                   {taking, programText(input, lines.link)},
                   {sender, std::string(kSender)}};
  return program;
}

plan::ReadProgram readMelfaDatalink(const std::vector<plan::ProgramFile>& files,
                                    const process::Tooling& tooling, const base::RunContext& ctx) {
  return readLinkFiles(kId, files, kForm, kSender, {{isTaking, readTaking}}, tooling, ctx);
}

bool looksLikeMelfaDatalink(std::string_view text) {
  return looksLikeLinkRows(text, kForm);
}

std::vector<std::string> filesOfMelfaDatalink(std::string_view text) {
  return namesBehind(text, {kProgramNote, kSenderNote});
}

bool mayBeMissingInMelfaDatalink(const std::vector<std::string>& lines, std::size_t i) {
  return isStandingLinkRow(lines, i, kForm);
}

} // namespace voluta::program
