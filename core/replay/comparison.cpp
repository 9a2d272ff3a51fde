#include "replay/comparison.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "geometry/triangle_queries.h"
#include "plan/finding_kinds.h"
#include "replay/beads.h"
#include "replay/controller_time.h"
#include "replay/joint_arcs.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;

// Collects findings and merges those of one kind in consecutive motions.
class Report {
public:
  Report(const plan::ReadProgram& program, const ExecutedPath& path)
      : program_(program), path_(path) {}

  void add(plan::FindingKind kind, TextPlace place, std::vector<plan::NamedValue> values = {},
           std::size_t count = 1) {
    findings_.push_back(textFinding(program_, kind, place, std::move(values), count));
  }
  void atMotion(plan::FindingKind kind, std::size_t motion,
                std::vector<plan::NamedValue> values = {}, std::size_t count = 1) {
    const std::string_view word = plan::rowOf(kind).reportId;
    for (std::size_t k = open_.size(); k-- > 0;)
      if (open_[k].word == word && open_[k].motion + 1 == motion && count == 1) {
        open_[k].motion = motion;
        ++findings_[open_[k].finding].finding.count;
        return;
      }
    add(kind, placeOf(program_, motion), std::move(values), count);
    findings_.back().finding.where = path_.targetTip[motion];
    findings_.back().finding.whenS = path_.startS[motion];
    std::erase_if(open_, [&](const Open& o) { return o.word == word; });
    open_.push_back({word, motion, findings_.size() - 1});
  }
  std::vector<TextFinding> take() { return std::move(findings_); }

private:
  struct Open {
    std::string_view word;
    std::size_t motion, finding;
  };
  const plan::ReadProgram& program_;
  const ExecutedPath& path_;
  std::vector<TextFinding> findings_;
  std::vector<Open> open_;
};

base::Quantity degreesOf(double rad) {
  return base::degrees(base::radiansToDegrees(rad));
}

// Returns "line 12".
base::Message lineOf(const plan::ReadProgram& program, std::size_t motion) {
  const plan::ProgramLine at = programLine(program, placeOf(program, motion));
  const std::string file = std::to_string(at.file), line = std::to_string(at.line);
  return at.file > 0 ? base::message("file {file}, line {line}"_text, file, line)
                     : base::message("line {line}"_text, line);
}

void reportDeviations(const Alignment& alignment, const plan::Trajectory& trajectory,
                      const plan::ReadProgram& program, Report& report) {
  using enum plan::FindingKind;
  constexpr double kReportedMm = 0.05;
  for (const Deviation& d : alignment.deviations) {
    switch (d.kind) {
    case DeviationKind::Moved:
      if (d.distanceMm > kReportedMm)
        report.atMotion(WaypointMoved, d.motion, {{"distance", base::mm(d.distanceMm)}});
      else
        report.atMotion(WaypointTilted, d.motion, {{"angle", degreesOf(d.angleRad)}});
      break;
    case DeviationKind::Missing:
      // The gap may contain lines without a motion, so both of its ends are named.
      if (d.motion == 0)
        report.atMotion(WaypointsMissingBefore, d.motion, {{"motions", d.count}}, d.count);
      else
        report.atMotion(WaypointsMissingBetween, d.motion,
                        {{"motions", d.count}, {"before", lineOf(program, d.motion - 1)}}, d.count);
      break;
    case DeviationKind::Extra:
      report.atMotion(MotionsUnplanned, d.motion, {{"motions", d.count}}, d.count);
      break;
    case DeviationKind::Swapped:
      report.atMotion(WaypointsSwapped, d.motion, {{"other", lineOf(program, d.other)}}, d.count);
      break;
    case DeviationKind::CutShort:
      if (program.motions.empty())
        report.add(NoMotions, {0, 1}, {}, trajectory.pointCount());
      else
        report.atMotion(plan::FindingKind::ProgramCutShort, d.motion, {{"motions", d.count}},
                        d.count);
      break;
    }
  }
  if (alignment.gaveUp)
    report.add(OtherProgram, {});
}

// Returns whether the nozzle passes there on its straight path to that point of the plan. A table's
// rotation between two directions need not be the shortest: the tilt may deviate by as much again
// as the angle between them.
bool passesStraight(const PlannedNozzle& planned, const plan::Trajectory& trajectory,
                    std::size_t point, const Vector3d& tip, const Vector3d& direction) {
  constexpr double kSameMm = 0.02, kSameRad = 0.01;
  if (point == 0 || point >= trajectory.pointCount() ||
      trajectory.move[point] == plan::MoveKind::Joint)
    return false;
  const Vector3d &from = planned.direction[point - 1], &to = planned.direction[point];
  return geometry::distanceToSegment(tip, planned.tip[point - 1], planned.tip[point]) <= kSameMm &&
         geometry::angleBetween(from, direction) + geometry::angleBetween(direction, to) <=
             2.0 * geometry::angleBetween(from, to) + kSameRad;
}

// A motion to a point of the plan together with the preceding pieces that lead there.
struct WholeMotion {
  std::size_t first; // index of the first motion
  double volumeMm3 = 0.0, durationS = 0.0;
};
// Returns the motion's duration by the text; for a joint motion including its ramps if the text
// gives them.
double textS(const plan::ReadProgram& program, const ExecutedPath& path, std::size_t m) {
  const plan::ProgramMotion& motion = program.motions[m];
  return m > 0 && path.arm && motion.jointInterpolated
             ? jointMotionS(path, m, motion.jointAccelerationRadPerS2)
             : path.durationS[m];
}
WholeMotion wholeMotion(const plan::ReadProgram& program, const ExecutedPath& path,
                        const Alignment& alignment, std::size_t m) {
  WholeMotion whole{m, motionVolume(program, path, m), textS(program, path, m)};
  while (whole.first > 0 && alignment.leadsTo[whole.first - 1] == alignment.pointOf[m]) {
    --whole.first;
    whole.volumeMm3 += motionVolume(program, path, whole.first);
    whole.durationS += textS(program, path, whole.first);
  }
  return whole;
}

// The sequences without the motions marked as aside, and the conversion of a result for them to
// indices of all motions.
class WithoutDetours {
public:
  WithoutDetours(const plan::ReadProgram& program, const std::vector<Vector3d>& tip,
                 const std::vector<Vector3d>& direction) {
    for (std::size_t m = 0; m < program.motions.size(); ++m)
      if (!program.motions[m].detour) {
        motions_.push_back(m);
        tip_.push_back(tip[m]);
        direction_.push_back(direction[m]);
      }
  }
  PoseSequence poses() const { return {tip_, direction_}; }
  std::size_t motion(std::size_t k) const { return motions_[k]; }

  Alignment ofAll(const Alignment& found, std::size_t count) const {
    Alignment all = found;
    all.pointOf.assign(count, kUnmatched);
    all.leadsTo.assign(count, kUnmatched);
    for (std::size_t k = 0; k < motions_.size(); ++k) {
      all.pointOf[motions_[k]] = found.pointOf[k];
      all.leadsTo[motions_[k]] = found.leadsTo[k];
    }
    for (Deviation& d : all.deviations) {
      d.motion = d.motion < motions_.size() ? motions_[d.motion] : count;
      d.other = d.other < motions_.size() ? motions_[d.other] : count;
    }
    return all;
  }

private:
  std::vector<std::size_t> motions_;
  std::vector<Vector3d> tip_, direction_;
};

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

Alignment alignProgram(const plan::ReadProgram& program, const ExecutedPath& path,
                       const PlannedNozzle& planned, const plan::Trajectory& trajectory,
                       const robot::Cell& cell, const base::RunContext& ctx) {
  JointArcs arcs(trajectory, cell, program.tellsDirections);
  // If the program states no directions, all directions are treated as equal.
  const std::vector<Vector3d> upOfMotions(program.tellsDirections ? 0 : path.motionCount(),
                                          Vector3d::UnitZ()),
      upOfPoints(program.tellsDirections ? 0 : planned.tip.size(), Vector3d::UnitZ());
  const WithoutDetours own(program, path.targetTip,
                           program.tellsDirections ? path.targetDirection : upOfMotions);
  const auto isVia = [&](std::size_t k, std::size_t point) {
    const std::size_t m = own.motion(k);
    const plan::ProgramMotion& motion = program.motions[m];
    if (program.beadsByJoints)
      return passesStraight(planned, trajectory, point, path.targetTip[m], path.targetDirection[m]);
    if (motion.target != plan::TargetKind::ToolPoint)
      return false;
    return (!motion.extruding && arcs.passes(point, path.targetTip[m], path.targetDirection[m])) ||
           (!motion.viaPoints.empty() &&
            passesStraight(planned, trajectory, point, path.targetTip[m], path.targetDirection[m]));
  };
  const Alignment found = alignToPlan(
      own.poses(), {planned.tip, program.tellsDirections ? planned.direction : upOfPoints},
      AlignmentOptions{}, ctx, isVia);
  return own.ofAll(found, path.motionCount());
}

TextPlace placeOf(const plan::ReadProgram& program, std::size_t motion) {
  const plan::ProgramMotion& m = program.motions[motion];
  return {m.file + 1, m.line};
}

plan::ProgramLine programLine(TextPlace place, TextPlace lastMotion) {
  return {{}, std::max(place.file, lastMotion.file) > 1 ? place.file : 0, place.line};
}

plan::ProgramLine programLine(const plan::ReadProgram& program, TextPlace place) {
  return programLine(place, program.motions.empty() ? TextPlace{}
                                                    : placeOf(program, program.motions.size() - 1));
}

TextFinding textFinding(const plan::ReadProgram& program, plan::FindingKind kind, TextPlace place,
                        std::vector<plan::NamedValue> values, std::size_t count) {
  TextFinding f;
  f.finding = plan::makeFinding(kind, std::move(values), std::nullopt, count);
  f.finding.program = programLine(program, place);
  f.place = place;
  return f;
}

namespace {

// Compares the motions that are where their points are planned.
class MotionComparison {
public:
  MotionComparison(const plan::ReadProgram& program, const ExecutedPath& path,
                   const PlannedNozzle& planned, const plan::Trajectory& trajectory,
                   const Alignment& alignment, const ComparisonOptions& options, Report& report)
      : program_(program), path_(path), planned_(planned), trajectory_(trajectory),
        alignment_(alignment), options_(options), report_(report) {}

  void compare() {
    for (std::size_t m = 0; m < path_.motionCount(); ++m)
      if (inPlace(m))
        compareMotion(m);
  }

private:
  // A motion and what is planned for it.
  struct Pair {
    std::size_t motion, point;
    bool print;         // by the plan
    double expectedMm3; // by the plan
    WholeMotion whole;
    bool extruding;
  };

  bool inPlace(std::size_t m) const {
    const std::size_t j = alignment_.pointOf[m];
    return j != kUnmatched && (path_.targetTip[m] - planned_.tip[j]).norm() <= options_.sameMm;
  }

  void compareMotion(std::size_t m) {
    const std::size_t j = alignment_.pointOf[m];
    const bool print = trajectory_.move[j] == plan::MoveKind::Print;
    const double expected =
        print && j > 0 ? trajectory_.extrudedMm3[j] - trajectory_.extrudedMm3[j - 1] : 0.0;
    const WholeMotion whole = wholeMotion(program_, path_, alignment_, m);
    const bool extruding =
        program_.motions[m].extruding || (whole.first < m && whole.volumeMm3 > 0.0);
    const Pair pair{m, j, print, expected, whole, extruding};
    if (path_.arm)
      compareJoints(pair);
    if (!compareExtruder(pair))
      return;
    if (m > 0 && print && path_.arm && program_.motions[m].jointInterpolated &&
        !program_.beadsByJoints)
      report_.atMotion(plan::FindingKind::BeadByJoints, m);
    if (followsItsPoint(pair))
      compareRates(pair);
  }

  void compareJoints(const Pair& pair) {
    const auto off = [&](int first, int last) {
      double maximum = 0.0;
      for (int k = first; k < last; ++k)
        maximum = std::max(maximum, std::abs(path_.angleOf(k, path_.jointsAt(pair.motion)[k] -
                                                                  trajectory_.at(pair.point)[k])));
      return maximum;
    };
    if (const double rad = off(0, path_.armDof); rad > options_.jointRad)
      report_.atMotion(plan::FindingKind::OtherConfiguration, pair.motion,
                       {{"angle", degreesOf(rad)}});
    if (const double rad = off(path_.armDof, path_.dof); rad > options_.externalRad)
      report_.atMotion(plan::FindingKind::ExternalAxisMoved, pair.motion,
                       {{"angle", degreesOf(rad)}});
  }

  // Returns whether the extruder is on or off as planned.
  bool compareExtruder(const Pair& pair) {
    if (!pair.print && pair.extruding &&
        (pair.motion > 0 || pair.whole.volumeMm3 > options_.minMm3)) {
      report_.atMotion(plan::FindingKind::ExtruderOnTravel, pair.motion);
      return false;
    }
    if (pair.print && !pair.extruding && pair.expectedMm3 > options_.minMm3) {
      report_.atMotion(plan::FindingKind::ExtruderOffPrint, pair.motion);
      return false;
    }
    return true;
  }

  // Returns whether the motion starts at the point before its own.
  bool followsItsPoint(const Pair& pair) const {
    const std::size_t first = pair.whole.first;
    if (first == 0 || pair.point == 0)
      return false;
    std::size_t before = first - 1; // the motion to the start of this one
    while (before > 0 && program_.motions[before].detour)
      --before;
    return inPlace(before) && alignment_.pointOf[before] + 1 == pair.point;
  }

  // Returns the shortest time of a joint motion from rest to rest; 0 for others.
  double rampsS(std::size_t m) const {
    const plan::ProgramMotion& motion = program_.motions[m];
    if (m == 0 || !path_.arm || !motion.jointInterpolated || options_.armRadPerS2 <= 0.0 ||
        motion.jointAccelerationRadPerS2 <= 0.0)
      return 0.0;
    double angle = 0.0;
    for (int k = 0; k < path_.armDof; ++k)
      angle = std::max(angle,
                       std::abs(path_.angleOf(k, path_.jointsAt(m)[k] - path_.jointsAt(m - 1)[k])));
    return 2.0 * std::sqrt(angle / options_.armRadPerS2);
  }

  // A motion's duration is length divided by speed; a bead may be slower where the extruder reaches
  // its limit.
  void compareRates(const Pair& pair) {
    const plan::ProgramMotion& motion = program_.motions[pair.motion];
    const double planned = trajectory_.timeS[pair.point] - trajectory_.timeS[pair.point - 1];
    const double time = pair.whole.durationS;
    const bool known = !(program_.time.jointsInPercent && motion.jointInterpolated);
    const auto tolerance = [&](double s) {
      return std::max(options_.minS, options_.rateTolerance * s);
    };
    const double maximum = std::max(planned, rampsS(pair.motion));
    const bool slow = known && planned > 0.0 && time > 0.0 &&
                      (time < planned - tolerance(planned) || time > maximum + tolerance(maximum));
    if (slow)
      report_.atMotion(plan::FindingKind::SpeedChanged, pair.motion,
                       {{"time", base::seconds(time)}, {"planned", base::seconds(planned)}});
    const double volume = pair.whole.volumeMm3, expected = pair.expectedMm3;
    if (pair.print && pair.extruding && !motion.trailing && !(slow && motion.volumeMm3 < 0.0) &&
        std::abs(volume - expected) > std::max(options_.minMm3, options_.rateTolerance * expected))
      report_.atMotion(plan::FindingKind::FlowChanged, pair.motion,
                       {{"volume", base::mm3(volume)}, {"planned", base::mm3(expected)}});
  }

  const plan::ReadProgram& program_;
  const ExecutedPath& path_;
  const PlannedNozzle& planned_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  const ComparisonOptions& options_;
  Report& report_;
};

} // namespace

std::vector<TextFinding> compareWithPlan(const plan::ReadProgram& program, const ExecutedPath& path,
                                         const PlannedNozzle& planned,
                                         const plan::Trajectory& trajectory,
                                         const Alignment& alignment,
                                         const ComparisonOptions& options) {
  using enum plan::FindingKind;
  Report report(program, path);
  for (const plan::ProgramDefect& d : program.defects)
    report.add(UnreadableLine, {d.file + 1, d.line}, {{"defect", d.reason}});
  reportDeviations(alignment, trajectory, program, report);
  const bool cut =
      std::any_of(alignment.deviations.begin(), alignment.deviations.end(),
                  [](const Deviation& d) { return d.kind == DeviationKind::CutShort; });
  if (!program.complete && !cut) {
    if (!program.defects.empty())
      report.add(EndMissing, {program.defects.back().file + 1, program.defects.back().line});
    else
      report.add(EndMissing, program.motions.empty()
                                 ? TextPlace{}
                                 : placeOf(program, program.motions.size() - 1));
  }
  MotionComparison(program, path, planned, trajectory, alignment, options, report).compare();
  return report.take();
}

} // namespace voluta::replay
