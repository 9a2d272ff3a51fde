#include "program/common/text_rows.h"

#include "program/common/program_text.h"

namespace voluta::program {

namespace {
constexpr std::size_t kHeadCharacters = 16384;
}

std::string_view rowOf(std::string_view line) {
  return trimmed(line.substr(0, line.find('#')));
}

bool parseNumbers(std::string_view line, std::span<double> numbers) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const bool last = k + 1 == numbers.size();
    const std::size_t comma = line.find(',');
    if (last != (comma == std::string_view::npos) ||
        !parseNumber(trimmed(line.substr(0, comma)), numbers[k]))
      return false;
    line.remove_prefix(last ? line.size() : comma + 1);
  }
  return true;
}

bool readEachRow(std::string_view text, const RowsForm& form,
                 const std::function<bool(std::string_view row)>& take, ProgramBuilder& out,
                 const base::RunContext& ctx) {
  out.beginOutputs();
  bool headed = false, ended = false;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    out.line = lines.number();
    if (out.line % 4096 == 0)
      ctx.checkpoint();
    line = rowOf(line);
    if (line.empty())
      continue;
    if (ended) {
      out.defect("text after the end"_text);
      continue;
    }
    if (!headed) {
      headed = true;
      if (line == form.header)
        continue;
      out.defect(form.notHeader);
    }
    ended = take(line);
  }
  if (!headed)
    out.defect("the header line is missing"_text);
  if (!ended)
    out.defect(form.cutShort);
  return ended;
}

std::string_view firstRow(std::string_view text) {
  LineReader lines(text.substr(0, kHeadCharacters));
  for (std::string_view line; lines.next(line);)
    if (line = rowOf(line); !line.empty())
      return line;
  return {};
}

std::vector<std::string> namesBehind(std::string_view text,
                                     std::initializer_list<std::string_view> notes) {
  std::vector<std::string> names;
  LineReader lines(text.substr(0, kHeadCharacters));
  for (std::string_view line; lines.next(line);)
    for (const std::string_view note : notes)
      if (line.starts_with(note))
        names.emplace_back(trimmed(line.substr(note.size())));
  return names;
}

} // namespace voluta::program
