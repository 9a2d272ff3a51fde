// Parts that are cut and split on the command line.
#include "command_line_fixture.h"

#include "helpers/shapes.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>

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
  expectOneLine(run({"cut", file, "--plane", "0,0,1,50", "-o", out.string()}), 3,
                {"the plane does not cut the part"});
  expectOneLine(run({"cut", file, "--plane", "0,0,0,5", "-o", out.string()}), 2, {"normal"});
}

} // namespace
