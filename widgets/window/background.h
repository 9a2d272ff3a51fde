// Runs work in the background and hands its result to the window's thread.
#pragma once

#include "jobs/job_runner.h"

#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

namespace voluta::window {

// Calls work() or work(ctx) in the background, then done(result) on the window's thread. Replaces
// the runner's current job. Uses one thread, because planning uses the others. Does nothing after
// an error, which would be a bug in the program.
template <typename Work, typename Done>
void inBackground(jobs::JobRunner& runner, Work work, Done done) {
  auto call = [work = std::move(work)](const base::RunContext& ctx) mutable {
    if constexpr (std::is_invocable_v<Work&, const base::RunContext&>)
      return std::make_shared<std::invoke_result_t<Work&, const base::RunContext&>>(work(ctx));
    else
      return std::make_shared<std::invoke_result_t<Work&>>(work());
  };
  using Made = std::invoke_result_t<decltype(call)&, const base::RunContext&>;
  runner.run(
      std::move(call),
      [done = std::move(done)](base::Outcome<Made> outcome) mutable {
        if (const Made* made = std::get_if<Made>(&outcome))
          done(std::move(**made));
      },
      1);
}

} // namespace voluta::window
