// Whether files are text that a controller loads at all.
#pragma once

#include "plan/program.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// A file that is no text and need not be one; nullptr: all have to be.
using IsNoText = bool (*)(std::string_view bytes);

// One defect a file that begins with a byte-order mark or holds what no text holds. true: there is
// one; such files are not to be read.
bool tellNoTexts(const std::vector<plan::ProgramFile>& files,
                 std::vector<plan::ProgramDefect>& defects, IsNoText mayBe = nullptr);

// One defect a file whose lines end now with LF, now with CR LF, or with CR alone: where that
// begins.
void tellMixedLineEnds(const std::vector<plan::ProgramFile>& files,
                       std::vector<plan::ProgramDefect>& defects, IsNoText mayBe = nullptr);

// What a controller takes of one line: characters, and those of a text in double quotation marks
// outside remarks, which begin with `remark`. 0: any number.
struct LineLimits {
  std::size_t line = 0, text = 0;
  std::string_view remark;
};
// One defect a file for its first line beyond each limit.
void tellLongLines(const std::vector<plan::ProgramFile>& files, const LineLimits& limits,
                   std::vector<plan::ProgramDefect>& defects);

} // namespace voluta::program
