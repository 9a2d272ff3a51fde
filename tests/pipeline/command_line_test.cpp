// The program as its users meet it: started as a process, judged by its exit code, its one line on
// stderr and the files it writes.
#include "command_line_fixture.h"

#include "base/files.h"
#include "helpers/shapes.h"
#include "helpers/sharp_prism.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace voluta;
using test::CommandLine, test::Ended, test::expectOneLine;

namespace {

TEST_F(CommandLine, WrongRequestsNameTheNearest) {
  const std::string part = smallBox();
  const std::string out = (folder_ / "out").string();
  expectOneLine(run({"plan", part, "-o", out, "--mode", "curvd"}), 2, {"curvd", "curved"});
  expectOneLine(run({"plan", part, "-o", out, "--cell", "ur5-fixd"}), 2, {"ur5-fixed"});
  expectOneLine(run({"plan", part, "-o", out, "--process", "fdm-10"}), 2, {"fdm-1.0"});
  expectOneLine(run({"plan", part, "-o", out, "--growth", "gready"}), 2, {"greedy"});
  expectOneLine(run({"plan", part, "-o", out, "--format", "urscrip"}), 2, {"urscript"});
  expectOneLine(run({"plan", part, "-o", out, "--set", "voxelmm=1"}), 2, {"voxelMm"});
  expectOneLine(run({"plan", part, "-o", out, "--set", "voxelMm=900"}), 2, {"voxelMm", " to "});
  expectOneLine(run({"plan", part, "-o", out, "--set", "infill=zigzak"}), 2, {"zigzag"});
  expectOneLine(run({"plan", part, "-o", out, "--platform", "disk:9"}), 2, {"disc"});
  expectOneLine(run({"plan", part, "-o", out, "--scale", "huge"}), 2, {"scale"});
  expectOneLine(run({"plan", part, "-o", out, "--until", "motin"}), 2, {"motion"});
  expectOneLine(run({"plan", part}), 2, {"-o"});
  expectOneLine(run({"film", part, "-o", part}), 2, {".webm"});
  expectOneLine(run({"plam"}), 2, {});
  expectOneLine(run({"list", "robot"}), 2, {"robots"});
  expectOneLine(run({"robot", "urr5", "--fk", "0,0,0,0,0,0"}), 2, {"ur5"});
  expectOneLine(run({"robot", "ur5", "--fk", "0,0,0"}), 2, {"6"});
  EXPECT_EQ(entries(), std::set<std::string>{"box.stl"}) << "a refused request left something";
}

TEST_F(CommandLine, AMilledPartIsVerifiedFromItsFolder) {
  const fs::path out = folder_ / "out";
  const std::string program = (out / "mill.nc").string(), job = (out / "mill.json").string();
  const Ended milled = run({"mill", smallBox(), "-o", out.string(), "--pitch", "0.2"});
  EXPECT_EQ(milled.code, 0) << milled.err;
  const Ended verified = run({"verify", program, "--job", job});
  EXPECT_EQ(verified.code, 0) << verified.err;
  std::string text = base::readFile(program);
  const std::size_t at = text.rfind("G1 ");
  text.erase(at, text.find('\n', at) + 1 - at);
  base::writeFile(program, text);
  EXPECT_EQ(run({"verify", program, "--job", job}).code, 4);
}

// A part to be milled also has notes on data that the reader skips and on holes that stay.
TEST_F(CommandLine, AMilledPartHasTheNotesOfItsReader) {
  geometry::TriangleMesh mesh = test::box({-10, -9, 0}, {10, 9, 8});
  mesh.triangles.resize(10); // A side is missing
  const std::string file = stl("hole.stl", mesh);
  base::writeFile(file, base::readFile(file) + std::string(50, ' '));
  const fs::path out = folder_ / "out";
  const Ended ended = run({"mill", file, "-o", out.string(), "--pitch", "0.2"});
  EXPECT_NE(ended.out.find("note: not used: 50 bytes behind"), std::string::npos) << ended.out;
  const auto report = nlohmann::json::parse(base::readFile(out / "report.json"));
  EXPECT_EQ(report.at("model").at("repairs").size(), 1u) << report.at("model");
  ASSERT_EQ(report.at("findings").size(), 1u) << report.at("findings");
  EXPECT_EQ(report.at("findings")[0].at("kind"), "meshDefect");
}

TEST_F(CommandLine, AMilledPartWithANarrowSlotIsNotComplete) {
  geometry::TriangleMesh mesh = test::box({-10, -9, 0}, {10, 9, 3});
  test::append(mesh, test::box({-10, -9, 3}, {10, -1, 8}));
  test::append(mesh, test::box({-10, 1, 3}, {10, 9, 8}));
  const Ended ended = run({"mill", stl("slot.stl", mesh), "-o", (folder_ / "out").string(),
                           "--pitch", "0.2", "--as-it-lies"});
  expectOneLine(ended, 4, {"mm3", "smaller cutter"});
}

TEST_F(CommandLine, SeveralPartsArePlacedAndPlanned) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  const Ended ended =
      run({"plan", part, "--copies", "2", "-o", out, "--mode", "flat", "--until", "layers",
           "--place", "1:-20,0", "--place", "2:20,5,90", "--part", "2:scale=0.5"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const auto report = nlohmann::json::parse(base::readFile(folder_ / "out" / "report.json"));
  ASSERT_EQ(report["items"].size(), 2u);
  EXPECT_EQ(report["items"][1]["model"]["scale"], 0.5);
  const auto centreX = [&](std::size_t i) {
    const auto& box = report["items"][i]["model"]["boundsMm"];
    return 0.5 * (box[0][0].get<double>() + box[1][0].get<double>());
  };
  EXPECT_NEAR(centreX(0), -20.0, 1e-6);
  EXPECT_NEAR(centreX(1), 20.0, 1e-6);
}

TEST_F(CommandLine, APartIsPlacedAboveThePlate) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  run({"plan", part, part, "-o", out, "--mode", "flat", "--until", "load", "--place", "1:0,0",
       "--place", "2:0,0,90,8"});
  const auto report = nlohmann::json::parse(base::readFile(folder_ / "out" / "report.json"));
  ASSERT_EQ(report["items"].size(), 2u);
  EXPECT_NEAR(report["items"][0]["model"]["boundsMm"][0][2].get<double>(), 0.0, 1e-6);
  EXPECT_NEAR(report["items"][1]["model"]["boundsMm"][0][2].get<double>(), 8.0, 1e-6);
  expectOneLine(run({"plan", part, "-o", out, "--place", "1:0,0,0,-1"}), 2, {"below the plate"});
}

TEST_F(CommandLine, PlacesOfPartsAreCheckedInOneLine) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  expectOneLine(run({"plan", part, "-o", out, "--place", "3:0,0"}), 2,
                {"3:0,0", "the last one is 1"});
  expectOneLine(run({"plan", part, "-o", out, "--place", "1:0"}), 2, {"NUMBER:X,Y"});
  expectOneLine(run({"plan", part, "-o", out, "--part", "1:mode"}), 2, {"NUMBER:KEY=VALUE"});
  expectOneLine(run({"plan", part, part, "-o", out, "--mode", "lathe", "--cell", "lathe"}), 2,
                {"printed alone"});
  expectOneLine(run({"plan", part, "--copies", "200", "-o", out, "--scale", "1"}), 3,
                {"no room", "200"});
}

TEST_F(CommandLine, AnOldKeyOfAParameterIsTakenWithANote) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  const Ended ended = run({"plan", part, "-o", out, "--mode", "flat", "--until", "layers", "--set",
                           "underlay=none", "--set", "infillTurn=60"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "note: parameter underlay was renamed to rimSupports\n"
                       "note: parameter infillTurn was renamed to infillRotation\n");
}

TEST_F(CommandLine, OrientListsTheOrientationsAndPlanTakesOne) {
  const std::string part =
      stl("plate.stl", test::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(50, 6, 40)));
  const Ended listed = run({"orient", part, "--scale", "0.5", "--json"});
  ASSERT_EQ(listed.code, 0) << listed.err;
  const auto found = nlohmann::json::parse(listed.out);
  EXPECT_EQ(found["scale"], 0.5);
  EXPECT_EQ(found["liesBadly"], true);
  ASSERT_EQ(found["ways"].size(), 2u);
  const auto& best = found["ways"][0];
  EXPECT_NEAR(best["contactMm2"], 500.0, 1e-3);
  EXPECT_NEAR(best["heightMm"], 3.0, 1e-3);
  EXPECT_EQ(best["missedVoxels"], 0);
  EXPECT_GT(best["estimatedS"], 10.0);
  EXPECT_EQ(best["now"], false);
  EXPECT_EQ(std::ranges::count_if(found["ways"],
                                  [](const auto& orientation) { return orientation["now"]; }),
            1);

  const std::string rotation = best["turn"], out = (folder_ / "out").string();
  const Ended text = run({"orient", part});
  EXPECT_NE(text.out.find("as it lies"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("--turn=" + rotation), std::string::npos) << text.out;
  // Both ways to write an option whose value may begin with a dash.
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--turn=" + rotation},
                                                 std::vector<std::string>{"--turn", rotation}}) {
    std::vector<std::string> words{"plan", part, "-o", out, "--mode", "flat", "--until", "load"};
    words.insert(words.end(), option.begin(), option.end());
    ASSERT_EQ(run(words).code, 0);
    const auto report = nlohmann::json::parse(base::readFile(folder_ / "out" / "report.json"));
    EXPECT_NEAR(report["model"]["boundsMm"][1][2], 6.0, 1e-3);
    EXPECT_TRUE(report["findings"].empty()) << report["findings"].dump();
  }
  expectOneLine(run({"orient", part, "--turn", "-90,0"}), 2, {"-90,0", "90,0,0"});
  expectOneLine(run({"orient", (folder_ / "none.stl").string()}), 3, {"none.stl"});
}

TEST_F(CommandLine, ErrorsForUnusableInputNameTheFileAndTheReason) {
  const std::string out = (folder_ / "out").string();
  base::writeFile(folder_ / "text.stl", "this is a letter, not a mesh\n");
  base::writeFile(folder_ / "empty.stl", "");
  const auto plan = [&](const std::string& name) {
    return run({"plan", (folder_ / name).string(), "-o", out});
  };
  expectOneLine(plan("none.stl"), 3, {"none.stl", "no such file"});
  fs::create_directory(folder_ / "folder.stl");
  expectOneLine(plan("folder.stl"), 3, {"folder.stl", "directory"});
  expectOneLine(plan("text.stl"), 3, {"text.stl"});
  expectOneLine(plan("empty.stl"), 3, {"empty.stl"});
  expectOneLine(run({"inspect", (folder_ / "none.stl").string()}), 3, {"none.stl"});
  expectOneLine(run({"verify", (folder_ / "none.script").string(), "--job",
                     (folder_ / "none.voluta").string()}),
                3, {"none"});
  base::writeFile(folder_ / "no.voluta", "not a job");
  expectOneLine(
      run({"verify", (folder_ / "text.stl").string(), "--job", (folder_ / "no.voluta").string()}),
      3, {"no.voluta"});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(CommandLine, UnwritableFolderIsRefusedFirst) {
  const std::string part = smallBox();
  base::writeFile(folder_ / "file", "x");
  expectOneLine(run({"plan", part, "-o", (folder_ / "file").string()}), 2, {"file"});
  expectOneLine(run({"plan", part, "-o", (folder_ / "file" / "below").string()}), 2, {"file"});
  expectOneLine(run({"plan", part, "-o", "/proc/voluta"}), 2, {"/proc/voluta"});
  expectOneLine(run({"plan", part, "-o", ""}), 2, {"name of the folder is empty"});
}

// Files of others are kept unless they may be replaced; results of the same kind of job always are.
// Two plans into one folder: the program of the first is named as none of the second's.
TEST_F(CommandLine, AProgramOfAnEarlierPlanIsNamed) {
  const std::string out = (folder_ / "out").string();
  const auto plan = [&](const std::string& name) {
    return run({"plan", stl(name, test::box({-5, -5, 0}, {5, 5, 3})), "-o", out, "--mode", "flat",
                "--format", "csv"});
  };
  EXPECT_EQ(plan("one.stl").out.find("earlier plan"), std::string::npos);
  const std::string second = plan("two.stl").out;
  EXPECT_NE(second.find("of an earlier plan, NOT of this one: one.csv"), std::string::npos)
      << second;
  EXPECT_EQ(second.find("two.csv and"), std::string::npos);
  EXPECT_EQ(plan("two.stl").out.find("two.csv and"), std::string::npos) << "its own are replaced";
}

// A part whose program is safe to run ends with 4 and a line of its own; so do its verification and
// the rest of the print.
TEST_F(CommandLine, APartThatDiffersIsAmberInEveryCommand) {
  const std::string out = (folder_ / "out").string(), job = out + "/job.voluta";
  const Ended plan = run({"plan", stl("prism.stl", test::sharpPrism()), "-o", out, "--mode", "flat",
                          "--format", "urscript", "--set", "quality=strict"});
  expectOneLine(plan, 4, {"not as asked: replay: ", "not covered by beads"});
  EXPECT_NE(plan.out.find("replay safe to run, NOT as asked: "), std::string::npos) << plan.out;
  const auto json = nlohmann::json::parse(base::readFile(fs::path(out) / "report.json"));
  EXPECT_EQ(json.at("verdict"), "differs");
  const std::string name = json.at("programs").at(0).at("files").at(0);
  const Ended verified = run({"verify", out + "/" + name, "--job", job});
  expectOneLine(verified, 4, {"not as asked: ", "not covered by beads"});
  EXPECT_NE(verified.out.find("not as asked: uncovered: "), std::string::npos) << verified.out;
  const Ended rest = run({"resume", job, "--bead", "3", "-o", (folder_ / "rest").string()});
  expectOneLine(rest, 4, {"not as asked: "});
}

TEST_F(CommandLine, StatementsOfTheUsersOwnAreNamedInEveryCommand) {
  const std::string out = (folder_ / "out").string(), part = smallBox();
  const std::string words = "safe to run but for your own statements";
  const Ended plan = run({"plan", part, "-o", out, "--mode", "flat", "--format", "urscript",
                          "--set", "layerEvents=2 statement urscript set_tool_voltage(24)"});
  expectOneLine(plan, 4, {"not checked: replay: ", "set_tool_voltage(24)"});
  EXPECT_NE(plan.out.find("replay " + words + ": "), std::string::npos) << plan.out;
  const auto json = nlohmann::json::parse(base::readFile(fs::path(out) / "report.json"));
  EXPECT_EQ(json.at("verdict"), "unchecked");
  const std::string name = json.at("programs").at(0).at("files").at(0);
  const Ended verified = run({"verify", out + "/" + name, "--job", out + "/job.voluta"});
  expectOneLine(verified, 4, {"not checked: ", "set_tool_voltage(24)"});
  EXPECT_NE(verified.out.find(": " + words + " (urscript)"), std::string::npos) << verified.out;
  const Ended refused = run({"plan", part, "-o", out + "2", "--mode", "flat", "--set",
                             "layerEvents=2 statement urscript set_tcp(p[0,0,0,0,0,0])"});
  expectOneLine(refused, 2, {"'set_tcp' in the statement before layer 2", "layerEvents"});
}

// What is accepted on the command line is one list, wherever it is given.
TEST_F(CommandLine, AcceptedSharesAreOneList) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  const auto accepted = [&](std::vector<std::string> words) {
    std::vector<std::string> all{"plan", part, "-o", out, "--mode", "flat", "--format", "csv"};
    all.insert(all.end(), words.begin(), words.end());
    const Ended ended = run(all);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("replay passed"), std::string::npos) << ended.out;
    const std::string report = base::readFile(fs::path(out) / "report.json");
    const std::size_t at = report.find("\"accepted\": \"");
    return report.substr(at + 13, report.find('"', at + 13) - at - 13);
  };
  EXPECT_EQ(accepted({"--set", "accept=mass=0.2", "--accept", "uncovered=1"}),
            "uncovered=1, mass=0.2");
  EXPECT_EQ(accepted({"--accept", "mass=0.2", "--accept", "mass=0.1"}), "mass=0.1");
  expectOneLine(run({"plan", part, "-o", out, "--accept", "uncoverd=0.1"}), 2, {"uncovered"});
}

TEST_F(CommandLine, FilesOfOthersAreReplacedOnRequestOnly) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  const std::vector<std::string> plan{"plan",   part,   "-o",      out,
                                      "--mode", "flat", "--until", "layers"};
  const std::vector<std::string> mill{"mill", part, "-o", out, "--pitch", "0.2"};
  const auto replacing = [](std::vector<std::string> words) {
    words.emplace_back("--replace");
    return words;
  };
  for (const char* name : {"job.voluta", "report.json"}) {
    fs::remove_all(out);
    fs::create_directory(out);
    base::writeFile(fs::path(out) / name, "mine");
    expectOneLine(run(plan), 2, {name, "would be replaced", "--replace"});
    EXPECT_EQ(base::readFile(fs::path(out) / name), "mine");
    EXPECT_EQ(run(replacing(plan)).code, 0);
    EXPECT_EQ(run(plan).code, 0) << "the second run";
  }
  const std::vector<std::string> whole{"plan", part, "-o", out, "--mode", "flat"};
  const fs::path program = fs::path(out) / "box.script";
  fs::remove_all(out);
  fs::create_directories(program);
  expectOneLine(run(replacing(whole)), 2, {"box.script", "it is a folder"});
  fs::remove(program);
  base::writeFile(program, "mine");
  expectOneLine(run(whole), 2, {"box.script", "would be replaced", "--replace"});
  EXPECT_EQ(run(replacing(whole)).code, 0);
  base::writeFile(fs::path(out) / "notes.txt", "mine");
  EXPECT_EQ(run(plan).code, 0);
  EXPECT_EQ(base::readFile(fs::path(out) / "notes.txt"), "mine");
  // Of another kind of job
  expectOneLine(run(mill), 2, {"report.json", "would be replaced"});
  EXPECT_EQ(run(replacing(mill)).code, 0);
  EXPECT_EQ(run(mill).code, 0) << "the second run";
  expectOneLine(run(plan), 2, {"report.json", "would be replaced"});
}

TEST_F(CommandLine, NumbersThatAreNoneAreRefused) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  expectOneLine(run({"together", part, "--clearance", "nan", "-o", out}), 2,
                {"--clearance", "'nan' is no number"});
  expectOneLine(run({"mill", part, "-o", out, "--cutter", "nan"}), 2, {"--cutter", "nan"});
  expectOneLine(run({"mill", part, "-o", out, "--pitch", "inf"}), 2, {"--pitch", "inf"});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(CommandLine, ListsAnswerInTextAndJson) {
  for (const char* what :
       {"modes", "cells", "robots", "formats", "processes", "presets", "parameters"}) {
    const Ended text = run({"list", what});
    EXPECT_EQ(text.code, 0);
    EXPECT_FALSE(text.out.empty()) << what;
    const Ended json = run({"list", what, "--json"});
    EXPECT_EQ(json.code, 0);
    const auto parsed = nlohmann::json::parse(json.out);
    ASSERT_TRUE(parsed.is_array()) << what;
    EXPECT_FALSE(parsed.empty()) << what;
  }
}

TEST_F(CommandLine, ProcessesAreExportedEditedAndImported) {
  ::setenv("VOLUTA_DATA", (folder_ / "data").c_str(), 1);
  const std::string file = (folder_ / "mine.json").string();
  EXPECT_EQ(run({"process", "export", "fdm-0.4", "-o", file}).code, 0);
  expectOneLine(run({"process", "import", file}), 3, {"fdm-0.4", "comes with the program"});
  auto json = nlohmann::json::parse(base::readFile(file));
  json["id"] = "mine";
  json["beadWidthMm"]["default"] = 4.5;
  base::writeFile(file, json.dump());
  expectOneLine(run({"process", "check", file}), 3, {"mine.json", "beadWidthMm.default", "4.5"});
  expectOneLine(run({"process", "import", file}), 3, {"beadWidthMm.default"});
  json["beadWidthMm"]["default"] = 0.5;
  base::writeFile(file, json.dump());
  EXPECT_EQ(run({"process", "import", file}).code, 0);
  EXPECT_NE(run({"process", "list"}).out.find("mine"), std::string::npos);
  EXPECT_EQ(run({"process", "check", "mine"}).code, 0);
  json["head"] = nlohmann::json::parse("[[0, 20], [30, 20], [40, 0.5]]");
  base::writeFile(file, json.dump());
  const Ended turned = run({"process", "check", file});
  EXPECT_EQ(turned.code, 4);
  EXPECT_NE(turned.out.find("point away from the part"), std::string::npos) << turned.out;
  const Ended inCell = run({"cell", "check", "ur5-moving", "--process", file});
  EXPECT_EQ(inCell.code, 4);
  EXPECT_NE(inCell.out.find("point away from the part"), std::string::npos) << inCell.out;
  const auto shown = nlohmann::json::parse(run({"process", "show", "mine"}).out);
  EXPECT_EQ(shown.at("beadWidthMm").at("default"), 0.5);
  expectOneLine(run({"process", "show", "mime"}), 2, {"mime", "mine"});
  // A torn file of one's own does not keep the others from being listed.
  base::writeFile(folder_ / "data" / "processes" / "a-torn.json", "{");
  for (const char* what : {"processes", "cells"})
    EXPECT_EQ(run({"list", what}).code, 0) << what;
  EXPECT_NE(run({"process", "list"}).out.find("a-torn"), std::string::npos);
  ::unsetenv("VOLUTA_DATA");
}

TEST_F(CommandLine, RobotAnswersInDegreesAndMillimetres) {
  const Ended forward = run({"robot", "ur5", "--fk", "0,-90,90,-90,-90,0"});
  ASSERT_EQ(forward.code, 0) << forward.err;
  const auto pose = nlohmann::json::parse(forward.out);
  EXPECT_NEAR(pose.at("positionMm")[0].get<double>(), -486.9, 1e-3);
  EXPECT_NEAR(pose.at("positionMm")[2].get<double>(), 431.859, 1e-3);
  const Ended inverse =
      run({"robot", "ur5", "--ik", "-486.9,-109.15,431.859,0,-0.70710678,-0.70710678,0"});
  ASSERT_EQ(inverse.code, 0) << inverse.err;
  EXPECT_EQ(nlohmann::json::parse(inverse.out).at("solutions").size(), 8u);
}

TEST_F(CommandLine, SmallPartIsPlannedFromMeshToPrograms) {
  const std::string part = smallBox();
  const std::string out = (folder_ / "out").string();
  const Ended ended =
      run({"plan", part, "-o", out, "--mode", "curved", "--set", "output.debug=true"});
  EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
  for (const char* name : {"job.voluta", "report.json", "box.script", "box.gcode", "voxels.vti",
                           "layers.vtp", "toolpath.vtp", "trajectory.csv"})
    EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
  const auto report = nlohmann::json::parse(base::readFile(folder_ / "out" / "report.json"));
  EXPECT_TRUE(report.at("replay").at("passed").get<bool>());
  EXPECT_EQ(report.at("decomposition").at("missedVoxels").get<int>(), 0);
  EXPECT_NEAR(report.at("model").at("volumeMm3").get<double>(), 2880.0, 1e-6);
  EXPECT_NEAR(report.at("toolpath").at("materialMm3").get<double>(), 2880.0, 0.03 * 2880.0);
  for (const char* name : {"box.script", "box.gcode"}) {
    const Ended verified = run({"verify", (folder_ / "out" / name).string(), "--job",
                                (folder_ / "out" / "job.voluta").string()});
    EXPECT_EQ(verified.code, 0) << name << ": " << verified.err << verified.out;
  }
}

// Parts of a report that must not depend on the number of threads, nor on the run.
nlohmann::json comparable(nlohmann::json report) {
  report.erase("timingS");
  report.erase("threads");
  report.erase("peakRssMb");
  return report;
}

TEST_F(CommandLine, OneAndTwoThreadsPlanTheSame) {
  const std::string part = smallBox();
  for (const char* threads : {"1", "2"})
    run({"plan", part, "-o", (folder_ / threads).string(), "--threads", threads});
  const auto report = [&](const char* threads) {
    return comparable(nlohmann::json::parse(base::readFile(folder_ / threads / "report.json")));
  };
  EXPECT_EQ(report("1"), report("2"));
  EXPECT_EQ(base::readFile(folder_ / "1" / "box.script"),
            base::readFile(folder_ / "2" / "box.script"));
}

TEST_F(CommandLine, APrintIsTakenUpAgain) {
  const std::string first = (folder_ / "first").string(), rest = (folder_ / "rest").string();
  ASSERT_EQ(run({"plan", smallBox(), "-o", first, "--mode", "flat", "--format", "urscript", "--set",
                 "motionsPerFile=2000"})
                .code,
            0);
  const std::string job = first + "/job.voluta";
  // A program in several files, of which any may be named.
  for (const char* name : {"/box.script", "/print_box_1.script", "/print_box_2.script"})
    EXPECT_EQ(run({"verify", first + name, "--job", job}).code, 0) << name;
  const Ended ended = run({"resume", job, "--bead", "3", "-o", rest});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("from bead 3 of "), std::string::npos) << ended.out;
  EXPECT_EQ(run({"verify", rest + "/box_rest.script", "--job", rest + "/job.voluta"}).code, 0);
  std::set<std::string> places;
  for (const char* name : {"/print_box_1.script", "/print_box_2.script"}) {
    const Ended byLine =
        run({"resume", job, "--at", "1000", "--program", first + name, "-o", rest});
    EXPECT_EQ(byLine.code, 0) << byLine.err;
    places.insert(byLine.out.substr(0, byLine.out.find(',')));
  }
  EXPECT_EQ(places.size(), 2u) << *places.begin();
  expectOneLine(run({"resume", job, "--at", "1000", "-o", rest}), 2,
                {"line 1000", "--program", "print_box_1.script"});
  expectOneLine(run({"resume", job, "--at", "99999999", "--program", first + "/print_box_1.script",
                     "-o", rest}),
                2, {"99999999", "print_box_1.script"});
  expectOneLine(run({"resume", job, "--bead", "0", "-o", rest}), 2, {"no bead 0"});
  expectOneLine(run({"resume", job, "--bead", "3", "-o", first}), 2, {"the stopped print", first});
  expectOneLine(run({"resume", job, "-o", rest}), 2, {});
  expectOneLine(run({"resume", job, "--at", "99999999", "-o", rest}), 2, {"99999999"});
  expectOneLine(run({"resume", first + "/none.voluta", "--bead", "1", "-o", rest}), 3, {"none"});
}

TEST_F(CommandLine, CancelLeavesTheFolderAsItWas) {
  const std::string part = smallBox();
  fs::create_directory(folder_ / "out");
  base::writeFile(folder_ / "out" / "report.json", "kept");
  std::mt19937 random(11);
  int cancelled = 0;
  for (int trial = 0; trial < 10; ++trial) {
    base::writeFile(folder_ / "out" / "report.json", "kept");
    const auto before = entries(), inside = names(folder_ / "out");
    const pid_t child = start({"plan", part, "-o", (folder_ / "out").string(), "--replace"});
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + random() % 1500));
    ::kill(child, SIGINT);
    const Ended ended = finish(child);
    if (ended.code != 5)
      continue; // it was done before the signal came
    ++cancelled;
    EXPECT_EQ(base::readFile(folder_ / "out" / "report.json"), "kept");
    EXPECT_EQ(names(folder_ / "out"), inside);
    EXPECT_EQ(entries(), before) << "something was left beside the folder";
  }
  EXPECT_GE(cancelled, 1);
}

TEST_F(CommandLine, EveryCommandObeysATermination) {
  const std::string part = smallBox(), out = (folder_ / "out").string(),
                    job = (folder_ / "job.voluta").string();
  const std::vector<std::vector<std::string>> commands{
      {"plan", part, "-o", out},
      {"compare", part, "-o", out},
      {"inspect", part},
      {"orient", part},
      {"mill", part, "-o", out},
      {"pith", part, "-o", out + ".stl"},
      {"cut", part, "--plane", "0,0,1,5", "-o", out},
      {"split", part, "-o", out},
      {"render", job, "-o", out + ".png"},
      {"film", job, "-o", out + ".webm"},
      {"verify", out + "/a.script", "--job", job},
      {"resume", job, "--bead", "1", "-o", out},
      {"compare-run", job, out + ".csv"},
      {"together", job, job, "--place", "1000,0,0,180", "-o", out},
      {"together", "--verify", out},
      {"cell", "reach"},
      {"cell", "nozzle", "--cell", "ur5-fixed"},
      {"cell", "check", "ur5-fixed"},
      {"cell", "advise", part, "--cells", "ur5-fixed,ur5-moving"},
      {"cell", "place", part, "--robot", "ur5"},
      {"robot", "ur5", "--fk", "0,0,0,0,0,0"},
      {"process", "show", "fdm-1.0"},
      {"material", "show", "pla"}};
  for (const std::vector<std::string>& words : commands)
    EXPECT_EQ(finish(start(words, true)).code, 5) << words[0] << ' ' << words[1];
  EXPECT_EQ(entries(), std::set<std::string>{"box.stl"}) << "a cancelled command left something";
}

nlohmann::json jsonOf(const fs::path& file) {
  return nlohmann::json::parse(base::readFile(file));
}

TEST_F(CommandLine, ComparisonTableEqualsTheReports) {
  const fs::path out = folder_ / "out";
  const Ended ended =
      run({"compare", smallBox(), "-o", out.string(), "--until", "layers", "--growths",
           "reverse,greedy", "--platforms", "fit:0,fit:20", "--weight", "pieces=0"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("best: row 1"), std::string::npos) << ended.out;
  const nlohmann::json compared = jsonOf(out / "compare.json");
  ASSERT_EQ(compared["rows"].size(), 8u);
  EXPECT_EQ(compared["rule"]["weights"]["pieces"], 0.0);
  std::set<std::string> folders{"compare.json"};
  for (const auto& row : compared["rows"]) {
    const std::string folder = row["folder"];
    folders.insert(folder);
    const nlohmann::json report = jsonOf(out / folder / "report.json");
    const nlohmann::json& d = report["decomposition"];
    EXPECT_EQ(row["mode"], d["mode"]);
    EXPECT_EQ(row["pieces"], d["pieces"]);
    EXPECT_EQ(row["supportVolumeMm3"], d["supportVolumeMm3"]);
    EXPECT_EQ(row["layers"], report["layers"]["count"]);
    for (const char* figure : {"missedVoxels", "riskyAreaMm2"})
      EXPECT_TRUE(row[figure].is_null() || row[figure] == d[figure]) << row << d;
    EXPECT_TRUE(row["printTimeS"].is_null()) << "the road ended before";
    for (const auto& picture : row["pictures"])
      EXPECT_TRUE(fs::exists(out / picture.get<std::string>())) << picture;
  }
  EXPECT_EQ(names(out), folders);
}

TEST_F(CommandLine, AComparisonThatCannotBeginLeavesNothing) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  expectOneLine(run({"compare", part, "-o", out, "--modes", "curved,flatt"}), 2, {"flat"});
  expectOneLine(run({"compare", part, "-o", out, "--growths", "gready"}), 2, {"greedy"});
  expectOneLine(run({"compare", part, "-o", out, "--platforms", "fit:0,disk:9"}), 2, {"disc"});
  expectOneLine(run({"compare", part, "-o", out, "--weight", "piece=1"}), 2, {"pieces"});
  expectOneLine(run({"compare", (folder_ / "none.stl").string(), "-o", out}), 3, {"none.stl"});
  const pid_t child = start({"compare", part, "-o", out});
  while (entries().size() < 2) // it has begun when its folder out of sight is there
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ::kill(child, SIGINT);
  EXPECT_EQ(finish(child).code, 5);
  EXPECT_EQ(entries(), std::set<std::string>{"box.stl"});
}

TEST_F(CommandLine, CellsAreMeasuredMappedAndChecked) {
  const auto table = [&](const char* name, const std::string& rows) {
    const fs::path file = folder_ / name;
    base::writeFile(file, rows);
    return file.string();
  };
  const std::string points = table("points.csv", "500,10,30\n600,10,30\n500,90,30\n");
  const Ended frame = run({"cell", "frame", points});
  EXPECT_EQ(frame.code, 0);
  const auto pose = nlohmann::json::parse(frame.out)["pose"];
  EXPECT_EQ(pose["xyzMm"], nlohmann::json({500.0, 10.0, 30.0}));
  EXPECT_EQ(pose["rpyDeg"], nlohmann::json({0.0, 0.0, 0.0}));
  expectOneLine(run({"cell", "frame", table("line.csv", "1 2 3\n2 4 6\n3 6 9\n")}), 3, {"line"});
  expectOneLine(run({"cell", "frame", table("word.csv", "1 2 3\n2 x 6\n")}), 3, {"line 2", "'x'"});
  expectOneLine(run({"cell", "frame", (folder_ / "none.csv").string()}), 3, {"none.csv"});
  // Four times the same pose.
  const std::string still = table("still.csv", "0,-90,90,-90,-90,0\n0,-90,90,-90,-90,0\n"
                                               "0,-90,90,-90,-90,0\n0,-90,90,-90,-90,0\n");
  expectOneLine(run({"cell", "tool-tip", still, "--robot", "ur5"}), 3, {"identical"});
  expectOneLine(run({"cell", "tool-tip", still}), 3, {"7"});

  const Ended reach = run({"cell", "reach", "--cell", "t3", "--json"});
  EXPECT_EQ(reach.code, 0);
  EXPECT_EQ(nlohmann::json::parse(reach.out)["tilts"].size(), 1u);
  expectOneLine(run({"cell", "reach", "--cell", "lathe"}), 2, {"no plate"});
  expectOneLine(run({"cell", "nozzle", "--cell", "ur5-moving"}), 2, {"stationary"});

  EXPECT_EQ(run({"cell", "check", "ur5-fixed"}).code, 0);
  const Ended heavy = run({"cell", "check", "ur5-fixed", "--part-kg", "9"});
  EXPECT_EQ(heavy.code, 4);
  EXPECT_NE(heavy.out.find("9.5 kg"), std::string::npos) << heavy.out;
  const Ended broken = run({"cell", "check", table("bad.json", "{\"id\": \"bad\"}")});
  EXPECT_EQ(broken.code, 3);
  EXPECT_NE(broken.out.find("'robot' is missing"), std::string::npos) << broken.out;
}

} // namespace
