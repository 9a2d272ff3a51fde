// Findings of a verdict, each with its place in the program's text.
#pragma once

#include "replay/comparison.h"
#include "replay/verification.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::replay {

inline constexpr std::size_t kMaxListed = 100; // of each kind; the rest is only counted

// Returns a finding with the line of that motion. Precondition: verdict.motionPlaces is complete.
TextFinding findingAtMotion(const Verification& verdict, plan::FindingKind kind, std::size_t motion,
                            std::vector<plan::NamedValue> values, const Eigen::Vector3d& where,
                            double whenS, std::size_t count = 1);

// Adds findings to the verdict, in their order.
void addFinding(Verification& verdict, TextFinding finding);
void addFindings(Verification& verdict, std::vector<TextFinding> findings);

} // namespace voluta::replay
