// The jobs of a batch: one for each part, or for each part and row of a study.
#pragma once

#include "cli/batch_request.h"

#include <string>
#include <utility>
#include <vector>

namespace voluta::cli {

struct BatchJob {
  std::string name;               // Of its folder: letters, digits, '.', '_' and '-'
  std::string part;               // Absolute, or sample:NAME
  std::vector<std::string> words; // Of plan, without part and folder
  std::vector<std::pair<std::string, std::string>> settings; // Cells of its row of the study
};

// Lists the files of parts in folders by name. Throws Error{Usage} if there is no job, or if a
// column of the study is no option and no parameter; Error{UnreadableFile} for a part or a study
// that is missing.
std::vector<BatchJob> batchJobs(const BatchOptions& options);

} // namespace voluta::cli
