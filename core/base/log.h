// Messages for whoever watches a run; quiet unless asked for (spdlog behind it).
#pragma once

#include <string_view>

namespace voluta::base {

enum class LogLevel { Debug, Info, Warning, Error, Off };

// What is below `level` is dropped. Default: Warning. To stderr.
void setLogLevel(LogLevel level);
void log(LogLevel level, std::string_view message);

} // namespace voluta::base
