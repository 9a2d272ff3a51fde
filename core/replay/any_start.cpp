#include "replay/any_start.h"

#include "plan/marks.h"
#include "replay/marked_run.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <random>
#include <utility>

namespace voluta::replay {

namespace {
// The outputs of each machine that are inputs of another one.
std::vector<std::pair<std::size_t, std::size_t>> outputsOf(std::size_t machines) {
  std::vector<std::pair<std::size_t, std::size_t>> outputs;
  for (std::size_t k = 0; k < machines; ++k)
    for (std::size_t signal = 0; signal < 2 * (machines - 1); ++signal)
      outputs.emplace_back(k, signal);
  return outputs;
}

std::vector<std::array<double, plan::kMaxMachines>> delaysOf(std::size_t machines) {
  constexpr double kMaxS = 600.0, kStepS = 7.0;
  std::vector<std::array<double, plan::kMaxMachines>> delays(1);
  for (std::size_t k = 0; k < machines; ++k)
    for (const bool isLate : {true, false}) {
      std::array<double, plan::kMaxMachines>& own = delays.emplace_back();
      const std::size_t first = isLate ? (k == 0 ? 1 : 0) : k; // machine that starts first
      for (std::size_t j = 0; j < machines; ++j)
        own.at(j) = (j == k) == isLate ? kMaxS + kStepS * static_cast<double>(first)
                                       : kStepS * static_cast<double>(j);
    }
  return delays;
}

// The marks of each machine with another one.
std::vector<PassedMark> marksWith(const MachineClock& clock, std::size_t other) {
  std::vector<PassedMark> marks;
  std::ranges::copy_if(clock.marks, std::back_inserter(marks),
                       [&](const PassedMark& mark) { return mark.other == other; });
  return marks;
}

// Returns how many of them a machine has left behind that may wait for ever amid the last one.
std::size_t passedBy(const MachineClock& clock, const std::vector<PassedMark>& marks) {
  return static_cast<std::size_t>(std::ranges::count_if(marks, [&](const PassedMark& mark) {
    return mark.toS > mark.fromS && !clock.beginS.empty() && clock.beginS.back() >= mark.toS;
  }));
}
} // namespace

std::vector<Start> startsOf(std::size_t machines) {
  const auto outputs = outputsOf(machines);
  std::vector<Start> states;
  const bool areAll = outputs.size() < 10 && (std::size_t{1} << outputs.size()) <= kMaxStates;
  const std::size_t count = areAll ? std::size_t{1} << outputs.size() : kMaxStates;
  std::mt19937_64 random(7);
  for (std::size_t state = 0; state < count; ++state) {
    // The last of a sample has all signals on, the first none.
    const std::uint64_t bits = areAll || state == 0 ? state
                               : state + 1 == count ? ~std::uint64_t{0}
                                                    : random();
    Start& start = states.emplace_back();
    for (std::size_t b = 0; b < outputs.size(); ++b)
      start.on.at(outputs[b].first).set(outputs[b].second, (bits >> b & 1U) != 0);
  }
  std::vector<Start> starts;
  for (const auto& delays : delaysOf(machines))
    for (Start start : states) {
      start.delayS = delays;
      starts.push_back(start);
    }
  return starts;
}

std::optional<EarlyMark> earlyMark(const CommonClock& clock) {
  constexpr double kSameS = 1e-9;
  for (std::size_t one = 0; one < clock.machines.size(); ++one)
    for (std::size_t other = 0; other < clock.machines.size(); ++other) {
      if (one == other)
        continue;
      const std::vector<PassedMark> own = marksWith(clock.machines[one], other),
                                    theirs = marksWith(clock.machines[other], one);
      const std::size_t passed = clock.stuck ? passedBy(clock.machines[one], own) : own.size();
      for (std::size_t m = 0; m < passed; ++m)
        if (m >= theirs.size() || own[m].toS + kSameS < theirs[m].fromS)
          return EarlyMark{one, other, own[m].file, own[m].line};
    }
  return std::nullopt;
}

std::optional<UnsafeStart> unsafeStart(std::span<const plan::ReadProgram* const> programs,
                                       std::span<const std::vector<double>> motionS) {
  std::vector<std::vector<MarkedAction>> actions;
  for (std::size_t k = 0; k < programs.size(); ++k)
    actions.push_back(joinedMotions(markedActions(*programs[k], motionS[k])));
  const auto hasMarks = [](const std::vector<MarkedAction>& own) { return own.size() > 1; };
  if (std::ranges::none_of(actions, hasMarks))
    return std::nullopt;
  for (const Start& start : startsOf(programs.size())) {
    const CommonClock clock = runMarked(actions, start);
    std::optional<EarlyMark> early = earlyMark(clock);
    if (early || clock.stuck)
      return UnsafeStart{start, early, clock.stuck};
  }
  return std::nullopt;
}

} // namespace voluta::replay
