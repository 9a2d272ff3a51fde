#include "cli/batch_jobs.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nearest_name.h"
#include "pipeline/stage_options.h"
#include "project/part_formats.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <set>
#include <string_view>

namespace voluta::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSample = "sample:";

bool isPart(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::any_of(project::partFormats(), [&](const project::PartFormat& format) {
    return format.ending == ending;
  });
}

void addParts(const std::string& text, std::vector<std::string>& parts) {
  if (text.starts_with(kSample)) {
    parts.push_back(text);
    return;
  }
  const fs::path path = fs::absolute(text).lexically_normal();
  if (!fs::exists(path))
    throw base::Error(base::ErrorCode::UnreadableFile, "no such file"_text, text);
  if (!fs::is_directory(path)) {
    parts.push_back(path.string());
    return;
  }
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.is_regular_file() && isPart(entry.path()))
      files.insert(entry.path().string());
  parts.insert(parts.end(), files.begin(), files.end());
}

// Returns the rows of a table with commas, or semicolons, and double quotes.
std::vector<std::vector<std::string>> csvRows(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  const std::string_view head = text.substr(0, text.find('\n'));
  const char separator = head.find(',') == std::string_view::npos ? ';' : ',';
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row{{}};
  bool quoted = false;
  const auto endRow = [&] {
    if (row.size() > 1 || !row.front().empty())
      rows.push_back(row);
    row = {{}};
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      row.back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == separator)
      row.emplace_back();
    else if (!quoted && c == '\n')
      endRow();
    else if (quoted || c != '\r')
      row.back() += c;
  }
  endRow();
  return rows;
}

std::string fileName(std::string_view text) {
  std::string name;
  for (const unsigned char c : text)
    name += std::isalnum(c) != 0 || c == '_' || c == '-' || (c == '.' && !name.empty())
                ? static_cast<char>(c)
                : '_';
  return name.empty() ? "part" : name;
}

std::string nameOfPart(const std::string& part) {
  return part.starts_with(kSample) ? part.substr(kSample.size()) : fs::path(part).stem().string();
}

// A row of a study.
struct StudyRow {
  std::string name, part;
  std::vector<std::string> words;
  std::vector<std::pair<std::string, std::string>> settings;
};

class StudyReader {
public:
  explicit StudyReader(const BatchOptions& options) : options_(options) {
    for (const base::ParameterSpec& spec : parameters_.specs())
      known_.push_back(spec.key);
    known_.insert(known_.end(), options.planOptionNames.begin(), options.planOptionNames.end());
    known_.insert(known_.end(), {"name", "part"});
  }

  std::vector<StudyRow> read() const {
    const auto table = csvRows(base::readFile(options_.study));
    if (table.size() < 2)
      throw base::Error(base::ErrorCode::Usage, "the study has no rows"_text,
                        options_.study.string());
    for (const std::string& column : table.front())
      if (std::ranges::find(known_, column) == known_.end())
        throw base::Error(base::ErrorCode::Usage,
                          base::message("unknown column '{column}'"_text, column),
                          options_.study.string(), base::didYouMean(column, known_));
    std::vector<StudyRow> rows;
    for (std::size_t i = 1; i < table.size(); ++i)
      rows.push_back(rowOf(table.front(), table[i], i));
    return rows;
  }

private:
  StudyRow rowOf(const std::vector<std::string>& columns, const std::vector<std::string>& cells,
                 std::size_t number) const {
    if (cells.size() > columns.size())
      throw base::Error(base::ErrorCode::Usage,
                        base::message("row {number} has more cells than columns"_text, number),
                        options_.study.string());
    StudyRow row{fmt::format("{:03}", number), {}, {}, {}};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].empty())
        continue;
      if (columns[i] == "name")
        row.name = cells[i];
      else if (columns[i] == "part")
        row.part = cells[i];
      else
        addSetting(columns[i], cells[i], row);
    }
    return row;
  }

  void addSetting(const std::string& column, const std::string& value, StudyRow& row) const {
    row.settings.emplace_back(column, value);
    if (std::ranges::find(options_.planOptionNames, column) != options_.planOptionNames.end()) {
      row.words.push_back(fmt::format("--{}={}", column, value));
      return;
    }
    row.words.emplace_back("--set");
    row.words.push_back(fmt::format("{}={}", column, value));
  }

  const BatchOptions& options_;
  base::ParameterTable parameters_ = pipeline::allParameters();
  std::vector<std::string> known_;
};

class JobList {
public:
  explicit JobList(const BatchOptions& options) : options_(options) {}

  void add(const std::string& part, const StudyRow* row) {
    BatchJob job{fileName(nameOfPart(part)), part, options_.planWords, {}};
    if (row) {
      job.name += "-" + fileName(row->name);
      job.words.insert(job.words.end(), row->words.begin(), row->words.end());
      job.settings = row->settings;
    }
    const std::string name = job.name;
    for (int copy = 2; !names_.insert(job.name).second; ++copy)
      job.name = fmt::format("{}-{}", name, copy);
    jobs.push_back(std::move(job));
  }

  std::vector<BatchJob> jobs;

private:
  const BatchOptions& options_;
  std::set<std::string> names_;
};

} // namespace

std::vector<BatchJob> batchJobs(const BatchOptions& options) {
  std::vector<std::string> parts;
  for (const std::string& part : options.parts)
    addParts(part, parts);
  JobList list(options);
  if (options.study.empty()) {
    for (const std::string& part : parts)
      list.add(part, nullptr);
  } else {
    for (const StudyRow& row : StudyReader(options).read()) {
      std::vector<std::string> own = parts;
      if (!row.part.empty()) {
        own.clear();
        addParts(row.part.starts_with(kSample)
                     ? row.part
                     : (fs::absolute(options.study).parent_path() / row.part).string(),
                 own);
      }
      for (const std::string& part : own)
        list.add(part, &row);
    }
  }
  if (list.jobs.empty())
    throw base::Error(base::ErrorCode::Usage, "no part to plan"_text, {},
                      "name files of parts, or folders that contain some"_text);
  return std::move(list.jobs);
}

} // namespace voluta::cli
