#include "program/rapid_files.h"

#include "program/rapid.h"
#include "program/rapid_tokens.h"
#include "program/text.h"

namespace voluta::program {

bool isModuleList(std::string_view text) {
  return text.starts_with("<?xml");
}

bool takeModule(std::string_view& line) {
  constexpr std::string_view kBegin = "<Module>", kEnd = "</Module>";
  if (!line.starts_with(kBegin) || !line.ends_with(kEnd))
    return false;
  line.remove_prefix(kBegin.size());
  line.remove_suffix(kEnd.size());
  return true;
}

bool looksLikeRapid(std::string_view text) {
  const std::string_view head = text.substr(0, 16384);
  if (isModuleList(head))
    return head.find("<Program>") != std::string_view::npos;
  return sameWord(RapidTokens(head).next().text, "module");
}

bool mayBeMissingInRapid(const std::vector<std::string>& lines, std::size_t i) {
  if (lines[i].find("UIMsgBox") != std::string::npos)
    return true;
  if (lines[i].find("ConfJ") == std::string::npos)
    return primes(lines, i);
  // About motions by joints: nothing where there is none.
  return std::none_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("MoveJ ") != std::string::npos;
  });
}

std::vector<std::string> filesOfRapid(std::string_view text) {
  std::vector<std::string> names;
  if (isModuleList(text)) {
    LineReader lines(text);
    for (std::string_view line; lines.next(line);)
      if (line = trimmed(line); takeModule(line))
        names.emplace_back(line);
    return names;
  }
  RapidTokens tokens(text);
  for (RapidToken token = tokens.next(); token.kind != RapidTokenKind::End; token = tokens.next()) {
    if (token.kind != RapidTokenKind::Name || !sameWord(token.text, "load"))
      continue;
    std::string_view last; // string of the statement: behind the folder stands the file
    for (token = tokens.next(); token.kind != RapidTokenKind::End && token.text != ";";
         token = tokens.next())
      if (token.kind == RapidTokenKind::Text)
        last = token.text;
    names.emplace_back(last);
  }
  return names;
}

} // namespace voluta::program
