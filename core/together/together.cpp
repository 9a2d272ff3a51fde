#include "together/together.h"

#include "base/run_context.h"
#include "robot/cell.h"
#include "together/poses.h"

#include <algorithm>
#include <utility>

namespace voluta::together {

namespace {
Eigen::Vector3d tipAt(const PlacedMotion& machine, std::size_t point) {
  return framesAt(machine, point)[static_cast<std::size_t>(machine.cell->toolFrame())]
      .translation();
}

std::optional<Obstruction> atRest(std::size_t machine, std::size_t other,
                                  const StaticConflicts& found) {
  for (const auto& contact : found.bodies)
    if (contact)
      return Obstruction{Obstruction::Kind::AtRest, {machine, other}, *contact, {}, contact->where};
  return std::nullopt;
}

class Planner {
public:
  Planner(std::span<const PlacedMotion> machines, const Options& options)
      : machines_(machines), options_(options) {}

  Plan run(const base::RunContext& ctx) {
    std::vector<std::size_t> segments;
    for (const PlacedMotion& machine : machines_) {
      plan_.rests.push_back(restsOf(*machine.trajectory, options_.maxSegments,
                                    options_.insideBeadsS, machine.printedBefore));
      plan_.seconds.push_back(secondsOf(*machine.trajectory, plan_.rests.back()));
      segments.push_back(plan_.rests.back().segments());
    }
    plan_.conflicts.emplace(std::move(segments));
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t j = 1; j < machines_.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        pairs.emplace_back(i, j);
    plan_.obstruction = overlap(pairs);
    ctx.report(0.0, "comparing the motions of the machines"_text);
    const double share = 0.9 / static_cast<double>(pairs.size());
    for (std::size_t k = 0; k < pairs.size() && !plan_.obstruction; ++k) {
      const double from = share * static_cast<double>(k);
      compare(pairs[k].first, pairs[k].second, ctx.sub(from, from + share));
    }
    if (plan_.obstruction)
      return std::move(plan_);
    ctx.report(0.9, "looking for an order of work"_text);
    plan_.order = orderOf(*plan_.conflicts, plan_.seconds, options_.markS, ctx);
    if (!plan_.order)
      plan_.obstruction = hindrance(pairs);
    else
      findPlaces(pairs);
    return std::move(plan_);
  }

private:
  std::optional<Obstruction>
  overlap(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
    for (const auto& [i, j] : pairs) {
      std::optional<Eigen::Vector3d> where = partOverlap(machines_[i], machines_[j]);
      if (!where)
        where = partOverlap(machines_[j], machines_[i]);
      if (where)
        return Obstruction{Obstruction::Kind::Overlap, {i, j}, {}, {}, *where};
    }
    return std::nullopt;
  }

  void compare(std::size_t i, std::size_t j, const base::RunContext& ctx) {
    FoundConflicts& found = found_.emplace_back(conflictsOf(
        machines_[i], plan_.rests[i], machines_[j], plan_.rests[j], options_.distances, ctx));
    plan_.conflicts->of(i, j) = std::move(found.table);
    plan_.obstruction = atRest(i, j, found.ofA);
    if (!plan_.obstruction)
      plan_.obstruction = atRest(j, i, found.ofB);
  }

  // For each rendezvous: the first segments on its two sides that must not happen at the same time.
  void findPlaces(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
    const std::vector<Rendezvous>& meetings = plan_.order->meetings;
    plan_.conflictPlaces.resize(meetings.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      const Conflicts& table = plan_.conflicts->of(i, j);
      std::vector<std::size_t> own; // rendezvous of the pair
      for (std::size_t m = 0; m < meetings.size(); ++m)
        if (meetings[m].first == i && meetings[m].second == j)
          own.push_back(m);
      for (std::size_t m = 0; m < own.size(); ++m) {
        const Rendezvous &at = meetings[own[m]],
                         before = m == 0 ? Rendezvous{} : meetings[own[m - 1]];
        const Rendezvous after =
            m + 1 == own.size() ? Rendezvous{i, j, table.a, table.b} : meetings[own[m + 1]];
        plan_.conflictPlaces[own[m]] = firstPlace(
            table, found_[k], {at.firstRest, after.firstRest, before.secondRest, at.secondRest});
        if (!plan_.conflictPlaces[own[m]])
          plan_.conflictPlaces[own[m]] = firstPlace(
              table, found_[k], {before.firstRest, at.firstRest, at.secondRest, after.secondRest});
      }
    }
  }

  static std::optional<Eigen::Vector3d>
  firstPlace(const Conflicts& table, const FoundConflicts& found, const Phase& among) {
    for (std::size_t a = among.aFrom; a < among.aTo; ++a)
      for (std::size_t b = among.bFrom; b < among.bTo; ++b)
        if (table.moving.at(a, b))
          if (const auto place = found.place(a, b))
            return place;
    return std::nullopt;
  }

  // Returns the first pair that has no order, or that all have none.
  Obstruction hindrance(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      const Conflicts& table = plan_.conflicts->of(i, j);
      const auto [a, b] = furthestReached(table);
      if (a < table.a || b < table.b)
        return moving(i, j, std::min(a, table.a - 1), std::min(b, table.b - 1), found_[k]);
    }
    Obstruction all;
    all.kind = Obstruction::Kind::All;
    return all;
  }

  Obstruction moving(std::size_t i, std::size_t j, std::size_t a, std::size_t b,
                     const FoundConflicts& found) const {
    Obstruction none;
    none.machines = {i, j};
    none.segments = {a, b};
    none.kind = found.atStart ? Obstruction::Kind::AtStart : Obstruction::Kind::Moving;
    std::optional<Eigen::Vector3d> where = found.atStart;
    if (!where)
      where = found.place(a, b);
    none.where = where.value_or(tipAt(machines_[i], plan_.rests[i].point[a + 1]));
    return none;
  }

  std::span<const PlacedMotion> machines_;
  const Options& options_;
  Plan plan_;
  std::vector<FoundConflicts> found_; // of the pairs, without their tables
};
} // namespace

Plan planTogether(std::span<const PlacedMotion> machines, const Options& options,
                  const base::RunContext& ctx) {
  return Planner(machines, options).run(ctx);
}

} // namespace voluta::together
