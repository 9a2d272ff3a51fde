// The program as a process: its exit code, its words and the files that it writes.
#pragma once

#include "base/files.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace voluta::test {

struct Ended {
  int code = -1;
  std::string out, err;
};

class CommandLine : public ::testing::Test {
protected:
  // With `cancelled`, the program begins with a SIGTERM that waits for it.
  pid_t start(const std::vector<std::string>& words, bool cancelled = false) const {
    std::vector<std::string> all{VOLUTA_CLI};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> argv;
    for (std::string& word : all)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      const int out = ::open((folder_ / "stdout").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
      const int err = ::open((folder_ / "stderr").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644);
      ::dup2(out, STDOUT_FILENO);
      ::dup2(err, STDERR_FILENO);
      if (cancelled) {
        sigset_t set;
        sigemptyset(&set);
        sigaddset(&set, SIGTERM);
        ::sigprocmask(SIG_BLOCK, &set, nullptr);
        ::raise(SIGTERM);
      }
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
    return child;
  }
  Ended finish(pid_t child) const {
    int status = 0;
    ::waitpid(child, &status, 0);
    Ended ended;
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.out = base::readFile(folder_ / "stdout");
    ended.err = base::readFile(folder_ / "stderr");
    return ended;
  }
  Ended run(const std::vector<std::string>& words) const { return finish(start(words)); }

  // A binary STL of a mesh.
  std::string stl(const std::string& name, const geometry::TriangleMesh& mesh) const {
    std::string bytes(80, ' ');
    const auto put = [&](const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k)
        put(0.0f);
      for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)
          put(static_cast<float>(mesh.corner(t, k)[axis]));
      put(std::uint16_t{0});
    }
    base::writeFile(folder_ / name, bytes);
    return (folder_ / name).string();
  }
  std::string smallBox() const {
    return stl("box.stl", box(Eigen::Vector3d(-10, -9, 0), Eigen::Vector3d(10, 9, 8)));
  }
  static std::set<std::string> names(const std::filesystem::path& folder) {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      found.insert(entry.path().filename().string());
    return found;
  }
  // Every entry of the folder but the two that hold the child's words.
  std::set<std::string> entries() const {
    std::set<std::string> found = names(folder_.path());
    found.erase("stdout");
    found.erase("stderr");
    return found;
  }

  const TemporaryFolder folder_;
};

inline void expectOneLine(const Ended& ended, int code, const std::vector<std::string>& says) {
  EXPECT_EQ(ended.code, code) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  for (const std::string& word : says)
    EXPECT_NE(ended.err.find(word), std::string::npos) << "no '" << word << "' in: " << ended.err;
}

} // namespace voluta::test
