// Invariants of every row of the registry: programs are read back as written.
#include "read_programs.h"

#include "base/error.h"
#include "program/common/language_words.h"
#include "program/common/tcp_motions.h"
#include "program/common/text_files.h"
#include "program/dialect.h"
#include "program/gcode/extruder_axis.h"
#include "program/job_head.h"
#include "program/text_damage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <numbers>
#include <set>
#include <sstream>

namespace voluta::program {
namespace {

class Dialects : public test::ReadPrograms {};

// A dialect with straight motions only writes joint motions in pieces, which lead to their points.
TEST_F(Dialects, writeJointMotionsInPiecesWithoutWordsForThem) {
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, 0, 0);
  append(plan::MoveKind::Joint, {1.1, -1.5, 1.5, -1.4, -1.0, 0.9}, 2, 0);
  append(plan::MoveKind::Linear, {1.1001, -1.5, 1.5, -1.4, -1.0, 0.9}, 0.1, 0);
  append(plan::MoveKind::Print, {1.11, -1.5, 1.5, -1.4, -1.0, 0.9}, 0.1, 1.0);
  const auto poseAt = [&](double t) {
    const Eigen::Map<const Eigen::VectorXd> a(trajectory_.at(0), 6), b(trajectory_.at(1), 6);
    return cell_->work_T_tool(robot::JointVector(a + t * (b - a)));
  };
  for (const Dialect& d : dialects()) {
    SCOPED_TRACE(d.id);
    if (!d.tiltsNozzle || (d.needsJoints && isForeign(d, *cell_))) {
      EXPECT_THROW(writeProgram(d.id, input()), base::Error);
      continue;
    }
    const plan::ReadProgram back =
        readProgram(d.id, writeProgram(d.id, input()).files, process::Tooling(process_));
    if (d.saysJointMotions) {
      EXPECT_EQ(back.motions.size(), 4u);
      continue;
    }
    ASSERT_GT(back.motions.size(), 12u);
    EXPECT_LT(back.motions.size(), 200u);
    if (!back.motions[1].viaPoints.empty())
      continue; // pieces of pieces: table_test.cpp
    const std::size_t pieces = back.motions.size() - 3;
    double seconds = 0.0;
    for (std::size_t i = 1; i <= pieces; ++i) {
      const plan::ProgramMotion& m = back.motions[i];
      const Eigen::Isometry3d pose = poseAt(static_cast<double>(i) / static_cast<double>(pieces));
      EXPECT_LT((m.position - pose.translation()).norm(), 1e-3);
      EXPECT_LT((m.direction + pose.linear().col(2)).norm(), 1e-5);
      EXPECT_FALSE(m.extruding);
      // Half way between two of them the straight line is close to the way by joints.
      const Eigen::Isometry3d half =
          poseAt((static_cast<double>(i) - 0.5) / static_cast<double>(pieces));
      const Eigen::Vector3d middle = 0.5 * (m.position + back.motions[i - 1].position);
      const Eigen::Vector3d path = (m.position - back.motions[i - 1].position).normalized();
      const Eigen::Vector3d off = half.translation() - middle;
      EXPECT_LT((off - off.dot(path) * path).norm(), 0.21);
      seconds += (m.position - back.motions[i - 1].position).norm() / m.speedMmPerS;
    }
    EXPECT_NEAR(seconds, 2.0, 1e-2);
  }
}

// Files of several dialects are in one folder; two makers may use the same file extension.
TEST_F(Dialects, haveNamesOfTheirOwn) {
  std::set<std::string_view> ids;
  std::set<std::string> files;
  for (const Dialect& d : dialects()) {
    randomFor(d, 4, 100);
    EXPECT_TRUE(ids.insert(d.id).second);
    for (const plan::ProgramFile& file : writeProgram(d.id, input()).files) {
      EXPECT_TRUE(files.insert(file.name).second) << file.name;
    }
    EXPECT_FALSE(d.label.empty());
    EXPECT_EQ(&findDialect(d.id), &d);
  }
  EXPECT_TRUE(ids.count("urscript") && ids.count("gcode-extended") && ids.count("rapid") &&
              ids.count("csv"));
}

TEST_F(Dialects, unknownOneNamesTheNearest) {
  try {
    findDialect("urscipt");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("urscript"), std::string::npos);
  }
}

TEST_F(Dialects, readBackEveryTarget) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    for (const Dialect& d : dialects()) {
      SCOPED_TRACE(d.id);
      randomFor(d, seed, 2000);
      const plan::Program program = writeProgram(d.id, input());
      EXPECT_EQ(program.format, d.id);
      EXPECT_EQ(program.foreign, isForeign(d, *cell_));
      EXPECT_EQ(std::count_if(program.files.begin(), program.files.end(),
                              [&](const auto& f) { return f.name.ends_with(d.extension); }),
                1);
      EXPECT_TRUE(program.files[0].name.ends_with(d.extension));
      plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process_));
      EXPECT_EQ(back.format, d.id);
      EXPECT_TRUE(back.complete);
      for (const plan::ProgramDefect& defect : back.defects)
        ADD_FAILURE() << defect.line << ": " << voluta::base::english(defect.reason);
      dropPieces(back);
      ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
      for (std::size_t i = 0; i < back.motions.size(); ++i)
        expectTarget(back, i);
    }
  }
}

TEST_F(Dialects, thatAreForAnyCellTurnItsRod) {
  for (const Dialect& d : dialects())
    EXPECT_TRUE(d.supportsExternalAxes || !d.forAnyCell) << d.id;
}

TEST_F(Dialects, readBackEveryTargetOnARod) {
  useRod();
  appendRandomOnRod(5, 2000);
  for (const Dialect& d : dialects()) {
    SCOPED_TRACE(d.id);
    if (!d.supportsExternalAxes) {
      EXPECT_THROW(writeProgram(d.id, input()), base::Error);
      continue;
    }
    plan::ReadProgram back =
        readProgram(d.id, writeProgram(d.id, input()).files, process::Tooling(process_));
    EXPECT_TRUE(back.complete);
    EXPECT_TRUE(back.defects.empty());
    dropPieces(back);
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
    for (std::size_t i = 0; i < back.motions.size(); ++i)
      expectTarget(back, i);
  }
}

TEST_F(Dialects, readBackTimeAndMaterial) {
  for (const Dialect& d : dialects()) {
    SCOPED_TRACE(d.id);
    randomFor(d, 7, 4000);
    plan::ReadProgram back =
        readProgram(d.id, writeProgram(d.id, input()).files, process::Tooling(process_));
    dropPieces(back);
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
    double total = 0.0;
    for (std::size_t i = 1; i < back.motions.size(); ++i) {
      const plan::ProgramMotion& m = back.motions[i];
      const bool print = trajectory_.move[i] == plan::MoveKind::Print;
      EXPECT_EQ(m.extruding, print) << "point " << i;
      if (trajectory_.move[i] == plan::MoveKind::Joint)
        continue; // not straight: its time depends on the interpolation
      const double s = seconds(back, i), wanted = trajectory_.timeS[i] - trajectory_.timeS[i - 1];
      EXPECT_NEAR(s, wanted, (kFlowBand + 1e-3) * wanted) << "point " << i;
      const double volume = trajectory_.extrudedMm3[i] - trajectory_.extrudedMm3[i - 1];
      const double deposited = !m.extruding         ? 0.0
                               : m.volumeMm3 >= 0.0 ? m.volumeMm3
                                                    : m.flowMm3PerS * s;
      EXPECT_NEAR(deposited, volume, 1e-3 * volume) << "point " << i;
      total += deposited;
    }
    EXPECT_NEAR(total, trajectory_.extrudedMm3.back(), 1e-4 * total);
  }
}

// A word of a language as the part's name is no word in the program.
TEST_F(Dialects, namesKeepClearOfTheirLanguage) {
  appendRandom(2, 50);
  for (const Dialect& d : dialects()) {
    if (d.isWord == nullptr)
      continue;
    EXPECT_FALSE(d.isWord("print_part_1"));
    for (const char* name : {"end", "floor", "sleep", "norm", "random", "force", "wait", "main",
                             "module", "z10", "v100", "test", "PROC", "movel", "", "1", "_",
                             "a-very-long-name-of-a-part-with-a-tail"}) {
      SCOPED_TRACE(std::string(d.id) + " " + name);
      ProgramInput in = input();
      in.name = name;
      const plan::Program program = writeProgram(d.id, in);
      const plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process_));
      EXPECT_TRUE(back.complete && back.defects.empty());
      // Definitions come after the first word, below a header if there is one.
      const std::string& text = program.files[0].text;
      const std::size_t top = text.starts_with("&") ? text.find("DEF ") : 0;
      const std::size_t at = text.find(' ', top) + 1;
      const std::string defined = text.substr(at, text.find_first_of("(\r\n", at) - at);
      EXPECT_TRUE(defined.starts_with("print_")) << defined;
      EXPECT_LE(defined.size(), 32u);
      EXPECT_FALSE(d.isWord(defined));
    }
  }
  for (const char* word : {"end", "floor", "sleep", "norm"})
    EXPECT_TRUE(isUrscriptWord(word)) << word;
  for (const char* word : {"test", "Z10", "MoveL", "main", "v100"})
    EXPECT_TRUE(isRapidWord(word)) << word;
  for (const char* unit : {"_rod", "2nd", "test", "a unit whose name is longer than it may be"}) {
    const std::string name = rapidName(unit);
    EXPECT_TRUE(std::isalpha(static_cast<unsigned char>(name.front()))) << name;
    EXPECT_TRUE(!isRapidWord(name) && name.size() <= 32) << name;
  }
  EXPECT_EQ(rapidName("rod"), "rod");
}

// Text from a file stays in its remark: a line feed in it would make code of the rest.
TEST_F(Dialects, textFromFilesNeverLeavesItsRemark) {
  for (const Dialect& d : dialects()) {
    SCOPED_TRACE(d.id);
    randomFor(d, 2, 50);
    process_.material = process::materialNamed("unknown");
    const plan::Program plain = writeProgram(d.id, input());
    const plan::ReadProgram whole = readProgram(d.id, plain.files, process::Tooling(process_));
    for (const std::string& hostile :
         {std::string("a\nmovej([0,0,0,0,0,0])\n"),
          std::string("a\r\n  MoveJ p1,v100,fine,tPlate;\r\n"),
          std::string("a\nG0 X0 Y0 Z0\nM104 S400\n"), std::string("a\"); set_tcp(p[0,0,0,0,0,0])"),
          std::string("a\0b\x1b\xff\xe2\x80\xa8", 9), std::string("a\\n; end\n# end\n"),
          std::string(5000, 'x')}) {
      process::Process process = process_;
      process.material.label = process.id = hostile;
      const ProgramInput in{plan_, trajectory_, *cell_, process::Tooling(process), hostile};
      const plan::Program program = writeProgram(d.id, in);
      const std::string& text = program.files[0].text;
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
                std::count(plain.files[0].text.begin(), plain.files[0].text.end(), '\n'))
          << text.substr(0, 1000);
      EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) {
        return c == '\n' || c == '\r' || (c >= ' ' && c <= '~');
      }));
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 255u);
      const plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process));
      EXPECT_TRUE(back.complete && back.defects.empty());
      ASSERT_EQ(back.motions.size(), whole.motions.size());
      for (std::size_t i = 0; i < back.motions.size(); ++i)
        EXPECT_TRUE(test::sameMotion(back.motions[i], whole.motions[i]));
    }
  }
}

TEST_F(Dialects, headsDescribeThePrint) {
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, 0, 0);
  append(plan::MoveKind::Joint, {0.2, -1.9, 1.5, -1.2, -1.4, 0.3}, 1, 0);
  append(plan::MoveKind::Print, {0.201, -1.9, 1.5, -1.2, -1.4, 0.3}, 0.1, 1.0);
  const std::string hash = jobHash(input());
  EXPECT_EQ(hash.size(), 16u);
  for (const Dialect& d : dialects()) {
    if (!d.tiltsNozzle)
      continue;
    useArmFor(d);
    const std::string text = writeProgram(d.id, input()).files[0].text;
    for (const std::string& said : {"part part 1, job " + jobHash(input()),
                                    std::string("cell bench, robot ") + cell_->robot().id,
                                    std::string("3 motions, 1 mm3, 0 g, 1.1 s")})
      EXPECT_NE(text.find(said), std::string::npos) << d.id << ": " << said << "\n" << text;
    if (!isForeign(d, *cell_)) {
      EXPECT_NE(text.find("joints go, degrees: 5.7 to 11.5, -108.9 to -108.9, 85.9 to 97.4, "),
                std::string::npos)
          << text;
    }
  }
  for (const Dialect& d : dialects()) {
    useArmFor(d);
    const JobHead own = jobHead(input());
    EXPECT_EQ(own, (JobHead{"part 1", jobHash(input()), "bench", cell_->robot().id, process_.id}));
    if (d.tiltsNozzle) {
      EXPECT_EQ(readJobHead(writeProgram(d.id, input()).files), own) << d.id;
    }
  }
  useArmFor(findDialect("urscript"));
  trajectory_.joints[7] += 1e-9;
  EXPECT_NE(jobHash(input()), hash);
}

TEST_F(Dialects, aPartOfAnyNameIsReadFromItsHead) {
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, 0, 0);
  for (const char* name : {"a, job b", "part part", "x, job 0123456789abcdef", "; # ! '"}) {
    ProgramInput in = input();
    in.name = name;
    for (const Dialect& d : dialects()) {
      useArmFor(d);
      EXPECT_EQ(readJobHead(writeProgram(d.id, in).files), jobHead(in)) << d.id << " " << name;
    }
  }
  EXPECT_EQ(readJobHead({{"f", "def f():\n  textmsg(\"part x, job 12\")\nend\n"}}), std::nullopt);
  EXPECT_EQ(readJobHead({}), std::nullopt);
}

TEST_F(Dialects, optionsAreOfTheirRowsAndReachNoOther) {
  const base::ParameterTable all = programParameters();
  for (const Dialect& d : dialects()) {
    randomFor(d, 3, 120);
    const std::string plain = writeProgram(d.id, input()).files[0].text;
    const auto own = optionsOf(d);
    for (const base::ParameterSpec& option : all.specs()) {
      if (option.key == extruderAxisMm().key) // of one extruder: extruder_test.cpp
        continue;
      // They choose the points that are written (pointsFor): arcs_test.cpp.
      if (option.key == programResolution().key || option.key == arcFitting().key)
        continue;
      const auto row = std::ranges::find(own, option.key, &base::ParameterSpec::key);
      const bool has = row != own.end();
      // A row may have fewer choices than the table of all.
      const std::vector<base::Choice>& choices = has ? row->choices : option.choices;
      base::ParameterValues values(all);
      values.set(option.key, option.type == base::ParameterType::Choice ? choices.back().id : "40");
      ProgramInput in = input();
      in.options = programOptions(values);
      const plan::Program program = writeProgram(d.id, in);
      const bool same = program.files[0].text == plain &&
                        program.files[0].name == writeProgram(d.id, input()).files[0].name;
      EXPECT_EQ(same, !has) << d.id << " " << option.key;
    }
    // An option that two rows have is one and the same.
    for (const base::ParameterSpec& option : optionsOf(d)) {
      EXPECT_EQ(all.find(option.key)->defaultValue, option.defaultValue) << d.id;
      EXPECT_EQ(all.find(option.key)->help.english(), option.help.english()) << d.id;
    }
  }
}

TEST(LongLines, giveOneDefectAFileAtTheFirst) {
  const std::vector<plan::ProgramFile> files = {
      {"a", "short\n0123456789a\n0123456789ab\n"},
      {"b", "! \"01234567\"\nT \"01234\", \"0123456\"\nT \"012345678"},
      {"c", "0123456789\r\n\"01234\"\n"}};
  std::vector<plan::ProgramDefect> defects;
  reportLongLines(files, {0, 0, "!"}, defects);
  EXPECT_TRUE(defects.empty());
  reportLongLines(files, {10, 0, "!"}, defects);
  ASSERT_EQ(defects.size(), 2u);
  EXPECT_EQ(defects[0].file * 100 + defects[0].line, 2u);
  EXPECT_NE(english(defects[0].reason).find("11 characters"), std::string::npos);
  EXPECT_EQ(defects[1].file * 100 + defects[1].line, 101u);
  defects.clear();
  reportLongLines(files, {0, 5, "!"}, defects);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].file * 100 + defects[0].line, 102u);
  EXPECT_NE(english(defects[0].reason).find("7 characters"), std::string::npos);
}

// Every program for a controller stops for a confirmation before its first motion, which is slow.
TEST_F(Dialects, operatorConfirmsBeforeTheFirstMotion) {
  for (const auto& [id, word] : {std::pair{"urscript", "popup("},
                                 {"rapid", "UIMsgBox "},
                                 {"gcode-extended", "M0\n"},
                                 {"gcode-bc", "M0\n"},
                                 {"gcode", "M0\n"},
                                 {"melfa", "Hlt\r\n"},
                                 {"tmscript", ",Pause(),"},
                                 {"krl", "HALT\r\n"},
                                 {"spel", "Pause\r\n"},
                                 {"urscript-stream", "popup("},
                                 {"melfa-stream", "Hlt\r\n"},
                                 {"melfa-datalink", "Hlt\r\n"},
                                 {"krl-eki", "HALT\r\n"}}) {
    randomFor(findDialect(id), 2, 50);
    const plan::Program program = writeProgram(id, input());
    const plan::ReadProgram back = readProgram(id, program.files, process::Tooling(process_));
    // For a stream the program that takes it stops.
    const auto taking = std::ranges::find_if(program.files, [](const auto& f) {
      return !f.name.ends_with(".joints") && !f.name.ends_with(".rows") &&
             !f.name.ends_with(".mxt") && !f.name.ends_with(".lines") && !f.name.ends_with(".eki");
    });
    const bool streams = taking != program.files.begin();
    const std::string& text = streams ? taking->text : program.files[0].text;
    const std::size_t at = text.find(word);
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_EQ(text.find(word, at + 1), std::string::npos);
    if (!streams) {
      EXPECT_LT(static_cast<std::size_t>(
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
                back.motions.front().line);
    }
  }
  randomFor(findDialect("urscript"), 2, 50);
  const plan::ReadProgram back =
      readProgram("urscript", writeProgram("urscript", input()).files, process::Tooling(process_));
  EXPECT_LE(back.motions.front().jointSpeedRadPerS, 0.25);
}

TEST_F(Dialects, sameInputSameBytes) {
  for (const Dialect& d : dialects()) {
    randomFor(d, 4, 300);
    const plan::Program one = writeProgram(d.id, input(), {});
    const plan::Program two = writeProgram(d.id, input(), base::RunContext(base::CancelToken(), 2));
    ASSERT_EQ(one.files.size(), two.files.size());
    EXPECT_EQ(one.files[0].text, two.files[0].text) << d.id;
  }
}

TEST_F(Dialects, areDetectedByTheirText) {
  for (const Dialect& d : dialects()) {
    randomFor(d, 4, 100);
    const plan::Program program = writeProgram(d.id, input());
    EXPECT_EQ(detectDialect("program.txt", program.files[0].text), &d);
    const Dialect* byName = detectDialect(program.files[0].name, "");
    ASSERT_NE(byName, nullptr);
    EXPECT_EQ(byName->extension, d.extension);
  }
  EXPECT_EQ(detectDialect("notes.txt", "Dear reader,\n"), nullptr);
  EXPECT_EQ(detectDialect("", ""), nullptr);
}

TEST_F(Dialects, cancelStopsWriterAndReader) {
  appendRandom(4, 100);
  base::CancelToken token;
  token.cancel();
  const base::RunContext ctx(token, 1);
  for (const Dialect& d : dialects()) {
    useArmFor(d);
    EXPECT_THROW(writeProgram(d.id, input(), ctx), base::Cancelled) << d.id;
  }
}

TEST_F(Dialects, refuseATrajectoryOfAnotherArm) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0}, 0, 0);
  for (const Dialect& d : dialects())
    EXPECT_THROW(writeProgram(d.id, input()), base::Error) << d.id;
}

// A format that is refused for a cell's axes names the others: each of them takes that cell.
TEST_F(Dialects, aRefusalForAxesNamesFormatsThatMoveThem) {
  platform::PlatformSolid plate;
  plate.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  int refused = 0;
  for (const std::string& id : robot::cellIds()) {
    const robot::Cell cell = robot::loadCell(id, process_, plate);
    for (const Dialect& d : dialects()) {
      const std::optional<base::Error> error = refusal(d, cell, {}, nullptr);
      if (!error || std::string(error->what()).find("external axes") == std::string::npos)
        continue;
      ++refused;
      SCOPED_TRACE(error->what());
      const std::string advice = base::english(error->remedy());
      int named = 0;
      for (const Dialect& other : dialects())
        if (const bool takes = !refusal(other, cell, {}, nullptr); takes) {
          ++named;
          EXPECT_NE((advice + ",").find(std::string(" ") + std::string(other.id) + ","),
                    std::string::npos)
              << other.id;
        }
      EXPECT_EQ(std::ranges::count(advice, ','), named - 1);
    }
  }
  EXPECT_GT(refused, 10);
}

TEST_F(Dialects, aForeignProgramDecidesOnlyAmongForeignOnes) {
  useRod(); // an ABB
  const std::vector<std::string> all = {"rapid", "gcode-extended", "csv"};
  EXPECT_TRUE(decidesOnPlan("rapid", all, *cell_));
  EXPECT_TRUE(decidesOnPlan("csv", all, *cell_));
  EXPECT_FALSE(decidesOnPlan("gcode-extended", all, *cell_));
  EXPECT_FALSE(decidesOnPlan("gcode-extended", {"gcode-extended", "csv"}, *cell_));
  EXPECT_TRUE(decidesOnPlan("gcode-extended", {"gcode-extended"}, *cell_));
}

// Files that are no programs: an error of one line.
TEST_F(Dialects, fileWithoutAProgramGivesAnErrorOfOneLine) {
  for (const Dialect& d : dialects()) {
    randomFor(d, 5, 60);
    const plan::Program program = writeProgram(d.id, input());
    const std::string& text = program.files[0].text;
    const auto with = [&](const std::string& changed) {
      std::vector<plan::ProgramFile> files = program.files;
      files[0].text = changed;
      return readProgram(d.id, files, process::Tooling(process_));
    };
    const std::string half = text.substr(0, text.find('\n', text.size() / 2) + 1);
    const std::string rest = text.substr(half.size());
    std::string other = rest;
    if (rest.find('\r') == std::string::npos)
      other.replace(other.find('\n'), 1, "\r\n");
    else
      other.erase(other.find('\r'), 1);
    const struct {
      std::string text;
      const char* part;
    } cases[] = {{"\xef\xbb\xbf" + text, "byte-order mark"},
                 {"\xff\xfe" + text, "byte-order mark"},
                 {half + std::string(1, '\0') + rest, "binary"},
                 {std::string("\x89PNG\r\n\x1a\n\0\0", 10), "binary"},
                 {half + other, d.id == std::string_view("rapid") ? "CR LF" : "mixed line ends"}};
    for (const auto& c : cases) {
      const plan::ReadProgram read = with(c.text);
      ASSERT_EQ(read.defects.size(), 1u) << d.id << " " << c.part;
      EXPECT_NE(voluta::base::english(read.defects[0].reason).find(c.part), std::string::npos)
          << d.id << ": " << voluta::base::english(read.defects[0].reason);
    }
    EXPECT_FALSE(with("").complete) << d.id;
  }
}

} // namespace
} // namespace voluta::program
