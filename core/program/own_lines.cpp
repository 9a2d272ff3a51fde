#include "program/own_lines.h"

#include "base/error.h"
#include "program/bead_words.h"
#include "program/common/program_text.h"
#include "program/refused_statements.h"
#include "program/tmscript/tmscript_frames.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::program {

namespace {
using plan::EventKind, plan::TrajectoryEvent;

constexpr std::string_view kCover = "own line: ";
constexpr std::string_view kFrame = "$TMSCT,";

std::string numbered(std::string_view words, int number) {
  const std::size_t at = words.find("{}");
  if (at == std::string_view::npos)
    return std::string(words);
  return joined({words.substr(0, at), std::to_string(number), words.substr(at + 2)});
}

constexpr OutputWords kGcodeOutputs{.on = "M42 P{} S255",
                                    .off = "M42 P{} S0",
                                    .name = "M42 P{} ",
                                    .first = 0,
                                    .last = 999,
                                    .settles = kGcodeSettles};
struct OutputRow {
  std::string_view dialect;
  OutputWords words;
};
// Numbers are those of the controller; where no text tells them from the program's own outputs,
// they begin behind these.
constexpr OutputRow kOutputs[] = {
    {"urscript",
     {.on = "set_standard_digital_out({},True)",
      .off = "set_standard_digital_out({},False)",
      .name = "set_standard_digital_out({},",
      .first = 0,
      .last = 7}},
    {"gcode-extended", kGcodeOutputs},
    {"gcode", kGcodeOutputs},
    {"rapid", {.on = "SetDO doOut{},1;", .off = "SetDO doOut{},0;", .first = 1, .last = 999}},
    {"krl",
     {.on = "$OUT[{}]=TRUE",
      .off = "$OUT[{}]=FALSE",
      .name = "$OUT[{}]",
      .first = 1,
      .last = 4095,
      .settles = kKrlSettles}},
    {"spel", {.on = "On {}", .off = "Off {}", .first = 12, .last = 511}},
    {"melfa", {.on = "M_Out({})=1", .off = "M_Out({})=0", .first = 32, .last = 255}},
    {"tmscript",
     {.on = "IO[\"ControlBox\"].DO[{}]=1",
      .off = "IO[\"ControlBox\"].DO[{}]=0",
      .name = ".DO[{}]",
      .first = 0,
      .last = 15,
      .settles = kTmSettles}}};

bool isOwnLine(const TrajectoryEvent& event) {
  return event.kind == EventKind::Output || event.kind == EventKind::Statement;
}

bool isOfOtherFormat(std::string_view dialect, const TrajectoryEvent& event) {
  return event.kind == EventKind::Statement && event.format != dialect;
}

// Takes a line, with its end, from the beginning of a text.
std::string_view takeLine(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end);
  return line;
}

// Returns the text of a remark; nullopt if the line is none.
std::optional<std::string_view> remarkIn(std::string_view line, std::string_view remark) {
  std::string_view code = codeOfLine(line);
  if (!code.starts_with(remark))
    return std::nullopt;
  return trimmed(code.substr(remark.size()));
}

// A line as its reader is to see it: a remark, or a frame that does nothing.
struct Covered {
  std::string line, code;
};
// Returns the code of a line; of a frame, its script.
std::string codeIn(std::string_view line) {
  const std::string_view code = codeOfLine(line);
  if (!code.starts_with(kFrame))
    return std::string(code);
  return std::string(
      takeTmFrame(line.substr(static_cast<std::size_t>(code.data() - line.data()))).script);
}
Covered covered(std::string_view line, std::string_view remark) {
  const std::string_view code = codeOfLine(line);
  const auto at = static_cast<std::size_t>(code.data() - line.data());
  if (code.starts_with(kFrame)) {
    const TmFrame frame = takeTmFrame(line.substr(at));
    if (!frame.sound || frame.script.find('\n') != std::string_view::npos)
      return {std::string(line), std::string(code)}; // the reader tells why
    return {joined({line.substr(0, at), tmFrame(frame.id, "QueueTag(2)")}),
            std::string(frame.script)};
  }
  return {joined({line.substr(0, at), remark, " ", line.substr(at)}), std::string(code)};
}

// The variables that the user's statements set; programs in G-code have none.
std::vector<std::string> namesSet(std::string_view dialect,
                                  const std::vector<TrajectoryEvent>& events) {
  std::vector<std::string> names;
  if (dialect.starts_with("gcode"))
    return names;
  for (const TrajectoryEvent& event : events)
    if (event.kind == EventKind::Statement)
      std::ranges::move(assignedNames(event.text), std::back_inserter(names));
  return names;
}
// Throws Error{Usage} if the program's line has one of them.
void requireOthers(std::string_view line, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (hasName(line, name))
      throw base::Error(base::ErrorCode::Usage,
                        base::message("a statement of your own sets '{name}', which the program "
                                      "uses itself"_text,
                                      name),
                        {}, "use another name"_text);
}
} // namespace

OutputWords outputWords(std::string_view dialect) {
  const auto* const row = std::ranges::find(kOutputs, dialect, &OutputRow::dialect);
  return row == std::end(kOutputs) ? OutputWords() : row->words;
}

std::string ownLine(std::string_view dialect, const TrajectoryEvent& event) {
  if (event.kind == EventKind::Statement)
    return std::string(trimmed(event.text));
  const OutputWords words = outputWords(dialect);
  return numbered(event.on ? words.on : words.off, event.tool);
}

void requireOwnLine(std::string_view dialect, const TrajectoryEvent& event,
                    const plan::Trajectory& trajectory) {
  if (isOfOtherFormat(dialect, event)) {
    const auto hasOwn = [&](const TrajectoryEvent& other) {
      return other.kind == EventKind::Statement && other.format == dialect;
    };
    if (std::ranges::any_of(trajectory.eventsBefore(event.point), hasOwn))
      return;
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("the statement '{text}' is one of format {wanted}, not of "
                      "{format}"_text,
                      event.text, event.format, dialect),
        {},
        base::message("add a statement for {format} at that place, or use {formats}"_text, dialect,
                      event.format));
  }
  if (event.kind == EventKind::Statement)
    if (const auto refused = refusedWord(dialect, event.text))
      throw base::Error(base::ErrorCode::Usage,
                        base::message("'{word}' in the statement '{text}' {effect}"_text,
                                      refused->word, event.text, refused->effect),
                        {}, refused->instead);
  const OutputWords words = outputWords(dialect);
  if (event.kind == EventKind::Output && words.last >= words.first &&
      (event.tool < words.first || event.tool > words.last))
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("format {format} has outputs {first} to {last}, not {number}"_text, dialect,
                      words.first, words.last, event.tool),
        {}, "use another output"_text);
}

std::shared_ptr<const plan::Trajectory>
withOwnStatements(std::string_view dialect, std::shared_ptr<const plan::Trajectory> trajectory) {
  const auto isOther = [&](const TrajectoryEvent& event) {
    return isOfOtherFormat(dialect, event);
  };
  if (std::ranges::none_of(trajectory->events, isOther))
    return trajectory;
  auto own = std::make_shared<plan::Trajectory>(*trajectory);
  std::erase_if(own->events, isOther);
  return own;
}

std::string ownLineRemark(std::string_view line) {
  return joined({kCover, line});
}

void uncoverOwnLines(std::vector<plan::ProgramFile>& files, std::string_view dialect,
                     std::string_view remark, const std::vector<TrajectoryEvent>& events) {
  if (std::ranges::none_of(events, isOwnLine))
    return;
  const std::string cover = joined({remark, " ", kCover});
  const std::vector<std::string> set = namesSet(dialect, events);
  const std::string_view name = outputWords(dialect).name;
  for (plan::ProgramFile& file : files) {
    std::string text;
    text.reserve(file.text.size());
    bool isMarked = false;
    for (std::string_view rest = file.text; !rest.empty();) {
      const std::string_view line = takeLine(rest);
      const std::size_t at = line.find(cover);
      const std::optional<std::string_view> said = remarkIn(line, remark);
      if (!said && !isMarked)
        requireOthers(line, set);
      if (!said && !isMarked && !name.empty())
        for (const TrajectoryEvent& event : events)
          if (event.kind == EventKind::Output &&
              line.find(numbered(name, event.tool)) != std::string_view::npos)
            throw base::Error(
                base::ErrorCode::Usage,
                base::message("output {number} is used by the program itself"_text, event.tool), {},
                "use another output"_text);
      isMarked = said == kOwnLineMark;
      if (at == std::string_view::npos)
        text.append(line);
      else
        text.append(line.substr(0, at)).append(line.substr(at + cover.size()));
    }
    file.text = std::move(text);
  }
}

ReadOwnLines takeOwnLines(const std::vector<plan::ProgramFile>& files, std::string_view dialect,
                          std::string_view remark) {
  ReadOwnLines read;
  if (std::ranges::none_of(files, [](const plan::ProgramFile& file) {
        return file.text.find(kOwnLineMark) != std::string::npos;
      }))
    return read;
  read.files = files;
  const std::string_view settles = outputWords(dialect).settles;
  for (std::size_t f = 0; f < files.size(); ++f) {
    std::string text;
    text.reserve(files[f].text.size());
    std::uint32_t number = 0;
    bool isMarked = false;
    std::string_view before; // the line before
    for (std::string_view rest = files[f].text; !rest.empty();) {
      const std::string_view line = takeLine(rest);
      ++number;
      if (!isMarked || codeOfLine(line).empty()) {
        text.append(line);
        isMarked = remarkIn(line, remark) == kOwnLineMark;
        if (isMarked && !settles.empty() && codeIn(before) != settles)
          read.defects.push_back(
              {f, number,
               base::message(
                   "'{code}' is missing before the line: it would run ahead of the arm"_text,
                   settles)});
        before = line;
        continue;
      }
      isMarked = false;
      before = line;
      Covered own = covered(line, remark);
      text.append(own.line);
      plan::StatedFact fact;
      fact.kind = plan::FactKind::OwnStatement;
      fact.file = static_cast<std::uint32_t>(f);
      fact.line = number;
      fact.number = 1.0;
      fact.word = std::move(own.code);
      read.facts.push_back(std::move(fact));
    }
    read.files[f].text = std::move(text);
  }
  return read;
}

} // namespace voluta::program
