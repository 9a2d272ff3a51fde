#include "cli/progress.h"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace voluta::cli {

namespace {
using Clock = std::chrono::steady_clock;

void drawBar(double fraction, std::string_view what) {
  constexpr int kWidth = 30;
  const int full = static_cast<int>(fraction * kWidth + 0.5);
  fmt::print(stderr, "\r[{:#>{}}{:->{}}] {:3.0f} % {:<40.40}", "", full, "", kWidth - full,
             100.0 * fraction, what);
  std::fflush(stderr);
}

void writeJsonLine(double fraction, std::string_view what) {
  const nlohmann::ordered_json line{{"stage", std::string(what)}, {"fraction", fraction}};
  fmt::print(stderr, "{}\n", line.dump());
}
} // namespace

base::ProgressSink progressSink(ProgressStyle style) {
  if (style == ProgressStyle::None || (style == ProgressStyle::Bar && !::isatty(STDERR_FILENO)))
    return {};
  return [style, last = Clock::time_point{},
          stage = base::Message()](double fraction, const base::Message& message) mutable {
    const Clock::time_point now = Clock::now();
    if (message == stage && now - last < std::chrono::milliseconds(100))
      return;
    last = now;
    stage = message;
    const std::string what = base::english(message);
    style == ProgressStyle::Bar ? drawBar(fraction, what) : writeJsonLine(fraction, what);
  };
}

void endProgress(ProgressStyle style) {
  if (style == ProgressStyle::Bar && ::isatty(STDERR_FILENO))
    fmt::print(stderr, "\r{:80}\r", "");
}

} // namespace voluta::cli
