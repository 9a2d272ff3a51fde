#include "motion/jerk_statistics.h"

#include "plan/finding_kinds.h"

#include <algorithm>

namespace voluta::motion {

namespace {

constexpr double kSlack = 1.005; // for rounding of the times

// Raises the greatest jerks to those of a piece that begins at `startS`.
void raise(const TimedPiece& piece, double startS, std::vector<double>& maximum,
           std::vector<double>& atS) {
  const std::size_t dof = piece.jerk.maxAbs.size();
  maximum.resize(std::max(dof, maximum.size()), 0.0);
  atS.resize(maximum.size(), 0.0);
  for (std::size_t j = 0; j < dof; ++j)
    if (piece.jerk.maxAbs[j] > maximum[j]) {
      maximum[j] = piece.jerk.maxAbs[j];
      atS[j] = startS + piece.times[piece.jerk.maxAt[j]];
    }
}

} // namespace

void setJerk(const TimedSequence& timed, plan::MotionStatistics& s) {
  double startS = 0.0;
  for (std::size_t i = 0; i < timed.ways.size(); ++i) {
    raise(timed.ways[i], startS, s.maxTravelJerk, s.maxTravelJerkAtS);
    startS += timed.ways[i].times.back();
    s.jerkSlowedS += timed.ways[i].slowedS;
    if (i >= timed.runs.size())
      continue;
    raise(timed.runs[i], startS, s.maxJerk, s.maxJerkAtS);
    startS += timed.runs[i].times.back();
    s.jerkSlowedS += timed.runs[i].slowedS;
    s.sumSquaredJerk += timed.runs[i].jerk.sumSquared;
    s.sumSquaredJerkBefore += timed.ladder[i].sumSquared;
    const std::vector<double>& before = timed.ladder[i].maxAbs;
    s.maxJerkBefore.resize(std::max(before.size(), s.maxJerkBefore.size()), 0.0);
    for (std::size_t j = 0; j < before.size(); ++j)
      s.maxJerkBefore[j] = std::max(s.maxJerkBefore[j], before[j]);
  }
}

std::optional<plan::Finding> jerkFinding(const plan::MotionStatistics& s, const robot::Cell& cell,
                                         double maxJerk) {
  if (maxJerk <= 0.0)
    return std::nullopt;
  double maximum = kSlack * maxJerk, atS = 0.0;
  std::size_t joint = 0;
  const auto look = [&](const std::vector<double>& jerks, const std::vector<double>& times) {
    for (std::size_t j = 0; j < jerks.size(); ++j)
      if (const double angle = robot::asAngle(cell.limits()[j].kind, jerks[j]); angle > maximum) {
        maximum = angle;
        atS = times[j];
        joint = j + 1;
      }
  };
  look(s.maxJerk, s.maxJerkAtS);
  look(s.maxTravelJerk, s.maxTravelJerkAtS);
  if (joint == 0)
    return std::nullopt;
  plan::Finding finding = plan::makeFinding(
      plan::FindingKind::JerkOverLimit,
      {{"joint", joint}, {"jerk", base::number(maximum)}, {"limit", base::number(maxJerk)}});
  finding.whenS = atS;
  return finding;
}

} // namespace voluta::motion
