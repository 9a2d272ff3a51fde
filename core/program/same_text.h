// Programs that are the same for every job, beside one that isn't.
#pragma once

#include "program/program_builder.h"

#include <cstddef>
#include <string_view>

namespace voluta::program {

// A defect of the file that is read where its first line other than the expected one stands; blanks
// and ends of lines do not count behind a line. `line`: of the text's first.
void tellOtherText(std::string_view text, std::string_view expected, std::size_t line,
                   ProgramBuilder& out);

} // namespace voluta::program
