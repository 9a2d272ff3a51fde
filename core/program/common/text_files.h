// Checks whether files are text that a controller can load.
#pragma once

#include "plan/program.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// Returns whether a file is of a binary kind that is allowed; nullptr: all files have to be text.
using IsNoText = bool (*)(std::string_view bytes);

// Adds one defect per file that begins with a byte-order mark or contains non-text characters.
// Returns true if there is one; such files must not be parsed.
bool reportNoTexts(const std::vector<plan::ProgramFile>& files,
                   std::vector<plan::ProgramDefect>& defects, IsNoText mayBe = nullptr);

// Adds one defect per file with mixed line ends (LF and CR LF), or with CR alone, at the first
// difference.
void reportMixedLineEnds(const std::vector<plan::ProgramFile>& files,
                         std::vector<plan::ProgramDefect>& defects, IsNoText mayBe = nullptr);

// Line limits of a controller: characters of a line, and of a text in double quotation marks
// outside remarks, which begin with `remark`. 0: unlimited.
struct LineLimits {
  std::size_t line = 0, text = 0;
  std::string_view remark;
};
// Adds one defect per file and limit, for the first line that exceeds it.
void reportLongLines(const std::vector<plan::ProgramFile>& files, const LineLimits& limits,
                     std::vector<plan::ProgramDefect>& defects);

} // namespace voluta::program
