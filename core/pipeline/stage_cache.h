// Cache of stage results, keyed by the text of their inputs.
#pragma once

#include "project/job_stage.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace voluta::modes {
struct LoadStage;
}
namespace voluta::project {
struct Job;
}

namespace voluta::pipeline {

struct Resolved;

// Thread-safe. T is one of the stage values of pipeline/stages.h, which name their stage.
class StageCache {
public:
  // Keeps the last `kept` results of each stage and slot. `behind` is a second cache that must
  // outlive this one: results kept here are also kept there, and results found there are copied
  // here.
  explicit StageCache(std::size_t kept = 3, StageCache* behind = nullptr)
      : kept_(kept), behind_(behind) {}

  // Returns nullptr if nothing is cached. `slot`: a program's format id, or "voxels" for the voxels
  // of a decomposition.
  template <typename T>
  std::shared_ptr<const T> find(const std::string& key, const std::string& slot = {}) {
    return std::static_pointer_cast<const T>(findAny(T::kStage, slot, key));
  }
  template <typename T>
  void keep(const std::string& key, std::shared_ptr<const T> value, const std::string& slot = {}) {
    keepAny(T::kStage, slot, key, std::move(value));
  }
  void clear();

private:
  using Value = std::shared_ptr<const void>;
  Value findAny(project::Stage stage, const std::string& slot, const std::string& key);
  Value findHere(project::Stage stage, const std::string& slot, const std::string& key);
  void keepAny(project::Stage stage, const std::string& slot, const std::string& key,
               const Value& value);
  void keepHere(project::Stage stage, const std::string& slot, const std::string& key, Value value);

  std::size_t kept_;
  StageCache* behind_; // may be null
  std::mutex mutex_;
  // Most recently used first.
  std::map<std::pair<project::Stage, std::string>, std::vector<std::pair<std::string, Value>>>
      shelves_;
};

// Returns the Load stage of a job read from disk with the plate of its cell, but without the cells
// of a voxel object. Throws Error{Usage, UnreadableFile, UnusableInput} if its cell cannot be read.
std::shared_ptr<modes::LoadStage> loadStageOf(const project::Job& job, std::size_t index,
                                              const Resolved& resolved);
// Puts the results of a job read from disk into the cache, so that a plan with the same choices
// computes only the results that the file lacks (the programs).
void seedCache(StageCache& cache, const project::Job& job);

} // namespace voluta::pipeline
