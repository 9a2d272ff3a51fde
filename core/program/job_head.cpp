#include "program/job_head.h"

#include "base/ascii_text.h"
#include "base/units.h"
#include "plan/marks.h"
#include "program/common/extruder_outputs.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/extruder.h"
#include "program/stream/extruder_stream.h"
#include "robot/tool_changer.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>

namespace voluta::program {

namespace {

// FNV-1a, 64 bits (Fowler, Noll, Vo).
class Hash {
public:
  void add(std::uint64_t word) {
    for (int k = 0; k < 8; ++k, word >>= 8)
      value_ = (value_ ^ (word & 0xffU)) * 0x100000001b3U;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); } // avoids -0
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text)
      add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::string hex() const {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4)
      text.push_back(kDigits[(value_ >> shift) & 0xfU]);
    return text;
  }

private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

constexpr std::string_view kPart = "part ", kJob = ", job ", kCell = "cell ", kRobot = ", robot ",
                           kProcess = ", process ";
constexpr std::size_t kHashDigits = 16;

// Parses "PART, job HASH"; a part may have any name.
bool takePart(std::string_view text, JobHead& head) {
  const std::size_t at = text.rfind(kJob);
  if (at == std::string_view::npos)
    return false;
  const std::string_view job = text.substr(at + kJob.size(), kHashDigits);
  const auto isDigit = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
  if (job.size() != kHashDigits || !std::all_of(job.begin(), job.end(), isDigit))
    return false;
  head.part = text.substr(0, at);
  head.job = job;
  return true;
}

// Parses "CELL, robot ROBOT, process PROCESS (MATERIAL)".
bool takeCell(std::string_view text, JobHead& head) {
  const std::size_t robot = text.find(kRobot), process = text.find(kProcess);
  if (robot == std::string_view::npos || process == std::string_view::npos || process < robot)
    return false;
  head.cell = text.substr(0, robot);
  head.robot = text.substr(robot + kRobot.size(), process - robot - kRobot.size());
  head.process = text.substr(process + kProcess.size());
  head.process = head.process.substr(0, head.process.find(" ("));
  return true;
}

} // namespace

int plateC(const ProgramInput& input) {
  // A rest may not use the tool that decided when the part was begun.
  int tool = input.tooling.usedAfter(input.trajectory, 0).front();
  for (const plan::ToolPath& path : input.toolPlan.paths)
    tool = std::min(tool, path.tool);
  return input.tooling.at(tool).process.material.bedC.value_or(0);
}

namespace {
// Returns e.g. "Nozzle 210 C, plate 60 C"; empty if no temperature is known.
std::string heatText(const ProgramInput& input, std::string_view unit) {
  std::string nozzles, text;
  std::size_t count = 0;
  for (const int tool : input.tooling.usedAfter(input.trajectory, 0))
    if (const std::optional<int> celsius = input.tooling.at(tool).process.material.nozzleC) {
      nozzles += joined({count++ > 0 ? ", " : "", std::to_string(*celsius)});
    }
  if (count > 0)
    text = joined({count > 1 ? "Nozzles " : "Nozzle ", nozzles, unit});
  if (const int bed = plateC(input); bed > 0)
    text += joined({text.empty() ? "Plate " : ", plate ", std::to_string(bed), unit});
  return text;
}

std::string heatLine(const ProgramInput& input) {
  std::string text = heatText(input, " degrees C");
  const process::Material& material = input.process().material;
  if (!text.empty() && material.fan > 0.0)
    text += joined({", fan ", fixedText(100.0 * material.fan, 0), " % from layer 2 on"});
  return text;
}

bool hasEvent(const ProgramInput& input, plan::EventKind kind) {
  const auto& events = input.trajectory.events;
  return std::ranges::find(events, kind, &plan::TrajectoryEvent::kind) != events.end();
}

} // namespace

std::string toolName(const process::Tooling& tooling, int tool) {
  constexpr std::size_t kMaxNameLength = 16; // so that questions with it are short enough
  const process::Process& process = tooling.at(tool).process;
  std::string text =
      joined({"tool ", std::to_string(tool + 1), " (", plainText(process.id, kMaxNameLength), ", ",
              plainText(process.material.label, kMaxNameLength)});
  if (process.material.nozzleC)
    text += joined({", ", std::to_string(*process.material.nozzleC), " C"});
  return text + ")";
}

std::string pauseText(const plan::TrajectoryEvent& pause) {
  if (pause.text.empty())
    return "Paused. Continue?";
  constexpr std::string_view kCheck = ". Check the way, then continue.";
  const bool hasRoom = pause.text.size() + kCheck.size() <= kQuestionLength;
  return plainText(hasRoom ? joined({pause.text, kCheck}) : pause.text, kQuestionLength);
}

std::string changeText(const process::Tooling& tooling, int tool) {
  return joined({"Fit ", toolName(tooling, tool), ", then continue"});
}

namespace {
// The outputs that the program sets for its tools.
std::vector<int> usedOutputs(const ProgramInput& input) {
  std::vector<int> outputs;
  if (input.selectsTool())
    for (int tool = 1; tool < static_cast<int>(input.tooling.tools().size()); ++tool)
      outputs.push_back(tool);
  if (locksTool(input))
    outputs.push_back(kChangerOutput);
  if (hasEvent(input, plan::EventKind::Mark))
    for (const int signal : plan::markSignalsOf(input.trajectory))
      outputs.push_back(kMarkOutput + signal);
  return outputs;
}

std::string otherMachine(int channel) {
  return channel == 0 ? std::string("the other machine")
                      : joined({"the other machine on channel ", std::to_string(channel + 1)});
}

std::string outputName(const ProgramInput& input, int output) {
  if (output >= kMarkOutput)
    return joined({"signal ", std::to_string((output - kMarkOutput) % 2 + 1), " for ",
                   otherMachine((output - kMarkOutput) / 2), ", its input there"});
  return output == kChangerOutput ? std::string("tool changer locked")
                                  : toolName(input.tooling, output);
}
} // namespace

std::vector<std::string> toolOutputs(const ProgramInput& input,
                                     const std::function<std::string(int)>& output) {
  std::vector<std::string> names;
  for (const int used : usedOutputs(input))
    names.push_back(output(used));
  return names;
}

std::vector<std::string> toolNotes(const ProgramInput& input,
                                   const std::function<std::string(int)>& output) {
  std::vector<std::string> notes;
  for (const int used : usedOutputs(input))
    notes.push_back(joined({outputName(input, used), ": ", output(used)}));
  return notes;
}

std::optional<std::string_view> behindMark(std::string_view line, std::string_view word) {
  const std::size_t at = line.find(word);
  const auto isMark = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) == 0; };
  if (at == std::string_view::npos ||
      !std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(at), isMark))
    return std::nullopt;
  return line.substr(at + word.size());
}

std::string plainText(std::string_view text, std::size_t maxLength) {
  std::string plain = base::asciiText(text);
  plain.resize(std::min(plain.size(), maxLength));
  std::ranges::replace_if(
      plain, [](char c) { return c == '"' || c == '\\'; }, '_');
  return plain;
}

std::string jobHash(const ProgramInput& input) {
  const plan::Trajectory& t = input.trajectory;
  Hash hash;
  for (const std::string& id : {input.cell.id(), input.cell.robot().id, input.process().id})
    hash.add(std::string_view(id));
  for (const double joint : t.joints)
    hash.add(joint);
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    hash.add(t.timeS[i]);
    hash.add(t.extrudedMm3[i]);
    hash.add(static_cast<std::uint64_t>(t.move[i]));
  }
  for (const plan::TrajectoryEvent& event : t.events) {
    hash.add(static_cast<std::uint64_t>(event.point));
    hash.add(event.seconds);
    if (event.kind == plan::EventKind::ToolChange)
      hash.add(static_cast<std::uint64_t>(event.tool));
    if (event.kind == plan::EventKind::Output)
      hash.add(static_cast<std::uint64_t>(2 * event.tool + (event.on ? 1 : 0)));
    for (const std::string& text : {event.text, event.format})
      if (!text.empty())
        hash.add(std::string_view(text));
  }
  if (t.firstTool != 0)
    hash.add(static_cast<std::uint64_t>(t.firstTool));
  return hash.hex();
}

JobHead jobHead(const ProgramInput& input) {
  return {plainText(input.name), input.job.empty() ? jobHash(input) : input.job,
          plainText(input.cell.id()), plainText(input.cell.robot().id),
          plainText(input.process().id)};
}

std::optional<JobHead> readJobHead(const std::vector<plan::ProgramFile>& files) {
  for (const plan::ProgramFile& file : files) {
    JobHead head;
    LineReader lines(file.text);
    for (std::string_view line; lines.number() < kHeadLines && lines.next(line);) {
      if (head.job.empty()) {
        if (const auto text = behindMark(line, kPart))
          takePart(*text, head);
      } else if (const auto text = behindMark(line, kCell); text && takeCell(*text, head)) {
        break;
      }
    }
    if (!head.job.empty())
      return head;
  }
  return std::nullopt;
}

bool replaceVerdict(std::vector<plan::ProgramFile>& files, std::string_view verdict,
                    std::size_t longestLine) {
  constexpr std::size_t kMaxLength = 240; // readable, and within every controller's line
  bool isReplaced = false;
  for (plan::ProgramFile& file : files) {
    LineReader lines(file.text);
    for (std::string_view line; lines.number() < kHeadLines && lines.next(line);) {
      const std::optional<std::string_view> old = behindMark(line, kVerdictMark);
      if (!old)
        continue;
      const std::size_t before = line.size() - old->size();
      const std::size_t room = longestLine > before ? longestLine - before : kMaxLength;
      const auto at = static_cast<std::size_t>(old->data() - file.text.data());
      file.text.replace(at, old->size(), plainText(verdict, std::min(room, kMaxLength)));
      isReplaced = true;
      break;
    }
  }
  return isReplaced;
}

std::string fittedQuestion(const ProgramInput& input) {
  const bool isFed = input.cell.toolChange().by == robot::ToolChange::By::Feeder;
  return joined({"Is ", toolName(input.tooling, input.trajectory.firstTool),
                 isFed ? " selected" : " fitted"});
}

namespace {
// Names the tool, which an operator may have to fit first, also before the rest of a print.
std::string toolQuestion(const ProgramInput& input) {
  const std::string tool = fittedQuestion(input);
  std::string question = tool + " and the way clear?";
  if (const int bed = plateC(input); bed > 0) {
    std::string all =
        joined({tool, ", the plate at ", std::to_string(bed), " C and the way clear?"});
    if (all.size() <= kQuestionLength)
      question = std::move(all);
  }
  return question;
}
} // namespace

std::string startQuestion(const ProgramInput& input) {
  if (input.selectsTool())
    return toolQuestion(input);
  const std::string heat = heatText(input, " C");
  std::string question = joined({heat, "? The arm goes straight to its start. Is the way clear?"});
  if (heat.empty() || question.size() > kQuestionLength)
    return std::string(kStartQuestion);
  return question;
}

namespace {
std::vector<std::string> markLines(const ProgramInput& input) {
  if (!hasEvent(input, plan::EventKind::Mark))
    return {};
  return {"works together with other machines: start all programs, in any order, whatever their "
          "signals are",
          "each goes to its first point and waits there until the others are there; at its end "
          "its signals are off",
          "if one is stopped, stop all, and start all again from the beginning"};
}
} // namespace

std::vector<std::string> headLines(const ProgramInput& input) {
  const plan::Trajectory& t = input.trajectory;
  const process::Process& p = input.process();
  const double mm3 = t.extrudedMm3.back();
  double waitS = 0.0;
  for (const plan::TrajectoryEvent& event : t.events)
    waitS += event.seconds;
  const JobHead head = jobHead(input);
  std::vector<std::string> lines = {joined({kPart, head.part, kJob, head.job}),
                                    joined({kCell, head.cell, kRobot, head.robot, kProcess,
                                            head.process, " (", plainText(p.material.label), ")"})};
  if (!input.verdict.empty())
    lines.push_back(joined({kVerdictMark, input.verdict}));
  lines.push_back(joined({std::to_string(t.pointCount()), " motions, ", fixedText(mm3, 1), " mm3, ",
                          fixedText(input.tooling.printedG(t), 1), " g, ",
                          fixedText(t.timeS.back() + waitS, 1), " s"}));
  if (std::string heat = heatLine(input); !heat.empty())
    lines.push_back(std::move(heat));
  if (input.selectsTool())
    lines.emplace_back("the tips of all tools are expected in one place, that of the TCP: no tool "
                       "has an offset of its own");
  if (extruderOf(input).streams)
    lines.push_back(joined({kStreamNote, streamName(input),
                            ", played from each moment on at which the extruder's output goes "
                            "on; the analogue one stays at 0"}));
  for (std::string& line : markLines(input))
    lines.push_back(std::move(line));
  if (input.foreign)
    return lines;
  // If all joints are revolute, the unit is stated once.
  std::string slides;
  for (std::size_t k = 0; k < input.cell.limits().size(); ++k)
    if (input.cell.limits()[k].kind == robot::JointKind::Sliding)
      slides += joined({", joint ", std::to_string(k + 1), " mm"});
  std::string range = joined({"joints go, degrees", slides, ":"}),
              start = joined({"starts at joints, degrees", slides, ":"});
  for (int k = 0; k < t.dof; ++k) {
    double low = t.at(0)[k], high = low;
    for (std::size_t i = 1; i < t.pointCount(); ++i) {
      low = std::min(low, t.at(i)[k]);
      high = std::max(high, t.at(i)[k]);
    }
    const std::string_view comma = k > 0 ? ", " : " ";
    const auto shown = [&](double value) {
      return fixedText(
          robot::shownValue(input.cell.limits()[static_cast<std::size_t>(k)].kind, value), 1);
    };
    range += joined({comma, shown(low), " to ", shown(high)});
    start += joined({comma, shown(t.at(0)[k])});
  }
  start += "; the first motion goes there slowly and straight from wherever the arm stands";
  lines.push_back(std::move(range));
  lines.push_back(std::move(start));
  return lines;
}

std::vector<std::string> headLines(const ProgramInput& input, std::size_t maxLength) {
  constexpr std::size_t kNamed = 2; // number of lines with names
  std::vector<std::string> lines;
  for (const std::string& whole : headLines(input)) {
    if (lines.size() < kNamed) {
      lines.push_back(whole.substr(0, maxLength));
      continue;
    }
    std::string_view rest = whole;
    while (rest.size() > maxLength) {
      const std::size_t blank = rest.rfind(' ', maxLength);
      const std::size_t end = blank == std::string_view::npos || blank == 0 ? maxLength : blank;
      lines.emplace_back(rest.substr(0, end));
      rest = trimmed(rest.substr(end));
    }
    lines.emplace_back(rest);
  }
  return lines;
}

bool locksTool(const ProgramInput& input) {
  return robot::hasChanger(input.cell) || hasEvent(input, plan::EventKind::Lock);
}

bool cutsTape(const ProgramInput& input) {
  return hasEvent(input, plan::EventKind::Cut);
}

} // namespace voluta::program
