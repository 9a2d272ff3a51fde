// Writes a trajectory as rows of joints over time (program/stream/joint_rows.h), for streaming
// dialects.
#pragma once

#include "base/run_context.h"
#include "program/program_input.h"
#include "program/stream/joint_rows.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

struct WrittenRows {
  std::string text;
  std::vector<JointRow> rows; // with rounded values, as in the file
};

// Divides straight motions into pieces if the joints would lead the nozzle off its path by more
// than kBlendToleranceMm (program/common/straight_pieces.h). `head`: remarks above the rows.
// `written`: converts a share of the full flow to the value that the outputs represent.
// Precondition: an arm of kRowJoints joints (Error{Internal}). Throws Cancelled.
WrittenRows writeRows(const ProgramInput& input, std::string_view format,
                      std::span<const std::string> head, double (*written)(double share),
                      const base::RunContext& ctx);

} // namespace voluta::program
