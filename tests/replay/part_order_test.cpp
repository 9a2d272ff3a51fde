// Programs of several files that are run in another order than they were written for: refused, at
// the file that is out of its turn.
#include "program/dialect.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <set>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(1);
  return s;
}

// Dialects whose programs may be cut.
std::vector<std::string> ofSeveralFiles() {
  std::vector<std::string> ids;
  for (const program::Dialect& dialect : program::dialects())
    for (const base::ParameterSpec& option : program::optionsOf(dialect))
      if (option.key == "motionsPerFile")
        ids.emplace_back(dialect.id);
  return ids;
}

class PartOrder : public ::testing::TestWithParam<std::string> {
protected:
  void SetUp() override {
    const test::Scene& s = scene();
    whole_ = program::writeProgram(
        GetParam(),
        {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box", {.motionsPerFile = 25}});
    std::set<std::size_t> files;
    for (const plan::ProgramMotion& m : read(whole_.files).motions)
      files.insert(m.file);
    parts_.assign(files.begin(), files.end());
    ASSERT_GE(parts_.size(), 4u);
    const Verification sound = verify(whole_.files);
    ASSERT_TRUE(sound.passed) << findingsText(sound);
  }

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) const {
    return program::readProgram(GetParam(), files, process::Tooling(scene().process));
  }
  Verification verify(const std::vector<plan::ProgramFile>& files) const {
    const test::Scene& s = scene();
    return replayProgram({read(files), s.plan, s.trajectory, s.cell, process::Tooling(s.process),
                          s.part, s.platform},
                         ReplayThresholds{}, {});
  }
  // Does the first finding name one of these files, or a line of them?
  bool named(const Verification& v, const std::vector<std::size_t>& files) const {
    return !v.passed && std::any_of(v.places.begin(), v.places.end(), [&](TextPlace p) {
      return std::find(files.begin(), files.end(), p.file - 1) != files.end();
    });
  }
  void expectRefused(const char* kind, const std::vector<plan::ProgramFile>& files,
                     std::vector<std::size_t> places) const {
    const Verification v = verify(files);
    EXPECT_FALSE(v.passed) << kind;
    EXPECT_TRUE(named(v, places)) << kind << "\n" << findingsText(v).substr(0, 400);
  }

  plan::Program whole_;
  std::vector<std::size_t> parts_; // files with motions
};

// The name of a part in a main program.
std::string nameOf(const plan::ProgramFile& file) {
  return file.name.substr(0, file.name.rfind('.'));
}

TEST_P(PartOrder, TextsThatChangedPlacesAreRefused) {
  auto files = whole_.files;
  std::swap(files[parts_[1]].text, files[parts_[2]].text);
  // These find a function by its own name, whatever the name of its file.
  if (GetParam() == "urscript" || GetParam() == "spel")
    EXPECT_TRUE(verify(files).passed);
  else
    expectRefused("two parts' texts have changed places", files, {0, parts_[1], parts_[2]});
}

TEST_P(PartOrder, APartInThePlaceOfAnotherIsRefused) {
  auto files = whole_.files;
  files[parts_[2]].text = files[parts_[1]].text;
  expectRefused("a part stands in another's place", files, {0, parts_[1], parts_[2]});
}

TEST_P(PartOrder, PartWithoutItsEndIsRefused) {
  auto files = whole_.files;
  std::string& text = files[parts_[1]].text;
  text.resize(text.find('\n', 2 * text.size() / 3) + 1);
  expectRefused("a part is cut short", files, {parts_[1], parts_[2]});
}

TEST_P(PartOrder, CallsThatChangedPlacesAreRefused) {
  auto files = whole_.files;
  ASSERT_GT(parts_.front(), 0u) << "no file calls the others";
  std::string& calls = files.front().text;
  const std::string a = nameOf(files[parts_[1]]), b = nameOf(files[parts_[2]]);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_NE(calls.find(a), std::string::npos);
  for (std::size_t i = 0; i + a.size() <= calls.size(); ++i)
    if (calls.compare(i, a.size(), a) == 0)
      calls.replace(i, a.size(), b);
    else if (calls.compare(i, b.size(), b) == 0)
      calls.replace(i, b.size(), a);
  expectRefused("two calls have changed places", files, {0, parts_[1], parts_[2]});
}

TEST_P(PartOrder, ACallThatIsMissingIsRefused) {
  auto files = whole_.files;
  std::string& calls = files.front().text;
  const std::string name = nameOf(files[parts_[1]]);
  for (std::size_t at = calls.rfind(name); at != std::string::npos; at = calls.rfind(name)) {
    const std::size_t begin = calls.rfind('\n', at) + 1;
    calls.erase(begin, calls.find('\n', at) + 1 - begin);
  }
  expectRefused("a call is missing", files, {0, parts_[1], parts_[2]});
}

INSTANTIATE_TEST_SUITE_P(Replay, PartOrder, ::testing::ValuesIn(ofSeveralFiles()),
                         [](const auto& i) { return i.param; });

} // namespace
} // namespace voluta::replay
