// Parameters whose keys were renamed, and those that no longer exist: the old keys are still read,
// with a note.
#include "helpers/temporary_folder.h"
#include "pipeline/sample_job.h"
#include "pipeline/stage_options.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

bool holds(const std::vector<base::Message>& notes, const char* english) {
  return std::ranges::any_of(
      notes, [&](const base::Message& note) { return base::english(note) == english; });
}

constexpr const char* kNote = "parameter underlay was renamed to rimSupports";

TEST(RenamedKeys, ReferToParameters) {
  const base::ParameterTable table = allParameters();
  for (const base::RenamedKey& renamed : base::renamedKeys()) {
    EXPECT_NE(table.find(renamed.key), nullptr) << renamed.key;
    EXPECT_EQ(table.find(renamed.oldKey), nullptr) << renamed.oldKey << " has two meanings";
  }
}

TEST(RenamedKeys, AnAssignmentWithTheOldKeySetsTheParameterWithANote) {
  project::Choices choices;
  const std::vector<base::Message> notes = setParameters(choices, {"underlay=none", "walls=3"});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(holds(notes, kNote));
  EXPECT_EQ(givenParameters(choices),
            (std::map<std::string, std::string>{{"rimSupports", "none"}, {"walls", "3"}}));
}

TEST(RenamedKeys, ChoicesWithTheOldKeyGiveTheValue) {
  project::Choices choices;
  choices.item().parameters["infillTurn"] = "60";
  EXPECT_DOUBLE_EQ(parameterValues(choices).number("infillRotation"), 60.0);
}

TEST(RenamedKeys, AProjectWithTheOldKeyIsReadWithANote) {
  const test::TemporaryFolder folder;
  project::Job job = test::sampleJob();
  job.choices.parameters = {{"underlay", "none"}};
  job.choices.item().parameters = {{"infillTurn", "60"}};
  project::writeJob(folder / "old.voluta", job);
  const project::Job read = project::readJob(folder / "old.voluta", allParameters());
  EXPECT_EQ(read.choices.parameters, (std::map<std::string, std::string>{{"rimSupports", "none"}}));
  EXPECT_EQ(read.choices.item().parameters,
            (std::map<std::string, std::string>{{"infillRotation", "60"}}));
  EXPECT_TRUE(holds(read.item().loaded->notes, kNote));
  EXPECT_TRUE(holds(read.item().loaded->readNotes, kNote));

  project::writeJob(folder / "new.voluta", read);
  const project::Job again = project::readJob(folder / "new.voluta", allParameters());
  EXPECT_EQ(givenParameters(again.choices), givenParameters(read.choices));
  EXPECT_EQ(again.item().loaded->notes.size(), read.item().loaded->notes.size());
}

TEST(RenamedKeys, AProjectWithBothKeysKeepsTheValueOfTheCurrentOne) {
  const test::TemporaryFolder folder;
  project::Job job = test::sampleJob();
  job.choices.parameters = {{"underlay", "none"}, {"rimSupports", "auto"}};
  project::writeJob(folder / "both.voluta", job);
  EXPECT_EQ(project::readJob(folder / "both.voluta", allParameters()).choices.parameters,
            (std::map<std::string, std::string>{{"rimSupports", "auto"}}));
}

TEST(DroppedKeys, LeadToNoParameter) {
  const base::ParameterTable table = allParameters();
  for (const std::string_view key : base::droppedKeys())
    EXPECT_EQ(table.find(key), nullptr) << key;
}

TEST(DroppedKeys, AreAcceptedWithANote) {
  project::Choices choices;
  const std::vector<base::Message> notes = setParameters(choices, {"growthIsp=0", "walls=3"});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(holds(notes, "parameter growthIsp no longer exists: its value has no effect"));
  EXPECT_EQ(givenParameters(choices), (std::map<std::string, std::string>{{"walls", "3"}}));
}

TEST(DroppedKeys, AProjectWithThemIsReadWithANote) {
  const test::TemporaryFolder folder;
  project::Job job = test::sampleJob();
  job.choices.parameters = {{"growthIsp", "0"}, {"walls", "3"}};
  job.choices.item().parameters = {{"growthQueue", "insertion"}};
  project::writeJob(folder / "old.voluta", job);
  const project::Job read = project::readJob(folder / "old.voluta", allParameters());
  EXPECT_EQ(givenParameters(read.choices), (std::map<std::string, std::string>{{"walls", "3"}}));
  for (const char* key : {"growthIsp", "growthQueue"})
    EXPECT_TRUE(holds(
        read.item().loaded->notes,
        ("parameter " + std::string(key) + " no longer exists: its value has no effect").c_str()))
        << key;
}

} // namespace
