#include "program/bead_words.h"

#include "base/error.h"
#include "plan/finding_kinds.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kMark = "statement of the process: ";

// Returns the kind of a statement; nullopt if no tool has it for the format.
std::optional<plan::FactKind> kindOf(std::string_view code, std::string_view format,
                                     const process::Tooling& tooling) {
  const auto has = [&](const std::vector<std::string>& statements) {
    return std::ranges::any_of(statements,
                               [&](const std::string& text) { return trimmed(text) == code; });
  };
  for (const process::Tool& tool : tooling.tools())
    if (const process::BeadWords* words = tool.process.wordsFor(format)) {
      if (has(words->start))
        return plan::FactKind::BeadStartWord;
      if (has(words->end))
        return plan::FactKind::BeadEndWord;
    }
  return std::nullopt;
}

// Calls change(line) for each line of a text, with its end, and replaces it by the result.
template <typename Change> void forEachLine(std::string& text, const Change& change) {
  std::string changed;
  changed.reserve(text.size());
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    change(std::string_view(text).substr(begin, end - begin), changed);
    begin = end;
  }
  text = std::move(changed);
}

} // namespace

std::string_view codeOfLine(std::string_view line) {
  constexpr std::string_view kBlanks = " \t", kDigits = "0123456789";
  const auto behind = [](std::string_view text, std::string_view skipped) {
    return text.substr(std::min(text.find_first_not_of(skipped), text.size()));
  };
  line = behind(line.substr(0, line.find_last_not_of("\r\n") + 1), kBlanks);
  const std::string_view rest = behind(line, kDigits);
  if (rest.size() < line.size() && rest.starts_with(' '))
    line = behind(rest, kBlanks);
  return trimmed(line);
}

std::string beadWordRemark(std::string_view statement) {
  return joined({kMark, statement});
}

void uncoverBeadWords(std::vector<plan::ProgramFile>& files, std::string_view remark) {
  const std::string marked = joined({remark, " ", kMark});
  for (plan::ProgramFile& file : files)
    if (file.text.find(kMark) != std::string::npos)
      forEachLine(file.text, [&](std::string_view line, std::string& out) {
        if (const std::size_t at = line.find(marked); at != std::string_view::npos)
          out.append(line.substr(0, at)).append(line.substr(at + marked.size()));
        else
          out.append(line);
      });
}

namespace {
// Returns whether a process has statements, but none for the format.
bool lacksWords(const process::Process& process, std::string_view format) {
  return !process.beadWords.empty() && !process.wordsFor(format);
}
bool isForceOnly(const process::Process& process) {
  return std::ranges::all_of(process.beadWords,
                             [](const process::BeadWords& words) { return words.isForce; });
}
std::string formatsWithWords(const process::Process& process) {
  std::string formats;
  for (const process::BeadWords& words : process.beadWords)
    formats += joined({formats.empty() ? "" : ", ", words.format});
  return formats;
}
} // namespace

std::optional<plan::Finding> withoutForce(std::string_view format,
                                          const process::Tooling& tooling) {
  for (const process::Tool& tool : tooling.tools())
    if (lacksWords(tool.process, format) && isForceOnly(tool.process))
      return plan::makeFinding(plan::FindingKind::WithoutForce,
                               {{"process", tool.process.id},
                                {"format", std::string(format)},
                                {"formats", formatsWithWords(tool.process)}});
  return std::nullopt;
}

void requireBeadWords(std::string_view format, const process::Tooling& tooling) {
  for (const process::Tool& tool : tooling.tools()) {
    if (!lacksWords(tool.process, format) || isForceOnly(tool.process))
      continue;
    const std::string formats = formatsWithWords(tool.process);
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("process {process} has no statements (beadWords) for format {format}, "
                      "which its beads need"_text,
                      tool.process.id, format),
        {}, base::message("use {formats}, or add the statements to the process"_text, formats));
  }
}

ReadBeadWords takeBeadWords(const std::vector<plan::ProgramFile>& files, std::string_view format,
                            std::string_view remark, const process::Tooling& tooling) {
  ReadBeadWords read;
  if (std::ranges::none_of(tooling.tools(), [&](const process::Tool& tool) {
        return tool.process.wordsFor(format) != nullptr;
      }))
    return read;
  read.files = files;
  for (std::size_t f = 0; f < files.size(); ++f) {
    std::uint32_t number = 0;
    forEachLine(read.files[f].text, [&](std::string_view line, std::string& out) {
      ++number;
      const std::string_view code = codeOfLine(line);
      const auto kind = kindOf(code, format, tooling);
      if (!kind) {
        out.append(line);
        return;
      }
      const auto at = static_cast<std::size_t>(code.data() - line.data());
      out.append(line.substr(0, at)).append(remark).append(" ").append(line.substr(at));
      plan::StatedFact fact;
      fact.kind = *kind;
      fact.file = static_cast<std::uint32_t>(f);
      fact.line = number;
      fact.word = code;
      read.facts.push_back(std::move(fact));
    });
  }
  return read;
}

void addBeadWords(std::vector<plan::StatedFact> facts, plan::ReadProgram& program) {
  for (plan::StatedFact& fact : facts) {
    const auto next =
        std::ranges::partition_point(program.motions, [&](const plan::ProgramMotion& motion) {
          return std::pair(motion.file, motion.line) < std::pair(fact.file, fact.line);
        });
    fact.before = static_cast<std::size_t>(next - program.motions.begin());
    const auto pause =
        std::ranges::partition_point(program.pauses, [&](const plan::ProgramPause& p) {
          return std::pair(p.file, p.line) <
                 std::pair<std::size_t, std::size_t>(fact.file, fact.line);
        });
    fact.beforePause = static_cast<std::size_t>(pause - program.pauses.begin());
    program.facts.push_back(std::move(fact));
  }
}

} // namespace voluta::program
