// A small box to be planned: a whole plan takes about a second.
#pragma once

#include "helpers/given_parameters.h"
#include "helpers/loaded_box.h"
#include "pipeline/road.h"

#include <map>
#include <string>

namespace voluta::test {

// The same part every time, 20 x 18 x 8 mm.
inline std::shared_ptr<const project::LoadedPart> boxPart() {
  static const auto kPart = loadedBox({-10, -9, 0}, {10, 9, 8});
  return kPart;
}

inline pipeline::PlanRequest boxRequest(const std::map<std::string, std::string>& parameters = {}) {
  pipeline::PlanRequest request;
  request.item().loaded = boxPart();
  test::giveParameters(request.choices, parameters);
  return request;
}

// That box in flat layers, planned once.
inline const pipeline::PlanResult& boxPlan() {
  static const pipeline::PlanResult kPlan = [] {
    pipeline::PlanRequest request = boxRequest();
    request.choices.item().mode = "flat";
    request.choices.formats = {"urscript", "gcode-extended", "csv"};
    return pipeline::planPart(request, base::RunContext());
  }();
  return kPlan;
}

} // namespace voluta::test
