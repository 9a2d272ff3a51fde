// The folder into which a command writes its results.
#pragma once

#include "base/error.h"
#include "base/staged_folder.h"
#include "pipeline/own_folder.h"

#include <filesystem>
#include <utility>

namespace voluta::cli {

// Without `replace`, throws Error{CannotWrite} if the folder holds the file: the stopped print,
// which its rest would replace.
inline void keepStoppedPrint(const std::filesystem::path& file, const std::filesystem::path& folder,
                             bool replace) {
  std::error_code none;
  if (!replace &&
      std::filesystem::equivalent(std::filesystem::absolute(file).parent_path(), folder, none))
    throw base::Error(base::ErrorCode::CannotWrite,
                      "holds the stopped print, which its rest would replace"_text, folder.string(),
                      "choose another folder, or give --replace"_text);
}

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
