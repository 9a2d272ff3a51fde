#include "cli/batch_command.h"

#include "base/error.h"
#include "cli/batch_table.h"
#include "cli/batch_workflow.h"
#include "cli/run_interruptibly.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voluta::cli {

namespace fs = std::filesystem;

namespace {

// Snakemake changes to its folder: names in its command line are absolute.
std::string profileOf(const BatchOptions& options) {
  if (options.profile == "slurm")
    return (options.folder / "slurm").string();
  return fs::is_directory(options.profile) ? fs::absolute(options.profile).string()
                                           : options.profile;
}

std::vector<std::string> snakemakeWords(const BatchOptions& options) {
  std::vector<std::string> words{"snakemake",
                                 "--directory",
                                 options.folder.string(),
                                 "--snakefile",
                                 (options.folder / "Snakefile").string(),
                                 "--keep-going",
                                 "--rerun-incomplete"};
  if (options.profile.empty())
    words.insert(words.end(), {"--cores", std::to_string(options.cores)});
  else
    words.insert(words.end(), {"--profile", profileOf(options)});
  return words;
}

// Keeps a second batch out of the folder. Snakemake inherits the lock, so that it lasts as long as
// any of its processes, and ends with them however they end; Snakemake's own lock would stay.
class FolderLock {
public:
  explicit FolderLock(const fs::path& folder)
      : file_(::open((folder / ".batch-lock").c_str(), O_RDWR | O_CREAT, 0666)) {
    if (file_ < 0)
      throw base::Error(base::ErrorCode::CannotWrite, "cannot be written"_text, folder.string());
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw base::Error(base::ErrorCode::Usage, "another batch runs in this folder"_text,
                        folder.string());
  }
  ~FolderLock() { ::close(file_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

private:
  int file_;
};

// Returns the process; nullopt if the program is not installed. It is a process group, so that an
// interrupt reaches the jobs too.
std::optional<pid_t> started(const std::vector<std::string>& words) {
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, arguments.front(), nullptr, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? std::optional(child) : std::nullopt;
}

enum class WorkflowEnd { Ended, Interrupted, NotInstalled };

WorkflowEnd runWorkflow(const BatchOptions& options) {
  std::vector<std::string> words = snakemakeWords(options);
  words.push_back("--nolock"); // FolderLock
  const std::optional<pid_t> child = started(words);
  if (!child)
    return WorkflowEnd::NotInstalled;
  const auto ended = [&] {
    int status = 0;
    const pid_t answer = ::waitpid(*child, &status, WNOHANG);
    return answer == *child || (answer < 0 && errno == ECHILD);
  };
  bool interrupted = false;
  while (waitOrInterrupted(ended)) {
    interrupted = true;
    ::kill(-*child, SIGINT);
  }
  return interrupted ? WorkflowEnd::Interrupted : WorkflowEnd::Ended;
}

ExitCode sayTable(const BatchTable& table, const fs::path& folder) {
  for (const std::string& job : table.incomplete)
    fmt::print("{}\n", job);
  for (const std::string& job : table.missing)
    fmt::print("{}: not planned\n", job);
  fmt::print("{} of {} jobs verified; {}\n", table.verified,
             table.verified + table.incomplete.size() + table.missing.size(),
             (folder / "table.csv").string());
  if (!table.missing.empty())
    fmt::print(stderr, "{} job{} did not end; the same command resumes the batch\n",
               table.missing.size(), table.missing.size() == 1 ? "" : "s");
  return table.incomplete.empty() && table.missing.empty() ? kDone : kNotAll;
}

} // namespace

ExitCode batchCommand(const BatchOptions& given) {
  BatchOptions options = given;
  options.folder = fs::absolute(given.folder).lexically_normal();
  if (options.tableOnly) {
    writeBatchTable(options.folder);
    return kDone;
  }
  const std::vector<BatchJob> jobs = batchJobs(options);
  writeWorkflow(options, jobs);
  if (options.writeOnly) {
    fmt::print("{} jobs; run them with: {}\n", jobs.size(),
               fmt::join(snakemakeWords(options), " "));
    return kDone;
  }
  const FolderLock lock(options.folder);
  const WorkflowEnd end = runWorkflow(options);
  if (end == WorkflowEnd::NotInstalled)
    throw base::Error(base::ErrorCode::Usage, "Snakemake is not installed"_text, {},
                      "apt install snakemake, or give --write-only"_text);
  const ExitCode code = sayTable(writeBatchTable(options.folder), options.folder);
  return end == WorkflowEnd::Interrupted ? kCancelled : code;
}

} // namespace voluta::cli
