// MELFA-BASIC V programs that receive data from a computer: the same steps for every job, except
// for the sources in the header and the address of the line.
#pragma once

#include "program/common/same_text.h"
#include "program/program_builder.h"
#include "program/program_input.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

struct MelfaTaking {
  std::string_view title; // The first remark
  std::string_view open;  // Beginning of the step that opens the line; the address follows
  std::string_view address;
};

// Returns numbered steps after the title, the job's head and `notes`. The step that opens the line
// has no address yet.
std::string melfaTakingText(const ProgramInput& input, const MelfaTaking& taking,
                            const std::vector<std::string>& notes, std::vector<std::string> steps);

// Reads such steps with any address. `addressLength` returns the number of characters of the
// address, given the text after `open`. Different steps are reported as defects at their line.
void readMelfaTaking(std::string_view text, const MelfaTaking& taking,
                     const std::vector<std::string>& steps,
                     const std::function<std::size_t(std::string_view)>& addressLength,
                     const OtherSteps& refusals, ProgramBuilder& out);

} // namespace voluta::program
