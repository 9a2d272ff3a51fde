// RAPID: its bytes, its modules, programs by people and statements that the reader must not ignore.
#include "program_defects.h"
#include "program_fixture.h"

#include "base/units.h"
#include "program/dialect.h"
#include "program/rapid/rapid.h"
#include <sstream>

namespace voluta::program {
namespace {

using test::expectDefect;

// A cell whose nozzle moves over a plate in the world.
constexpr const char* kMovingNozzle = R"({
  "id": "bench", "label": "bench", "robot": "ur5",
  "nozzle": {"mount": "flange", "pose": {"xyzMm": [0, 30, 120], "rpyDeg": [0, 20, 0]}},
  "platform": {"mount": "world", "pose": {"xyzMm": [-400, 150, 10], "rpyDeg": [0, 0, 30]},
               "thicknessMm": 5},
  "obstacles": [], "homeDeg": [0, 0, 0, 0, 0, 0], "neverMeet": [], "externalAxes": []
})";

std::string crLf(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

// A whole module around the given body, whose first line is line 8.
std::string module(const std::string& body) {
  return crLf("MODULE m\n"
              "PERS tooldata t1:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,80],[1,0,0,0],0,0,0]];\n"
              "PERS wobjdata w1:=[FALSE,TRUE,\"\",[[400,0,0],[1,0,0,0]],[[0,0,10],[1,0,0,0]]];\n"
              "PROC main()\n"
              "ConfL\\Off; ConfJ\\Off;\n"
              "SetDO doExtruder,0;\n"
              "SetAO aoFlow,0;\n" +
              body +
              "SetDO doExtruder,0;\n"
              "SetAO aoFlow,0;\n"
              "ENDPROC\nENDMODULE\n");
}

plan::ReadProgram read(std::vector<plan::ProgramFile> files) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram("rapid", files, process::Tooling(process));
}
plan::ReadProgram read(std::string text) {
  return read({{"m.mod", std::move(text)}});
}

void expectSound(const plan::ReadProgram& program) {
  EXPECT_TRUE(program.complete);
  for (const plan::ProgramDefect& d : program.defects)
    ADD_FAILURE() << d.file << ":" << d.line << ": " << voluta::base::english(d.reason);
}

constexpr const char* kMove =
    "MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1\\WObj:=w1;\n";

TEST(RapidReader, takesHandWrittenVariations) {
  const auto program = read(
      crLf("! a program; with a semicolon\n"
           "module Hand (NOSTEPIN)\n"
           "  LOCAL CONST robtarget pA:=[[1,2,3],[0.5,0.5,0.5,0.5],[0,-1,0,1],\n"
           "     [9E9,9E+09,9E9,9E9,9E9,9E9]]; ! over two lines\n"
           "  const jointtarget jHome:=[[0,90,-90,0,45,180],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
           "  VAR speeddata vSlow:=[12.5,500,5000,1000];\n"
           "  CONST zonedata zFine:=[FALSE,0.4,0.5,0.5,1,1,1];\n"
           "  PERS tooldata tNozzle:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,80],[1,0,0,0],0,0,0]];\n"
           "  PROC Main()\n"
           "    ConfL\\Off; CONFJ \\ off ;\n"
           "    TPWrite \"it begins! now;\";\n"
           "    SetDO doExtruder,0; SetAO aoFlow,0; SetDO doFan,1;\n"
           "    MoveAbsJ jHome\\NoEOffs,v50,fine,tNozzle;\n"
           "    MoveJ pA,v7000,z10,tNozzle\\WObj:=wobj0;\n"
           "    SetAO aoFlow , .25 ; SetDO doExtruder , 1 ;\n"
           "    MoveL\n      PA,\n      vSlow,zFine,TNOZZLE;\n"
           "    MoveL [[1,2,4],[.5,.5,.5,.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v5\\T:=0.5,z0,"
           "tNozzle\\WObj:=wobj0;\n"
           "    MoveL [[1,2,4],[0.5,0.5,0.5,-0.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v5,fine,"
           "tNozzle;\n"
           "    WaitTime 1;\n"
           "    SetAO aoFlow,0; SetDO doExtruder,0;\n"
           "  ENDPROC\n"
           "ENDMODULE\n"));
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 5u);
  const auto& m = program.motions;
  EXPECT_NEAR(program.flange_T_tcp.translation().z(), 100.0, 1e-12);
  EXPECT_EQ(m[0].target, plan::TargetKind::Joints);
  EXPECT_EQ(m[0].line, 13u);
  EXPECT_NEAR(m[0].joints[5], base::kPi, 1e-12);
  EXPECT_TRUE(m[0].jointInterpolated && m[1].jointInterpolated && !m[2].jointInterpolated);
  EXPECT_EQ(m[1].target, plan::TargetKind::FlangePose);
  EXPECT_EQ(m[1].blendMm, 10.0);
  EXPECT_EQ(m[1].frame_T_tcp.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(m[2].line, 16u);
  EXPECT_EQ(m[2].speedMmPerS, 12.5);
  EXPECT_EQ(m[2].blendMm, 0.4);
  EXPECT_TRUE(m[2].extruding && !m[1].extruding);
  EXPECT_EQ(m[2].flowMm3PerS, 10.0);
  EXPECT_EQ(m[3].durationS, 0.5);
  EXPECT_EQ(m[3].blendMm, 0.3);
  // A third of a turn on the spot at 500 degrees a second.
  EXPECT_NEAR(m[4].durationS, 120.0 / 500.0, 1e-9);
}

TEST(RapidReader, placesTargetsInTheirWorkObject) {
  const auto program = read(module(kMove));
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 1u);
  EXPECT_EQ(program.motions[0].frame_T_tcp.translation(), Eigen::Vector3d(401, 2, 13));
}

TEST(RapidReader, namesStatementsThatItCannotRead) {
  const std::string pose = "[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
  const struct {
    std::string line;
    const char* part;
  } cases[] = {
      {"MoveL [[1,2,3],[1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1;",
       "other components"},
      {"MoveL [[1,2,3],[1,0.1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1;",
       "normalised"},
      {"MoveL [[1,2,3],[1,0,0,0],[0,0.5,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1;",
       "quarter turns"},
      {"MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1;", "external"},
      {"MoveL [[1,2,4E9],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1;", "reach"},
      {"MoveL " + pose + ",v101,fine,t1;", "not declared"},
      {"MoveL " + pose + ",[0,500,5000,1000],fine,t1;", "speed"},
      {"MoveL " + pose + ",v100\\T:=0,fine,t1;", "time"},
      {"MoveL " + pose + ",v100\\V:=3,fine,t1;", "not understood"},
      {"MoveL " + pose + ",v100,z3,t1;", "not declared"},
      {"MoveL " + pose + ",v100,[FALSE,1,0.5,1,1,1,1],t1;", "smaller than"},
      {"MoveL " + pose + ",v100,fine,t2;", "not declared"},
      {"MoveL " + pose + ",v100,fine,w1;", "not of type tooldata"},
      {"MoveL " + pose + ",v100,fine,tool0;", "different tool"},
      {"MoveL " + pose + ",v100,fine,t1\\WObj:=w2;", "not declared"},
      {"MoveL Offs(p1,0,0,1),v100,fine,t1;", "not declared"},
      {"MoveL " + pose + ",v100,fine;", "not understood"},
      {"MoveC " + pose + "," + pose + ",v100,fine,t1;", "on a line"},
      {"MoveAbsJ [[0,0,0,0,0,1E5],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1;", "limit"},
      {"SetDO doExtruder,2;", "0 or 1"},
      {"SetAO aoFlow,1.5;", "0..1"},
      {"VelSet 50,500;", "slows the arm"},
      {"WaitTime -1;", "seconds"},
      {"IF TRUE THEN", "not known"},
      {"x:=3;", "not known"},
      {"%\"other\"%;", "not loaded"},
      {"UnLoad \"HOME:\"\\File:=\"a.mod\";", "not loaded"},
      {"$;", "not understood"},
      {"PERS speeddata vA:=[1,1,1,1];", "not known"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const auto program =
        read(module(kMove + c.line + (c.line.back() == ';' ? "\n" : ";\n") + kMove));
    expectDefect(program, 9, c.part);
    EXPECT_EQ(program.motions.size(), 2u);
  }
}

TEST(RapidReader, namesPartsMissingInAModule) {
  const std::string whole = module(kMove);
  expectSound(read(whole));
  const auto without = [&](const std::string& piece) {
    std::string text = whole;
    text.erase(text.find(piece), piece.size());
    return read(text);
  };
  expectDefect(without("MODULE m"), 2, "begin with MODULE");
  expectDefect(without("PROC main()"), 5, "outside the procedure");
  expectDefect(without("ConfL\\Off; "), 8, "configuration");
  expectDefect(without("ENDPROC"), 12, "no ENDPROC");
  expectDefect(without("\r\nENDMODULE"), 12, "ENDMODULE is missing");
  expectDefect(without("PERS tooldata"), 8, "'t1' is not declared");
  EXPECT_FALSE(without("\r\nENDMODULE").complete);
  EXPECT_FALSE(without("ENDPROC").complete);
  EXPECT_FALSE(read("").complete);
  EXPECT_FALSE(read(std::vector<plan::ProgramFile>{}).complete);
}

TEST(RapidReader, requiresCrLfEverywhere) {
  std::string text = module(kMove);
  const std::size_t third = text.find("PROC") - 2;
  text.erase(third, 1);
  const auto program = read(text);
  expectDefect(program, 3, "CR LF");
  EXPECT_EQ(program.defects.size(), 1u);
  // The last line may have no end.
  expectSound(read(module(kMove).substr(0, module(kMove).size() - 2)));
}

TEST(RapidReader, turnsWithinItsSpeedLimit) {
  const std::string turned =
      "MoveL [[1,2,4],[0,0,0,1],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[1,10,5000,1000],fine,"
      "t1\\WObj:=w1;\n";
  const auto program = read(module(kMove + turned));
  expectSound(program);
  EXPECT_NEAR(program.motions[1].durationS, 18.0, 1e-9); // half a turn; the way takes 1 s
}

class Rapid : public test::Programs {
protected:
  void useMovingNozzle(const std::string& robot = "ur5") {
    const test::TemporaryFolder folder;
    std::string cell = kMovingNozzle;
    cell.replace(cell.find("ur5"), 3, robot);
    base::writeFile(folder / "bench.json", cell);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
  }
  // The tip and the nozzle's pose in the work frame against the plan's.
  void expectTargets(const plan::ReadProgram& back) const {
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      const Eigen::Isometry3d planned =
          cell_->work_T_tool(Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), trajectory_.dof));
      const bool held = back.base_T_nozzle.has_value();
      ASSERT_EQ(held, cell_->nozzleMount() == robot::Mount::World);
      if (held) {
        ASSERT_TRUE(back.base_T_nozzle->isApprox(cell_->base_T_fixed(), 1e-9) &&
                    back.flange_T_tcp.isApprox(cell_->flange_T_moved(), 1e-9));
      }
      const Eigen::Isometry3d tool =
          held ? back.motions[i].frame_T_tcp
               : cell_->work_T_toolOfFlange(
                     back.motions[i].frame_T_tcp * back.flange_T_tcp.inverse(), cell_->home());
      ASSERT_LE((tool.translation() - planned.translation()).norm(), 1e-3) << "point " << i;
      ASSERT_LE(Eigen::AngleAxisd(planned.linear().transpose() * tool.linear()).angle(), 1e-5);
    }
  }
};

TEST_F(Rapid, everyLineOfEveryFileEndsWithCrLf) {
  appendRandom(3, 6000);
  for (const plan::ProgramFile& file : writeProgram("rapid", input()).files) {
    ASSERT_TRUE(file.text.ends_with("\r\n")) << file.name;
    for (std::size_t i = 0; i < file.text.size(); ++i) {
      ASSERT_EQ(file.text[i] == '\r', i + 1 < file.text.size() && file.text[i + 1] == '\n');
      ASSERT_TRUE(file.text[i] != '\n' || file.text[i - 1] == '\r');
    }
  }
}

TEST_F(Rapid, targetsOfAMovingNozzleAreInThePlatesWorkObject) {
  useMovingNozzle();
  appendRandom(8, 1500);
  const plan::Program program = writeProgram("rapid", input());
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  expectTargets(back);
  // A target's numbers are the tip in the work frame.
  const Eigen::Vector3d tip =
      cell_->work_T_tool(Eigen::Map<const Eigen::VectorXd>(trajectory_.at(0), 6)).translation();
  const std::string& text = program.files[0].text;
  const std::size_t at = text.find("MoveJ [[") + 8;
  EXPECT_NEAR(std::stod(text.substr(at)), tip.x(), 1e-4);
}

TEST_F(Rapid, itsOwnRobotGetsJointsTimesAndConfigurations) {
  useMovingNozzle("irb1200");
  const double d = base::kPi / 180.0;
  append(plan::MoveKind::Joint, {0, 10 * d, 20 * d, 0, 60 * d, 0}, 0.0, 0.0);
  append(plan::MoveKind::Joint, {-100 * d, 15 * d, 25 * d, 95 * d, 50 * d, -185 * d}, 2.5, 0.0);
  append(plan::MoveKind::Linear, {-100.1 * d, 15 * d, 25 * d, 95 * d, 50 * d, -185 * d}, 0.1, 0.0);
  const plan::Program program = writeProgram("rapid", input());
  EXPECT_FALSE(program.foreign);
  const std::string& text = program.files[0].text;
  EXPECT_EQ(text.find("FOREIGN"), std::string::npos);
  EXPECT_NE(text.find("MoveAbsJ [[-100,15,25,95,50,-185],[9E9,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,"
                      "[100,500,5000,1000]\\T:=2.5,fine,tNozzle\\WObj:=wPrint;\r\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(",[-2,1,-3,0],"), std::string::npos) << text; // quarters of axes 1, 4, 6
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_EQ(back.motions.size(), 3u);
  EXPECT_TRUE(back.motions[0].jointInterpolated && back.motions[1].jointInterpolated);
  EXPECT_EQ(back.motions[1].durationS, 2.5);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(back.motions[1].joints[k], trajectory_.at(1)[k], 1e-8);
  EXPECT_EQ(back.motions[2].target, plan::TargetKind::FlangePose);
}

TEST_F(Rapid, isCutIntoModulesThatAreReadBackInOrder) {
  appendRandom(9, 12100);
  const plan::Program program = writeProgram("rapid", input());
  ASSERT_EQ(program.files.size(), 6u); // main, three parts, the signals, the list
  EXPECT_EQ(program.files[0].name, "part_1.mod");
  EXPECT_EQ(program.files[3].name, "part_1_3.mod");
  EXPECT_EQ(program.files[5].name, "part_1.pgf");
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  expectTargets(back);
  for (std::size_t i = 1; i < back.motions.size(); ++i)
    if (back.motions[i].file != back.motions[i - 1].file) {
      EXPECT_FALSE(back.motions[i].extruding);
      EXPECT_EQ(back.motions[i - 1].blendMm, 0.0);
    }
  const Dialect& rapid = findDialect("rapid");
  EXPECT_EQ(rapid.continuationFiles(program.files[0].text),
            (std::vector<std::string>{"part_1_1.mod", "part_1_2.mod", "part_1_3.mod"}));
  EXPECT_EQ(rapid.continuationFiles(program.files[5].text), std::vector<std::string>{"part_1.mod"});
  EXPECT_TRUE(rapid.continuationFiles(program.files[1].text).empty());
  std::vector<plan::ProgramFile> files = program.files;
  std::swap(files[1], files[2]);
  EXPECT_FALSE(read(files).complete);
  files = program.files;
  files.erase(files.begin() + 3);
  EXPECT_FALSE(read(files).complete);
  EXPECT_FALSE(read({program.files[1]}).complete);
  // Each of main's lines counts.
  const std::string& main = program.files[0].text;
  for (const char* lost :
       {"    Load\\Dynamic,\"HOME:\"\\File:=\"part_1_2.mod\";\r\n", "    %\"runPart2\"%;\r\n",
        "    UnLoad \"HOME:\"\\File:=\"part_1_2.mod\";\r\n"}) {
    files = program.files;
    const std::size_t at = main.find(lost);
    ASSERT_NE(at, std::string::npos) << lost;
    files[0].text.erase(at, std::string_view(lost).size());
    const plan::ReadProgram damaged = read(files);
    EXPECT_FALSE(damaged.defects.empty()) << lost;
  }
}

TEST_F(Rapid, aPathWithoutEndIsCutAtAStop) {
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, 0, 0);
  for (int i = 1; i <= 12000; ++i)
    append(plan::MoveKind::Print, {0.1 + 1e-4 * i, -1.9, 1.7, -1.2, -1.4, 0.3}, 0.05, 0.5);
  const plan::Program program = writeProgram("rapid", input());
  ASSERT_EQ(program.files.size(), 6u);
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  expectTargets(back);
  std::size_t stops = 0;
  for (std::size_t i = 1; i + 1 < back.motions.size(); ++i) {
    EXPECT_TRUE(back.motions[i].extruding);
    stops += back.motions[i].blendMm == 0.0;
  }
  EXPECT_EQ(stops, 2u);
}

// A flow that changes between motions which do not stop is an event on the path; an assignment
// would run ahead of the arm. At a stop it is one.
TEST_F(Rapid, flowChangesWhereItsMotionBegins) {
  appendRandom(8, 1500);
  const plan::Program program = writeProgram("rapid", input());
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  std::vector<std::string> lines;
  std::istringstream text(program.files[0].text);
  for (std::string line; std::getline(text, line);)
    lines.push_back(line);
  std::size_t events = 0;
  for (std::size_t m = 1; m < back.motions.size(); ++m) {
    bool assigned = false, event = false;
    for (std::size_t l = back.motions[m - 1].line; l + 1 < back.motions[m].line; ++l) {
      assigned = assigned || lines[l].find("SetAO") != std::string::npos ||
                 lines[l].find("SetDO") != std::string::npos;
      event =
          event || lines[l].find("TriggEquip tFlow,0\\Start,0\\AOp:=aoFlow,") != std::string::npos;
    }
    EXPECT_FALSE(back.motions[m - 1].blendMm > 0.0 ? assigned : event) << back.motions[m].line;
    const bool trigg = lines[back.motions[m].line - 1].find("TriggL ") != std::string::npos;
    EXPECT_EQ(trigg, event);
    events += event;
  }
  EXPECT_GT(events, 500u);
}

TEST(RapidReader, readsTheFlowOfATriggL) {
  const std::string pose = "[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
  const auto with = [&](const std::string& body) {
    return read(module("SetDO doExtruder,1;\n" + body));
  };
  std::string text = module("SetDO doExtruder,1;\nTriggEquip t2, 0\\Start, 0 \\AOp:=aoFlow, 0.25;\n"
                            "TriggL " +
                            pose + ",v100,t2,fine,t1\\WObj:=w1;\n");
  text.insert(text.find("PROC"), "VAR triggdata t2;\r\n");
  const auto program = read(text);
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 1u);
  EXPECT_FALSE(program.motions[0].jointInterpolated);
  EXPECT_EQ(program.motions[0].flowMm3PerS, 10.0);
  const auto bad = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return read(changed);
  };
  expectDefect(bad("t2, 0\\Start", "t2, 1\\Start"), 10, "start of a motion");
  expectDefect(bad("0 \\AOp", "0.1 \\AOp"), 10, "start of a motion");
  expectDefect(bad(":=aoFlow", ":=aoFan"), 10, "start of a motion");
  expectDefect(bad("aoFlow, 0.25", "aoFlow, 1.25"), 10, "0..1");
  expectDefect(bad("VAR triggdata t2;", "VAR triggdata t3;"), 10, "not declared");
  expectDefect(with("TriggL " + pose + ",v100,t2,fine,t1;\n"), 9, "not declared");
}

// confdata's eight branches: wrist's centre before or behind axis 1 and the lower arm, axis 5.
TEST_F(Rapid, targetsStateTheBranchOfTheArm) {
  useMovingNozzle("irb1200");
  const double d = base::kPi / 180.0;
  const struct {
    double q2, q3, q5;
    int cfx;
  } cases[] = {{0, 0, 60, 0},   {0, 0, -60, 1},   {90, -170, 60, 2}, {90, -170, -60, 3},
               {-90, 0, 60, 4}, {-90, 0, -60, 5}, {0, -180, 60, 6},  {0, -180, -60, 7}};
  for (const auto& c : cases) {
    trajectory_ = {};
    append(plan::MoveKind::Joint, {0, c.q2 * d, c.q3 * d, 0, c.q5 * d, 0}, 0.0, 0.0);
    append(plan::MoveKind::Linear, {0.001, c.q2 * d, c.q3 * d, 0.001, c.q5 * d, 0.001}, 0.1, 0.0);
    const std::string text = writeProgram("rapid", input()).files[0].text;
    EXPECT_NE(text.find(",[0,0,0," + std::to_string(c.cfx) + "],"), std::string::npos)
        << c.cfx << "\n"
        << text;
  }
}

TEST_F(Rapid, modulesComeWithTheSignalsThatTheyUse) {
  appendRandom(9, 12100);
  ProgramInput in = input();
  in.options = {.motionsPerFile = 3000, .own = {{"rapidModules", std::string("modx")}}};
  const plan::Program program = writeProgram("rapid", in);
  ASSERT_EQ(program.files.size(), 8u); // main, five parts, the signals, the list
  EXPECT_EQ(program.files[2].name, "part_1_2.modx");
  EXPECT_NE(program.files[0].text.find("\\File:=\"part_1_2.modx\";"), std::string::npos);
  EXPECT_NE(program.files[7].text.find("<Module>part_1.modx</Module>"), std::string::npos);
  EXPECT_EQ(program.files[6].name, "part_1_EIO.cfg");
  for (const char* signal : {"-Name \"doExtruder\" -SignalType \"DO\"",
                             "-Name \"aoFlow\" -SignalType \"AO\" -MaxLog 1 "})
    EXPECT_NE(program.files[6].text.find(signal), std::string::npos);
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  expectTargets(back);
  // Modules are cut after the lift: while the next one loads the nozzle is clear of the part.
  for (std::size_t m = 1; m < back.motions.size(); ++m)
    EXPECT_TRUE(back.motions[m].file == back.motions[m - 1].file ||
                trajectory_.move[m - 1] != plan::MoveKind::Print);
}

TEST_F(Rapid, namesKeepClearOfTheLanguage) {
  appendRandom(2, 50);
  for (const char* name :
       {"test", "main", "z10", "MODULE", "a-very-long-name-of-a-part-with-a-tail"}) {
    ProgramInput in = input();
    in.name = name;
    const plan::Program program = writeProgram("rapid", in);
    expectSound(readProgram("rapid", program.files, process::Tooling(process_)));
    const std::string& text = program.files[0].text;
    const std::string module = text.substr(7, text.find('\r') - 7);
    EXPECT_TRUE(module.starts_with("print_"));
    EXPECT_LE(module.size(), 32u);
  }
}

// A module whose work object turns with the unit rod; the body begins in line 8.
std::string rodModule(const std::string& body, const std::string& object = "FALSE,\"rod\"") {
  std::string text = module(body);
  const auto put = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  put("[FALSE,TRUE,\"\",[[400,0,0],[1,0,0,0]],[[0,0,10],[1,0,0,0]]]",
      "[FALSE," + object + ",[[7,7,7],[1,0,0,0]],[[0,0,10],[0.5,-0.5,-0.5,-0.5]]]");
  put("ConfJ\\Off;", "ConfJ\\Off; ActUnit Rod;");
  return text;
}
constexpr const char* kRodMove =
    "MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[-720.1125,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1\\WObj:=w1;\n";

TEST(RapidReader, placesTargetsInTheWorkFrameThatTheRodTurns) {
  const auto program = read(rodModule(
      std::string("MoveAbsJ [[0,0,0,0,90,0],[360,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1\\WObj:=w1;\n") +
      kRodMove));
  expectSound(program);
  ASSERT_EQ(program.motions.size(), 2u);
  EXPECT_EQ(program.motions[0].joints.size(), 7u);
  EXPECT_NEAR(program.motions[0].joints[6], 2.0 * base::kPi, 1e-12);
  const plan::ProgramMotion& m = program.motions[1];
  EXPECT_EQ(m.target, plan::TargetKind::UnitPose);
  ASSERT_EQ(m.externals.size(), 1u);
  EXPECT_NEAR(m.externals[0], -base::degreesToRadians(720.1125), 1e-12);
  // The object is 10 mm along the unit's axis, its z, which is the work frame's x; its axes are the
  // work frame's. The user frame of the text has no effect.
  EXPECT_LE((m.frame_T_tcp.translation() - Eigen::Vector3d(2, 3, 11)).norm(), 1e-12);
  EXPECT_TRUE(
      (m.frame_T_tcp.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(
      (m.frame_T_tcp.linear() * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitY()));
}

TEST(RapidReader, namesStatementsOfARodThatItCannotRead) {
  const struct {
    std::string text;
    std::size_t line;
    const char* part;
  } cases[] = {
      {rodModule(kMove), 8, "eax_a is missing"},
      {rodModule("MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[0,9E9,0,9E9,9E9,9E9]],v100,fine,t1"
                 "\\WObj:=w1;\n"),
       8, "after an unused one"},
      {rodModule("MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[2E7,9E9,9E9,9E9,9E9,9E9]],v100,fine,t1"
                 "\\WObj:=w1;\n"),
       8, "limit"},
      {rodModule("DeactUnit ROD;\n" + std::string(kRodMove)), 9, "'rod' is not active"},
      {rodModule(kRodMove, "FALSE,\"table\""), 8, "'table' is not active"},
      {rodModule(kRodMove, "FALSE,\"\""), 3, "mechanical unit"},
      {rodModule(kRodMove, "TRUE,\"rod\""), 3, "mechanical unit"},
      {module(kRodMove), 8, "moves no work object"},
      {rodModule("ActUnit;\n"), 8, "not understood"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.text);
    expectDefect(read(c.text), c.line, c.part);
  }
}

TEST(RapidReader, turnsTheRodWithinItsSpeedLimit) {
  const std::string turned =
      "MoveL [[1,2,4],[1,0,0,0],[0,0,0,0],[-360.1125,9E9,9E9,9E9,9E9,9E9]],[1,500,5000,90],fine,"
      "t1\\WObj:=w1;\n";
  const auto program = read(rodModule(kRodMove + turned));
  expectSound(program);
  EXPECT_NEAR(program.motions[1].durationS, 4.0, 1e-9); // a turn; the way takes 1 s
}

TEST_F(Rapid, onARodPositionsAreThePartsAndTheRodIsAnExternalAxis) {
  useRod();
  const double d = base::kPi / 180.0;
  // The nozzle 159.1 mm over the rod's axis and 49 mm before it, pointing down.
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 90 * d, 0, 0}, 0.0, 0.0);
  append(plan::MoveKind::Linear, {0, 0, 0, 0, 90 * d, 0, -90 * d}, 0.5, 0.0);
  append(plan::MoveKind::Linear, {0, 0, 0, 0, 90 * d, 0, -90.1125 * d}, 0.005, 0.0);
  const plan::Program program = writeProgram("rapid", input());
  EXPECT_FALSE(program.foreign);
  const std::string& text = program.files[0].text;
  for (const char* line :
       {"  ! the rod is the mechanical unit rod, its angle eax_a, its frame "
        "[[400,0,350],[0,0,0.707106781,0.707106781]] in world, the base while the base frame is "
        "zero\r\n",
        "  PERS wobjdata wRod:=[FALSE,FALSE,\"rod\",[[0,0,0],[1,0,0,0]],[[0,0,0],"
        "[0.5,-0.5,-0.5,-0.5]]];\r\n",
        "    ActUnit rod;\r\n",
        "    MoveAbsJ [[0,0,0,0,90,0],[0,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,[50,20,5000,1000],fine,"
        "tNozzle\\WObj:=wRod;\r\n",
        // A quarter turn carries (49, 159.1) to (-159.1, 49).
        "    MoveL [[0,-159.1,49],[0.5,-0.5,-0.5,-0.5],[0,0,0,0],[-90,9E9,9E9,9E9,9E9,9E9]],"
        "[470.8614,500,5000,1000],[FALSE,0.085,0.085,0.085,1,1,1],tNozzle\\WObj:=wRod;\r\n",
        ",[-90.1125,9E9,9E9,9E9,9E9,9E9]],"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST_F(Rapid, aRodsProgramIsReadBack) {
  useRod();
  appendRandomOnRod(31, 12100);
  const plan::Program program = writeProgram("rapid", input());
  ASSERT_EQ(program.files.size(), 6u);
  for (const plan::ProgramFile& file : program.files)
    for (std::size_t i = 0; i < file.text.size(); ++i) {
      ASSERT_EQ(file.text[i] == '\r', i + 1 < file.text.size() && file.text[i + 1] == '\n');
      ASSERT_TRUE(file.text[i] != '\n' || file.text[i - 1] == '\r');
    }
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  expectSound(back);
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  double worst = 0.0;
  for (std::size_t i = 0; i < back.motions.size(); ++i) {
    const plan::ProgramMotion& m = back.motions[i];
    const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), 7);
    ASSERT_EQ(m.jointInterpolated, trajectory_.move[i] == plan::MoveKind::Joint);
    if (m.target == plan::TargetKind::Joints) {
      ASSERT_LE((Eigen::Map<const Eigen::VectorXd>(m.joints.data(), 7) - q).cwiseAbs().maxCoeff(),
                1e-8);
      continue;
    }
    ASSERT_EQ(m.target, plan::TargetKind::UnitPose);
    ASSERT_NEAR(m.externals.at(0), q[6], 1e-9); // whole steps have four decimals
    const Eigen::Isometry3d planned = cell_->work_T_unit().inverse() * cell_->work_T_tool(q);
    ASSERT_LE((m.frame_T_tcp.translation() - planned.translation()).norm(), 1e-3);
    ASSERT_LE(Eigen::AngleAxisd(planned.linear().transpose() * m.frame_T_tcp.linear()).angle(),
              1e-5);
    if (trajectory_.move[i] != plan::MoveKind::Print)
      continue;
    const double s =
        m.durationS > 0.0
            ? m.durationS
            : (m.frame_T_tcp.translation() - back.motions[i - 1].frame_T_tcp.translation()).norm() /
                  m.speedMmPerS;
    const double volume = trajectory_.extrudedMm3[i] - trajectory_.extrudedMm3[i - 1];
    ASSERT_NEAR(m.flowMm3PerS * s, volume, 1e-3 * volume) << "point " << i;
    worst = std::max(worst, std::abs(m.externals[0]));
  }
  EXPECT_GT(worst, 40.0 * 2.0 * base::kPi);
}

} // namespace
} // namespace voluta::program
