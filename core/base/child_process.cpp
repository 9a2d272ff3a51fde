#include "base/child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace voluta::base {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kAskMs = 50;

bool isCancelled(const ChildLimits& limits) {
  return limits.cancelled && limits.cancelled();
}

// Reads until the output ends or a limit is reached.
ChildResult::End readAll(int from, Clock::time_point until, const ChildLimits& limits,
                         std::string& output) {
  std::string buffer(1 << 16, '\0');
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    if (left.count() <= 0)
      return ChildResult::End::TimedOut;
    if (isCancelled(limits))
      return ChildResult::End::Cancelled;
    pollfd waiting{from, POLLIN, 0};
    const auto longest =
        limits.cancelled ? std::min<long long>(left.count(), kAskMs) : left.count();
    const int ready = ::poll(&waiting, 1, static_cast<int>(longest) + 1);
    if (ready < 0 && errno != EINTR)
      return ChildResult::End::Crashed;
    if (ready <= 0)
      continue;
    const ssize_t n = ::read(from, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return ChildResult::End::Exited;
    if (output.size() + static_cast<std::size_t>(n) > limits.bytes)
      return ChildResult::End::TooMuchOutput;
    output.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

// Returns how the child ends; TimedOut and Cancelled: it still runs.
ChildResult::End endOf(pid_t child, Clock::time_point until, const ChildLimits& limits,
                       int& status) {
  while (true) {
    const pid_t done = ::waitpid(child, &status, WNOHANG);
    if (done == child)
      return ChildResult::End::Exited;
    if ((done < 0 && errno != EINTR) || Clock::now() >= until)
      return ChildResult::End::TimedOut;
    if (isCancelled(limits))
      return ChildResult::End::Cancelled;
    ::usleep(1000);
  }
}

} // namespace

ChildResult runChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const ChildLimits& limits) {
  const auto until = Clock::now() + limits.time;
  ChildResult result;
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0)
    return result;
  std::string name = program.string();
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  // The caller may block signals that are meant only for it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = 0;
  const int failed =
      ::posix_spawn(&child, name.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  if (failed != 0) {
    ::close(pipe[0]);
    return result;
  }
  result.end = readAll(pipe[0], until, limits, result.output);
  ::close(pipe[0]);
  int status = 0;
  if (result.end == ChildResult::End::Exited)
    result.end = endOf(child, until, limits, status);
  if (result.end != ChildResult::End::Exited) {
    ::kill(child, SIGKILL);
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
  } else if (WIFEXITED(status)) {
    result.code = WEXITSTATUS(status);
    constexpr int kNoProgram = 127; // Exit code of a spawn that fails late
    if (result.code == kNoProgram && result.output.empty())
      result.end = ChildResult::End::NotStarted;
  } else {
    result.end = ChildResult::End::Crashed;
  }
  return result;
}

std::filesystem::path programBeside(const std::string& name) {
  std::error_code status;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", status).parent_path();
  if (std::filesystem::path beside = folder / name; std::filesystem::exists(beside, status))
    return beside;
  return folder.parent_path() / "libexec" / "voluta" / name;
}

} // namespace voluta::base
