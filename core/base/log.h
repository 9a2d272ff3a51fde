// A log file for whoever looks into a fault: what was done, in lines with their time.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace spdlog {
class logger;
}

namespace voluta::base {

enum class LogLevel { Info, Warning, Error };

// Copies write to the same file. To be written from any thread.
class Log {
public:
  // Writes nothing.
  Log() = default;
  // Goes on where the file ends; at `mostBytes` it becomes NAME.1.log, and so on to NAME.2.log, so
  // that the three hold that much each at most. Makes the folder. Throws Error{CannotWrite}.
  explicit Log(const std::filesystem::path& file, std::size_t mostBytes = 200000);

  // One line, in the file at once; line ends within the message become spaces. What cannot be
  // written is lost without a word: a log is no reason to stop.
  void write(LogLevel level, std::string_view message) const;

private:
  std::shared_ptr<spdlog::logger> logger_;
};

} // namespace voluta::base
