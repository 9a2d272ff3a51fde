// The workflow that voluta-cli batch writes, and the table of its results; neither needs Snakemake.
#include "batch/batch_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace voluta {
namespace {

using test::BatchFolder;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> namesOfJobs(const nlohmann::ordered_json& config) {
  std::vector<std::string> names;
  for (const auto& [name, job] : config.at("jobs").items())
    names.push_back(name);
  return names;
}

TEST(BatchWorkflow, HasAJobForEachPartOfAFolder) {
  const BatchFolder folder;
  folder.writeBar("parts/b.stl", 8, 4);
  folder.writeBar("parts/a part.STL", 8, 4);
  folder.write("parts/b.obj", "v 0 0 0\n");
  folder.write("parts/notes.pdf", "no part");
  const auto output =
      folder.batch("parts sample:vase -o out --write-only --cores 8 -- --mode flat");
  ASSERT_EQ(output.code, 0) << folder.read("err");
  EXPECT_THAT(output.text, HasSubstr("snakemake --directory"));
  const auto config = folder.json("out/config.json");
  EXPECT_THAT(namesOfJobs(config), ElementsAre("a_part", "b", "b-2", "vase"));
  EXPECT_EQ(config.at("threads"), 2);
  const auto& job = config.at("jobs").at("a_part");
  const std::string file = (folder / "parts/a part.STL").string();
  EXPECT_THAT(job.at("files"), ElementsAre(file));
  EXPECT_THAT(job.at("words"), ElementsAre(file, "--mode", "flat"));
  EXPECT_TRUE(config.at("jobs").at("vase").at("files").empty());
  EXPECT_TRUE(fs::exists(folder / "out/Snakefile"));
  EXPECT_FALSE(fs::exists(folder / "out/jobs"));
}

TEST(BatchWorkflow, HasAJobForEachRowOfAStudy) {
  const BatchFolder folder;
  folder.writeBar("parts/a.stl", 8, 4);
  folder.writeBar("parts/b.stl", 8, 4);
  folder.write("study.csv", "name,part,mode,layerHeightMm,planarScheme\r\n"
                            "thin,parts/a.stl,flat,0.6,\r\n"
                            "\"thick, wide\",,flat,0.9,\r\n");
  ASSERT_EQ(folder.batch("parts/b.stl --study study.csv -o out --write-only -- --scale 0.5").code,
            0)
      << folder.read("err");
  const auto config = folder.json("out/config.json");
  EXPECT_THAT(namesOfJobs(config), ElementsAre("a-thin", "b-thick__wide"));
  EXPECT_THAT(config.at("jobs").at("a-thin").at("words"),
              ElementsAre((folder / "parts/a.stl").string(), "--scale", "0.5", "--mode=flat",
                          "--set", "layerHeightMm=0.6"));
}

TEST(BatchWorkflow, RefusesWrongRequestsBeforeItWrites) {
  const BatchFolder folder;
  folder.writeBar("parts/a.stl", 8, 4);
  folder.write("study.csv", "layerHeigthMm\n0.6\n");
  const auto refused = [&](const std::string& words, int code, const std::string& reason) {
    EXPECT_EQ(folder.batch(words).code, code) << words;
    EXPECT_THAT(folder.read("err"), HasSubstr(reason));
    EXPECT_FALSE(fs::exists(folder / "out")) << words;
  };
  refused("-o out", 2, "PART or --study");
  refused("parts -o out -- --moed flat", 2, "--moed");
  refused("parts --study study.csv -o out", 2, "layerHeightMm"); // did you mean
  refused("parts/none.stl -o out", 3, "no such file");
  refused("/dev -o out", 2, "no part to plan");
}

TEST(BatchWorkflow, KeepsFilesOfOthersAndAnEditedProfile) {
  const BatchFolder folder;
  folder.writeBar("parts/a.stl", 8, 4);
  fs::create_directory(folder / "out");
  folder.write("out/config.json", "of another program");
  EXPECT_EQ(folder.batch("parts -o out --write-only").code, 2);
  EXPECT_EQ(folder.read("out/config.json"), "of another program");
  EXPECT_EQ(folder.batch("parts -o out --write-only --replace").code, 0);
  folder.write("out/slurm/config.yaml", "edited");
  EXPECT_EQ(folder.batch("parts -o out --write-only").code, 0);
  EXPECT_EQ(folder.read("out/slurm/config.yaml"), "edited");
}

TEST(BatchWorkflow, NamesThePackageIfSnakemakeIsNotInstalled) {
  const BatchFolder folder;
  folder.writeBar("parts/a.stl", 8, 4);
  const auto output = folder.run("PATH=/nowhere " VOLUTA_CLI " batch parts -o out");
  EXPECT_EQ(output.code, 2);
  EXPECT_EQ(folder.read("err"), "voluta-cli: Snakemake is not installed (apt install snakemake, or "
                                "give --write-only)\n");
}

TEST(BatchTable, HasTheFiguresOfTheReports) {
  const BatchFolder folder;
  for (const char* name : {"a", "b", "c"})
    folder.writeBar(std::string("parts/") + name + ".stl", 8, 4);
  folder.write("study.csv", "name,mode\n1,flat\n");
  ASSERT_EQ(folder.batch("parts --study study.csv -o out --write-only").code, 0);
  fs::create_directories(folder / "out/results");
  fs::create_directories(folder / "out/logs");
  for (const char* job : {"a-1", "c-1"})
    fs::create_directories(folder / ("out/jobs/" + std::string(job)));
  folder.write("out/results/a-1.json", R"({"exitCode": 4})");
  folder.write("out/logs/a-1.err", "note: none\n\"too\", small\n");
  folder.write(
      "out/jobs/a-1/report.json",
      R"({"verdict": "blocked", "layers": {"count": 7}, "motion": {"durationS": 1.25}, "findings": [{}, {}]})");
  folder.write("out/results/b-1.json", R"({"exitCode": 3})");
  folder.write("out/logs/b-1.err", "voluta-cli: broken\n");
  folder.write("out/jobs/c-1/report.json", R"({"verdict": "passed"})"); // of a job that was killed
  ASSERT_EQ(folder.batch("--table -o out").code, 0) << folder.read("err");
  const auto rows = folder.json("out/table.json");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].at("job"), "a-1");
  EXPECT_EQ(rows[0].at("mode"), "flat"); // the setting, whatever the report has
  EXPECT_EQ(rows[0].at("plannedMode"), nullptr);
  EXPECT_EQ(rows[0].at("layers"), 7);
  EXPECT_EQ(rows[0].at("durationS"), 1.25);
  EXPECT_EQ(rows[0].at("findings"), 2);
  EXPECT_EQ(rows[0].at("reason"), "\"too\", small");
  EXPECT_EQ(rows[1].at("exitCode"), 3);
  EXPECT_EQ(rows[1].at("reason"), "voluta-cli: broken");
  EXPECT_EQ(rows[1].at("mode"), "flat");
  EXPECT_EQ(rows[2].at("exitCode"), nullptr);
  EXPECT_EQ(rows[2].at("verdict"), nullptr);
  folder.write("out/jobs/a-1/report.json",
               R"({"decomposition": {"mode": "curved"}, "findings": [{}, {}]})");
  ASSERT_EQ(folder.batch("--table -o out").code, 0);
  EXPECT_EQ(folder.json("out/table.json")[0].at("mode"), "flat");
  EXPECT_EQ(folder.json("out/table.json")[0].at("plannedMode"), "curved");
  const std::string csv = folder.read("out/table.csv");
  EXPECT_THAT(csv, HasSubstr(",2,\"\"\"too\"\", small\"\n"));
  EXPECT_THAT(csv, HasSubstr(",not planned\n"));
}

TEST(BatchTable, IsAPageThatMarksTheBestJobs) {
  const BatchFolder folder;
  folder.writeBar("parts/a.stl", 8, 4);
  folder.write("study.csv", "name,mode\nfast,flat\nslow,flat\nbad,flat\n");
  ASSERT_EQ(folder.batch("parts --study study.csv -o out --write-only").code, 0);
  fs::create_directories(folder / "out/results");
  for (const auto& [job, seconds, code] :
       {std::tuple{"a-fast", 60.0, 0}, {"a-slow", 90.0, 0}, {"a-bad", 5.0, 4}}) {
    const std::string name = job;
    fs::create_directories(folder / ("out/jobs/" + name));
    folder.write("out/results/" + name + ".json", fmt::format(R"({{"exitCode": {}}})", code));
    folder.write("out/jobs/" + name + "/report.json",
                 fmt::format(R"({{"verdict": "{}", "motion": {{"durationS": {}}}}})",
                             code == 0 ? "passed" : "differs", seconds));
  }
  ASSERT_EQ(folder.batch("--table -o out").code, 0) << folder.read("err");
  const std::string page = folder.read("out/compare.html");
  EXPECT_THAT(page, HasSubstr("2 of 3 jobs passed"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number best\">1 min 0 s</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">5 s</td>"));
  EXPECT_THAT(page, HasSubstr("safe to run, not as asked"));
  EXPECT_THAT(page, HasSubstr("<a href=\"jobs/a-slow\">"));
  folder.write("out/jobs/a-fast/report.json", R"({"verdict": "notReplayed"})");
  ASSERT_EQ(folder.batch("--table -o out").code, 0);
  EXPECT_THAT(folder.read("out/compare.html"), HasSubstr("1 of 3 jobs passed"));
  EXPECT_THAT(folder.read("out/compare.html"), HasSubstr("not verified"));
}

} // namespace
} // namespace voluta
