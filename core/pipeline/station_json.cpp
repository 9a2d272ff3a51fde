#include "pipeline/checked_program.h"
#include "pipeline/station_plan.h"
#include "plan/finding_kinds.h"
#include "plan/marks.h"
#include "project/message_json.h"

#include <nlohmann/json.hpp>
#include <numeric>

namespace voluta::pipeline {

namespace {
using Json = nlohmann::ordered_json;

Json pointJson(const Eigen::Vector3d& p) {
  return Json{p.x(), p.y(), p.z()};
}

// The outputs and inputs at which the machine has to be wired to the others (plan/marks.h), counted
// from 1 in the order in which its program's head lists them.
Json wiringJson(const plan::Trajectory& trajectory, std::size_t own) {
  Json wiring = Json::array();
  for (const int signal : plan::markSignalsOf(trajectory)) {
    const std::size_t other = plan::markPeer(own, signal / 2);
    wiring.push_back({{"signal", signal + 1},
                      {"use", signal % 2 == 0 ? "each mark" : "start mark"},
                      {"otherMachine", other + 1},
                      {"otherSignal", 2 * plan::markChannel(other, own) + signal % 2 + 1}});
  }
  return wiring;
}

Json runJson(const replay::SharedRun& run) {
  Json meetings = Json::array();
  for (const replay::Meeting& m : run.meetings)
    meetings.push_back({{"atS", m.whenS},
                        {"whereMm", pointJson(m.where)},
                        {"machines", {m.machines[0] + 1, m.machines[1] + 1}},
                        {"bodies", {base::english(m.bodies[0]), base::english(m.bodies[1])}}});
  return {{"makespanS", run.makespanS},
          {"keepsTogetherFromAnyStart", !run.unsafeStart.has_value()},
          {"stuck", run.clock.stuck.has_value()},
          {"collisions", run.collisions},
          {"meetings", meetings},
          {"leastDistanceMm", run.minDistanceMm},
          {"leastAtS", run.minDistanceAtS}};
}

Json machineJson(const StationResult& result, std::size_t k) {
  const PlanResult& plan = result.plans[k];
  const Eigen::Isometry3d& place = result.shared_T_world[k];
  Json json{{"part", plan.job.item().partName},
            {"cell", plan.cell->id()},
            {"folder", machineFolder(k)},
            {"verdict", verdictReport(plan.job.report).verdict},
            {"placeMm", pointJson(place.translation())},
            {"turnDeg", machineRotationDeg(place)}};
  if (!result.work.rests.empty()) { // a machine found no way to its place: nothing was compared
    const std::vector<double>& seconds = result.work.seconds[k];
    json["segments"] = result.work.rests[k].segments();
    json["aloneS"] = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  }
  if (const CheckedProgram* replayed = replayedTogether(plan))
    json["program"] = replayed->program.files.front().name;
  if (result.replay) {
    const replay::MachineClock& clock = result.replay->clock.machines[k];
    json["marks"] = clock.meetings().size();
    json["waitS"] = clock.waitS();
    json["endS"] = clock.totalS;
    json["wiring"] = wiringJson(*plan.job.trajectory, k);
  }
  return json;
}

Json orderJson(const together::Order& order) {
  Json meetings = Json::array();
  for (const together::Rendezvous& r : order.meetings)
    meetings.push_back(
        {{"machines", {r.first + 1, r.second + 1}}, {"segmentsDone", {r.firstRest, r.secondRest}}});
  return {{"marks", order.meetings.size()}, {"seconds", order.seconds}, {"meetings", meetings}};
}

// What the programs expect of their signals and their operator (plan/marks.h).
Json startJson(const together::Order& order) {
  if (order.meetings.empty())
    return {};
  return {{"order", "any"},
          {"signalsBefore", "any"},
          {"signalsAfterTheEnd", "off"},
          {"waits", "atTheFirstPoint"},
          {"afterAStop", "stopAllStartAll"}};
}
} // namespace

std::string stationJson(const StationResult& result) {
  const plan::Finding* why = firstBlocking(result.findings);
  Json machines = Json::array();
  for (std::size_t k = 0; k < result.plans.size(); ++k)
    machines.push_back(machineJson(result, k));
  const PlanVerdict verdict = verdictOf(result);
  Json json{
      {"passed", !why},
      {"verdict", verdictId(verdict)},
      {"safeToRun", verdict == PlanVerdict::Passed || verdict == PlanVerdict::NotAsAsked},
      {"refusal", verdict == PlanVerdict::Refused ? Json(plan::englishReason(*why)) : Json()}};
  json["findings"] = Json::array();
  for (const plan::Finding& finding : result.findings)
    json["findings"].push_back(project::findingJson(finding));
  json["machines"] = machines;
  json["start"] = result.work.order ? startJson(*result.work.order) : Json();
  json["order"] = result.work.order ? orderJson(*result.work.order) : Json();
  json["replay"] = result.replay ? runJson(*result.replay) : Json();
  return json.dump(2) + "\n";
}

} // namespace voluta::pipeline
