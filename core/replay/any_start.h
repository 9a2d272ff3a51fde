// Whether programs with marks keep together from any state of the signals and any delay between
// their starts.
#pragma once

#include "plan/program.h"
#include "replay/common_clock.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::replay {

// Returns starts of this many machines: every state of the signals between two machines; up to
// kMaxStates of those of more, the same ones each time; each with every machine as the first and
// as the last one, by up to ten minutes. Precondition: 2 to plan::kMaxMachines machines.
inline constexpr std::size_t kMaxStates = 512;
std::vector<Start> startsOf(std::size_t machines);

// Returns the first mark that a machine passes before the other one has reached it.
std::optional<EarlyMark> earlyMark(const CommonClock& clock);

// Returns the first start after which a machine passes a mark too early or waits for ever; nullopt
// if there is none. Preconditions: as for commonClock.
std::optional<UnsafeStart> unsafeStart(std::span<const plan::ReadProgram* const> programs,
                                       std::span<const std::vector<double>> motionS);

} // namespace voluta::replay
