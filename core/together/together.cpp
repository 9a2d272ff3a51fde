#include "together/together.h"

#include "base/run_context.h"
#include "together/poses.h"

#include <algorithm>

namespace voluta::together {

namespace {
Eigen::Vector3d tipAt(const Machine& machine, std::size_t point) {
  return framesAt(machine, point)[static_cast<std::size_t>(machine.cell.toolFrame())].translation();
}

std::optional<Obstruction> atRest(int machine, const StaticConflicts& found) {
  for (const auto& contact : found.bodies)
    if (contact)
      return Obstruction{Obstruction::Kind::AtRest, machine, *contact, 0, 0, contact->where};
  return std::nullopt;
}

Obstruction moving(const Machine& a, const Plan& plan, const FoundConflicts& found) {
  const auto [i, j] = furthestReached(plan.conflicts);
  Obstruction none;
  none.kind = found.atStart ? Obstruction::Kind::AtStart : Obstruction::Kind::Moving;
  none.aSegment = std::min(i, plan.a.segments() - 1);
  none.bSegment = std::min(j, plan.b.segments() - 1);
  std::optional<Eigen::Vector3d> where = found.atStart;
  if (!where)
    where = found.place(none.aSegment, none.bSegment);
  none.where = where.value_or(tipAt(a, plan.a.point[none.aSegment + 1]));
  return none;
}
} // namespace

Plan planTogether(const Machine& a, const Machine& b, const Options& options,
                  const base::RunContext& ctx) {
  Plan plan;
  plan.a = restsOf(a.trajectory, options.mostSegments);
  plan.b = restsOf(b.trajectory, options.mostSegments);
  plan.aS = secondsOf(a.trajectory, plan.a);
  plan.bS = secondsOf(b.trajectory, plan.b);
  std::optional<Eigen::Vector3d> overlap = partOverlap(a, b);
  if (!overlap)
    overlap = partOverlap(b, a);
  if (overlap) {
    plan.obstruction = Obstruction{Obstruction::Kind::Overlap, 0, {}, 0, 0, *overlap};
    return plan;
  }
  ctx.report(0.0, "comparing the motions of both machines"_text);
  FoundConflicts found = conflictsOf(a, plan.a, b, plan.b, options.distances, ctx.sub(0.0, 0.9));
  plan.conflicts = std::move(found.table);
  plan.obstruction = atRest(0, found.ofA);
  if (!plan.obstruction)
    plan.obstruction = atRest(1, found.ofB);
  if (plan.obstruction)
    return plan;
  ctx.report(0.9, "looking for an order of work"_text);
  plan.schedule = leastTime(plan.conflicts, plan.aS, plan.bS, options.markS);
  if (!plan.schedule)
    plan.obstruction = moving(a, plan, found);
  return plan;
}

} // namespace voluta::together
