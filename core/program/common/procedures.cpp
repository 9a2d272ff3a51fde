#include "program/common/procedures.h"

#include "program/common/program_text.h"

#include <algorithm>

namespace voluta::program {

bool Procedures::find(const std::vector<plan::ProgramFile>& files, const Statement& outside) {
  bool sound = true;
  lines_.resize(files.size());
  cameTo_.assign(files.size(), false);
  for (out_.file = 0; out_.file < files.size(); ++out_.file) {
    ctx_.checkpoint();
    const std::string_view text = files[out_.file].text;
    LineReader reader(text);
    for (std::string_view line; reader.next(line);)
      if (const std::string_view code = codeOf(line, words_.syntax); !code.empty())
        lines_[out_.file].push_back({reader.number(), code});
    sound = findIn(out_.file, outside) && sound;
    out_.line = reader.number();
    if (text.empty()) {
      out_.defect("the file is empty"_text);
      sound = false;
    }
  }
  return sound;
}

bool Procedures::findIn(std::size_t file, const Statement& outside) {
  const std::vector<Line>& lines = lines_[file];
  bool sound = true, any = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out_.line = lines[i].number;
    std::string name, inner;
    switch (words_.part({lines[i].code, words_.syntax}, name)) {
    case LinePart::Other:
      outside(lines[i].code);
      continue;
    case LinePart::Ends:
      out_.defect("end without a matching beginning"_text);
      sound = false;
      continue;
    case LinePart::Begins:
      break;
    }
    any = true;
    if (name.empty())
      out_.defect("not a valid procedure header"_text);
    Procedure found{file, i + 1, i + 1};
    const auto partAt = [&](std::size_t k) {
      return words_.part({lines[k].code, words_.syntax}, inner);
    };
    while (found.end < lines.size() && partAt(found.end) == LinePart::Other)
      ++found.end;
    const bool ended = found.end < lines.size() && partAt(found.end) == LinePart::Ends;
    if (!ended) {
      out_.line = lines[std::min(found.end, lines.size() - 1)].number;
      out_.defect("the procedure has no end"_text);
    }
    sound = sound && ended && !name.empty();
    if (first_.empty() && file == 0)
      first_ = name;
    if (!name.empty() && !procedures_.try_emplace(name, found).second)
      out_.defect("a name is declared twice"_text);
    i = ended ? found.end : found.end - 1;
  }
  cameTo_[file] = !any;
  return sound;
}

bool Procedures::run(const Statement& statement) {
  statement_ = &statement;
  out_.file = 0;
  if (!call(first_)) {
    out_.defect("no procedure is defined"_text);
    return false;
  }
  const std::size_t file = out_.file, line = out_.line;
  bool all = true;
  for (std::size_t f = 0; f < cameTo_.size(); ++f)
    if (!cameTo_[f]) {
      out_.file = f;
      out_.line = lines_[f].empty() ? 1 : lines_[f].front().number;
      out_.defect("no procedure of this file is called"_text);
      all = false;
    }
  out_.file = file;
  out_.line = line;
  return all;
}

bool Procedures::call(const std::string& name) {
  constexpr std::size_t kMaxDepth = 16, kMaxCalls = 100000;
  const auto found = procedures_.find(name);
  if (found == procedures_.end())
    return false;
  if (std::find(running_.begin(), running_.end(), name) != running_.end() ||
      running_.size() == kMaxDepth || ++calls_ > kMaxCalls) {
    out_.defect(base::message("'{name}' calls itself"_text, name));
    return true;
  }
  const std::size_t file = out_.file, line = out_.line;
  running_.push_back(name);
  runLines(found->second);
  running_.pop_back();
  if (!running_.empty()) {
    out_.file = file;
    out_.line = line;
  }
  return true;
}

void Procedures::runLines(const Procedure& procedure) {
  const std::vector<Line>& lines = lines_[procedure.file];
  cameTo_[procedure.file] = true;
  for (std::size_t i = procedure.first; i < procedure.end; ++i) {
    if (++statements_ % 4096 == 0)
      ctx_.checkpoint();
    out_.file = procedure.file;
    out_.line = lines[i].number;
    (*statement_)(lines[i].code);
  }
  out_.file = procedure.file;
  out_.line = procedure.end < lines.size() ? lines[procedure.end].number
              : lines.empty()              ? std::size_t{1}
                                           : lines.back().number;
}

} // namespace voluta::program
