#include "pipeline/station_findings.h"

#include "base/units.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "plan/waypoints.h"
#include "robot/cell.h"
#include "together/plate_overlap.h"

#include <algorithm>
#include <array>

namespace voluta::pipeline {

namespace {
using plan::FindingKind;
using plan::makeFinding;

// Returns "layer 3", of the first bead in the segment or after it.
base::Message layerIn(const together::PlacedMotion& motion, const together::Rests& rests,
                      std::size_t segment) {
  const std::size_t w = plan::waypointAhead(*motion.trajectory, rests.point[segment]);
  if (w != plan::kNoWaypoint)
    return base::message("layer {layer}"_text, plan::pathOf(*motion.toolPlan, w)->layer);
  return "the way home"_text;
}

base::Value bodyName(const PlanResult& plan, int body) {
  return robot::nameOf(plan.cell->bodies()[static_cast<std::size_t>(body)]);
}
} // namespace

plan::Finding obstructionFinding(const together::Obstruction& obstruction,
                                 const together::Plan& work, std::span<const PlanResult> plans,
                                 std::span<const together::PlacedMotion> motions) {
  using Kind = together::Obstruction::Kind;
  if (obstruction.kind == Kind::All)
    return makeFinding(FindingKind::NoWorkOrder);
  const auto [one, other] = obstruction.machines;
  const Eigen::Vector3d& where = obstruction.where;
  const std::vector<plan::NamedValue> both{{"one", one + 1}, {"two", other + 1}};
  if (obstruction.kind == Kind::Overlap)
    return makeFinding(FindingKind::MachinesOverlap, both, where);
  if (obstruction.kind == Kind::AtStart)
    return makeFinding(FindingKind::MachinesStartClose, both, where);
  const auto layer = [&](std::size_t machine, std::size_t segment) {
    return layerIn(motions[machine], work.rests[machine], segment);
  };
  if (obstruction.kind == Kind::AtRest)
    return makeFinding(FindingKind::MachineMeetsBody,
                       {{"body", bodyName(plans[one], obstruction.contact.body)},
                        {"one", one + 1},
                        {"obstacle", bodyName(plans[other], obstruction.contact.other)},
                        {"two", other + 1},
                        {"layer", layer(one, obstruction.contact.segment)}},
                       where);
  return makeFinding(FindingKind::MachinesHinder,
                     {{"first", layer(one, obstruction.segments[0])},
                      {"one", one + 1},
                      {"second", layer(other, obstruction.segments[1])},
                      {"two", other + 1}},
                     where);
}

plan::Findings overlapFindings(std::span<const together::PlacedMotion> motions) {
  plan::Findings notes;
  for (std::size_t one = 0; one < motions.size(); ++one)
    for (std::size_t two = one + 1; two < motions.size(); ++two)
      if (const auto overlap =
              together::plateOverlap({*motions[one].cell, motions[one].shared_T_world},
                                     {*motions[two].cell, motions[two].shared_T_world}))
        notes.push_back(
            makeFinding(FindingKind::PlatesOverlap, {{"one", one + 1},
                                                     {"cell", motions[one].cell->id()},
                                                     {"two", two + 1},
                                                     {"other", motions[two].cell->id()},
                                                     {"depth", base::mm(overlap->depthMm)},
                                                     {"area", base::mm2(overlap->areaMm2)}}));
  return notes;
}

plan::Findings runFindings(const replay::SharedRun& run) {
  if (const auto& unsafe = run.unsafeStart; unsafe && unsafe->early)
    return {makeFinding(FindingKind::MarkPassedEarly, {{"machine", unsafe->early->machine + 1},
                                                       {"line", unsafe->early->line},
                                                       {"other", unsafe->early->other + 1}})};
  if (const auto& stuck = run.clock.stuck)
    return {makeFinding(FindingKind::MarkNotReached,
                        {{"machine", stuck->machine + 1}, {"line", stuck->line}})};
  if (run.collisions == 0)
    return {};
  const replay::Meeting& first = run.meetings.front();
  plan::Finding meet = makeFinding(FindingKind::MachinesMeet,
                                   {{"body", first.bodies[0]},
                                    {"one", first.machines[0] + 1},
                                    {"obstacle", first.bodies[1]},
                                    {"two", first.machines[1] + 1},
                                    {"time", base::seconds(first.whenS)},
                                    {"collisions", run.collisions}},
                                   first.where);
  meet.whenS = first.whenS;
  return {std::move(meet)};
}

plan::Finding machineFinding(std::size_t k, base::Message reason) {
  return makeFinding(FindingKind::MachineRefused,
                     {{"machine", k + 1}, {"reason", std::move(reason)}});
}

std::optional<plan::Finding> machineFinding(std::size_t k, PlanVerdict verdict,
                                            const plan::Findings& own) {
  if (verdict == PlanVerdict::Passed)
    return std::nullopt;
  if (!isRefused(verdict)) {
    const bool isUnchecked = verdict == PlanVerdict::Unchecked;
    const auto first = std::ranges::find_if(own, [&](const plan::Finding& finding) {
      return finding.blocking && (!isUnchecked || finding.kind == FindingKind::OwnStatement);
    });
    const base::Message words =
        isUnchecked ? "safe to run but for its own statements, which nothing checks"_text
                    : "safe to run, but does not print its part as asked"_text;
    const base::Message reason =
        first == own.end() ? base::Message("see its report"_text) : plan::reasonOf(*first);
    return makeFinding(FindingKind::MachineDiffers,
                       {{"machine", k + 1}, {"verdict", words}, {"reason", reason}});
  }
  const plan::Finding* first = firstBlocking(own);
  return machineFinding(k, first ? plan::reasonOf(*first)
                                 : base::Message("the program is refused"_text));
}

bool isOfPlaces(const plan::Finding& finding) {
  using enum FindingKind;
  constexpr std::array kOfPlaces{MachinesOverlap, MachinesStartClose, MachineMeetsBody,
                                 MachinesHinder,  NoWorkOrder,        MachinesMeet};
  return std::ranges::find(kOfPlaces, finding.kind) != kOfPlaces.end();
}

} // namespace voluta::pipeline
