#include "program/krl/krl_eki.h"

#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/language_words.h"
#include "program/common/program_text.h"
#include "program/common/tcp_motions.h"
#include "program/common/text_rows.h"
#include "program/full_flow.h"
#include "program/job_head.h"
#include "program/krl/krl.h"
#include "program/krl/krl_eki_texts.h"
#include "program/krl/krl_motions.h"
#include "program/krl/krl_text.h"
#include "program/krl/krl_values.h"
#include "program/stream/link_files.h"

#include <algorithm>
#include <iterator>

namespace voluta::program {

namespace {

constexpr std::string_view kId = "krl-eki", kTitle = "lines for EthernetKRL, KRL",
                           kProgramNote = "# taken by ", kDataNote = "# with ",
                           kChannelNote = "# channel ", kSenderNote = "# sent by ",
                           kChannelBegins = "<ETHERNETKRL>";
constexpr LinkForm kForm{.header =
                             "X_mm,Y_mm,Z_mm,A_deg,B_deg,C_deg,mm_per_s,deg_per_s,flow,blend_mm",
                         .turns = true,
                         .inFrame = true,
                         .jointRadPerS = kKrlPtpDegPerS * base::kPi / 180.0,
                         .mmDecimals = kKrlMmDecimals,
                         .degDecimals = kKrlDegDecimals,
                         .frameDecimals = kKrlFrameDecimals,
                         .pose = krlPose};

LinkFrame frameOf(const Eigen::Isometry3d& pose) {
  return linkFrame(pose.translation(), zyxDegrees(Eigen::Quaterniond(pose.linear())), kForm);
}
Eigen::Vector3d mmOf(const LinkFrame& frame) {
  return Eigen::Vector3d(frame.data());
}
std::string frameText(const LinkFrame& frame) {
  return krlFrameText(mmOf(frame), Eigen::Vector3d(frame.data() + 3));
}

std::string startText(const LinkRow& start) {
  if (start.blend != kLinkByJoints)
    return frameText(start.target);
  std::string text;
  for (std::size_t k = 0; k < start.target.size(); ++k)
    text += joined({k > 0 ? ",A" : "{A", std::to_string(k + 1), " ",
                    fixedText(start.target[k], kKrlFrameDecimals)});
  return text + "}";
}

// ---- KRL program that receives the lines, one statement per line

std::vector<std::string> programLines(const Link& link, std::string_view channel,
                                      const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = {"&ACCESS RVP", "&REL 1", joined({"DEF ", channel, " ( )"}),
                                    "DECL EKI_STATUS RET"};
  for (const std::string& remark : remarks)
    lines.push_back(joined({"; ", remark}));
  lines.insert(lines.end(), kKrlInit.begin(), kKrlInit.end());
  const auto add = [&](std::initializer_list<std::string> more) {
    std::ranges::copy(more, std::back_inserter(lines));
  };
  const LinkFrame load = link.load.value_or(LinkFrame{});
  add({"$ADVANCE=5", link.nozzle ? "$IPO_MODE=#TCP" : "$IPO_MODE=#BASE",
       joined({"$BASE=", frameText(link.nozzle ? *link.nozzle : link.base.value_or(LinkFrame{}))}),
       joined({"$TOOL=", frameText(link.tool)}),
       joined({"$LOAD=", krlLoadText(load[0], {load[1], load[2], load[3]})}),
       joined({"$ACC.CP=", fixedText(kKrlMaxMmPerS2 / 1000.0, 2)}), "$OUT[1]=FALSE", "$ANOUT[1]=0",
       "HELD=0", "FEEDS=FALSE", "SLOT=1", "TAKEN=0", "UNTOLD=0", joined({"; ", kStartQuestion}),
       "HALT", joined({"BAS (#VEL_PTP,", fixedText(link.start.speed, 2), ")"}),
       joined({"PTP ", startText(link.start)})});
  std::ranges::copy(linesFor(krlEkiLoop(link.start.blend == kLinkByJoints), channel),
                    std::back_inserter(lines));
  return lines;
}

std::vector<std::string> dataLines(std::string_view channel) {
  std::vector<std::string> lines = {"&ACCESS RVP", "&REL 1",
                                    joined({"DEFDAT ", channel, " PUBLIC"})};
  std::ranges::copy(linesFor(krlEkiData(), channel), std::back_inserter(lines));
  lines.emplace_back("ENDDAT");
  return lines;
}

std::string textOf(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    text += joined({line, "\r\n"});
  return text;
}

std::vector<std::string> remarksFor(const ProgramInput& in) {
  std::vector<std::string> remarks = {"Takes lines by EthernetKRL"};
  std::ranges::copy(headLines(in), std::back_inserter(remarks));
  remarks.push_back(joined(
      {"extruder on: $OUT[1]; flow: $ANOUT[1], ", fullFlowText("1", in.tooling), ", 0 to 10 V"}));
  remarks.push_back(joined({"carries, assumed: ", assumedLoadText(in)}));
  if (in.cell.nozzleMount() == robot::Mount::World)
    remarks.emplace_back("fixed nozzle: $BASE is the nozzle, $TOOL the work frame on the flange");
  remarks.emplace_back("the channel's .xml belongs in Config/User/Common/EthernetKRL of the "
                       "controller, with its address; the robot serves");
  return remarks;
}

// ---- reading

std::string codeOfKrl(std::string_view line) {
  return std::string(codeOf(line, kKrlSyntax));
}
bool isData(std::string_view text) {
  return text.substr(0, 1024).find("DEFDAT") != std::string_view::npos;
}
bool isTaking(std::string_view text) {
  return looksLikeKrl(text);
}
// Returns the name after DEF or DEFDAT.
std::string nameIn(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    line = trimmed(line);
    for (const std::string_view word : {"DEFDAT ", "DEF "})
      if (line.starts_with(word)) {
        const std::string_view rest = trimmed(line.substr(word.size()));
        return std::string(rest.substr(0, std::min(rest.find_first_of(" ("), rest.size())));
      }
  }
  return {};
}
void readTaking(std::string_view text, const Link& link, ProgramBuilder& out) {
  const std::string name = nameIn(text);
  std::vector<std::string> steps;
  for (const std::string& line : isData(text) ? dataLines(name) : programLines(link, name, {}))
    if (std::string code = codeOfKrl(line); !code.empty())
      steps.push_back(std::move(code));
  reportOtherSteps(text, steps, codeOfKrl, kOtherTaking, out);
}

bool isChannel(std::string_view text) {
  return text.substr(0, 1024).find(kChannelBegins) != std::string_view::npos;
}
// Removes address and port, which the user sets.
std::string codeOfChannel(std::string_view line) {
  std::string code(trimmed(line));
  for (const std::string_view name : {"<IP>", "<PORT>"})
    if (code.starts_with(name)) {
      const std::size_t end = code.find_first_not_of("0123456789.", name.size());
      code.erase(name.size(), std::min(end, code.size()) - name.size());
    }
  return code.starts_with("<!--") && code.ends_with("-->") ? std::string() : code;
}
void readChannel(std::string_view text, const Link&, ProgramBuilder& out) {
  std::vector<std::string> steps;
  for (const std::string& line : linesFor(krlEkiChannel(), ""))
    steps.push_back(codeOfChannel(line));
  reportOtherSteps(text, steps, codeOfChannel, kOtherTaking, out);
}

} // namespace

const LinkForm& krlLinkForm() {
  return kForm;
}

plan::Program writeKrlEki(const ProgramInput& input, const base::RunContext& ctx) {
  const KrlMotions motions(input, ctx);
  const std::string name = identifierOf(input.name), channel = krlName(input.name) + "_eki",
                    sender = name + "_eki.py";
  LinkHead head{kId,
                {std::string(kTitle), joined({kProgramNote.substr(2), channel, ".src"}),
                 joined({kDataNote.substr(2), channel, ".dat"}),
                 joined({kChannelNote.substr(2), channel, ".xml"}),
                 joined({kSenderNote.substr(2), sender})},
                {}};
  if (input.foreign)
    head.remarks.emplace_back(
        "FOREIGN: not the language of the cell's controller; Cartesian targets only");
  std::ranges::copy(headLines(input), std::back_inserter(head.remarks));
  const Eigen::Isometry3d& moved = input.cell.flange_T_moved();
  head.frames.tool = frameOf(moved);
  if (input.cell.nozzleMount() == robot::Mount::World)
    head.frames.nozzle = frameOf(input.cell.base_T_fixed());
  else
    head.frames.base = frameOf(input.cell.base_T_work(
        Eigen::Map<const Eigen::VectorXd>(input.trajectory.at(0), input.trajectory.dof)));
  const Eigen::Vector3d& centre = moved.translation();
  head.frames.load = LinkFrame{roundedTo(assumedLoadKg(input), 3),
                               roundedTo(centre.x(), 1),
                               roundedTo(centre.y(), 1),
                               roundedTo(centre.z(), 1),
                               0.0,
                               0.0};
  LinkText lines = writeLinkRows(input, kForm, motions, head, ctx);
  plan::Program program;
  program.format = kId;
  program.foreign = input.foreign;
  program.files = {{name + ".eki", std::move(lines.text)},
                   {channel + ".src", textOf(programLines(lines.link, channel, remarksFor(input)))},
                   {channel + ".dat", textOf(dataLines(channel))},
                   {channel + ".xml", std::string(krlEkiChannel())},
                   {sender, std::string(krlEkiSender())}};
  return program;
}

plan::ReadProgram readKrlEki(const std::vector<plan::ProgramFile>& files,
                             const process::Tooling& tooling, const base::RunContext& ctx) {
  return readLinkFiles(kId, files, kForm, krlEkiSender(),
                       {{isTaking, readTaking}, {isChannel, readChannel}}, tooling, ctx);
}

bool looksLikeKrlEki(std::string_view text) {
  return looksLikeLinkRows(text, kForm);
}

std::vector<std::string> filesOfKrlEki(std::string_view text) {
  return namesBehind(text, {kProgramNote, kDataNote, kChannelNote, kSenderNote});
}

bool mayBeMissingInKrlEki(const std::vector<std::string>& lines, std::size_t i) {
  return isStandingLinkRow(lines, i, kForm);
}

} // namespace voluta::program
