// Findings of a station: what keeps its machines from working together, with the place in the frame
// that they share.
#pragma once

#include "pipeline/plan_result.h"
#include "pipeline/plan_verdict.h"
#include "plan/finding.h"
#include "replay/shared_run.h"
#include "together/placed_motion.h"
#include "together/together.h"

#include <cstddef>
#include <optional>
#include <span>

namespace voluta::pipeline {

// Returns why there is no order of work. `plans`, `motions`: per machine.
plan::Finding obstructionFinding(const together::Obstruction& obstruction,
                                 const together::Plan& work, std::span<const PlanResult> plans,
                                 std::span<const together::PlacedMotion> motions);
// Returns a note for each two plates that overlap, which may be on purpose.
plan::Findings overlapFindings(std::span<const together::PlacedMotion> motions);
// Returns why a common run of the programs is refused; nothing if it is not.
plan::Findings runFindings(const replay::SharedRun& run);
// Returns the finding that machine k (from 0) keeps its programs back.
plan::Finding machineFinding(std::size_t k, base::Message reason);
// Returns the finding about machine k (from 0) by the verdict on it alone, with the first of its
// blocking findings; nullopt if it passed.
std::optional<plan::Finding> machineFinding(std::size_t k, PlanVerdict verdict,
                                            const plan::Findings& own);

// Returns whether other places of the machines may help against the finding.
bool isOfPlaces(const plan::Finding& finding);

} // namespace voluta::pipeline
