// Folders into which results are written again: files of others in them stay.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace voluta::pipeline {

// The kind of job whose results a folder holds.
enum class FolderKind : std::uint8_t { Plan, Comparison, Together, Milling };

// Checks the files in `folder` whose names are the same for every job of that kind, such as
// job.voluta and report.json. Throws Error{CannotWrite} for the first that is no result of such a
// job: of another program, or of another kind of job. A folder that does not exist holds nothing.
void requireOwnFiles(const std::filesystem::path& folder, FolderKind kind);

// Checks the files that results are about to replace. Throws Error{CannotWrite} for the first of
// them unless the folder holds results of a job of that kind: then they are an earlier result's.
void requireOwnResults(const std::vector<std::filesystem::path>& replaced,
                       const std::filesystem::path& folder, FolderKind kind);

} // namespace voluta::pipeline
