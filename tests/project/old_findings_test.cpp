// Findings of projects of older versions, which had a kind of their own for further findings.
#include "plan/finding_kinds.h"
#include "project/message_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using plan::FindingKind;

namespace {

using Json = nlohmann::ordered_json;

// As project files store a finding: its words, then its values.
plan::Finding readBack(const char* kind, std::size_t count, const Json& fact) {
  plan::Finding finding = plan::verbatimFinding(plan::Stage::Replay, kind, "as it was", "");
  finding.count = count;
  project::readFact(fact, finding);
  return finding;
}

Json oldFact(const char* id, const Json& values) {
  return {
      {"fact", id}, {"values", values}, {"program", {{"format", "csv"}, {"file", 0}, {"line", 0}}}};
}

TEST(OldFindings, CountsThatWereValuesAreFindingsForSeveral) {
  const plan::Finding collisions = readBack(
      "collision", 7,
      oldFact("moreReplayedCollisions", {{{"name", "collisions"}, {"value", {{"whole", 7}}}}}));
  EXPECT_EQ(collisions.kind, FindingKind::ReplayedCollision);
  EXPECT_TRUE(collisions.more);
  EXPECT_EQ(plan::englishReason(collisions), "csv: 7 more collisions");
  const plan::Finding limits = readBack(
      "limit", 1, oldFact("moreLimits", {{{"name", "violations"}, {"value", {{"whole", 1}}}}}));
  EXPECT_EQ(plan::reportId(limits), "limit");
  EXPECT_EQ(plan::englishReason(limits), "csv: 1 more violation");
}

TEST(OldFindings, ValuesStay) {
  const plan::Finding head = readBack(
      "collision", 40, oldFact("moreHeadInPart", {{{"name", "place"}, {"value", "layer 3"}}}));
  EXPECT_EQ(head.kind, FindingKind::HeadInPart);
  EXPECT_TRUE(head.more);
  ASSERT_NE(head.value("place"), nullptr);
  const plan::Finding missed =
      readBack("missedVoxels", 9,
               oldFact("moreShadowed", {{{"name", "voxels"}, {"value", {{"whole", 9}}}},
                                        {{"name", "groups"}, {"value", {{"whole", 2}}}}}));
  EXPECT_EQ(missed.kind, FindingKind::MissedGroups);
  EXPECT_FALSE(missed.more);
}

TEST(OldFindings, WithoutAValueTheirWordsStay) {
  const plan::Finding head = readBack("collision", 40, oldFact("moreHeadInPart", Json::array()));
  EXPECT_EQ(head.kind, FindingKind::Verbatim);
  EXPECT_EQ(plan::englishReason(head), "as it was");
}

TEST(OldFindings, AreStoredAsTheyAreNow) {
  const plan::Finding more = plan::makeMoreFinding(
      FindingKind::BeyondRod,
      {{"place", "layer 1"_name}, {"radius", base::mm(50)}, {"along", base::mm(100)}}, std::nullopt,
      3);
  const plan::Finding back = readBack("beyondRod", 3, project::factJson(more));
  EXPECT_EQ(back.kind, more.kind);
  EXPECT_TRUE(back.more);
  EXPECT_EQ(back.values, more.values);
  EXPECT_EQ(plan::englishReason(back), plan::englishReason(more));
  const plan::Finding one =
      plan::makeFinding(FindingKind::HomeMeets, {{"first", "arm"_name}, {"second", "post"_name}});
  EXPECT_FALSE(project::factJson(one).contains("more"));
}

} // namespace
