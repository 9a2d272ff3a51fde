// Verifies the programs of machines that work together, from disk.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "pipeline/road.h"
#include "replay/shared_run.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace voluta::pipeline {

struct CheckedMachine {
  std::filesystem::path program; // its first file
  VerifyResult alone;
};

struct TogetherCheck {
  std::vector<CheckedMachine> machines;
  replay::SharedRun replay; // of all programs in one time
};

// Reads the programs in a folder that writeTogether() filled, verifies each against its job, its
// marks included, and replays all in one time. Throws Error{UnreadableFile} for a missing file,
// Error{UnusableInput} if together.json names no programs or a program has no motions; Cancelled.
TogetherCheck verifyTogether(const std::filesystem::path& folder, const base::RunContext& ctx);

// Returns the reason why the programs are refused; nullopt if all passed.
std::optional<base::Message> refusal(const TogetherCheck& check);
// Returns why a common run is refused; nullopt if it is not.
std::optional<base::Message> refusal(const replay::SharedRun& run);

} // namespace voluta::pipeline
