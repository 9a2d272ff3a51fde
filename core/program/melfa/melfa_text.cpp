#include "program/melfa/melfa_text.h"

#include "program/common/program_scanner.h"
#include "program/common/program_text.h"
#include "program/melfa/melfa.h"
#include "program/rapid/rapid_tokens.h"

#include <algorithm>

namespace voluta::program {

std::string_view melfaCode(std::string_view line, std::size_t& step) {
  line = trimmed(line);
  std::size_t digits = 0;
  step = 0;
  while (digits < line.size() && line[digits] >= '0' && line[digits] <= '9') {
    step = std::min<std::size_t>(10 * step + static_cast<std::size_t>(line[digits] - '0'),
                                 kMelfaMaxSteps + 1);
    ++digits;
  }
  line = trimmed(line.substr(digits));
  TextScanner first{line};
  if (sameWord(first.name(), "rem"))
    return {};
  return trimmed(line.substr(0, findUnquoted(line, "'")));
}

std::string_view takeMelfaStatement(std::string_view& rest) {
  const std::size_t colon = findUnquoted(rest, ":");
  const std::string_view code = trimmed(rest.substr(0, colon));
  rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
  return code;
}

MelfaText melfaText(std::string_view text, ProgramBuilder& out, const base::RunContext& ctx) {
  MelfaText into;
  LineReader reader(text);
  std::string_view line;
  std::size_t last = 0;
  while (reader.next(line)) {
    into.lastLine = out.line = reader.number();
    if (out.line % 4096 == 0)
      ctx.checkpoint();
    std::size_t number = 0;
    const std::string_view code = melfaCode(line, number);
    if (trimmed(line).size() > kMelfaMaxCharacters)
      out.defect("step longer than 127 characters"_text);
    if (number > kMelfaMaxSteps || (number > 0 && number <= last))
      out.defect("step numbers must ascend, up to 32767"_text);
    last = number > 0 ? number : last;
    if (code.empty())
      continue;
    if (code.front() == '*') {
      TextScanner label{code.substr(1)};
      into.labels.insert_or_assign(inSmallLetters(label.name()), into.steps.size());
    }
    into.steps.push_back({reader.number(), code});
  }
  return into;
}

bool looksLikeMelfa(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  std::string_view line;
  while (lines.next(line)) {
    std::size_t step = 0;
    TextScanner code{melfaCode(line, step)};
    const std::string_view word = code.name();
    for (const char* own : {"mov", "mvs", "emvs", "callp", "ovrd", "spd"})
      if (sameWord(word, own))
        return true;
  }
  return false;
}

bool mayBeMissingInMelfa(const std::vector<std::string>& lines, std::size_t i) {
  std::size_t step = 0;
  const std::string_view code = melfaCode(lines[i], step);
  const auto begins = [&](std::string_view word) { return code.starts_with(word); };
  // The arm's own speeds and accelerations are the defaults.
  return code.empty() || begins("Ovrd") || begins("Accel") ||
         (begins("Cnt 0") && i > 0 && lines[i - 1].find("Accel") != std::string::npos) ||
         primes(lines, i);
}

std::vector<std::string> filesOfMelfa(std::string_view text) {
  std::vector<std::string> names;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    std::size_t step = 0;
    TextScanner code{melfaCode(line, step)};
    std::string_view name;
    if (sameWord(code.name(), "callp") && code.take('"') && code.textBehindQuote(name))
      names.push_back(joined({name, ".prg"}));
  }
  return names;
}

} // namespace voluta::program
