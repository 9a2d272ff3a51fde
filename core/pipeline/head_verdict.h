// The verdict on a program as the line of its head states it.
#pragma once

#include "plan/finding.h"

#include <string>
#include <string_view>

namespace voluta::replay {
struct Verification;
}

namespace voluta::pipeline {

// Programs are written with this verdict: the text of one that passes is the text that was
// replayed.
inline constexpr std::string_view kPassedVerdict =
    "passed, safe to run and prints the part as asked";

// Returns the verdict in English, with each point's amount and place, e.g. "safe to run; differs
// from the part: 4.6 % not covered at (7.0 -3.0 4.5)". `blockers`: findings that block the plan,
// apart from those of its programs. `accepted`: differences that the user accepts beyond the
// quality's limits, as textOf(Quality::accepted).
std::string headVerdict(const replay::Verification& verdict, const plan::Findings& blockers,
                        const std::string& accepted = {});

} // namespace voluta::pipeline
