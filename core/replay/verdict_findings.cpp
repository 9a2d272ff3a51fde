#include "replay/verdict_findings.h"

#include "plan/finding_kinds.h"

#include <utility>

namespace voluta::replay {

TextFinding findingAtMotion(const Verification& verdict, plan::FindingKind kind, std::size_t motion,
                            std::vector<plan::NamedValue> values, const Eigen::Vector3d& where,
                            double whenS, std::size_t count) {
  const TextPlace place = verdict.motionPlaces[motion];
  TextFinding found{plan::makeFinding(kind, std::move(values), where, count), place};
  found.finding.whenS = whenS;
  found.finding.program = programLine(place, verdict.motionPlaces.back());
  return found;
}

void addFinding(Verification& verdict, TextFinding finding) {
  verdict.findings.push_back(std::move(finding.finding));
  verdict.places.push_back(finding.place);
}

void addFindings(Verification& verdict, std::vector<TextFinding> findings) {
  for (TextFinding& finding : findings)
    addFinding(verdict, std::move(finding));
}

} // namespace voluta::replay
