#include "program/common/language_words.h"
#include "program/common/program_text.h"
#include "program/common/text_files.h"
#include "program/urscript/urscript.h"
#include "program/urscript/urscript_values.h"

#include <algorithm>

namespace voluta::program {

bool looksLikeUrscript(std::string_view text) {
  const std::string_view head = text.substr(0, 16384);
  const auto has = [&](std::string_view word) { return head.find(word) != std::string_view::npos; };
  return (head.starts_with("def ") || has("\ndef ")) &&
         (has("movel(") || has("movej(") || has("movep(") || has(kCalledNote));
}

bool mayBeMissingInUrscript(const std::vector<std::string>& lines, std::size_t i) {
  return lines[i].find("sleep(") != std::string::npos || primes(lines, i);
}

// Returns the functions that are called without arguments and not defined in the text.
std::vector<std::string> filesOfUrscript(std::string_view text) {
  static const UrscriptVariables kNone;
  std::vector<std::string> files;
  std::vector<std::string_view> defined, called;
  if (text.starts_with(kByteOrderMark)) // The reader refuses it
    text.remove_prefix(kByteOrderMark.size());
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (const std::string_view note = trimmed(line); note.starts_with(kNextNote))
      files.emplace_back(trimmed(note.substr(kNextNote.size())));
    const std::string_view code = trimmed(line.substr(0, findUnquoted(line, "#")));
    UrscriptScanner scanner{code, kNone};
    const std::string_view word = scanner.name();
    if (word == "def")
      defined.push_back(scanner.name());
    else if (!word.empty() && !isUrscriptWord(word) && scanner.take('(') && scanner.take(')') &&
             scanner.ended())
      called.push_back(word);
  }
  for (const std::string_view name : called)
    if (std::ranges::find(defined, name) == defined.end())
      files.push_back(joined({name, ".script"}));
  return files;
}

} // namespace voluta::program
