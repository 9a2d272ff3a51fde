#include "pipeline/plan_result.h"

#include "pipeline/resolved.h"

namespace voluta::pipeline {

const process::Tooling& PlanResult::tooling() const {
  return resolved().tooling;
}

PlanResult emptyResult(const project::Choices& choices) {
  PlanResult result;
  result.items.clear();
  for (std::size_t i = 0; i < choices.items.size(); ++i)
    result.items.push_back({std::make_shared<const Resolved>(resolveItem(choices, i)), nullptr});
  const base::ParameterValues& values = result.resolved().values;
  result.debug = values.boolean("output.debug");
  result.keepRefused = values.boolean("output.refused");
  result.proofs = values.boolean("output.proof");
  result.buildFile = values.boolean("output.build3mf");
  return result;
}

} // namespace voluta::pipeline
