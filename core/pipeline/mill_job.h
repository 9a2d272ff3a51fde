// The job of a milled part as a file, so that its program can be verified later.
#pragma once

#include "base/run_context.h"
#include "pipeline/mill_part.h"

#include <string>
#include <string_view>

namespace voluta::pipeline {

// The file beside the program.
inline constexpr const char* kMillJobFile = "mill.json";

// Returns the part as milled, with the values that its passes follow from.
std::string writeMillJob(const geometry::TriangleMesh& part, const MillOrder& order);

// Returns whether a file begins as such a job.
bool isMillJob(std::string_view text);

struct MillJob {
  MillOrder order; // the part is not laid down again
  geometry::TriangleMesh part;
};

// `file` names it in errors. Throws Error{UnreadableFile, UnusableInput} with the key.
MillJob readMillJob(std::string_view text, const std::string& file);

// Plans the job again, and runs a program's text on its block. Throws as milling::planMilling().
milling::CutVerdict verifyMilling(std::string_view program, const MillJob& job,
                                  const base::RunContext& ctx);

} // namespace voluta::pipeline
