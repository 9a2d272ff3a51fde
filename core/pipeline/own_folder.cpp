#include "pipeline/own_folder.h"

#include "base/error.h"
#include "base/files.h"
#include "pipeline/mill_job.h"
#include "project/job_magic.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

namespace voluta::pipeline {

namespace {

bool hasKeys(std::string_view text, std::initializer_list<const char*> keys) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() &&
         std::ranges::all_of(keys, [&](const char* key) { return json.contains(key); });
}

struct OwnFile {
  FolderKind kind;
  const char* name;
  bool (*isOwn)(std::string_view bytes);
};

constexpr std::array kFiles{
    OwnFile{FolderKind::Plan, "job.voluta",
            [](std::string_view bytes) { return bytes.starts_with(project::kJobMagic); }},
    OwnFile{FolderKind::Plan, "report.json",
            [](std::string_view bytes) {
              return hasKeys(bytes, {"findings", "toolpath"});
            }},
    OwnFile{FolderKind::Comparison, "compare.json",
            [](std::string_view bytes) {
              return hasKeys(bytes, {"rule", "best"});
            }},
    OwnFile{FolderKind::Together, "together.json",
            [](std::string_view bytes) {
              return hasKeys(bytes, {"machines", "refusal"});
            }},
    OwnFile{FolderKind::Milling, kMillJobFile, isMillJob},
    OwnFile{FolderKind::Milling, "report.json", [](std::string_view bytes) {
              return hasKeys(bytes, {"findings", "milling"});
            }}};

bool isOwn(const OwnFile& row, const std::filesystem::path& file) {
  try {
    return row.isOwn(base::readFile(file));
  } catch (const base::Error&) {
    return false; // A folder, or not ours to read
  }
}

base::Error wouldReplace(const std::filesystem::path& file) {
  return base::Error(base::ErrorCode::CannotWrite,
                     "is no result of this kind of job, and would be replaced"_text, file.string(),
                     "choose another folder, or give --replace"_text);
}

} // namespace

void requireOwnFiles(const std::filesystem::path& folder, FolderKind kind) {
  for (const OwnFile& row : kFiles) {
    const std::filesystem::path file = folder / row.name;
    std::error_code none;
    if (row.kind == kind && std::filesystem::exists(file, none) && !isOwn(row, file))
      throw wouldReplace(file);
  }
}

void requireOwnResults(const std::vector<std::filesystem::path>& replaced,
                       const std::filesystem::path& folder, FolderKind kind) {
  const bool holdsResults = std::ranges::any_of(kFiles, [&](const OwnFile& row) {
    return row.kind == kind && isOwn(row, folder / row.name);
  });
  if (!replaced.empty() && !holdsResults)
    throw wouldReplace(replaced.front());
}

} // namespace voluta::pipeline
