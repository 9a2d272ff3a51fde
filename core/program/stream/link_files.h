// What belongs to lines for a data link (program/stream/link_rows.h): the lines, the program or
// programs that take them, and the one that sends them.
#pragma once

#include "program/common/same_text.h"
#include "program/stream/link_rows.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Defects of a text that is made from the lines, or that goes with all of them.
struct LinkTaking {
  bool (*isIt)(std::string_view text);
  std::function<void(std::string_view text, const Link& link, ProgramBuilder& out)> read;
};

// A program of one text of lines; `sender`, a script that begins with "#!", and what takes them are
// held against what the lines make. `complete`: the lines came to their end. Throws Cancelled.
plan::ReadProgram readLinkFiles(std::string_view format,
                                const std::vector<plan::ProgramFile>& files, const LinkForm& form,
                                std::string_view sender, const std::vector<LinkTaking>& takings,
                                const process::Process& process, const base::RunContext& ctx);

// How a text that takes the lines is told to be another one.
inline constexpr OtherSteps kOtherTaking{"not what takes these lines: '{code}'"_text,
                                         "the program that takes the lines was cut short"_text};

} // namespace voluta::program
