#include "program/melfa_taking.h"

#include "program/job_head.h"
#include "program/melfa.h"
#include "program/melfa_text.h"
#include "program/text.h"

namespace voluta::program {

std::string melfaTakingText(const ProgramInput& input, const MelfaTaking& taking,
                            const std::vector<std::string>& notes, std::vector<std::string> steps) {
  std::string out;
  std::size_t count = 0;
  const auto step = [&](std::string_view code) {
    out += joined({std::to_string(++count), " ", code, "\r\n"});
  };
  step(taking.title);
  for (const std::string& head : headLines(input, kMelfaMostCharacters - 12))
    step(joined({"' ", head}));
  for (const std::string& note : notes)
    step(joined({"' ", note}));
  for (std::string& code : steps) {
    if (code.starts_with(taking.open))
      code.insert(taking.open.size(), taking.address);
    step(code);
  }
  return out;
}

MelfaTakingRead readMelfaTaking(std::string_view text, const MelfaTaking& taking,
                                const std::vector<std::string>& steps,
                                const std::function<std::size_t(std::string_view)>& addressLength,
                                ProgramBuilder& out) {
  std::size_t next = 0;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    out.line = lines.number();
    std::size_t number = 0;
    std::string code(trimmed(melfaCode(line, number)));
    if (code.empty())
      continue;
    if (code.starts_with(taking.open))
      code.erase(taking.open.size(),
                 addressLength(std::string_view(code).substr(taking.open.size())));
    if (next == steps.size() || code != steps[next])
      return {false, code};
    ++next;
  }
  return {next == steps.size(), {}};
}

} // namespace voluta::program
