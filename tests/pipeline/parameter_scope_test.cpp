// Settings that all parts of a job share, and settings of one part.
#include "base/error.h"
#include "base/files.h"
#include "helpers/other_text.h"
#include "helpers/temporary_folder.h"
#include "pipeline/sample_job.h"
#include "pipeline/stage_options.h"
#include "project/block_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace voluta::pipeline {
namespace {

using base::ParameterScope;
using Texts = std::map<std::string, std::string>;

TEST(ParameterScope, EachParameterIsStoredWithTheJobOrWithTheItem) {
  const base::ParameterTable table = allParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    project::Choices choices;
    setParameters(choices, {spec.key + "=" + test::otherText(spec)});
    const bool ofJob = spec.scope == ParameterScope::Job;
    EXPECT_EQ(choices.parameters.contains(spec.key), ofJob) << spec.key;
    EXPECT_EQ(choices.item().parameters.contains(spec.key), !ofJob) << spec.key;
    EXPECT_EQ(givenParameters(choices).size(), 1u) << spec.key;
    EXPECT_TRUE(parameterValues(choices).changed(spec.key)) << spec.key;
  }
}

TEST(ParameterScope, ASettingOfTheJobIsRefusedForAPart) {
  const base::ParameterTable table = allParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    const std::string assignment = spec.key + "=" + test::otherText(spec);
    project::ItemChoices item;
    if (spec.scope != ParameterScope::Job) {
      setItemParameters(item, {assignment});
      EXPECT_TRUE(item.parameters.contains(spec.key));
      continue;
    }
    try {
      setItemParameters(item, {assignment});
      ADD_FAILURE() << spec.key << " is taken for a part";
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ErrorCode::Usage);
      EXPECT_NE(std::string(error.what()).find(spec.key + " is a setting of the job"),
                std::string::npos)
          << error.what();
    }
    project::Choices choices;
    choices.item().parameters[spec.key] = test::otherText(spec);
    EXPECT_THROW(checkChoices(choices), base::Error) << spec.key;
  }
}

TEST(ParameterScope, ItemsOfOneJobHaveItsSettings) {
  project::Choices choices;
  choices.items.resize(2);
  setParameters(choices, {"maxJerk=5"});
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_DOUBLE_EQ(parameterValues(project::onlyItem(choices, i)).number("maxJerk"), 5.0);
}

TEST(ParameterScope, AValueThatNamesAFileStoresItsContent) {
  const test::TemporaryFolder folder;
  const base::ParameterTable table = allParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    if (!spec.file.read)
      continue;
    const std::string content = test::otherText(spec);
    base::writeFile(folder / "given.txt", content);
    project::Choices choices;
    setParameters(choices, {spec.key + "=" + (folder / "given.txt").string()});
    EXPECT_EQ(givenParameters(choices), (Texts{{spec.key, content}}));
    setParameters(choices, {spec.key + "=" + content});
    EXPECT_EQ(givenParameters(choices), (Texts{{spec.key, content}})) << "typed";
  }
}

TEST(ParameterScope, OnlyTextsNameFiles) {
  const base::ParameterTable table = allParameters();
  for (const base::ParameterSpec& spec : table.specs())
    if (!spec.file.patterns.empty()) {
      EXPECT_EQ(spec.type, base::ParameterType::Text) << spec.key;
    }
}

// Returns the bytes of a project as the format before stored it: with the settings of the job in
// each item.
std::string withScopelessChoices(const std::string& bytes) {
  const std::size_t first = bytes.find('\n'), second = bytes.find('\n', first + 1);
  const std::size_t length = std::stoul(bytes.substr(first + 1));
  auto header = nlohmann::ordered_json::parse(bytes.substr(second + 1, length));
  auto& choices = header.at("choices");
  choices.at("parameters").update(choices.at("jobParameters"));
  choices.erase("jobParameters");
  const std::string text = header.dump(1);
  return "VOLUTA 2\n" + std::to_string(text.size()) + " " + std::to_string(project::crcOf(text)) +
         "\n" + text + bytes.substr(second + 1 + length);
}

TEST(ParameterScope, AProjectOfTheFormatBeforeGivesTheJobItsSettings) {
  const test::TemporaryFolder folder;
  project::Job job = test::sampleJob();
  job.choices.parameters = {{"seam", "corner"}, {"maxJerk", "5"}};
  job.choices.item().parameters = {{"walls", "3"}};
  base::writeFile(folder / "old.voluta", withScopelessChoices(project::jobBytes(job)));
  const project::Job read = project::readJob(folder / "old.voluta", allParameters());
  EXPECT_EQ(read.choices.parameters, job.choices.parameters);
  EXPECT_EQ(read.choices.item().parameters, job.choices.item().parameters);
}

} // namespace
} // namespace voluta::pipeline
