// Reads the files of a data link (program/stream/link_rows.h): the lines, the program or programs
// that receive them, and the one that sends them.
#pragma once

#include "program/common/same_text.h"
#include "program/stream/link_rows.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Checks a text that is derived from the lines, or that accompanies all of them.
struct LinkTaking {
  bool (*isIt)(std::string_view text);
  std::function<void(std::string_view text, const Link& link, ProgramBuilder& out)> read;
};

// Reads a program with one text of lines. `sender`, a script that begins with "#!", and the
// receiving programs are compared with those generated from the lines. `complete`: the end of the
// lines was found. Throws Cancelled.
plan::ReadProgram readLinkFiles(std::string_view format,
                                const std::vector<plan::ProgramFile>& files, const LinkForm& form,
                                std::string_view sender, const std::vector<LinkTaking>& takings,
                                const process::Tooling& tooling, const base::RunContext& ctx);

// Errors for a receiving program that differs from the expected one.
inline constexpr OtherSteps kOtherTaking{
    "unexpected in the program that receives these lines: '{code}'"_text,
    "the program that receives the lines is truncated"_text};

} // namespace voluta::program
