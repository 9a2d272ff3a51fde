// Every row of the table of remedies: a cure changes the choices into others that can be planned.
#include "helpers/shapes.h"
#include "modes/part_voxels.h"
#include "pipeline/choices.h"
#include "pipeline/remedies.h"
#include "pipeline/road.h"

#include <gtest/gtest.h>
#include <set>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

plan::Finding findingOf(std::string_view kind) {
  plan::Finding finding;
  finding.stage = "decompose";
  finding.kind = kind;
  finding.reason = "something is missed";
  return finding;
}

// Finding and choices of which a remedy is known to be the cure.
struct Case {
  plan::Finding finding;
  Choices choices;
};
Case caseOf(const Remedy& remedy, std::string_view kind) {
  Case one{findingOf(kind), {}};
  if (remedy.id == "shrinkPlatform")
    one.choices.platform = project::Platform("disc:80");
  if (remedy.id == "dropToPlate")
    one.choices.placement.liftMm = 4.0;
  if (remedy.id == "adaptLayers")
    one.choices.mode = "flat";
  if (remedy.id == "narrowVoxels") {
    const auto thin = test::box({0, 0, 0}, {20, 0.5, 10});
    one.finding = thinWallFindings(thin, 0.8, {}).at(0);
  }
  return one;
}

// Rows wait for the stages that know these.
bool known(const Remedy& remedy) {
  const base::ParameterTable table = allParameters();
  return !(remedy.id == "addSupports" && !table.find("supports")) &&
         !(remedy.id == "turnPart" && !table.find("orient"));
}

StageKeys keysOf(const Choices& choices) {
  PlanRequest request;
  request.loaded = loadedFrom(
      "box.stl", std::make_shared<geometry::TriangleMesh>(test::box({0, 0, 0}, {9, 9, 5})), {},
      true, {});
  request.choices = choices;
  return stageKeys(request);
}

TEST(Remedies, EveryRowCuresWhatItIsForAndIsThenDone) {
  std::set<std::string_view> ids;
  for (const Remedy& remedy : remedies()) {
    EXPECT_TRUE(ids.insert(remedy.id).second) << remedy.id << " stands twice";
    EXPECT_FALSE(remedy.label.empty()) << remedy.id;
    EXPECT_FALSE(remedy.kinds.empty()) << remedy.id;
    for (const std::string_view kind : remedy.kinds) {
      const Case one = caseOf(remedy, kind);
      const std::optional<Cure> cure = remedy.cure(one.finding, one.choices);
      ASSERT_EQ(cure.has_value(), known(remedy)) << remedy.id << " for " << kind;
      if (!cure)
        continue;
      EXPECT_NO_THROW(checkChoices(cure->choices)) << remedy.id;
      const StageKeys before = keysOf(one.choices), after = keysOf(cure->choices);
      EXPECT_NE(before[indexOf(Stage::Layers)], after[indexOf(Stage::Layers)])
          << remedy.id << " changes nothing of what is decomposed and sliced";
      EXPECT_EQ(remedy.label.find("%1") != std::string_view::npos,
                remedy.id == "narrowVoxels" && !cure->value.empty())
          << remedy.id;
      EXPECT_FALSE(remedy.cure(one.finding, cure->choices)) << remedy.id << " is offered again";
      Choices unchanged = cure->choices;
      unchanged.parameters = one.choices.parameters;
      unchanged.platform = one.choices.platform;
      unchanged.placement = one.choices.placement;
      EXPECT_EQ(keysOf(unchanged), before) << remedy.id << " changes something else too";
    }
  }
}

TEST(Remedies, AreOfferedForTheirKindsOnly) {
  Choices choices;
  choices.platform = project::Platform("rect:90x70");
  choices.placement.liftMm = 2.0;
  const auto idsFor = [&](std::string_view kind) {
    std::set<std::string_view> ids;
    for (const Offer& offer : remediesFor(findingOf(kind), choices))
      ids.insert(offer.id);
    return ids;
  };
  EXPECT_TRUE(idsFor("collision").empty());
  EXPECT_TRUE(idsFor("thinWalls").empty()) << "no width is named";
  EXPECT_TRUE(idsFor("shadowedVoxels").contains("shrinkPlatform"));
  EXPECT_FALSE(idsFor("shadowedVoxels").contains("dropToPlate"));
  EXPECT_FALSE(idsFor("unreachedVoxels").contains("shrinkPlatform"));
  EXPECT_TRUE(idsFor("unreachedVoxels").contains("dropToPlate"));
  EXPECT_TRUE(idsFor("uncovered").empty()) << "curved layers follow the field";
  choices.mode = "planar";
  EXPECT_EQ(idsFor("uncovered"), (std::set<std::string_view>{"adaptLayers"}));
  EXPECT_EQ(idsFor(kStopped), (std::set<std::string_view>{"dropToPlate"}));
}

TEST(Remedies, TheContactAreaIsAsSmallAsAPlatformGets) {
  Choices choices;
  for (const char* platform : {"fit", "fit:0"}) {
    choices.platform = project::Platform(platform);
    for (const Offer& offer : remediesFor(findingOf("shadowedVoxels"), choices))
      EXPECT_NE(offer.id, "shrinkPlatform") << platform;
  }
  choices.platform = project::Platform("fit:20");
  EXPECT_EQ(remediesFor(findingOf("shadowedVoxels"), choices).at(0).cure.choices.platform.text(),
            "fit:0");
}

TEST(Remedies, AThinWallNamesTheWidthThatHoldsIt) {
  const auto findings = thinWallFindings(test::box({0, 0, 0}, {20, 0.5, 10}), 0.8, {});
  ASSERT_FALSE(findings.empty());
  const auto offers = remediesFor(findings[0], {});
  ASSERT_EQ(offers.size(), 1U);
  EXPECT_EQ(offers[0].cure.value, "0.5");
  EXPECT_EQ(offers[0].cure.choices.parameters.at("voxelMm"), "0.5");
  // A wall that no voxel is narrow enough for.
  const auto foil = thinWallFindings(test::box({0, 0, 0}, {20, 0.05, 10}), 0.8, {});
  ASSERT_FALSE(foil.empty());
  EXPECT_TRUE(remediesFor(foil[0], {}).empty());
}

} // namespace
