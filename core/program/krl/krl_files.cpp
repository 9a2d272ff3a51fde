#include "program/common/program_text.h"
#include "program/krl/krl.h"
#include "program/krl/krl_values.h"

#include <algorithm>

namespace voluta::program {

LinePart krlPart(LineCursor line, std::string& name) {
  if (line.isWord("end") || line.isWord("endfct")) {
    std::string word;
    line.takeName(word);
    return line.ended() ? LinePart::Ends : LinePart::Other;
  }
  line.takeWord("global");
  if (line.isWord("deffct"))
    return LinePart::Begins;
  if (!line.takeWord("def"))
    return LinePart::Other;
  const bool whole =
      line.takeName(name) && line.takeMark('(') && line.takeMark(')') && line.ended();
  if (!whole)
    name.clear();
  return LinePart::Begins;
}

bool looksLikeKrl(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  for (std::string_view line; lines.next(line);) {
    const std::string_view code = codeOf(line, kKrlSyntax);
    if (code.empty())
      continue;
    LineCursor head(code, kKrlSyntax);
    std::string name;
    if (head.takeMark('&'))
      return head.takeName(name) &&
             (name == "access" || name == "rel" || name == "comment" || name == "param");
    return head.isWord("defdat") || (krlPart(head, name) == LinePart::Begins && !name.empty());
  }
  return false;
}

bool mayBeMissingInKrl(const std::vector<std::string>& lines, std::size_t i) {
  const std::string_view line = trimmed(lines[i]);
  if (line.starts_with("&"))
    return true;
  bool moved = false;
  for (std::size_t k = 0; k <= i; ++k)
    moved = moved || lines[k].find("PTP ") != std::string::npos;
  if (!moved)
    for (const std::string_view idle :
         {"GLOBAL INTERRUPT", "INTERRUPT ON", "BAS (#INITMOV", "$ADVANCE", "$VEL.ORI", "$ACC.CP",
          "$IPO_MODE=#BASE", "$OUT[1]=FALSE", "$ANOUT[1]=0", "MsgNotify("})
      if (line.starts_with(idle))
        return true;
  return primes(lines, i);
}

void reportOtherNames(const std::vector<plan::ProgramFile>& files, ProgramBuilder& out) {
  for (out.file = 1; out.file < files.size(); ++out.file) {
    const std::string& file = files[out.file].name;
    LineReader lines(files[out.file].text);
    std::string name;
    for (std::string_view line; name.empty() && lines.next(line);)
      krlPart({codeOf(line, kKrlSyntax), kKrlSyntax}, name);
    LineCursor own(file, kKrlSyntax);
    out.line = lines.number();
    if (!name.empty() && file.ends_with(".src") && !own.isWord(name))
      out.defect(base::message("the file {file} begins with {procedure}: a module must "
                               "have the name of its first procedure"_text,
                               file, name));
  }
}

std::vector<std::string> filesOfKrl(std::string_view text) {
  std::vector<std::string> defined, called;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    LineCursor code(codeOf(line, kKrlSyntax), kKrlSyntax);
    std::string name;
    if (krlPart(code, name) == LinePart::Begins) {
      defined.push_back(name);
      continue;
    }
    const std::string_view spelled = code.rest();
    if (code.takeName(name) && code.takeMark('(') && code.takeMark(')') && code.ended())
      called.emplace_back(spelled.substr(0, name.size()));
  }
  std::vector<std::string> files;
  for (const std::string& name : called) {
    const bool own = std::any_of(defined.begin(), defined.end(), [&](const std::string& d) {
      LineCursor same(name, kKrlSyntax);
      return same.isWord(d);
    });
    const std::string file = name + ".src";
    if (!own && std::find(files.begin(), files.end(), file) == files.end())
      files.push_back(file);
  }
  return files;
}

} // namespace voluta::program
