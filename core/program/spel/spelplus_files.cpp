#include "program/common/program_text.h"
#include "program/spel/spelplus.h"
#include "program/spel/spelplus_points.h"

#include <algorithm>
#include <array>

namespace voluta::program {

namespace {
// A directive (#include "x.inc", #define N 3) or a declaration of variables.
bool standsBeforeFunctions(LineCursor line) {
  if (line.isMark('#'))
    return true;
  line.takeWord("global");
  line.takeWord("preserve");
  constexpr std::array kTypes = {"boolean", "byte",   "double", "int32", "int64",
                                 "integer", "long",   "real",   "short", "string",
                                 "ubyte",   "uint32", "uint64", "ushort"};
  return std::ranges::any_of(kTypes, [&](std::string_view type) { return line.isWord(type); });
}
} // namespace

bool looksLikeSpelplus(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  for (std::string_view line; lines.next(line);) {
    LineCursor code(codeOf(line, kSpelplusSyntax), kSpelplusSyntax);
    std::string name;
    if (!code.ended() && !standsBeforeFunctions(code))
      return spelplusPart(code, name) == LinePart::Begins && !name.empty();
  }
  return false;
}

// AccelS is never below the value that a reader assumes without it.
bool mayBeMissingInSpelplus(const std::vector<std::string>& lines, std::size_t i) {
  const std::string_view line = trimmed(lines[i]);
  for (const std::string_view idle : {"Motor On", "Power Low", "AutoLJM On", "Print", "AccelS"})
    if (line.starts_with(idle))
      return true;
  return primes(lines, i);
}

std::vector<std::string> filesOfSpelplus(std::string_view text) {
  std::vector<std::string> defined, files;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    LineCursor code(codeOf(line, kSpelplusSyntax), kSpelplusSyntax);
    std::string name;
    if (spelplusPart(code, name) == LinePart::Begins)
      defined.push_back(name);
    else if (code.takeWord("call"))
      files.emplace_back(code.rest().substr(0, code.rest().find_first_of(" (\t")));
  }
  std::erase_if(files, [&](const std::string& name) {
    return std::any_of(defined.begin(), defined.end(), [&](const std::string& own) {
      return LineCursor(name, kSpelplusSyntax).isWord(own);
    });
  });
  for (std::string& file : files)
    file += ".prg";
  return files;
}

} // namespace voluta::program
