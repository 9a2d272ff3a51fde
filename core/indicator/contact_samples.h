// Training samples for an indicator near a contact configuration space: first sparse, evenly
// distributed ones on it, then more across the border between free and colliding. Source: Dai 2020,
// 4.4.2, algorithm 7.
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
  std::size_t samples = 3020;  // maximum number
  std::size_t neighbours = 20; // nearest neighbours considered per sample
  // Neighbours further apart get a sample in between; halved while there is room
  double evenRad = 0.8;
  double borderRad = 0.05; // same for pairs of which one collides
  // Ends after so many phases, which alternate: samples in between everywhere, then at the border.
  // 0: as many as there is room for
  int phases = 0;
  std::uint64_t seed = 1;
};

// Both are called from several threads concurrently.
using TrueCheck = std::function<bool(const robot::JointVector&)>;
using Projection =
    // Onto the contact space
    std::function<std::optional<robot::JointVector>(const robot::JointVector&)>;

// Returns the samples, starting with `first`, which must be on the contact space. Every second new
// sample is projected onto it, the others are not. Pairs are processed by decreasing distance, and
// no sample is closer to another than half the distance that triggered it. The result does not
// depend on the number of threads. Returns fewer samples than requested if no pairs are left.
// Throws Cancelled.
std::vector<JudgedJoints> contactSamples(const std::vector<robot::JointVector>& first,
                                         const std::vector<robot::JointLimits>& limits,
                                         const TrueCheck& collides, const Projection& project,
                                         const ContactSampling& options,
                                         const base::RunContext& ctx);

} // namespace voluta::indicator
