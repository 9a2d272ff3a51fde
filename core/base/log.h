// A log file for diagnosing faults: the program's actions, one line each with its time.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace spdlog {
class logger;
}

namespace voluta::base {

enum class LogLevel { Info, Warning, Error };

// Copies write to the same file. Thread-safe.
class Log {
public:
  // Writes nothing.
  Log() = default;
  // Appends to the file; at `maxBytes` it becomes NAME.1.log, and that one NAME.2.log, so that
  // each of the three has at most that size. Creates the folder. Throws Error{CannotWrite}.
  explicit Log(const std::filesystem::path& file, std::size_t maxBytes = 200000);

  // Writes one line, immediately; line breaks within the message become spaces. Write errors are
  // ignored, since logging must not stop the program.
  void write(LogLevel level, std::string_view message) const;

private:
  std::shared_ptr<spdlog::logger> logger_;
};

} // namespace voluta::base
