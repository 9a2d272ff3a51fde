#include "program/urscript/urscript_functions.h"

#include "program/common/language_words.h"
#include "program/common/program_text.h"
#include "program/urscript/urscript.h"
#include "program/urscript/urscript_values.h"

namespace voluta::program {

namespace {
// Neither definitions nor the words of blocks contain variables.
const UrscriptVariables& noVariables() {
  static const UrscriptVariables none;
  return none;
}

std::string_view firstWordOf(std::string_view code) {
  return UrscriptScanner{code, noVariables()}.name();
}

std::string_view nameOfDefinition(std::string_view code) {
  UrscriptScanner scanner{code, noVariables()};
  scanner.name();
  return scanner.name();
}

// Returns whether this line begins a block that must be closed by an `end`.
bool opensBlock(std::string_view code) {
  const std::string_view word = firstWordOf(code);
  return UrscriptFunctions::isDefinition(code) || word == "while" || word == "for" || word == "if";
}
} // namespace

bool UrscriptFunctions::isDefinition(std::string_view code) {
  const std::string_view word = firstWordOf(code);
  return word == "def" || word == "sec" || word == "thread";
}

void UrscriptFunctions::collect(std::string_view text) {
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) {
    file().last = reader.number();
    file().mustCall = file().mustCall || trimmed(line).starts_with(kCalledNote);
    file().isPart = file().isPart || trimmed(line).starts_with(kPartNote);
    if (const std::string_view code = trimmed(line.substr(0, findUnquoted(line, "#")));
        !code.empty())
      file().lines.push_back({reader.number(), code});
  }
}

void UrscriptFunctions::find(const std::vector<plan::ProgramFile>& files) {
  files_.resize(files.size());
  for (out_.file = 0; out_.file < files.size(); ++out_.file) {
    collect(files[out_.file].text);
    const std::vector<Line>& lines = file().lines;
    for (std::size_t i = 0; i < lines.size();) {
      out_.line = lines[i].number;
      if (!isDefinition(lines[i].code)) {
        ++i;
        continue;
      }
      const std::size_t head = i;
      file().defined = nameOfDefinition(lines[i].code);
      file().closed = define(i);
      file().behind[head] = i;
    }
  }
}

bool UrscriptFunctions::define(std::size_t& i) {
  const std::vector<Line>& lines = file().lines;
  UrscriptScanner scanner{lines[i].code, noVariables()};
  const std::string_view kind = scanner.name(), name = scanner.name();
  if (name.empty() || !scanner.take('(') || !scanner.take(')') || !scanner.take(':') ||
      !scanner.ended())
    out_.defect("not the definition of a function without arguments"_text);
  else if (kind == "thread")
    out_.defect("threads are not supported"_text);
  else if (isUrscriptWord(name))
    out_.defect(base::message("'{name}' is a reserved word and cannot name a function"_text, name));
  else if (functions_.contains(name))
    out_.defect(base::message("the function '{defined}' is defined twice"_text, name));
  const std::size_t head = lines[i].number, first = ++i;
  for (std::size_t open = 1; i < lines.size(); ++i) {
    open += opensBlock(lines[i].code) ? 1 : 0;
    if (lines[i].code == "end" && --open == 0) {
      functions_.try_emplace(std::string(name), Function{out_.file, first, i++, head});
      return true;
    }
  }
  functions_.try_emplace(std::string(name), Function{out_.file, first, i, head});
  if (!lines.empty())
    out_.line = lines.back().number;
  out_.defect(base::message("the function '{defined}' has no end"_text, name));
  return false;
}

const UrscriptFunctions::Function& UrscriptFunctions::call(std::string_view name) {
  Function& function = functions_.find(name)->second;
  function.isCalled = true;
  return function;
}

void UrscriptFunctions::refuseBesideParts() {
  for (out_.file = 0; out_.file < files_.size(); ++out_.file) {
    if (file().isRun || !file().isReached)
      continue;
    const std::vector<Line>& lines = file().lines;
    for (std::size_t i = 0; i < lines.size();) {
      out_.line = lines[i].number;
      if (const auto definition = file().behind.find(i); definition != file().behind.end()) {
        i = definition->second;
        continue;
      }
      out_.defect(base::message("outside the function of a part: '{code}'"_text,
                                lines[i].code.substr(0, 60)));
      ++i;
    }
    for (const auto& [name, function] : functions_)
      if (function.file == out_.file && !function.isCalled && file().isPart)
        out_.defectAt(function.head,
                      base::message("the function '{defined}' is never called"_text, name));
  }
}

} // namespace voluta::program
