// The table of a batch: a row for each job, with figures of its report.json.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace voluta::cli {

struct BatchTable {
  std::size_t verified = 0;            // Number of jobs with exit code 0
  std::vector<std::string> incomplete; // "NAME: REASON" of jobs that ended otherwise
  std::vector<std::string> missing;    // Names of jobs that have not ended
};

// Writes table.csv, table.json and compare.html to the folder of a batch: the jobs in the order of
// its config.json. Throws Error{UnreadableFile} if the folder has none.
BatchTable writeBatchTable(const std::filesystem::path& folder);

} // namespace voluta::cli
