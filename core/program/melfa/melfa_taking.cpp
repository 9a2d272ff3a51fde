#include "program/melfa/melfa_taking.h"

#include "program/common/program_text.h"
#include "program/job_head.h"
#include "program/melfa/melfa.h"
#include "program/melfa/melfa_text.h"

namespace voluta::program {

std::string melfaTakingText(const ProgramInput& input, const MelfaTaking& taking,
                            const std::vector<std::string>& notes, std::vector<std::string> steps) {
  std::string out;
  std::size_t count = 0;
  const auto step = [&](std::string_view code) {
    out += joined({std::to_string(++count), " ", code, "\r\n"});
  };
  step(taking.title);
  for (const std::string& head : headLines(input, kMelfaMaxCharacters - 12))
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

void readMelfaTaking(std::string_view text, const MelfaTaking& taking,
                     const std::vector<std::string>& steps,
                     const std::function<std::size_t(std::string_view)>& addressLength,
                     const OtherSteps& refusals, ProgramBuilder& out) {
  const auto code = [&](std::string_view line) {
    std::size_t number = 0;
    std::string step(trimmed(melfaCode(line, number)));
    if (step.starts_with(taking.open))
      step.erase(taking.open.size(),
                 addressLength(std::string_view(step).substr(taking.open.size())));
    return step;
  };
  reportOtherSteps(text, steps, code, refusals, out);
}

} // namespace voluta::program
