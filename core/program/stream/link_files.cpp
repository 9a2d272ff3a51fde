#include "program/stream/link_files.h"

#include <algorithm>
#include <utility>

namespace voluta::program {

plan::ReadProgram readLinkFiles(std::string_view format,
                                const std::vector<plan::ProgramFile>& files, const LinkForm& form,
                                std::string_view sender, const std::vector<LinkTaking>& takings,
                                const process::Tooling& tooling, const base::RunContext& ctx) {
  ProgramBuilder out(format, tooling);
  const auto takingOf = [&](std::string_view text) {
    return std::ranges::find_if(takings, [&](const LinkTaking& t) { return t.isIt(text); });
  };
  LinkRead lines;
  bool found = false;
  for (out.file = 0; out.file < files.size(); ++out.file) {
    const std::string_view text = files[out.file].text;
    out.line = 1;
    if (text.starts_with("#!"))
      reportOtherText(text, sender, 1, out);
    else if (takingOf(text) != takings.end())
      continue;
    else if (std::exchange(found, true))
      out.defect("a second stream"_text);
    else
      lines = readLinkRows(text, form, out, ctx);
  }
  for (out.file = 0; lines.link && out.file < files.size(); ++out.file) {
    out.line = 1;
    if (const auto taking = takingOf(files[out.file].text); taking != takings.end())
      taking->read(files[out.file].text, *lines.link, out);
  }
  return out.take(lines.complete);
}

} // namespace voluta::program
