#include "pipeline/head_verdict.h"

#include "pipeline/replay_stage.h"
#include "plan/finding_kinds.h"
#include "replay/verification.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace voluta::pipeline {

namespace {
using plan::Finding;
using plan::FindingKind;

double percentOf(const Finding& finding, std::string_view name) {
  const base::Value* value = finding.value(name);
  const auto* quantity = value ? std::get_if<base::Quantity>(&value->data()) : nullptr;
  return quantity ? quantity->number : 0.0;
}

// A few words for the figures that most parts differ by.
std::string amountOf(const Finding& finding) {
  switch (finding.kind) {
  case FindingKind::Uncovered:
    return fmt::format("{:.1f} % not covered", percentOf(finding, "share"));
  case FindingKind::Overfill:
    return fmt::format("{:.1f} % too much",
                       percentOf(finding, "outside") + percentOf(finding, "noRoom"));
  case FindingKind::Mass:
    return fmt::format("mass {:.1f} % of the part's", percentOf(finding, "share"));
  case FindingKind::Unsupported:
    return fmt::format("{:.1f} % of bead unsupported", percentOf(finding, "share"));
  default:
    return base::english(plan::factOf(finding));
  }
}

std::string pointOf(const Finding& finding) {
  std::string text = amountOf(finding);
  if (finding.where)
    text += fmt::format(" at ({:.1f} {:.1f} {:.1f})", finding.where->x(), finding.where->y(),
                        finding.where->z());
  return text;
}

std::string pointsOf(const plan::Findings& findings) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> points;
  for (const Finding& finding : findings)
    if (points.size() < kShown)
      points.push_back(pointOf(finding));
  if (findings.size() > kShown)
    points.push_back(fmt::format("{} more", findings.size() - kShown));
  return fmt::format("{}", fmt::join(points, "; "));
}
} // namespace

std::string headVerdict(const replay::Verification& verdict, const plan::Findings& blockers,
                        const std::string& accepted) {
  if (!verdict.safeToRun) {
    std::vector<std::string> failed;
    for (const base::Message& one : failedThresholds(verdict))
      failed.push_back(base::english(one));
    return fmt::format("REFUSED, do not run: {}", fmt::join(failed, "; "));
  }
  plan::Findings all, safety;
  std::ranges::copy_if(verdict.findings, std::back_inserter(all), &Finding::blocking);
  std::ranges::copy(blockers, std::back_inserter(all));
  std::ranges::copy_if(all, std::back_inserter(safety), plan::blocksRunning);
  if (!safety.empty())
    return "NOT approved, the plan is not safe: " + pointsOf(safety);
  plan::Findings differing;
  std::ranges::copy_if(all, std::back_inserter(differing), [](const Finding& finding) {
    return finding.kind != FindingKind::OwnStatement;
  });
  const std::string differs =
      differing.empty() && verdict.passed ? "" : "; differs from the part: " + pointsOf(differing);
  if (differing.size() < all.size())
    return fmt::format("safe to run but for your own statements, which nothing checks{}", differs);
  if (!differs.empty())
    return "safe to run" + differs;
  return accepted.empty() ? std::string(kPassedVerdict)
                          : "safe to run; prints the part with accepted differences: " + accepted;
}

} // namespace voluta::pipeline
