// Every kind of finding: it is made somewhere, has sentences, and its values are just those that
// the sentences have places for.
#include "base/error.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

using namespace voluta;
using namespace voluta::plan;

namespace {

namespace fs = std::filesystem;

std::vector<NamedValue> sampleValues(const FindingRow& row, bool more = false) {
  const bool whole = row.reason.plural() || row.remedy.plural() || (more && row.more.plural());
  std::vector<NamedValue> values;
  for (const std::string_view name : valueNames(row, more))
    values.push_back({name, whole ? base::Value(2) : base::Value(base::mm(1.5))});
  return values;
}

// The enumerators that occur in core's sources outside the table of kinds.
std::set<std::string> usedInCore() {
  static const std::regex kWord("[A-Za-z]+");
  std::set<std::string> used;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(VOLUTA_SOURCE_DIR) / "core")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename() == "finding_table.cpp")
      continue;
    std::ifstream in(entry.path());
    std::ostringstream text;
    text << in.rdbuf();
    const std::string source = text.str();
    if (source.find("FindingKind") == std::string::npos)
      continue;
    for (std::sregex_iterator word(source.begin(), source.end(), kWord), end; word != end; ++word)
      used.insert(word->str());
  }
  return used;
}

// The enumerators of FindingKind, in their order. Ids are those of older projects and may differ.
std::vector<std::string> enumerators() {
  std::ifstream in(fs::path(VOLUTA_SOURCE_DIR) / "core/plan/finding_kinds.h");
  std::string line;
  while (std::getline(in, line) && !line.starts_with("enum class FindingKind"))
    ;
  std::vector<std::string> names;
  static const std::regex kName("^  ([A-Z][A-Za-z]*),?$");
  for (std::smatch name; std::getline(in, line) && line != "};";)
    if (std::regex_match(line, name, kName))
      names.push_back(name[1]);
  return names;
}

TEST(FindingKinds, EveryKindHasSentencesAndAnIdOfItsOwn) {
  std::set<std::string_view> ids;
  for (const FindingRow& row : findingRows()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id << " stands twice";
    EXPECT_FALSE(row.reason.empty()) << row.id;
    if (row.kind == FindingKind::Verbatim || row.kind == FindingKind::Stopped)
      continue;
    EXPECT_FALSE(row.remedy.empty()) << row.id;
    EXPECT_FALSE(row.reportId.empty()) << row.id;
    EXPECT_EQ(&rowOf(row.kind), &row);
    EXPECT_EQ(rowWithId(row.id), &row);
  }
  EXPECT_EQ(rowWithId("nothing"), nullptr);
}

TEST(FindingKinds, EveryKindIsMadeBySomething) {
  const std::set<std::string> used = usedInCore();
  const std::vector<std::string> names = enumerators();
  ASSERT_EQ(names.size(), findingRows().size());
  for (const FindingRow& row : findingRows()) {
    if (row.kind != FindingKind::Verbatim &&
        row.kind != FindingKind::Stopped) { // made in the table's file
      EXPECT_TRUE(used.contains(names[static_cast<std::size_t>(row.kind)]))
          << row.id << " is never told";
    }
  }
}

TEST(FindingKinds, ValuesAreThoseOfTheSentences) {
  for (const FindingRow& row : findingRows()) {
    const std::vector<NamedValue> values = sampleValues(row);
    Finding finding;
    ASSERT_NO_THROW(finding = makeFinding(row.kind, values)) << row.id;
    EXPECT_EQ(finding.blocking, row.severity != Severity::Info) << row.id;
    for (const std::string& text : {englishReason(finding), englishRemedy(finding)})
      EXPECT_EQ(text.find('{'), std::string::npos) << row.id << ": " << text;
    std::vector<NamedValue> more = values;
    more.push_back({"unheardOf", base::Value(1)});
    EXPECT_THROW(makeFinding(row.kind, more), base::Error)
        << row.id << " takes what it never tells";
    if (values.empty())
      continue;
    std::vector<NamedValue> fewer(values.begin() + 1, values.end());
    EXPECT_THROW(makeFinding(row.kind, fewer), base::Error) << row.id << " leaves a place empty";
  }
}

TEST(FindingKinds, FindingsForSeveralHaveTheirOwnSentence) {
  for (const FindingRow& row : findingRows()) {
    if (row.more.empty()) {
      EXPECT_THROW(makeMoreFinding(row.kind, sampleValues(row), std::nullopt, 3), base::Error);
      continue;
    }
    const Finding one = makeFinding(row.kind, sampleValues(row));
    Finding more;
    ASSERT_NO_THROW(more = makeMoreFinding(row.kind, sampleValues(row, true), std::nullopt, 3))
        << row.id;
    EXPECT_EQ(more.count, 3u);
    EXPECT_EQ(englishReason(more).find('{'), std::string::npos) << englishReason(more);
    EXPECT_NE(englishReason(more).find("more"), std::string::npos) << englishReason(more);
    EXPECT_EQ(reportId(more), reportId(one));
    EXPECT_FALSE(sameFact(one, more));
  }
  const std::vector<NamedValue> bodies{{"first", "arm"_name}, {"second", "part"_name}};
  EXPECT_EQ(englishReason(makeFinding(FindingKind::ReplayedCollision, bodies)),
            "arm and part collide");
  EXPECT_EQ(englishReason(makeMoreFinding(FindingKind::ReplayedCollision, {}, std::nullopt, 12)),
            "12 more collisions");
  EXPECT_EQ(
      englishReason(
          makeMoreFinding(FindingKind::HeadInPart, {{"place", "layer 3"_name}}, std::nullopt, 40)),
      "40 more waypoints, the first: layer 3: the print head would cut into printed material");
  EXPECT_EQ(
      englishReason(makeMoreFinding(FindingKind::ShadowedUnreached, {{"voxels", 4}, {"more", 1}},
                                    std::nullopt, 5)),
      "4 voxels are shadowed: covered by the convex front before growth reached them; another "
      "voxel depends on this");
}

TEST(FindingKinds, IdsOfOlderVersionsLeadToTheirKinds) {
  const std::pair<const char*, FindingKind> old[] = {
      {"shadowedUnderFacetAndMore", FindingKind::ShadowedUnderFacet},
      {"moreUnreachable", FindingKind::Unreachable},
      {"moreCollisions", FindingKind::Collision},
      {"moreReplayedCollisions", FindingKind::ReplayedCollision}};
  for (const auto& [id, kind] : old) {
    ASSERT_NE(rowWithId(id), nullptr) << id;
    EXPECT_EQ(rowWithId(id)->kind, kind) << id;
    EXPECT_TRUE(isIdOfMore(id)) << id;
    EXPECT_FALSE(isIdOfMore(rowWithId(id)->id)) << id;
  }
  EXPECT_EQ(rowWithId("moreLimits")->reportId, "limit");
  EXPECT_EQ(rowWithId("moreUnreached")->kind, FindingKind::MissedGroups);
  EXPECT_FALSE(isIdOfMore("moreUnreached"));
}

// Only for severities decided case by case, and for sentences with one number: the number is a
// whole one, so that its form is known.
TEST(FindingKinds, PluralFormsHaveANumberToGoBy) {
  for (const FindingRow& row : findingRows())
    for (const base::Text text : {row.reason, row.remedy, row.more}) {
      const std::size_t minimum = text.plural() ? 1 : 0;
      EXPECT_GE(base::countPlaces(text.english()), minimum) << row.id;
    }
}

TEST(Findings, TheSameFactInAnotherFormatIsOne) {
  Finding a = makeFinding(FindingKind::JointRange,
                          {{"joint", base::message("joint {number}"_text, 3)},
                           {"angle", base::degrees(181.25)},
                           {"limit", base::degrees(180.0)}},
                          Eigen::Vector3d(1, 2, 3));
  a.program = {"urscript", 0, 1200};
  Finding b = a;
  b.program = {"csv", 2, 7};
  EXPECT_TRUE(sameFact(a, b));
  EXPECT_EQ(englishReason(a),
            "urscript: line 1200: joint 3 at 181.2 degrees, beyond its limit of 180.0");
  EXPECT_EQ(englishReason(b),
            "csv: file 2, line 7: joint 3 at 181.2 degrees, beyond its limit of 180.0");
  EXPECT_EQ(factOf(a), factOf(b));
  b.where = Eigen::Vector3d(1, 2, 9);
  EXPECT_FALSE(sameFact(a, b));
}

TEST(Findings, OfBeforeThereWereValuesStayAsTheyWere) {
  const Finding f = verbatimFinding(Stage::Replay, "limit", "the arm {cannot} reach", "");
  EXPECT_EQ(englishReason(f), "the arm {cannot} reach");
  EXPECT_EQ(reportId(f), "limit");
  EXPECT_EQ(stageOf(f), Stage::Replay);
  const Finding stopped = stoppedFinding(Stage::Layers, "out of memory"_text);
  EXPECT_EQ(stageOf(stopped), Stage::Layers);
  EXPECT_EQ(englishReason(stopped), "out of memory");
}

} // namespace

// Which of the two verdicts a finding concerns: a kind that is added to stage replay concerns
// safety unless its row says otherwise, and here.
TEST(FindingKinds, SayWhichVerdictTheyConcern) {
  using enum FindingKind;
  const std::set<FindingKind> partInReplay{
      Uncovered,        Thin,           GivenThin,      Overfill,        Mass,
      Unsupported,      CoolingTime,    GivenUncovered, GivenOverfill,   GivenMass,
      GivenUnsupported, MachineDiffers, LongBridge,     GivenLongBridge, StatementBeforeRest,
      OwnStatement}; // heads name own statements beside the verdict
  const std::set<FindingKind> unsafeBefore{Verbatim,          Stopped,   Overload,
                                           CollisionInMotion, HomeMeets, GivenCollisionInMotion};
  const auto isOfStation = [](FindingKind kind) {
    return kind >= PlatesOverlap && kind <= MachineRefused;
  };
  for (const FindingRow& row : findingRows()) {
    SCOPED_TRACE(row.id);
    ASSERT_NE(row.concern, Concern::ByStage);
    const bool isSafety = row.stage == Stage::Replay
                              ? !partInReplay.contains(row.kind)
                              : unsafeBefore.contains(row.kind) || isOfStation(row.kind);
    EXPECT_EQ(row.concern == Concern::Safety, isSafety);
  }
  Finding finding = verbatimFinding(Stage::Motion, "collision", "", "");
  finding.blocking = false;
  EXPECT_FALSE(blocksRunning(finding));
  finding.blocking = true;
  EXPECT_TRUE(blocksRunning(finding));
}
