// Layer times that belong to a material hold for a job that has none of its own.
#include "base/error.h"
#include "base/files.h"
#include "motion/motion_options.h"
#include "pipeline/box_request.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "process/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace voluta;
using ::testing::HasSubstr;

namespace {

// fdm-1.0 with a material that has these layer times.
std::string processWith(const std::string& times) {
  std::string text = base::readFile(base::resourceFolder() / "processes/fdm-1.0.json");
  const std::string material = "\"material\": \"PLA\"";
  text.replace(text.find(material), material.size(),
               R"("material": "mud", "ownMaterial": {"id": "mud", "label": "Mud", )"
               R"("densityGPerCm3": 1.24)" +
                   times + "}");
  return text;
}

project::Choices choicesWith(const std::string& times, const std::vector<std::string>& own = {}) {
  project::Choices choices = test::boxRequest().choices;
  choices.item().automatic = false;
  choices.item().mode = "flat";
  choices.tool().process = processWith(times);
  pipeline::setParameters(choices, own);
  return choices;
}

plan::LayerTimes timesOf(const project::Choices& choices) {
  return motion::layerTimes(pipeline::parameterValues(choices));
}

std::string errorOf(const project::Choices& choices) {
  try {
    pipeline::checkChoices(choices);
  } catch (const base::Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(MaterialLayerTimes, AreThoseOfAJobWithoutItsOwn) {
  EXPECT_EQ(timesOf(choicesWith("")).minS, 0.0);
  EXPECT_EQ(timesOf(choicesWith("")).maxS, 0.0);
  const std::string both = R"(, "minLayerTimeS": 20, "maxLayerTimeS": 90)";
  const plan::LayerTimes times = timesOf(choicesWith(both));
  EXPECT_EQ(times.minS, 20.0);
  EXPECT_EQ(times.maxS, 90.0);
  EXPECT_EQ(timesOf(choicesWith(both, {"minLayerTimeS=45"})).minS, 45.0);
  EXPECT_EQ(timesOf(choicesWith(both, {"minLayerTimeS=45"})).maxS, 90.0);
}

TEST(MaterialLayerTimes, ChangeTheKeysOfTheStagesThatUseThem) {
  const auto keysWith = [](const std::string& times) {
    pipeline::PlanRequest request = test::boxRequest();
    request.choices = choicesWith(times);
    return pipeline::stageKeys(request);
  };
  constexpr std::size_t kMotion = project::indexOf(project::Stage::Motion);
  const project::StageKeys none = keysWith(""), minimum = keysWith(R"(, "minLayerTimeS": 20)"),
                           maximum = keysWith(R"(, "maxLayerTimeS": 20)");
  EXPECT_NE(none[kMotion], minimum[kMotion]);
  EXPECT_EQ(none[kMotion], maximum[kMotion]) << "only the replay judges the longest time";
  EXPECT_NE(none.back(), maximum.back());
}

TEST(MaterialLayerTimes, ThatContradictTheJobsAreOneLine) {
  EXPECT_EQ(errorOf(choicesWith(R"(, "maxLayerTimeS": 90)", {"minLayerTimeS=90"})), "no error");
  EXPECT_THAT(errorOf(choicesWith(R"(, "maxLayerTimeS": 40)", {"minLayerTimeS=60"})),
              HasSubstr("minLayerTimeS=60 s is longer than the 40 s in which Mud bonds"));
  EXPECT_THAT(errorOf(choicesWith(R"(, "minLayerTimeS": 60)", {"maxLayerTimeS=30"})),
              HasSubstr("maxLayerTimeS=30 s is shorter than the 60 s that Mud has to cool"));
  EXPECT_THAT(errorOf(choicesWith("", {"minLayerTimeS=60", "maxLayerTimeS=30"})),
              HasSubstr("minLayerTimeS=60 s is longer than maxLayerTimeS=30 s"));
}

} // namespace
