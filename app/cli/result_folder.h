// The folder into which a command writes its results.
#pragma once

#include "base/staged_folder.h"
#include "pipeline/own_folder.h"

#include <filesystem>
#include <utility>

namespace voluta::cli {

class ResultFolder {
public:
  // Without `replace`, throws Error{CannotWrite} for files of others that the results would
  // replace: at once for those that every job of this kind writes, in commit() for all others. Also
  // throws as StagedFolder.
  ResultFolder(std::filesystem::path target, pipeline::FolderKind kind, bool replace)
      : target_(std::move(target)), kind_(kind), replace_(replace), staged_(checked()) {}

  const std::filesystem::path& target() const { return target_; }
  // The results are written here.
  const std::filesystem::path& path() const { return staged_.path(); }
  void commit() {
    if (!replace_)
      pipeline::requireOwnResults(staged_.replaced(), target_, kind_);
    staged_.commit();
  }
  void discard() noexcept { staged_.discard(); }

private:
  const std::filesystem::path& checked() const {
    if (!replace_)
      pipeline::requireOwnFiles(target_, kind_);
    return target_;
  }

  std::filesystem::path target_;
  pipeline::FolderKind kind_;
  bool replace_;
  base::StagedFolder staged_;
};

} // namespace voluta::cli
