#include "base/log.h"

#include "base/error.h"

#include <algorithm>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>
#include <string>

namespace voluta::base {

namespace {
constexpr std::size_t kOlderFiles = 2;

spdlog::level::level_enum toSpdlog(LogLevel level) {
  switch (level) {
  case LogLevel::Info:
    return spdlog::level::info;
  case LogLevel::Warning:
    return spdlog::level::warn;
  case LogLevel::Error:
    break;
  }
  return spdlog::level::err;
}
} // namespace

Log::Log(const std::filesystem::path& file, std::size_t maxBytes) {
  try {
    logger_ = std::make_shared<spdlog::logger>(
        "voluta", std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file.string(), maxBytes,
                                                                         kOlderFiles));
  } catch (const spdlog::spdlog_ex& e) {
    throw Error(ErrorCode::CannotWrite,
                message("cannot be written: {why}"_text, std::string(e.what())), file.string());
  }
  logger_->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
  logger_->flush_on(spdlog::level::trace);
  logger_->set_error_handler([](const std::string&) {});
}

void Log::write(LogLevel level, std::string_view message) const {
  if (!logger_)
    return;
  std::string line(message);
  std::replace(line.begin(), line.end(), '\n', ' ');
  logger_->log(toSpdlog(level), line);
}

} // namespace voluta::base
