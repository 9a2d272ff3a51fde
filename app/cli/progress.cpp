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

void drawBar(double fraction, const std::string& title, const std::string& what) {
  constexpr int kWidth = 20;
  const int full = static_cast<int>(fraction * kWidth + 0.5);
  const std::string text = title.empty() ? what : title + ": " + what;
  fmt::print(stderr, "\r[{:#>{}}{:->{}}] {:3.0f} % {:<50.50}", "", full, "", kWidth - full,
             100.0 * fraction, text);
  std::fflush(stderr);
}

void writeJsonLine(double fraction, const std::string& title, const std::string& what) {
  nlohmann::ordered_json line{{"stage", what}, {"fraction", fraction}};
  if (!title.empty())
    line["trying"] = title;
  fmt::print(stderr, "{}\n", line.dump());
}
} // namespace

base::ProgressSink progressSink(ProgressStyle style, std::shared_ptr<const base::Message> title) {
  if (style == ProgressStyle::None || (style == ProgressStyle::Bar && !::isatty(STDERR_FILENO)))
    return {};
  return [style, title = std::move(title), last = Clock::time_point{},
          stage = base::Message()](double fraction, const base::Message& message) mutable {
    const Clock::time_point now = Clock::now();
    if (message == stage && now - last < std::chrono::milliseconds(100))
      return;
    last = now;
    stage = message;
    const std::string what = base::english(message);
    const std::string before = title ? base::english(*title) : std::string();
    style == ProgressStyle::Bar ? drawBar(fraction, before, what)
                                : writeJsonLine(fraction, before, what);
  };
}

void endProgress(ProgressStyle style) {
  if (style == ProgressStyle::Bar && ::isatty(STDERR_FILENO))
    fmt::print(stderr, "\r{:80}\r", "");
}

} // namespace voluta::cli
