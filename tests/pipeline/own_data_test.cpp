// Processes, materials and cells of the user's own on the command line.
#include "command_line_fixture.h"

#include "pipeline/stage_options.h"
#include "process/process.h"
#include "project/job.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace voluta {
namespace {

class OwnData : public test::CommandLine {
protected:
  void SetUp() override { setenv("VOLUTA_DATA", (folder_ / "data").c_str(), 1); }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

  std::string write(const std::string& name, const std::string& text) const {
    base::writeFile(folder_ / name, text);
    return (folder_ / name).string();
  }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(base::readFile(folder_ / name));
  }
};

TEST_F(OwnData, AnOwnProcessStatesItsDifferencesAndIsExportedWhole) {
  const std::string file = write("mine.json", R"({"id": "mine", "label": "Mine", "inherits": )"
                                              R"("fdm-0.4", "speedMmPerS": 22})");
  EXPECT_EQ(run({"process", "import", file}).code, 0);
  EXPECT_EQ(json("data/processes/mine.json").size(), 4u);
  const test::Ended listed = run({"process", "list"});
  EXPECT_NE(listed.out.find("(own, inherits from fdm-0.4)"), std::string::npos) << listed.out;
  const test::Ended compared = run({"process", "compare", "fdm-0.4", "mine"});
  EXPECT_NE(compared.out.find("speedMmPerS: 30 mm/s | 22 mm/s\n"), std::string::npos)
      << compared.out;
  const std::string whole = (folder_ / "whole.json").string();
  EXPECT_EQ(run({"process", "export", "mine", "-o", whole}).code, 0);
  EXPECT_FALSE(json("whole.json").contains("inherits"));
  EXPECT_EQ(json("whole.json").at("nozzleDiameterMm"), 0.4);
}

TEST_F(OwnData, AProjectNeedsNoParentOfItsProcess) {
  const std::string file = write("mine.json", R"({"id": "mine", "label": "Mine", "inherits": )"
                                              R"("fdm-1.0", "speedMmPerS": 22})");
  const std::string out = (folder_ / "out").string();
  const test::Ended ended = run(
      {"plan", smallBox(), "-o", out, "--mode", "flat", "--until", "layers", "--process", file});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const project::Job job =
      project::readJob(folder_ / "out" / "job.voluta", pipeline::allParameters());
  EXPECT_EQ(job.choices.tool().process.find("inherits"), std::string::npos);
  EXPECT_EQ(process::loadProcess(job.choices.tool().process).speedMmPerS, 22.0);
}

TEST_F(OwnData, MaterialsAreCompared) {
  const test::Ended compared = run({"material", "compare", "pla", "petg"});
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_NE(compared.out.find("densityGPerCm3: 1.24 g/cm\xC2\xB3 | 1.27 g/cm\xC2\xB3\n"),
            std::string::npos)
      << compared.out;
  EXPECT_EQ(run({"material", "compare", "pla", "pla"}).out, "");
  test::expectOneLine(run({"material", "compare", "pla", "petgg"}), 2, {"petgg", "petg"});
}

TEST_F(OwnData, ACellIsExportedAndImported) {
  const std::string file = (folder_ / "mine.json").string();
  EXPECT_EQ(run({"cell", "export", "ur5-fixed", "-o", file}).code, 0);
  test::expectOneLine(run({"cell", "import", file}), 3, {"mine.json", "'ur5-fixed'"});
  const std::string same = (folder_ / "ur5-fixed.json").string();
  EXPECT_EQ(run({"cell", "export", "ur5-fixed", "-o", same}).code, 0);
  test::expectOneLine(run({"cell", "import", same}), 2, {"'ur5-fixed'", "built-in"});
  nlohmann::json cell = json("mine.json");
  cell["id"] = "mine";
  cell["label"] = "Mine";
  write("mine.json", cell.dump());
  EXPECT_EQ(run({"cell", "import", file}).code, 0);
  EXPECT_EQ(json("data/cells/mine.json"), cell);
  EXPECT_NE(run({"list", "cells"}).out.find("Mine"), std::string::npos);
  cell.erase("robot");
  write("broken.json", cell.dump());
  test::expectOneLine(run({"cell", "import", (folder_ / "broken.json").string()}), 3,
                      {"broken.json", "robot"});
  EXPECT_EQ(json("data/cells/mine.json").at("robot"), "ur5");
}

} // namespace
} // namespace voluta
