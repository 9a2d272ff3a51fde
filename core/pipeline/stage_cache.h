// Results of stages, kept by what went into them.
#pragma once

#include "project/stage.h"

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

// Good for several threads at once. T is one of the stage values of pipeline/stages.h, each of
// which names its stage.
class StageCache {
public:
  // Keeps the last `kept` results of each stage and slot. `behind` outlives it: what is kept here
  // is kept there too, and what is found there is kept here.
  explicit StageCache(std::size_t kept = 3, StageCache* behind = nullptr)
      : kept_(kept), behind_(behind) {}

  // nullptr: not kept. `slot`: a format's id for programs, "voxels" for a decomposition's.
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
  StageCache* behind_; // null: none
  std::mutex mutex_;
  // Latest first.
  std::map<std::pair<project::Stage, std::string>, std::vector<std::pair<std::string, Value>>>
      shelves_;
};

// What a job read from disk holds of its first stage, and the plate of its cell: not the cells of a
// voxel object. Throws Error{Usage, UnreadableFile, UnusableInput} where its cell cannot be read.
std::shared_ptr<modes::LoadStage> loadStageOf(const project::Job& job);
// Puts what a job read from disk holds into the cache, so that a plan of the same choices makes
// only what is not in the file (the programs).
void seedCache(StageCache& cache, const project::Job& job);

} // namespace voluta::pipeline
