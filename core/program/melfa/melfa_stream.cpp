#include "program/melfa/melfa_stream.h"

#include "base/error.h"
#include "base/units.h"
#include "program/common/program_text.h"
#include "program/common/same_text.h"
#include "program/common/text_rows.h"
#include "program/full_flow.h"
#include "program/job_head.h"
#include "program/melfa/melfa.h"
#include "program/melfa/melfa_taking.h"
#include "program/melfa/melfa_text.h"
#include "program/melfa/mxt_packets.h"
#include "program/program_builder.h"
#include "program/stream/joint_rows_writer.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kId = "melfa-stream", kTitle = "joint stream, MELFA Mxt",
                           kPacketsNote = "# as packets in ", kProgramNote = "# taken by ",
                           kSenderNote = "# sent by ", kCycleNote = "# a packet each ",
                           kTakes = "' Takes a stream", kOpen = "Open \"ENET:";
constexpr MelfaTaking kTaking{"' Takes a stream by real-time control, MELFA-BASIC V", kOpen,
                              "192.168.0.2"};
constexpr double kCr750S = 0.00711, kCr800S = 0.0035, kStartRadPerS2 = 0.5;
constexpr std::size_t kMaxPackets = 5'000'000; // 1 GB
constexpr std::size_t kNameCharacters = 8;     // 12 with "_mxt"

// The same for every job. Sends one packet per answer, which keeps pace with the controller.
constexpr std::string_view kSender = R"(#!/usr/bin/env python3
"""Sends packets of real-time control to a MELFA controller.

python3 NAME_mxt.py NAME.mxt ADDRESS_OF_THE_ROBOT

The controller answers each packet once its program has come to Mxt.
"""
import socket
import sys

PORT, BYTES, START_S, ANSWER_S = 10000, 196, 600, 1


def main(path, robot):
    with open(path, "rb") as stream, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as port:
        port.settimeout(ANSWER_S)
        packet = stream.read(BYTES)
        for _ in range(START_S // ANSWER_S):  # an operator starts the program meanwhile
            port.sendto(packet, (robot, PORT))
            try:
                port.recv(1024)
                break
            except socket.timeout:
                pass
        else:
            sys.exit("no answer: is the program at Mxt?")
        packet = stream.read(BYTES)
        while packet:
            port.sendto(packet, (robot, PORT))
            last = packet[:2] == b"\xff\x00"
            if not last:
                port.recv(1024)
            packet = stream.read(BYTES)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
)";

// Packets set all 16 outputs. Uses the numbers of the melfa dialect that no other output has.
std::string outputsNote(const process::Tooling& tooling) {
  return joined({"extruder on: output ", std::to_string(kMxtFirstOutput + 15), "; flow: outputs ",
                 std::to_string(kMxtFirstOutput), " to ", std::to_string(kMxtFirstOutput + 14),
                 " as a number, ", fullFlowText(fixedText(kMxtFullFlow, 0), tooling)});
}

// Returns the steps of the program that receives the stream; "" is a placeholder for the address.
std::vector<std::string> stepsFor(const JointRow& start) {
  std::string joints = "J1=(";
  for (std::size_t k = 0; k < kRowJoints; ++k)
    joints += (k > 0 ? "," : "") + fixedText(base::radiansToDegrees(start.joints[k]), 6);
  const std::string off = joined({"M_Outw(", std::to_string(kMxtFirstOutput), ")=0"});
  return {
      "Ovrd 100",   off,        "Hlt",       joined({"JOvrd ", fixedText(kMelfaStartPercent, 0)}),
      joints + ")", "Mov J1",   "JOvrd 100", joined({kOpen, "\" As #1"}),
      "Mxt 1,1,10", "Close #1", off,         "End"};
}

std::string programText(const ProgramInput& in, const JointRow& start) {
  return melfaTakingText(in, kTaking,
                         {outputsNote(in.tooling),
                          "the address behind ENET is the computer's that sends, to be set",
                          std::string(kStartQuestion)},
                         stepsFor(start));
}

void readTaking(std::string_view text, const std::optional<JointRow>& start, ProgramBuilder& out) {
  if (!start)
    return;
  readMelfaTaking(
      text, kTaking, stepsFor(*start),
      [](std::string_view rest) {
        const std::size_t quote = rest.find('"');
        return quote == std::string_view::npos ? 0 : quote;
      },
      {"not the program that receives this stream: '{code}'"_text,
       "the program that receives the stream is truncated"_text},
      out);
}

void readPackets(std::string_view bytes, std::string_view wanted, ProgramBuilder& out) {
  const auto [own, theirs] = std::ranges::mismatch(bytes, wanted);
  if (own == bytes.end() && theirs == wanted.end())
    return;
  const std::size_t packet = static_cast<std::size_t>(own - bytes.begin()) / kMxtBytes;
  out.line = packet + 1;
  out.defect(base::message("packet {number} does not match the rows"_text, packet + 1));
}

double cycleOf(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  for (std::string_view line; lines.next(line);)
    if (double ms = 0.0; line.starts_with(kCycleNote) &&
                         (line.remove_prefix(kCycleNote.size()), takeNumber(line, ms)) &&
                         ms >= 1.0 && ms <= 100.0)
      return ms / 1000.0;
  return kCr750S;
}

} // namespace

base::ParameterSpec mxtController() {
  return base::choiceParameter(
      "mxtController", "cr750",
      {{"cr750", "CR750 (7.11 ms)"_text}, {"cr800", "CR800 (3.5 ms)"_text}}, "Programs"_text,
      "controller"_text, "MELFA stream: one packet is sent per controller cycle."_text);
}

std::vector<base::ParameterSpec> melfaStreamOptions() {
  return {mxtController()};
}

plan::Program writeMelfaStream(const ProgramInput& input, const base::RunContext& ctx) {
  const double cycleS = chosenOf(mxtController(), input.options) == "cr800" ? kCr800S : kCr750S;
  const std::string name = identifierOf(input.name);
  const std::string packets = name + ".mxt", sender = name + "_mxt.py",
                    taking = joined({name.substr(0, kNameCharacters), "_mxt.prg"});
  std::vector<std::string> head = {
      std::string(kTitle), joined({kPacketsNote.substr(2), packets}),
      joined({kProgramNote.substr(2), taking}), joined({kSenderNote.substr(2), sender}),
      joined({kCycleNote.substr(2), fixedText(1000.0 * cycleS, 3), " ms"})};
  std::ranges::copy(headLines(input), std::back_inserter(head));
  head.push_back(outputsNote(input.tooling));
  WrittenRows rows = writeRows(input, kId, head, mxtShare, ctx);
  if (const std::size_t count = mxtPacketCount(rows.rows, cycleS); count > kMaxPackets)
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("a stream of {count} packets is too large for a file"_text, count), {},
        "use melfa"_text);
  plan::Program program;
  program.format = kId;
  program.files = {{name + ".rows", std::move(rows.text)},
                   {packets, mxtPackets(rows.rows, cycleS)},
                   {taking, programText(input, rows.rows.front())},
                   {sender, std::string(kSender)}};
  return program;
}

plan::ReadProgram readMelfaStream(const std::vector<plan::ProgramFile>& files,
                                  const process::Tooling& tooling, const base::RunContext& ctx) {
  ProgramBuilder out(kId, tooling);
  const auto isBeside = [](std::string_view text) {
    return isMxtPackets(text) || text.starts_with("#!") ||
           text.substr(0, 16384).find(kTakes) != std::string_view::npos;
  };
  RowsRead rows;
  double cycleS = kCr750S;
  std::size_t streams = 0;
  for (out.file = 0; out.file < files.size(); ++out.file) {
    const std::string_view text = files[out.file].text;
    if (isBeside(text))
      continue;
    out.line = 1;
    if (++streams > 1)
      out.defect("a second stream"_text);
    else
      rows = readRows(text, {kMelfaStartPercent / 100.0 * kMelfaJointRadPerS, kStartRadPerS2}, out,
                      ctx);
    cycleS = cycleOf(text);
  }
  const std::optional<JointRow> start =
      rows.rows.empty() ? std::nullopt : std::optional(rows.rows.front());
  for (out.file = 0; out.file < files.size(); ++out.file) {
    const std::string_view text = files[out.file].text;
    out.line = 1;
    if (!isBeside(text))
      continue;
    if (text.starts_with("#!"))
      reportOtherText(text, kSender, 1, out);
    else if (!isMxtPackets(text))
      readTaking(text, start, out);
    else if (mxtPacketCount(rows.rows, cycleS) <= kMaxPackets)
      readPackets(text, mxtPackets(rows.rows, cycleS), out);
  }
  return out.take(rows.complete);
}

bool looksLikeMelfaStream(std::string_view text) {
  return looksLikeRows(text) && text.substr(0, 16384).find(kTitle) != std::string_view::npos;
}

std::vector<std::string> filesOfMelfaStream(std::string_view text) {
  return namesBehind(text, {kPacketsNote, kProgramNote, kSenderNote});
}

} // namespace voluta::program
