// The cut of a tape: a pulse of the cutter's output, which cuts when it turns on and is drawn back
// when it turns off.
#pragma once

namespace voluta::program {

// Duration of the pulse as written, and the durations that a reader accepts [s].
inline constexpr double kCutPulseS = 0.2, kMinCutPulseS = 0.1, kMaxCutPulseS = 1.0;

} // namespace voluta::program
