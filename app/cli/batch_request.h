// The request of a batch.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::cli {

struct BatchOptions {
  std::vector<std::string> parts;           // Files, folders or sample:NAME
  std::filesystem::path study;              // Table of settings; empty: none
  std::vector<std::string> planWords;       // Options of plan for all jobs
  std::vector<std::string> planOptionNames; // Columns of a study that are options of plan
  std::filesystem::path folder;
  std::string profile; // Empty: this machine; "slurm": the one in the folder
  bool writeOnly = false, tableOnly = false, replace = false;
  int cores = 1;
  int threads = 0; // Of a job; 0: cores divided by jobs
  int memoryMb = 4000;
};

} // namespace voluta::cli
