// Cells and processes from files of the user's own: the choices keep their text, and a finished
// plan does not need the files any more.
#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/outputs.h"
#include "pipeline/stage_options.h"
#include "process/library.h"
#include "program/dialect.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

// The program's own data with another id and label, as a file in the folder.
std::string copyOf(const std::string& folder, const std::string& id, const std::string& as,
                   const test::TemporaryFolder& to) {
  auto json = nlohmann::ordered_json::parse(
      base::readFile(base::resourceFolder() / folder / (id + ".json")));
  json["id"] = as;
  json["label"] = "own " + as;
  base::writeFile(to / (as + ".json"), json.dump());
  return (to / (as + ".json")).string();
}

TEST(OwnFiles, AJobIsVerifiedWithoutThem) {
  test::TemporaryFolder folder;
  PlanRequest request = test::boxRequest();
  request.choices.item().mode = "flat";
  request.choices.formats = {"csv"};
  request.choices.tool().process = copyOf("processes", "fdm-1.0", "mine", folder);
  request.choices.cell = copyOf("cells", "ur5-fixed", "my-cell", folder);
  takeOwnFiles(request.choices);
  EXPECT_EQ(base::dataName(request.choices.tool().process), "mine");
  EXPECT_EQ(base::dataName(request.choices.cell), "my-cell");
  PlanResult plan = planPart(request, kCtx);
  ASSERT_TRUE(nothingBlocks(plan.job.report));
  EXPECT_EQ(plan.tooling().first().process.label, "own mine");
  EXPECT_EQ(plan.cell->label(), "own my-cell");
  std::filesystem::create_directory(folder / "out");
  writeOutputs(plan, folder / "out", kCtx);
  std::filesystem::remove(folder / "mine.json");
  std::filesystem::remove(folder / "my-cell.json");
  const VerifyResult again =
      verifyProgram(folder / "out" / "box.csv", folder / "out" / "job.voluta", kCtx);
  EXPECT_TRUE(again.replay.passed);
  project::Job job = project::readJob(folder / "out" / "job.voluta", allParameters());
  EXPECT_EQ(base::dataName(job.choices.tool().process), "mine");
  EXPECT_EQ(resultOf(std::move(job)).cell->id(), "my-cell");
}

// An own process is chosen by its id; the job then has its text.
TEST(OwnFiles, AProcessOfTheLibraryTravelsWithTheJob) {
  test::TemporaryFolder folder;
  setenv("VOLUTA_DATA", folder.path().c_str(), 1);
  const auto own = process::duplicateOf(process::loadItem(process::Shelf::Processes, "fdm-1.0"));
  process::saveOwn(own);
  project::Choices choices;
  choices.tool().process = own.id();
  takeOwnFiles(choices);
  unsetenv("VOLUTA_DATA");
  EXPECT_EQ(base::dataName(choices.tool().process), own.id());
  EXPECT_EQ(process::loadProcess(choices.tool().process).label, own.label());
  choices.tool().process = "fdm-0.4";
  takeOwnFiles(choices);
  EXPECT_EQ(choices.tool().process, "fdm-0.4") << "comes with the program";
}

TEST(OwnFiles, AChangedFileIsAnotherStage) {
  test::TemporaryFolder folder;
  PlanRequest request = test::boxRequest();
  request.choices.cell = copyOf("cells", "ur5-fixed", "my-cell", folder);
  takeOwnFiles(request.choices);
  const project::StageKeys before = stageKeys(request);
  const std::string was = "own my-cell";
  request.choices.cell.replace(request.choices.cell.find(was), was.size(), "moved cell");
  EXPECT_NE(stageKeys(request), before);
}

TEST(OwnFiles, AWrongFileIsNamed) {
  test::TemporaryFolder folder;
  const auto errorOf = [](project::Choices choices) -> std::string {
    try {
      takeOwnFiles(choices);
    } catch (const base::Error& error) {
      return base::english(error.whole());
    }
    return {};
  };
  project::Choices choices;
  choices.tool().process = (folder / "none.json").string();
  EXPECT_THAT(errorOf(choices), testing::HasSubstr("none.json"));
  base::writeFile(folder / "bad.json", "{\"id\": \"bad\"}");
  choices.tool().process = (folder / "bad.json").string();
  EXPECT_THAT(errorOf(choices), testing::AllOf(testing::HasSubstr("bad.json"),
                                               testing::HasSubstr("'label' is missing")));
  choices = {};
  choices.cell = (folder / "bad.json").string();
  EXPECT_THAT(errorOf(choices), testing::HasSubstr("bad.json"));
}

} // namespace
