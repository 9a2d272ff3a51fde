#include "replay/purge_drops.h"

#include "geometry/drop.h"
#include "plan/finding_kinds.h"
#include "replay/beside_motion.h"
#include "robot/nozzle_drop.h"

#include <algorithm>

namespace voluta::replay {

namespace {
using Eigen::AlignedBox3d, Eigen::Vector3d;
using enum plan::FindingKind;

constexpr double kDropMm3 = 0.5;  // Less hangs on the nozzle
constexpr double kStrandMm = 5.0; // Width of a strand that curls up
} // namespace

DropTargets dropTargets(const plan::ToolPlan& plan, const platform::PlatformSolid& platform) {
  DropTargets targets;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t w = path.first; !plan::isWaste(path.kind) && w < path.first + path.count; ++w)
      targets.print.extend(plan.position[w]);
  if (platform.mesh)
    for (const Vector3d& vertex : platform.mesh->vertices)
      targets.workpiece.extend(vertex);
  if (platform.rod)
    for (const Eigen::Vector2d& at : platform.rod->profile) {
      targets.workpiece.extend(Vector3d(at.x(), at.y(), at.y()));
      targets.workpiece.extend(Vector3d(at.x(), -at.y(), -at.y()));
    }
  for (const Eigen::Vector2d& corner : platform.polygon)
    targets.plate.extend(Vector3d(corner.x(), corner.y(), 0.0));
  return targets;
}

std::vector<TextFinding> purgeDrops(const plan::ReadProgram& program,
                                    const plan::Trajectory& trajectory, const Alignment& alignment,
                                    const PlannedStops& planned, const DropTargets& targets,
                                    const robot::Cell& cell, std::size_t firstPoint) {
  std::vector<TextFinding> found;
  const std::size_t firstBead = firstBeadOf(program);
  const AlignedBox3d print = geometry::widened(targets.print, kStrandMm),
                     workpiece = geometry::widened(targets.workpiece, kStrandMm);
  for (const plan::ProgramPause& pause : program.pauses) {
    const bool isPrime = pause.before <= firstBead && pause.before >= program.firstMotion;
    const bool isPurge = planned.purgeAt(pause.before) > 0.0 && !planned.shotAt(pause.before);
    if (!(pause.volumeMm3 > kDropMm3) || pause.before >= program.motions.size() ||
        !(isPrime || isPurge))
      continue;
    const std::size_t next = alignment.pointAhead(pause.before);
    if (next >= trajectory.pointCount())
      continue;
    const std::size_t point = next > firstPoint ? next - 1 : firstPoint;
    const robot::JointVector q =
        Eigen::Map<const robot::JointVector>(trajectory.at(point), trajectory.dof);
    const base::Quantity volume = base::mm3(pause.volumeMm3);
    const auto add = [&](plan::FindingKind kind, std::vector<plan::NamedValue> values) {
      found.push_back(textFinding(program, kind, {pause.file + 1, pause.line}, std::move(values)));
      found.back().finding.where = cell.work_T_tool(q).translation();
    };
    if (robot::dropMeets(cell, q, print))
      add(PurgeOnPart, {{"volume", volume}, {"body", base::Message("print"_text)}});
    else if (robot::dropMeets(cell, q, workpiece))
      add(PurgeOnPart, {{"volume", volume}, {"body", base::Message("workpiece"_text)}});
    else if (robot::dropMeets(cell, q, targets.plate))
      add(PurgeOnPlate, {{"volume", volume}});
  }
  return found;
}

} // namespace voluta::replay
