// The page that compares the jobs of a batch.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace voluta::cli {

// Returns a self-contained HTML page with a row for each job of table.json, grouped by part. Of the
// jobs of one part that passed, the least time and the least material are marked. `settings`: the
// columns of the study.
std::string batchPage(const nlohmann::ordered_json& rows, const std::vector<std::string>& settings);

} // namespace voluta::cli
