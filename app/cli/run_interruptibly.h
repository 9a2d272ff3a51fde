// Runs work on another thread while this one waits for it or for Ctrl-C.
#pragma once

#include "base/outcome.h"
#include "base/run_context.h"
#include "cli/exit_code.h"
#include "cli/result_folder.h"

#include <fmt/format.h>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace voluta::cli {

// Blocks SIGINT and SIGTERM in this thread and the threads that it starts. Call it before any
// thread exists.
void blockInterrupts();

// Waits until `done()` is true. Returns true if SIGINT or SIGTERM came first. Precondition:
// blockInterrupts() was called.
bool waitOrInterrupted(const std::function<bool()>& done);

// Runs `work` and returns its outcome. After an interrupt the work has 0.4 s to stop. If it is
// still inside a library call then, `abandon` cleans up and the process ends with exit code 5
// (docs/design.md, Progress and cancel).
template <typename F>
auto runInterruptibly(F work, int threads, base::ProgressSink sink,
                      const std::function<void()>& abandon) {
  using T = std::invoke_result_t<F, const base::RunContext&>;
  const base::CancelToken token;
  auto result = std::make_shared<std::promise<base::Outcome<T>>>();
  std::future<base::Outcome<T>> future = result->get_future();
  const base::RunContext ctx(token, threads, std::move(sink));
  std::thread worker([result, ctx, work = std::move(work)] {
    result->set_value(base::outcomeOf([&] { return work(ctx); }));
  });
  const auto ready = [&] {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (waitOrInterrupted(ready)) {
    token.cancel();
    if (future.wait_for(std::chrono::milliseconds(400)) != std::future_status::ready) {
      abandon();
      std::_Exit(5);
    }
  }
  worker.join();
  base::Outcome<T> outcome = future.get();
  if (token.cancelled())
    outcome = base::Cancelled{};
  return outcome;
}

// Returns the result of a run; nullopt if it was cancelled. Throws the Error with which it ended.
template <typename T> std::optional<T> endedWith(base::Outcome<T> outcome) {
  if (const auto* error = std::get_if<base::Error>(&outcome))
    throw *error;
  if (T* value = std::get_if<T>(&outcome))
    return std::move(*value);
  return std::nullopt;
}

// Returns the result of a run that fills a folder, and moves the folder into place. Returns nullopt
// and prints a line if the run was cancelled. Throws the Error with which it ended, or with which
// the folder refuses the files.
template <typename T> std::optional<T> settled(base::Outcome<T> outcome, ResultFolder& folder) {
  std::optional<T> ended = endedWith(std::move(outcome));
  if (ended)
    folder.commit();
  else
    fmt::print(stderr, "cancelled; {} is as it was\n", folder.target().string());
  return ended;
}

// Runs a command that only prints, or writes one file as a whole.
template <typename F> ExitCode answered(F command, int threads = 1) {
  const auto run = [&](const base::RunContext& ctx) { return command(ctx); };
  return endedWith(runInterruptibly(run, threads, {}, [] {})).value_or(kCancelled);
}
// The same for a command that takes a moment.
template <typename F> std::function<ExitCode()> quick(F command) {
  return [command] { return answered([&](const base::RunContext&) { return command(); }); };
}

} // namespace voluta::cli
