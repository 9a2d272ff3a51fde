#include "program/rapid/rapid_files.h"

#include "program/common/program_text.h"
#include "program/rapid/rapid.h"
#include "program/rapid/rapid_text.h"
#include "program/rapid/rapid_tokens.h"

#include <algorithm>

namespace voluta::program {

bool isModuleList(std::string_view text) {
  return text.starts_with("<?xml");
}

std::string_view moduleExtension(bool omniCore) {
  return omniCore ? ".modx" : ".mod";
}

std::string moduleListText(std::string_view module) {
  return joined({"<?xml version=\"1.0\" encoding=\"ISO-8859-1\" ?>\r\n<Program>\r\n\t<Module>",
                 module, "</Module>\r\n</Program>\r\n"});
}

std::string signalListText(std::string_view unit, bool omniCore, bool extrudes,
                           std::span<const std::string> outputs) {
  std::string text = joined({"EIO:CFG_1.0:", omniCore ? "7:0" : "6:1", "::\r\n"});
  text += "# What the program expects; give each signal its -Device and -DeviceMap.\r\n";
  if (!unit.empty())
    text += joined({"# Its mechanical unit, ", unit, ", belongs into MOC.cfg.\r\n"});
  text += "#\r\nEIO_SIGNAL:\r\n";
  if (extrudes)
    text += "\r\n      -Name \"doExtruder\" -SignalType \"DO\"\r\n"
            "\r\n      -Name \"aoFlow\" -SignalType \"AO\" -MaxLog 1 -MaxPhys 10 -MaxPhysLimit "
            "10\r\n";
  for (const std::string& output : outputs)
    text += joined({"\r\n      -Name \"", output, "\" -SignalType \"DO\"\r\n"});
  constexpr std::string_view kMarkOutputs = "doMark"; // each has an input
  for (const std::string& output : outputs)
    if (output.starts_with(kMarkOutputs))
      text += joined({"\r\n      -Name \"diMark", output.substr(kMarkOutputs.size()),
                      "\" -SignalType \"DI\"\r\n"});
  return text;
}

bool takeModule(std::string_view& line) {
  constexpr std::string_view kBegin = "<Module>", kEnd = "</Module>";
  if (!line.starts_with(kBegin) || !line.ends_with(kEnd))
    return false;
  line.remove_prefix(kBegin.size());
  line.remove_suffix(kEnd.size());
  return true;
}

void reportLineEnds(std::string_view text, ProgramBuilder& out) {
  bool reported = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool lf = text[i] == '\n', cr = text[i] == '\r';
    const bool pair =
        lf ? i > 0 && text[i - 1] == '\r' : !cr || (i + 1 < text.size() && text[i + 1] == '\n');
    if (!pair && !reported)
      out.defect("a line does not end with CR LF"_text);
    reported = reported || !pair;
    out.line += lf ? 1 : 0;
  }
}

std::string_view behindHeader(std::string_view text) {
  constexpr std::string_view kMark = "%%%";
  if (!text.starts_with(kMark))
    return text;
  const std::size_t end = text.find(kMark, kMark.size());
  return end == std::string_view::npos ? text : text.substr(end + kMark.size());
}

bool readModuleList(std::string_view text, const std::vector<plan::ProgramFile>& files,
                    ProgramBuilder& out) {
  LineReader lines(text);
  std::string_view line;
  bool open = false, closed = false;
  while (lines.next(line)) {
    out.line = lines.number();
    line = trimmed(line);
    if (out.line == 1 || line.empty())
      continue;
    if (line == "<Program>" && !open) {
      open = true;
    } else if (line == "</Program>" && open && !closed) {
      closed = true;
    } else if (std::string_view name = line; open && !closed && takeModule(name)) {
      if (std::none_of(files.begin(), files.end(),
                       [&](const auto& f) { return f.name.ends_with(name); }))
        out.defect(base::message("module {name} is missing"_text, name.substr(0, 60)));
    } else {
      out.defect(base::message("not understood: '{code}'"_text, line.substr(0, 60)));
    }
  }
  if (!closed)
    out.defect("the list of modules has no end"_text);
  return closed;
}

bool isSignalList(std::string_view text) {
  return text.starts_with("EIO:CFG");
}

bool looksLikeRapid(std::string_view text) {
  const std::string_view head = text.substr(0, 16384);
  if (isModuleList(head))
    return head.find("<Program>") != std::string_view::npos;
  return sameWord(RapidTokens(behindHeader(head)).next().text, "module");
}

bool mayBeMissingInRapid(const std::vector<std::string>& lines, std::size_t i) {
  if (lines[i].find("ConfJ") == std::string::npos)
    return primes(lines, i);
  // Joint motions are configured only if there are any.
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
    std::string_view last; // Last string of the statement: the file follows the folder
    for (token = tokens.next(); token.kind != RapidTokenKind::End && token.text != ";";
         token = tokens.next())
      if (token.kind == RapidTokenKind::Text)
        last = token.text;
    names.emplace_back(last);
  }
  return names;
}

} // namespace voluta::program
