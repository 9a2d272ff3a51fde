// Parts that are cut and split on the command line.
#include "command_line_fixture.h"

#include "helpers/shapes.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace voluta;
using test::CommandLine, test::Ended, test::expectOneLine;

namespace {

TEST_F(CommandLine, APartIsCutWithDowelsAndSplit) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {60, 30, 40});
  test::append(mesh, test::box({80, 0, 0}, {90, 10, 10}));
  const std::string file = stl("two.stl", mesh);
  const fs::path out = folder_ / "out";
  const Ended cut =
      run({"cut", file, "--plane", "0,0,2,20", "--joint", "dowels", "-o", out.string()});
  EXPECT_EQ(cut.code, 0) << cut.err;
  EXPECT_EQ(names(out), (std::set<std::string>{"two A.stl", "two B.stl", "two dowel 1.stl",
                                               "two dowel 2.stl"}));
  EXPECT_NE(cut.out.find("two dowel 1.stl: 6.0 x 6.0 x 16.0 mm"), std::string::npos) << cut.out;
  const fs::path bodies = folder_ / "bodies";
  const Ended split = run({"split", file, "-o", bodies.string()});
  EXPECT_EQ(split.code, 0) << split.err;
  EXPECT_EQ(names(bodies), (std::set<std::string>{"two 1.stl", "two 2.stl"}));
  EXPECT_NE(split.out.find("72.0 cm3"), std::string::npos) << split.out;
  expectOneLine(run({"cut", file, "--plane", "0,0,1,50", "-o", out.string(), "--replace"}), 3,
                {"the plane does not cut the part"});
  expectOneLine(run({"cut", file, "--plane", "0,0,0,5", "-o", out.string(), "--replace"}), 2,
                {"normal"});
}

TEST_F(CommandLine, ACutKeepsOtherFilesAndLeavesNoneOfAnEarlierOne) {
  const std::string file = stl("two.stl", test::box({0, 0, 0}, {60, 30, 40}));
  const fs::path out = folder_ / "out";
  std::vector<std::string> words{"cut",     file,     "--plane", "0,0,1,20",
                                 "--joint", "dowels", "-o",      out.string()};
  ASSERT_EQ(run(words).code, 0);
  base::writeFile(out / "notes.txt", "kept");
  base::writeFile(out / "two dowel x.stl", "kept");
  const std::string before = base::readFile(out / "two A.stl");
  const std::set<std::string> all = names(out);
  // Not even a dowel alone is joined by others.
  expectOneLine(run(words), 2, {"two A.stl", "exists already", "--replace"});
  EXPECT_EQ(base::readFile(out / "two A.stl"), before);
  EXPECT_EQ(names(out), all);
  // Without dowels, those of the earlier halves go.
  words[5] = "none";
  words.push_back("--replace");
  EXPECT_EQ(run(words).code, 0);
  EXPECT_EQ(names(out),
            (std::set<std::string>{"two A.stl", "two B.stl", "notes.txt", "two dowel x.stl"}));
  // A cut that fails leaves all.
  words[3] = "0,0,1,50";
  expectOneLine(run(words), 3, {"does not cut"});
  EXPECT_EQ(names(out).size(), 4u);
  EXPECT_EQ(entries(), (std::set<std::string>{"two.stl", "out"})) << "nothing beside the folder";
}

TEST_F(CommandLine, APartInInchesIsCutInMillimetres) {
  const std::string file = stl("inch.stl", test::box({0, 0, 0}, {2, 1, 1}));
  const std::string out = (folder_ / "out").string();
  const Ended cut = run({"cut", file, "--units", "in", "--plane", "1,0,0,12.7", "-o", out});
  EXPECT_EQ(cut.code, 0) << cut.err;
  EXPECT_NE(cut.out.find("inch A.stl: 12.7 x 25.4 x 25.4 mm"), std::string::npos) << cut.out;
  EXPECT_NE(cut.out.find("inch B.stl: 38.1 x 25.4 x 25.4 mm"), std::string::npos) << cut.out;
  expectOneLine(run({"split", file, "--units", "ell", "-o", out}), 2, {"ell", "mm"});
}

TEST_F(CommandLine, NoCommandReplacesAFileUnasked) {
  const std::string part = smallBox(), job = (folder_ / "job.voluta").string();
  const std::vector<std::vector<std::string>> commands{
      {"render", job, "-o", "x.png"},
      {"film", job, "-o", "x.webm"},
      {"pith", part, "-o", "x.stl"},
      {"compare-run", job, "r.csv", "-o", "x.csv"},
      {"cell", "place", part, "--robot", "ur5", "-o", "x.json"},
      {"material", "export", "pla", "-o", "x.json"},
      {"cell", "export", "ur5-fixed", "-o", "x.json"},
      {"cell", "export", "ur5-fixed", "-o", "x.json"},
      {"process", "export", "fdm-1.0", "-o", "x.json"},
      {"process", "sizes", "fdm-1.0", "t.txt", "-o", "x.json"}};
  for (std::vector<std::string> words : commands) {
    SCOPED_TRACE(words[0] + ' ' + words[1]);
    const fs::path file = folder_ / words.back();
    base::writeFile(file, "kept");
    words.back() = file.string();
    expectOneLine(run(words), 2, {file.string(), "exists already", "--replace"});
    EXPECT_EQ(base::readFile(file), "kept");
  }
  const std::string file = (folder_ / "x.json").string();
  EXPECT_EQ(run({"process", "export", "fdm-1.0", "-o", file, "--replace"}).code, 0);
  EXPECT_NE(base::readFile(file), "kept");
}

} // namespace
