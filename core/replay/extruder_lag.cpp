#include "replay/extruder_lag.h"

#include "replay/beads.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

constexpr double kSlackS = 0.05;
constexpr double kMaxShare = 0.4; // maximum tolerance in stop lags

class LagFollower {
public:
  LagFollower(plan::ReadProgram& program, const ExecutedPath& path,
              const plan::Trajectory& trajectory, const Alignment& alignment,
              const process::Tooling& tooling)
      : program_(program), path_(path), tooling_(tooling), prints_(program.motions.size(), 0) {
    for (std::size_t m = 0; m < prints_.size(); ++m)
      if (const std::size_t point = alignment.pointAhead(m); point != kUnmatched)
        prints_[m] = trajectory.move[point] == plan::MoveKind::Print;
  }

  void run() {
    const std::size_t n = program_.motions.size();
    std::vector<char> flows(n);
    for (std::size_t m = 0; m < n; ++m)
      flows[m] = motionVolume(program_, path_, m) > 0.0;
    takePulses(flows);
    const std::vector<double> runningS = takeRunningPauses(flows);
    for (std::size_t m = std::max<std::size_t>(program_.firstMotion, 1); m < n; ++m)
      if (flows[m] && !flows[m - 1])
        start(m, flows, lagOf(m).startS - runningS[m]);
      else if (!flows[m] && flows[m - 1])
        stop(m, flows);
  }

private:
  const process::ExtruderLag& lagOf(std::size_t motion) const {
    return tooling_.at(program_.motions[motion].tool).process.lag;
  }
  double seconds(std::size_t motion) const { return path_.durationS[motion]; }

  // A bead shorter than the stop lag is fed by an extruder that runs only before it.
  void takePulses(const std::vector<char>& flows) {
    for (std::size_t p = 0; p < program_.pauses.size(); ++p) {
      plan::ProgramPause& pulse = program_.pauses[p];
      if (pulse.volumeMm3 <= 0.0 || pulse.before <= program_.firstMotion + 1 ||
          pulse.before >= flows.size() || flows[pulse.before])
        continue;
      const process::ExtruderLag& lag = lagOf(pulse.before);
      double sinceS = 0.0; // it was switched off
      for (std::size_t q = p + 1;
           q < program_.pauses.size() && program_.pauses[q].before == pulse.before; ++q)
        sinceS += program_.pauses[q].durationS;
      if (std::abs(pulse.durationS + sinceS - lag.startS) > kSlackS)
        continue;
      const double mm3PerS = pulse.volumeMm3 / pulse.durationS;
      feed(pulse.before, flows, lag.stopS - sinceS,
           [&](std::size_t m) { return mm3PerS * seconds(m); });
      pulse.volumeMm3 = 0.0;
    }
  }

  // Feeds the rest of a bead from the extruder that was switched off: motion `first` follows it.
  // `leftS`: of the stop lag there. A rest of another duration gets the material as long as it
  // comes, and the travel behind it what is left.
  template <typename Volume>
  void feed(std::size_t first, const std::vector<char>& flows, double leftS,
            const Volume& volumeMm3) {
    const double gapS = std::max(seconds(first), seconds(first - 1));
    const double toleranceS =
        std::max(kSlackS, std::min(0.5 * gapS, kMaxShare * lagOf(first).stopS));
    std::size_t end = first;
    double restS = 0.0;
    for (; end < flows.size() && !flows[end] && prints_[end]; ++end)
      restS += seconds(end);
    const bool fits = std::abs(restS - leftS) <= toleranceS;
    for (std::size_t m = first; m < flows.size() && !flows[m]; ++m) {
      if (fits ? m >= end : leftS <= toleranceS)
        return;
      plan::ProgramMotion& motion = program_.motions[m];
      motion.extruding = motion.trailing = true;
      motion.volumeMm3 = volumeMm3(m);
      leftS -= seconds(m);
    }
  }

  // Returns for each motion how long the extruder runs before it while the arm is at rest. During
  // the start lag no material comes.
  std::vector<double> takeRunningPauses(const std::vector<char>& flows) {
    std::vector<double> running(program_.motions.size(), 0.0);
    for (plan::ProgramPause& pause : program_.pauses) {
      if (pause.before >= flows.size() || !flows[pause.before] || pause.volumeMm3 <= 0.0)
        continue;
      const double lagS = lagOf(pause.before).startS;
      if (lagS <= 0.0)
        continue;
      const double lost = std::clamp(lagS - running[pause.before], 0.0, pause.durationS);
      running[pause.before] += pause.durationS;
      if (lost >= pause.durationS - kSlackS)
        pause.volumeMm3 = 0.0;
      else
        pause.volumeMm3 *= 1.0 - lost / pause.durationS;
    }
    return running;
  }

  void start(std::size_t first, const std::vector<char>& flows, double missingS) {
    for (std::size_t m = first; m < flows.size() && flows[m] && missingS > kSlackS; ++m) {
      if (m > first && missingS < 0.5 * seconds(m))
        return;
      program_.motions[m].extruding = false;
      program_.motions[m].flowMm3PerS = 0.0;
      program_.motions[m].volumeMm3 = -1.0;
      missingS -= seconds(m);
    }
  }

  void stop(std::size_t first, const std::vector<char>& flows) {
    const double sectionMm2 = sectionOf(first - 1);
    feed(first, flows, lagOf(first - 1).stopS,
         [&](std::size_t m) { return sectionMm2 * lengthMm(m); });
  }

  double lengthMm(std::size_t motion) const {
    double length = 0.0;
    for (std::size_t s = std::max<std::size_t>(path_.firstSample[motion], 1);
         s < path_.firstSample[motion + 1]; ++s)
      length += (path_.tip[s] - path_.tip[s - 1]).norm();
    return length;
  }
  double sectionOf(std::size_t motion) const {
    const double length = lengthMm(motion);
    return length > 0.0 ? motionVolume(program_, path_, motion) / length : 0.0;
  }

  plan::ReadProgram& program_;
  const ExecutedPath& path_;
  const process::Tooling& tooling_;
  std::vector<char> prints_; // per motion: by the plan
};

} // namespace

void followLags(plan::ReadProgram& program, const ExecutedPath& path,
                const plan::Trajectory& trajectory, const Alignment& alignment,
                const process::Tooling& tooling) {
  const bool lags = std::ranges::any_of(tooling.tools(), [](const process::Tool& tool) {
    return tool.process.lag.startS > 0.0 || tool.process.lag.stopS > 0.0;
  });
  if (lags)
    LagFollower(program, path, trajectory, alignment, tooling).run();
}

} // namespace voluta::replay
