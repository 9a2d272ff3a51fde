// Samples that teach an indicator where the border between free and colliding runs about a contact
// configuration space: sparse ones on it, made even, then more of them across the border.
// Source: Dai 2020, 4.4.2, algorithm 7.
#pragma once

#include "indicator/learned_indicator.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::indicator {

struct ContactSampling {
  std::size_t samples = 3020;  // at most so many
  std::size_t neighbours = 20; // of a sample that are looked at
  double evenRad = 0.8;    // neighbours further apart get one between; halved while there is room
  double borderRad = 0.05; // and so do those of which one collides, if further apart than this
  std::uint64_t seed = 1;
};

// Both are asked on several threads at once.
using TrueCheck = std::function<bool(const robot::JointVector&)>;
using Projection =
    std::function<std::optional<robot::JointVector>(const robot::JointVector&)>; // onto contact

// `first`: on the contact space; they come first in the answer. Every second sample made from them
// is projected onto it, the others stay beside it. Of pairs the furthest apart come first, and none
// is nearer to another than half the distance that called for it. The same for any number of
// threads. Fewer than asked for where there is nothing left to tell. Throws Cancelled.
std::vector<JudgedJoints> contactSamples(const std::vector<robot::JointVector>& first,
                                         const std::vector<robot::JointLimits>& limits,
                                         const TrueCheck& collides, const Projection& project,
                                         const ContactSampling& options,
                                         const base::RunContext& ctx);

} // namespace voluta::indicator
