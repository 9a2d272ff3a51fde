#include "replay/comparison.h"

#include "base/error.h"
#include "base/parallel.h"
#include "replay/beads.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;

std::string text(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}
std::string counted(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

// Collects findings; those of one kind in consecutive motions become one.
class Report {
public:
  Report(const plan::ReadProgram& program, const ExecutedPath& path)
      : program_(program), path_(path) {}

  void add(const char* kind, TextPlace place, std::string reason, std::string remedy,
           std::size_t count = 1) {
    TextFinding f;
    f.finding.stage = "replay";
    f.finding.kind = kind;
    f.finding.reason = (place.line > 0 ? placeName(program_, place) + ": " : "") + reason;
    f.finding.remedy = std::move(remedy);
    f.finding.count = count;
    f.place = place;
    findings_.push_back(std::move(f));
  }
  void atMotion(const char* kind, std::size_t motion, std::string reason, std::string remedy,
                std::size_t count = 1) {
    for (std::size_t k = open_.size(); k-- > 0;)
      if (open_[k].kind == kind && open_[k].motion + 1 == motion && count == 1) {
        open_[k].motion = motion;
        ++findings_[open_[k].finding].finding.count;
        return;
      }
    add(kind, placeOf(program_, motion), std::move(reason), std::move(remedy), count);
    findings_.back().finding.where = path_.targetTip[motion];
    findings_.back().finding.whenS = path_.startS[motion];
    std::erase_if(open_, [&](const Open& o) { return o.kind == kind; });
    open_.push_back({kind, motion, findings_.size() - 1});
  }
  std::vector<TextFinding> take() { return std::move(findings_); }

private:
  struct Open {
    std::string kind;
    std::size_t motion, finding;
  };
  const plan::ReadProgram& program_;
  const ExecutedPath& path_;
  std::vector<TextFinding> findings_;
  std::vector<Open> open_;
};

const char* const kWriteAgain = "write the program again, or plan anew with this change";

// Lines without a motion may stand in a gap, so both of its ends are named.
std::string gapBefore(const plan::ReadProgram& program, std::size_t motion) {
  if (motion == 0)
    return "before this one";
  return "between " + placeName(program, placeOf(program, motion - 1)) + " and this one";
}

void tellDeviations(const Alignment& alignment, const plan::Trajectory& trajectory,
                    const plan::ReadProgram& program, Report& report) {
  for (const Deviation& d : alignment.deviations) {
    switch (d.kind) {
    case DeviationKind::Moved:
      report.atMotion("waypointMoved", d.motion,
                      d.distanceMm > 0.05
                          ? "the nozzle goes " + text(d.distanceMm, 3) + " mm beside its plan"
                          : "the nozzle's axis is " + text(d.angleRad * 180.0 / M_PI, 2) +
                                " degrees off its plan",
                      kWriteAgain);
      break;
    case DeviationKind::Missing:
      report.atMotion("waypointsMissing", d.motion,
                      counted(d.count, "planned motion") + " missing " +
                          gapBefore(program, d.motion),
                      kWriteAgain, d.count);
      break;
    case DeviationKind::Extra:
      report.atMotion("motionsUnplanned", d.motion,
                      counted(d.count, "motion") + " from here on not in the plan", kWriteAgain,
                      d.count);
      break;
    case DeviationKind::Swapped:
      report.atMotion("waypointsSwapped", d.motion,
                      "this motion and that of " + placeName(program, placeOf(program, d.other)) +
                          " have changed places",
                      kWriteAgain, d.count);
      break;
    case DeviationKind::CutShort:
      if (program.motions.empty())
        report.add("programCutShort", {0, 1}, "the program has no motions", kWriteAgain,
                   trajectory.pointCount());
      else
        report.atMotion("programCutShort", d.motion,
                        "the program ends here; " + counted(d.count, "planned motion") +
                            " not in it",
                        kWriteAgain, d.count);
      break;
    }
  }
  if (alignment.gaveUp)
    report.add("otherProgram", {}, "the program's motions are not those of this plan",
               "give the job that the program was written from");
}

} // namespace

PlannedNozzle plannedNozzle(const plan::Trajectory& trajectory, const robot::Cell& cell,
                            const base::RunContext& ctx) {
  base::require(trajectory.dof == cell.dof(), "plannedNozzle: the trajectory is the cell's");
  PlannedNozzle result;
  result.tip.resize(trajectory.pointCount());
  result.direction.resize(trajectory.pointCount());
  base::parallelChunks(ctx, trajectory.pointCount(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(trajectory.at(j), cell.dof());
      const Eigen::Isometry3d work_T_tool = cell.work_T_tool(q);
      result.tip[j] = work_T_tool.translation();
      result.direction[j] = -work_T_tool.linear().col(2);
    }
  });
  return result;
}

TextPlace placeOf(const plan::ReadProgram& program, std::size_t motion) {
  const plan::ProgramMotion& m = program.motions[motion];
  return {m.file + 1, m.line};
}

std::string placeName(const plan::ReadProgram& program, TextPlace place) {
  const bool several =
      (!program.motions.empty() && program.motions.back().file > 0) || place.file > 1;
  const std::string line = "line " + std::to_string(place.line);
  return several ? "file " + std::to_string(place.file) + ", " + line : line;
}

std::vector<TextFinding> compareWithPlan(const plan::ReadProgram& program, const ExecutedPath& path,
                                         const PlannedNozzle& planned,
                                         const plan::Trajectory& trajectory,
                                         const Alignment& alignment,
                                         const ComparisonOptions& options) {
  Report report(program, path);
  for (const plan::ProgramDefect& d : program.defects)
    report.add("unreadableLine", {d.file + 1, d.line}, d.reason, kWriteAgain);
  tellDeviations(alignment, trajectory, program, report);
  const bool cut =
      std::any_of(alignment.deviations.begin(), alignment.deviations.end(),
                  [](const Deviation& d) { return d.kind == DeviationKind::CutShort; });
  if (!program.complete && !cut) {
    if (!program.defects.empty())
      report.add("endMissing", {program.defects.back().file + 1, program.defects.back().line},
                 "the end sequence is missing", kWriteAgain);
    else
      report.add("endMissing",
                 program.motions.empty() ? TextPlace{}
                                         : placeOf(program, program.motions.size() - 1),
                 "the end sequence is missing", kWriteAgain);
  }

  const auto& pointOf = alignment.pointOf;
  const auto inPlace = [&](std::size_t m) {
    return pointOf[m] != kUnmatched &&
           (path.targetTip[m] - planned.tip[pointOf[m]]).norm() <= options.sameMm;
  };
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    if (!inPlace(m))
      continue;
    const std::size_t j = pointOf[m];
    const bool print = trajectory.move[j] == plan::MoveKind::Print;
    const double expected =
        print && j > 0 ? trajectory.extrudedMm3[j] - trajectory.extrudedMm3[j - 1] : 0.0;
    const double volume = motionVolume(program, path, m);
    const bool extruding = program.motions[m].extruding;
    if (path.arm) {
      const auto off = [&](int first, int last) {
        double most = 0.0;
        for (int k = first; k < last; ++k)
          most = std::max(most, std::abs(path.jointsAt(m)[k] - trajectory.at(j)[k]));
        return most;
      };
      if (const double rad = off(0, path.armDof); rad > options.jointRad)
        report.atMotion("otherConfiguration", m,
                        "the arm stands otherwise than planned, a joint by " +
                            text(rad * 180.0 / M_PI, 1) + " degrees",
                        kWriteAgain);
      if (const double rad = off(path.armDof, path.dof); rad > options.externalRad)
        report.atMotion("externalAxisMoved", m,
                        "the external axis stands " + text(rad * 180.0 / M_PI, 3) +
                            " degrees off its plan",
                        kWriteAgain);
    }
    if (!print && extruding && (m > 0 || volume > options.leastMm3)) {
      report.atMotion("extruderOnTravel", m, "the extruder is on over a travel", kWriteAgain);
      continue;
    }
    if (print && !extruding && expected > options.leastMm3) {
      report.atMotion("extruderOffPrint", m, "the extruder is off where a bead is to be laid",
                      kWriteAgain);
      continue;
    }
    if (m == 0 || j == 0 || !inPlace(m - 1) || pointOf[m - 1] + 1 != j)
      continue;
    // The time a motion takes is its length by its speed; a bead may be slower where the extruder
    // is at its end.
    const double dt = trajectory.timeS[j] - trajectory.timeS[j - 1];
    const double time = path.durationS[m];
    bool slow = false;
    if (dt > 0.0 && time > 0.0 &&
        std::abs(time - dt) > std::max(options.leastS, options.rateTolerance * dt)) {
      slow = true;
      report.atMotion("speedChanged", m,
                      "this motion takes " + text(time, 3) + " s, planned are " + text(dt, 3) +
                          " s",
                      kWriteAgain);
    }
    if (print && extruding && !(slow && program.motions[m].volumeMm3 < 0.0) &&
        std::abs(volume - expected) > std::max(options.leastMm3, options.rateTolerance * expected))
      report.atMotion("flowChanged", m,
                      "this motion lays " + text(volume, 3) + " mm3, planned are " +
                          text(expected, 3) + " mm3",
                      kWriteAgain);
  }
  return report.take();
}

namespace {
double segmentPointDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}
} // namespace

PathDeviation pathDeviation(const ExecutedPath& path, const PlannedNozzle& planned,
                            const plan::Trajectory& trajectory, const plan::ReadProgram& program,
                            const Alignment& alignment, const base::RunContext& ctx) {
  constexpr std::size_t kGrain = 4096, kMostSegments = 64;
  std::vector<PathDeviation> worst((path.motionCount() + kGrain - 1) / kGrain);
  base::parallelChunks(ctx, path.motionCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    PathDeviation& w = worst[begin / kGrain];
    for (std::size_t m = begin; m < end; ++m) {
      const std::size_t j = alignment.pointOf[m];
      if (j == kUnmatched)
        continue;
      const double angle = std::atan2(path.targetDirection[m].cross(planned.direction[j]).norm(),
                                      path.targetDirection[m].dot(planned.direction[j]));
      w.rad = std::max(w.rad, angle);
      // A dialect without joint motions goes straight where the plan has a free travel.
      const bool endOnly = m == 0 || trajectory.move[j] == plan::MoveKind::Joint;
      const std::size_t before =
          m > 0 && alignment.pointOf[m - 1] != kUnmatched ? alignment.pointOf[m - 1] : kUnmatched;
      const std::size_t first = before < j
                                    ? std::max(before, j > kMostSegments ? j - kMostSegments : 0)
                                    : (j > 0 ? j - 1 : 0);
      const std::size_t last = std::min(j + 1, planned.tip.size() - 1);
      const bool blended = program.motions[m].blendMm > 0.0;
      for (std::size_t s = path.firstSample[m]; s < path.firstSample[m + 1]; ++s) {
        if (endOnly && s + 1 < path.firstSample[m + 1])
          continue;
        double d = (path.tip[s] - planned.tip[j]).norm();
        if (!(endOnly && !blended))
          for (std::size_t k = first; k < last; ++k)
            d = std::min(d, segmentPointDistance(path.tip[s], planned.tip[k], planned.tip[k + 1]));
        if (d > w.mm) {
          w.mm = d;
          w.motion = m;
        }
      }
      // A target beside the plan's line may still lie on it: that is no deviation of the path.
    }
  });
  PathDeviation result;
  for (const PathDeviation& w : worst) {
    result.rad = std::max(result.rad, w.rad);
    if (w.mm > result.mm) {
      result.mm = w.mm;
      result.motion = w.motion;
    }
  }
  return result;
}

} // namespace voluta::replay
