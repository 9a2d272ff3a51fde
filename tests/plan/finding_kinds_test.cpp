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

using namespace voluta;
using namespace voluta::plan;

namespace {

namespace fs = std::filesystem;

std::vector<NamedValue> sampleValues(const FindingRow& row) {
  std::vector<NamedValue> values;
  std::set<std::string_view> known;
  for (const base::Text text : {row.reason, row.remedy})
    for (const std::string_view name : base::placeNames(text.english()))
      if (known.insert(name).second)
        values.push_back({name, text.plural() ? base::Value(2) : base::Value(base::mm(1.5))});
  return values;
}

// The enumerators that occur in core's sources outside the table of kinds.
std::set<std::string> usedInCore() {
  static const std::regex kWord("[A-Za-z]+");
  std::set<std::string> used;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(VOLUTA_SOURCE_DIR) / "core")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename() == "finding_kinds.cpp")
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

// "shadowedUnderFacet" is the enumerator ShadowedUnderFacet.
std::string enumeratorOf(std::string_view id) {
  std::string name(id);
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
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
  for (const FindingRow& row : findingRows()) {
    if (row.kind != FindingKind::Verbatim &&
        row.kind != FindingKind::Stopped) { // made in the table's file
      EXPECT_TRUE(used.contains(enumeratorOf(row.id))) << row.id << " is never told";
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

// Only what is decided case by case, and what a sentence of one number says: the number is a whole
// one, so that its form is known.
TEST(FindingKinds, PluralFormsHaveANumberToGoBy) {
  for (const FindingRow& row : findingRows())
    for (const base::Text text : {row.reason, row.remedy}) {
      const std::size_t least = text.plural() ? 1 : 0;
      EXPECT_GE(base::countPlaces(text.english()), least) << row.id;
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
