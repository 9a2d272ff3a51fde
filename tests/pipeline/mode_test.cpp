// Properties of every mode.
#include "helpers/given_parameters.h"
#include "helpers/other_text.h"
#include "modes/mode_table.h"

#include "base/error.h"
#include "pipeline/box_request.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "robot/cell.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

using namespace voluta;
using modes::Mode;
using project::Stage;

namespace {

pipeline::PlanRequest requestFor(const Mode& mode) {
  pipeline::PlanRequest request = test::boxRequest();
  request.choices.item().mode = mode.id;
  request.choices.cell = mode.usual.cell;
  request.choices.item().platform = mode.usual.platform;
  request.until = Stage::Decompose;
  return request;
}

// Another value than the one that is there.
std::string otherValue(const base::ParameterSpec& spec) {
  switch (spec.type) {
  case base::ParameterType::Number:
    return spec.key == "firstLayerMm" ? "0.5"
                                      : base::formatParameter(0.5 * (spec.minimum + spec.maximum));
  case base::ParameterType::Integer:
    return std::to_string(static_cast<long long>(spec.maximum));
  case base::ParameterType::Boolean:
    return std::get<bool>(spec.defaultValue) ? "false" : "true";
  case base::ParameterType::Choice:
    return spec.choices.back().id == base::formatParameter(spec.defaultValue)
               ? spec.choices.front().id
               : spec.choices.back().id;
  case base::ParameterType::Text:
    break;
  }
  return test::otherText(spec);
}

// Does a change of it reach the layers, in any of these settings?
bool reaches(const Mode& mode, const base::ParameterSpec& spec) {
  std::vector<std::map<std::string, std::string>> settings{{}, {{"planarScheme", "greedy"}}};
  if (modes::takesParameter(mode, "orient"))
    settings.push_back({{"orient", "leastRisky"}});
  for (const curved::GrowthScheme& growth : curved::growthSchemes())
    for (auto parameters : settings) {
      pipeline::PlanRequest request = requestFor(mode);
      request.choices.item().growth = growth;
      test::giveParameters(request.choices, parameters);
      const std::string before = pipeline::stageKeys(request)[indexOf(Stage::Layers)];
      parameters[spec.key] = otherValue(spec);
      test::giveParameters(request.choices, parameters);
      if (pipeline::stageKeys(request)[indexOf(Stage::Layers)] != before)
        return true;
    }
  return false;
}

TEST(Modes, HaveNamesOfTheirOwn) {
  std::set<std::string_view> ids;
  for (const Mode& mode : modes::modeTable()) {
    EXPECT_TRUE(ids.insert(mode.id).second) << mode.id;
    EXPECT_FALSE(mode.label.empty());
    EXPECT_EQ(modes::modeNamed(mode.id), &mode);
  }
  EXPECT_EQ(modes::modeNamed("by hand"), nullptr);
}

TEST(Modes, ParametersAreThoseThatReachTheLayers) {
  const base::ParameterTable table = modes::modeParameters();
  for (const Mode& mode : modes::modeTable()) {
    for (const auto& [key, text] : mode.defaults)
      EXPECT_NE(pipeline::allParameters().find(key), nullptr) << mode.id << ": " << key;
    const base::ParameterTable own = pipeline::parametersOf(mode.id);
    for (const base::ParameterSpec& any : table.specs()) {
      const base::ParameterSpec& spec = *own.find(any.key); // with the mode's default
      if (spec.key == "voxelMm") // also the unit of parts that are voxels
        continue;
      EXPECT_EQ(modes::takesParameter(mode, spec.key), reaches(mode, spec))
          << mode.id << ": " << spec.key;
    }
  }
}

TEST(Modes, EveryParameterMeansSomethingToOne) {
  const base::ParameterTable table = modes::modeParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    bool asked = false;
    for (const Mode& mode : modes::modeTable())
      asked = asked || mode.requiresParameter(spec.key);
    EXPECT_TRUE(asked) << spec.key;
  }
}

TEST(Modes, TheirDefaultsAreCompatible) {
  for (const Mode& mode : modes::modeTable()) {
    project::Choices choices;
    choices.item().mode = mode.id;
    choices.cell = mode.usual.cell;
    choices.tool().process = mode.usual.process;
    choices.item().platform = mode.usual.platform;
    EXPECT_NO_THROW(pipeline::checkChoices(choices)) << mode.id;
    const process::Process process = process::loadProcess(mode.usual.process);
    EXPECT_EQ(pipeline::fittingCell(choices, process).rod().has_value(), mode.aroundRod) << mode.id;
    EXPECT_TRUE(mode.usual.platform.isForAnyOf(mode.platforms)) << mode.id;
  }
}

TEST(Modes, GrowthCountsWhereTheyGrow) {
  for (const Mode& mode : modes::modeTable()) {
    std::set<std::string> keys;
    for (const curved::GrowthScheme& growth : curved::growthSchemes()) {
      pipeline::PlanRequest request = requestFor(mode);
      request.choices.item().growth = growth;
      keys.insert(pipeline::stageKeys(request)[indexOf(Stage::Decompose)]);
    }
    EXPECT_EQ(keys.size(), mode.grows ? curved::growthSchemes().size() : 1) << mode.id;
  }
}

TEST(Modes, ResultsMatchTheRowOfTheMode) {
  for (const Mode& mode : modes::modeTable()) {
    pipeline::PlanRequest request = requestFor(mode);
    if (mode.requiresParameter("rodAxis"))
      request.choices.item().parameters["rodAxis"] = "x"; // a box has no clear one
    const pipeline::PlanResult result =
        pipeline::planPart(request, base::RunContext(base::CancelToken(), 2));
    EXPECT_EQ(project::kindOf(result.job.item().result), mode.result) << mode.id;
    EXPECT_EQ(result.job.report.item().decomposition.mode, mode.id);
    EXPECT_EQ(result.job.item().decomposition() != nullptr,
              mode.result == project::ResultKind::InVoxels);
    EXPECT_EQ(result.job.item().pieces() != nullptr, mode.result == project::ResultKind::InPieces);
    EXPECT_TRUE(result.job.item().platform.known()) << mode.id;
  }
}

} // namespace
