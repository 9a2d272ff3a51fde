// A trajectory as rows of joints over time (program/stream/joint_rows.h), for the dialects that
// stream.
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
  std::vector<JointRow> rows; // as they are written
};

// A straight motion comes in pieces where the joints would lead the nozzle off its way by more than
// kBlendToleranceMm (program/common/straight_pieces.h).
// `head`: remarks above the rows. `written`: a share of the full flow as the outputs say it.
// Precondition: an arm of kRowJoints joints (Error{Internal}). Throws Cancelled.
WrittenRows writeRows(const ProgramInput& input, std::string_view format,
                      std::span<const std::string> head, double (*written)(double share),
                      const base::RunContext& ctx);

} // namespace voluta::program
