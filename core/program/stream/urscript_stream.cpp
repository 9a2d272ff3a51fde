#include "program/stream/urscript_stream.h"

#include "program/common/extruder_outputs.h"
#include "program/common/language_words.h"
#include "program/common/program_text.h"
#include "program/common/same_text.h"
#include "program/common/tcp_motions.h"
#include "program/common/text_rows.h"
#include "program/full_flow.h"
#include "program/job_head.h"
#include "program/program_builder.h"
#include "program/stream/joint_rows_writer.h"
#include "program/stream/urscript_stream_texts.h"
#include "program/urscript/urscript.h"

#include <Eigen/Core>
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kId = "urscript-stream", kTitle = "joint stream, URScript",
                           kReceiverNote = "# received by ", kSenderNote = "# sent by ",
                           kPayload = "set_payload(";
constexpr double kStartRadPerS2 = 0.5; // the receiver's value

std::string receiverName(const ProgramInput& input) {
  return identifierOf(input.name) + "_receiver.script";
}
std::string senderName(const ProgramInput& input) {
  return identifierOf(input.name) + "_sender.py";
}

std::string receiver(const ProgramInput& in) {
  std::string text = joined({"def ", programName(in.name), "_receiver():\n",
                             "  # for port 30002, sent by ", senderName(in), "\n"});
  for (const std::string& head : headLines(in))
    text += joined({"  # ", head, "\n"});
  text += joined({"  ", kPayload, fixedText(assumedLoadKg(in), 3), ",["});
  const Eigen::Isometry3d& tcp = in.cell.flange_T_moved();
  for (int k = 0; k < 3; ++k)
    text += joined({k > 0 ? "," : "", fixedText(tcp.translation()[k] / 1000.0, 4)});
  return text + joined({"]) # assumed: ", assumedLoadText(in), "\n", urscriptReceiver()});
}

bool isReceiver(std::string_view text) {
  return text.find(urscriptReceiverBegin()) != std::string_view::npos || text.starts_with("def ");
}

// Parses ",[x,y,z]" in metres.
std::optional<Eigen::Vector3d> takeCentre(std::string_view rest) {
  Eigen::Vector3d metres;
  for (int k = 0; k < 3; ++k) {
    const std::string_view mark = k == 0 ? ",[" : ",";
    if (!rest.starts_with(mark))
      return std::nullopt;
    rest.remove_prefix(mark.size());
    if (!takeNumber(rest, metres[k]))
      return std::nullopt;
  }
  return 1000.0 * metres;
}

// Parses the head: a name, remarks and the load; everything else is the same for every job.
void readReceiver(std::string_view text, ProgramBuilder& out) {
  const std::size_t body = text.find(urscriptReceiverBegin());
  LineReader head(text.substr(0, body));
  for (std::string_view line; head.next(line);) {
    out.line = head.number();
    line = trimmed(line);
    if (line.empty() || line.front() == '#' || (out.line == 1 && line.starts_with("def ")))
      continue;
    double kg = 0.0;
    std::string_view rest = line.substr(std::min(kPayload.size(), line.size()));
    if (line.starts_with(kPayload) && takeNumber(rest, kg))
      out.load(kPayload.substr(0, kPayload.size() - 1), kg, takeCentre(rest));
    else
      out.defect(base::message("not understood: '{code}'"_text, line.substr(0, 60)));
  }
  if (body == std::string_view::npos) {
    out.defect("this is not the program that receives a stream"_text);
    return;
  }
  if (!out.program().load) {
    out.line = head.number() + 1;
    out.defect("the payload is not set"_text);
  }
  reportOtherText(text.substr(body), urscriptReceiver(), head.number() + 1, out);
}

} // namespace

plan::Program writeUrscriptStream(const ProgramInput& input, const base::RunContext& ctx) {
  std::vector<std::string> head = {std::string(kTitle),
                                   joined({kReceiverNote.substr(2), receiverName(input)}),
                                   joined({kSenderNote.substr(2), senderName(input)})};
  std::ranges::copy(headLines(input), std::back_inserter(head));
  head.push_back(joined(
      {"extruder: digital output 0; flow: analogue output 0, ", fullFlowText("1", input.tooling)}));
  plan::Program program;
  program.format = kId;
  program.files = {
      {identifierOf(input.name) + ".joints", writeRows(input, kId, head, writtenShare, ctx).text},
      {receiverName(input), receiver(input)},
      {senderName(input), std::string(urscriptSender())}};
  return program;
}

plan::ReadProgram readUrscriptStream(const std::vector<plan::ProgramFile>& files,
                                     const process::Tooling& tooling, const base::RunContext& ctx) {
  ProgramBuilder out(kId, tooling);
  bool complete = false, stream = false;
  for (out.file = 0; out.file < files.size(); ++out.file) {
    const std::string_view text = files[out.file].text;
    out.line = 1;
    if (text.starts_with("#!")) {
      reportOtherText(text, urscriptSender(), 1, out);
    } else if (isReceiver(text)) {
      readReceiver(text, out);
    } else if (std::exchange(stream, true)) {
      out.defect("a second stream"_text);
    } else {
      complete = readRows(text, {kStartRadPerS, kStartRadPerS2}, out, ctx).complete;
    }
  }
  return out.take(complete);
}

bool looksLikeUrscriptStream(std::string_view text) {
  const std::string_view head = text.substr(0, 16384);
  const bool another = head.find("joint stream, ") != std::string_view::npos &&
                       head.find(kTitle) == std::string_view::npos;
  return looksLikeRows(text) && !another;
}

std::vector<std::string> filesOfUrscriptStream(std::string_view text) {
  return namesBehind(text, {kReceiverNote, kSenderNote});
}

} // namespace voluta::program
