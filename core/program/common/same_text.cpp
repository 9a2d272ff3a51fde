#include "program/common/same_text.h"

#include "program/common/program_text.h"

namespace voluta::program {

namespace {
std::string_view withoutEnd(std::string_view line) {
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r' || line.back() == '\t'))
    line.remove_suffix(1);
  return line;
}
} // namespace

void reportOtherText(std::string_view text, std::string_view expected, std::size_t line,
                     ProgramBuilder& out) {
  LineReader own(text), wanted(expected);
  while (true) {
    std::string_view a, b;
    const bool more = own.next(a), wants = wanted.next(b);
    out.line = line++;
    if (!more && !wants)
      return;
    if (more == wants && withoutEnd(a) == withoutEnd(b))
      continue;
    out.defect("this line differs from the one Voluta writes; it is the same for every job"_text);
    return;
  }
}

void reportOtherSteps(std::string_view text, const std::vector<std::string>& steps,
                      const CodeOf& codeOf, const OtherSteps& refusals, ProgramBuilder& out) {
  std::size_t next = 0;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    out.line = lines.number();
    const std::string code = codeOf(line);
    if (code.empty())
      continue;
    if (next == steps.size() || code != steps[next]) {
      out.defect(base::message(refusals.other, code.substr(0, 60)));
      return;
    }
    ++next;
  }
  if (next < steps.size())
    out.defect(refusals.cutShort);
}

} // namespace voluta::program
