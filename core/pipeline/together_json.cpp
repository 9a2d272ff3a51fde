#include "base/units.h"
#include "pipeline/together.h"

#include <nlohmann/json.hpp>

namespace voluta::pipeline {

namespace {
using Json = nlohmann::ordered_json;

Json pointJson(const Eigen::Vector3d& p) {
  return Json{p.x(), p.y(), p.z()};
}

Json machineJson(const TogetherResult& result, std::size_t k) {
  const project::Job& job = result.plans[k].job;
  const Eigen::Isometry3d& place = result.shared_T_world[k];
  const Eigen::Vector3d x = place.linear().col(0);
  Json json{{"part", job.item().partName},
            {"cell", result.plans[k].cell->id()},
            {"placeMm", pointJson(place.translation())},
            {"turnDeg", base::radiansToDegrees(std::atan2(x.y(), x.x()))},
            {"segments", (k == 0 ? result.work.a : result.work.b).segments()}};
  const std::vector<double>& seconds = k == 0 ? result.work.aS : result.work.bS;
  double aloneS = 0.0;
  for (const double s : seconds)
    aloneS += s;
  json["aloneS"] = aloneS;
  if (result.replay) {
    const replay::MachineClock& clock = result.replay->clock.machines[k];
    json["marks"] = clock.marks;
    json["waitS"] = clock.waitS;
    json["endS"] = clock.totalS;
  }
  return json;
}

Json scheduleJson(const together::Schedule& schedule) {
  Json phases = Json::array();
  for (const together::Phase& p : schedule.phases)
    phases.push_back({{"first", {p.aFrom, p.aTo}}, {"second", {p.bFrom, p.bTo}}});
  return {{"marks", schedule.marks()}, {"seconds", schedule.seconds}, {"phases", phases}};
}

Json replayJson(const replay::TwoMachines& run) {
  Json meetings = Json::array();
  for (const replay::Meeting& m : run.meetings)
    meetings.push_back({{"atS", m.whenS},
                        {"whereMm", pointJson(m.where)},
                        {"first", base::english(m.first)},
                        {"second", base::english(m.second)}});
  return {{"makespanS", run.makespanS},
          {"stuck", run.clock.stuck.has_value()},
          {"collisions", run.collisions},
          {"meetings", meetings},
          {"leastDistanceMm", run.leastDistanceMm},
          {"leastAtS", run.leastAtS}};
}
} // namespace

std::string togetherJson(const TogetherResult& result) {
  Json json{{"passed", passed(result)},
            {"obstruction", result.obstruction ? Json(base::english(*result.obstruction)) : Json()},
            {"machines", {machineJson(result, 0), machineJson(result, 1)}}};
  json["schedule"] = result.work.schedule ? scheduleJson(*result.work.schedule) : Json();
  json["replay"] = result.replay ? replayJson(*result.replay) : Json();
  return json.dump(2) + "\n";
}

} // namespace voluta::pipeline
