// Batches that run with Snakemake, on this machine and on a Slurm of one node.
#include "batch/batch_folder.h"

#include <gmock/gmock.h>
#include <map>
#include <set>
#include <string>

namespace fs = std::filesystem;

namespace voluta {
namespace {

using test::BatchFolder;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

const std::string kOptions = " -- --mode flat --process fdm-1.0";

// Bars a and b, and further ones up to that number, and a broken part.
void writeParts(const BatchFolder& folder, int bars = 2) {
  folder.writeBar("parts/a.stl", 10, 4);
  folder.writeBar("parts/b.stl", 8, 6);
  for (int i = 2; i < bars; ++i)
    folder.writeBar("parts/c" + std::to_string(i) + ".stl", 7.0 + 0.1 * i, 4.0 + 0.8 * (i % 3));
  folder.write("parts/broken.stl", "solid");
}

// Plans each part alone, and expects the same figures in the table.
void expectTableOfSingleRuns(const BatchFolder& folder, const std::string& out,
                             std::size_t count = 3) {
  const Json rows = folder.json(out + "/table.json");
  ASSERT_EQ(rows.size(), count);
  for (const Json& row : rows) {
    const std::string job = row.at("job");
    const auto single = folder.run(std::string(VOLUTA_CLI) + " plan parts/" + job +
                                   ".stl --mode flat --process fdm-1.0 -o single/" + job);
    EXPECT_EQ(row.at("exitCode"), single.code) << job;
    if (job == "broken") {
      EXPECT_EQ(single.code, 3);
      EXPECT_THAT(row.at("reason").get<std::string>(), HasSubstr("broken.stl"));
      continue;
    }
    const Json report = folder.json("single/" + job + "/report.json");
    EXPECT_EQ(row.at("verdict"), report.at("verdict")) << job;
    EXPECT_EQ(row.at("mode"), report.at("decomposition").at("mode")) << job;
    EXPECT_EQ(row.at("layers"), report.at("layers").at("count")) << job;
    EXPECT_EQ(row.at("waypoints"), report.at("toolpath").at("waypoints")) << job;
    EXPECT_EQ(row.at("lengthMm"), report.at("toolpath").at("lengthMm")) << job;
    EXPECT_EQ(row.at("durationS"), report.at("motion").at("durationS")) << job;
    EXPECT_EQ(row.at("massRatio"), report.at("replay").at("massRatio")) << job;
    EXPECT_GT(row.at("layers"), 3) << job;
  }
  EXPECT_NE(rows[0].at("layers"), rows[1].at("layers"));
}

std::set<std::string> entriesOf(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

// Writes a program that plans, but is killed while it plans b.stl.
void writeKilledProgram(const BatchFolder& folder) {
  folder.write("killed",
               "#!/bin/sh\ncase \"$*\" in *plan*b.stl*) " VOLUTA_CLI
               " \"$@\" & sleep 0.3; kill -9 $!; kill -9 $$ ;; esac\nexec " VOLUTA_CLI " \"$@\"\n");
  fs::permissions(folder / "killed", fs::perms::owner_all);
}

bool isInstalled(const std::string& program) {
  return test::outputOf("command -v " + program).code == 0;
}

TEST(BatchRun, WithSnakemakeResumesAKilledJobAndEqualsSingleRuns) {
  if (!isInstalled("snakemake"))
    GTEST_SKIP() << "no snakemake";
  const BatchFolder folder;
  writeParts(folder);
  writeKilledProgram(folder);
  ASSERT_EQ(folder.batch("parts -o out --write-only" + kOptions).code, 0);
  const auto first =
      folder.run("snakemake --directory out --snakefile out/Snakefile --cores 2 --keep-going "
                 "--config program=" +
                 (folder / "killed").string());
  EXPECT_NE(first.code, 0);
  ASSERT_TRUE(fs::exists(folder / "out/results/a.json")) << folder.read("err");
  ASSERT_FALSE(fs::exists(folder / "out/results/b.json"));
  const auto planned = fs::last_write_time(folder / "out/jobs/a/job.voluta");

  const auto second = folder.batch("parts -o out" + kOptions);
  EXPECT_EQ(second.code, 4) << folder.read("err"); // broken.stl
  EXPECT_THAT(second.text, HasSubstr("2 of 3 jobs verified"));
  EXPECT_EQ(fs::last_write_time(folder / "out/jobs/a/job.voluta"), planned);
  expectTableOfSingleRuns(folder, "out");

  // Nothing is left to do; then an option changes.
  EXPECT_EQ(folder.batch("parts -o out" + kOptions).code, 4);
  EXPECT_EQ(fs::last_write_time(folder / "out/jobs/a/job.voluta"), planned);
  EXPECT_EQ(folder.batch("parts -o out" + kOptions + " --scale 0.9").code, 4);
  EXPECT_NE(fs::last_write_time(folder / "out/jobs/a/job.voluta"), planned);
}

TEST(BatchRun, FortyPartsAreResumedAndNothingIsLeftBehind) {
  if (!isInstalled("snakemake"))
    GTEST_SKIP() << "no snakemake";
  constexpr int kBars = 39;
  const BatchFolder folder;
  writeParts(folder, kBars);
  writeKilledProgram(folder);
  ASSERT_EQ(folder.batch("parts -o out --write-only" + kOptions).code, 0);
  const auto first =
      folder.run("snakemake --directory out --snakefile out/Snakefile --cores 2 --keep-going "
                 "--config program=" +
                 (folder / "killed").string());
  EXPECT_NE(first.code, 0);
  EXPECT_EQ(entriesOf(folder / "out/results").size(), 39u) << "all but the killed one";
  const auto planned = fs::last_write_time(folder / "out/jobs/a/job.voluta");

  const auto second = folder.batch("parts -o out" + kOptions);
  EXPECT_EQ(second.code, 4) << folder.read("err");
  EXPECT_THAT(second.text, HasSubstr("39 of 40 jobs verified"));
  EXPECT_EQ(fs::last_write_time(folder / "out/jobs/a/job.voluta"), planned);
  expectTableOfSingleRuns(folder, "out", kBars + 1);

  EXPECT_EQ(entriesOf(folder / "out"),
            (std::set<std::string>{".batch-lock", ".snakemake", "Snakefile", "compare.html",
                                   "config.json", "jobs", "logs", "results", "slurm", "table.csv",
                                   "table.json"}));
  std::set<std::string> jobs = entriesOf(folder / "out/jobs");
  EXPECT_EQ(jobs.size(), 39u) << "of the killed job only the second run's";
  for (const std::string& job : jobs)
    EXPECT_FALSE(job.starts_with('.')) << job;
  EXPECT_TRUE(fs::is_empty(folder / "out/.snakemake/locks"));
  EXPECT_TRUE(fs::is_empty(folder / "out/.snakemake/incomplete"));
  EXPECT_NE(test::outputOf("pgrep -f '" + (folder / "[o]ut").string() + "'").code, 0)
      << "a process is left";
}

TEST(BatchRun, WithSlurmResumesAKilledJobAndEqualsSingleRuns) {
  if (!isInstalled("snakemake"))
    GTEST_SKIP() << "no snakemake";
  const BatchFolder folder;
  writeParts(folder);
  writeKilledProgram(folder);
  const std::string profile = " --profile slurm --memory 300 --threads 1";
  ASSERT_EQ(folder.batch("parts -o out --write-only" + profile + kOptions).code, 0);
  const std::string slurm = VOLUTA_WITH_SLURM;
  const auto first = folder.run(
      slurm + " snakemake --directory out --snakefile out/Snakefile --keep-going --profile '" +
      (folder / "out/slurm").string() + "' --config program=" + (folder / "killed").string());
  constexpr int kSkipped = 77;
  if (first.code == kSkipped)
    GTEST_SKIP() << folder.read("err");
  EXPECT_NE(first.code, 0);
  ASSERT_TRUE(fs::exists(folder / "out/results/a.json")) << folder.read("err");
  ASSERT_FALSE(fs::exists(folder / "out/results/b.json"));
  const auto planned = fs::last_write_time(folder / "out/jobs/a/job.voluta");

  const auto second = folder.run(slurm + " " VOLUTA_CLI " batch parts -o out" + profile + kOptions);
  EXPECT_EQ(second.code, 4) << folder.read("err");
  EXPECT_THAT(folder.read("err"), HasSubstr("Submitted job"));
  EXPECT_EQ(fs::last_write_time(folder / "out/jobs/a/job.voluta"), planned);
  expectTableOfSingleRuns(folder, "out");
}

} // namespace
} // namespace voluta
