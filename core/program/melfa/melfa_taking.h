// Programs of MELFA-BASIC V that take what a computer sends: the same steps for every job, but for
// what they are made from and the address of the line.
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
  std::string_view title; // the first remark
  std::string_view open;  // how the step that opens the line begins; behind it comes the address
  std::string_view address;
};

// Numbered steps behind the title, the job's head and `notes`. The step that opens the line has no
// address yet.
std::string melfaTakingText(const ProgramInput& input, const MelfaTaking& taking,
                            const std::vector<std::string>& notes, std::vector<std::string> steps);

// Steps with any address: `addressLength` says how many characters of what stands behind `open` it
// has. Others are a defect at their line, told so.
void readMelfaTaking(std::string_view text, const MelfaTaking& taking,
                     const std::vector<std::string>& steps,
                     const std::function<std::size_t(std::string_view)>& addressLength,
                     const OtherSteps& told, ProgramBuilder& out);

} // namespace voluta::program
