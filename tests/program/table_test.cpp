// A table that tilts and turns below an upright nozzle: angles, ways, and programs for it.
#include "program_fixture.h"

#include "base/error.h"
#include "program/dialect.h"
#include "program/gcode/gcode_bc.h"
#include "program/gcode/tilting_table.h"
#include "program/program_defects.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace voluta::program {
namespace {

using Eigen::Vector3d;

double degrees(double rad) {
  return base::radiansToDegrees(rad);
}

std::vector<TableAngles> anglesOf(const std::vector<Vector3d>& directions, bool prints = true,
                                  std::size_t travel = static_cast<std::size_t>(-1)) {
  std::vector<TableStation> stations;
  for (const Vector3d& n : directions)
    stations.push_back({n.normalized(), 0.1, prints && stations.size() != travel});
  return tableAngles(stations);
}

Vector3d leaning(double tiltDeg, double aroundDeg) {
  const double t = base::degreesToRadians(tiltDeg), a = base::degreesToRadians(aroundDeg);
  return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
}

// The vector of docs/programs.md (G-code with B and C): B = -9.0950, C = -126.5073; and the point
// by its formulas.
TEST(Table, PoseEqualsTheExampleOfTheThesis) {
  const TableAngles a = anglesOf({Vector3d(-0.094, 0.127, 0.987)}).front();
  EXPECT_NEAR(degrees(a.tilt), -9.0950, 5e-5);
  EXPECT_NEAR(degrees(a.rotation), -126.5073, 5e-5);
  const Vector3d p(6.338, 8.390, 46.300);
  const double cB = std::cos(a.tilt), sB = std::sin(a.tilt), cC = std::cos(a.rotation),
               sC = std::sin(a.rotation);
  const Vector3d wanted(cB * cC * p.x() - cB * sC * p.y() + sB * p.z(), sC * p.x() + cC * p.y(),
                        -sB * cC * p.x() + sB * sC * p.y() + cB * p.z());
  EXPECT_LT((tablePose({}, p, a).axesMm - wanted).norm(), 1e-12);
}

TEST(Table, BringsTheNozzleBackToItsPoint) {
  for (const TableFrame& frame : {TableFrame{}, TableFrame{12.0, -35.0}})
    for (double tilt = 0.0; tilt < 179.0; tilt += 7.0)
      for (double around = -180.0; around < 180.0; around += 13.0) {
        const Vector3d n = leaning(tilt, around), p(3.0, -20.0, 17.0);
        const plan::NozzlePoint back = nozzleAt(frame, tablePose(frame, p, anglesOf({n}).front()));
        EXPECT_LT((back.position - p).norm(), 1e-10);
        EXPECT_LT((back.direction - n).norm(), 1e-10);
      }
  // Flat, the machine's axes are the part's for any place of the tilt axis.
  EXPECT_LT((tablePose({5.0, 60.0}, {1, 2, 3}, {}).axesMm - Vector3d(1, 2, 3)).norm(), 1e-12);
}

// Over the normal and down the other side: the tilt changes its sign, the turn stays.
TEST(Table, DoesNotTurnWhereItCanTiltThrough) {
  std::vector<Vector3d> over;
  for (double t = 20.0; t >= -20.0; t -= 1.0)
    over.push_back(leaning(t, 40.0));
  const auto angles = anglesOf(over);
  for (const TableAngles& a : angles) {
    EXPECT_NEAR(degrees(a.rotation), degrees(angles.front().rotation), 1e-9);
  }
  EXPECT_NEAR(degrees(angles.back().tilt), -degrees(angles.front().tilt), 1e-9);
}

// It changes to its other pair of angles only near the normal: elsewhere the nozzle would lean back
// and forth within a bead, whatever turning that would save.
TEST(Table, ChangesItsWayOnlyAboutTheNormal) {
  std::vector<Vector3d> path;
  for (double a = 0.0; a <= 175.0; a += 5.0)
    path.push_back(leaning(7.0, a));
  for (double t = 7.0; t >= -60.0; t -= 1.0)
    path.push_back(leaning(t, 175.0));
  const auto angles = anglesOf(path);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i].tilt * angles[i - 1].tilt < 0.0) {
      EXPECT_LT(std::abs(degrees(angles[i].tilt - angles[i - 1].tilt)), 3.0);
    }
  }
}

TEST(Table, CountsItsTurnsOn) {
  std::vector<Vector3d> round;
  for (double a = 0.0; a <= 1080.0; a += 5.0)
    round.push_back(leaning(30.0, a));
  const auto angles = anglesOf(round);
  for (std::size_t i = 1; i < angles.size(); ++i)
    EXPECT_NEAR(degrees(angles[i].rotation - angles[i - 1].rotation), -5.0, 1e-9);
  EXPECT_NEAR(degrees(angles.back().rotation - angles.front().rotation), -1080.0, 1e-6);
}

// Flat layers between two leaning ones, their directions off the normal by rounding at random.
TEST(Table, RestsWhereItsTurnIsFree) {
  std::vector<Vector3d> path = {leaning(20, 10)};
  for (int i = 0; i < 100; ++i)
    path.push_back(leaning(0.05, 97.0 * i));
  path.push_back(leaning(20, 70));
  // In the last travel: the motion to station 80.
  auto angles = anglesOf(path, true, 80);
  for (std::size_t i = 1; i < 101; ++i) {
    EXPECT_EQ(angles[i].tilt, 0.0);
    EXPECT_NEAR(degrees(angles[i].rotation - angles[0].rotation), i < 80 ? 0.0 : -60.0, 1e-9) << i;
  }
  // No travel: evenly.
  angles = anglesOf(path);
  double maximum = 0.0;
  for (std::size_t i = 2; i < angles.size(); ++i)
    maximum = std::max(maximum, std::abs(degrees(angles[i].rotation - angles[i - 1].rotation)));
  EXPECT_LT(maximum, 1.0);
  // Before the first and behind the last it has nowhere to go.
  angles = anglesOf({leaning(0, 0), leaning(0, 0), leaning(20, 70), leaning(0, 0)});
  for (const TableAngles& a : angles)
    EXPECT_NEAR(degrees(a.rotation), -70.0, 1e-9);
}

// A quarter turn 50 mm off the axis leaves its chord by r (1 - cos 45): the closed form.
TEST(Table, SagIsThatOfTheArc) {
  const TablePose from = tablePose({}, {50, 0, 0}, {}),
                  to = tablePose({}, {50, 0, 0}, {0.0, base::kPi / 2.0});
  // Where the machine moves straight from (50,0) to (0,50) the nozzle nears the part's axis.
  EXPECT_NEAR(sagMm({}, from, to), 50.0 * (1.0 - std::cos(base::kPi / 4.0)), 1e-6);
  for (const double maximum : {1.0, 0.05, 0.01}) {
    const int pieces = tablePieces({}, from, to, maximum);
    const auto piece = [&](int k) {
      return tablePiece({}, from, to, static_cast<double>(k) / pieces);
    };
    for (int k = 1; k <= pieces; ++k)
      EXPECT_LE(sagMm({}, piece(k - 1), piece(k)), maximum);
    EXPECT_GT(50.0 * (1.0 - std::cos(base::kPi / 4.0 / (0.5 * pieces))), maximum)
        << "no more pieces";
  }
  EXPECT_EQ(tablePieces({}, from, tablePose({}, {-50, 3, 9}, {}), 1e-6), 1) << "it stands";
}

TEST(Table, TheWayOnThePartIsTheMachinesLine) {
  const TableFrame frame{4.0, 20.0};
  const TablePose from = tablePose(frame, {20, 5, 9}, {0.2, 0.3}),
                  to = tablePose(frame, {24, 1, 11}, {-0.3, 1.7});
  const auto onTable = pathOnPart(frame, from, to);
  ASSERT_GT(onTable.size(), 10u);
  for (std::size_t k = 0; k < onTable.size(); ++k) {
    const double share = static_cast<double>(k + 1) / static_cast<double>(onTable.size() + 1);
    // Back on the machine it is on the line between the two.
    const TableAngles a{from.angles.tilt + share * (to.angles.tilt - from.angles.tilt),
                        from.angles.rotation + share * (to.angles.rotation - from.angles.rotation)};
    const Vector3d axes = tablePose(frame, onTable[k].position, a).axesMm;
    EXPECT_LT((axes - (from.axesMm + share * (to.axesMm - from.axesMm))).norm(), 1e-9);
  }
  EXPECT_TRUE(pathOnPart(frame, from, tablePose(frame, {0, 0, 0}, from.angles)).empty());
}

class TablePrograms : public test::Programs {};

// The part is the same for every table; and between its points the nozzle stays on its line.
TEST_F(TablePrograms, NeverLeaveTheLineOnThePart) {
  appendRandom(6, 400);
  for (const bool reversed : {false, true}) {
    ProgramInput in = input();
    in.options.own["tableXMm"] = reversed ? -20.0 : 0.0;
    in.options.own["tableZMm"] = reversed ? 75.0 : 0.0;
    in.options.own["tableSense"] = std::string(reversed ? "tool" : "part");
    const plan::ReadProgram back =
        readProgram("gcode-bc", writeProgram("gcode-bc", in).files, process::Tooling(process_));
    for (const auto& d : back.defects)
      ADD_FAILURE() << d.line << ": " << base::english(d.reason);
    ASSERT_TRUE(back.complete);
    std::size_t m = 0;
    const auto planned = [&](std::size_t i) {
      return cell_->work_T_tool(Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), 6));
    };
    for (std::size_t i = 1; i < trajectory_.pointCount(); ++i) {
      const Vector3d a = planned(i - 1).translation(), b = planned(i).translation();
      double seconds = 0.0, volume = 0.0, off = 0.0;
      do {
        ++m;
        ASSERT_LT(m, back.motions.size());
        seconds += back.motions[m].durationS;
        volume += back.motions[m].volumeMm3;
        const auto look = [&](const Vector3d& p) {
          const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
          off = std::max(off, (a + t * (b - a) - p).norm());
        };
        for (const plan::NozzlePoint& p : back.motions[m].viaPoints)
          look(p.position);
        look(back.motions[m].position);
      } while ((back.motions[m].position - b).norm() > 1e-3);
      EXPECT_LT((back.motions[m].direction + planned(i).linear().col(2)).norm(), 1e-5);
      EXPECT_NEAR(seconds, trajectory_.timeS[i] - trajectory_.timeS[i - 1], 1e-5);
      EXPECT_NEAR(volume, trajectory_.extrudedMm3[i] - trajectory_.extrudedMm3[i - 1], 1e-3);
      if (trajectory_.move[i] != plan::MoveKind::Joint) {
        EXPECT_LT(off, kSagMm + 1e-3) << "point " << i;
      }
    }
    EXPECT_EQ(m + 1, back.motions.size());
  }
}

// C's count is set back where nothing is printed, the table keeps its pose: read back, each motion
// is the same as without, to the rounding of C.
TEST_F(TablePrograms, CountIsSetBackInTravels) {
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.0}, 1.0, 0.0);
  for (int i = 1; i < 900; ++i)
    append(i % 40 < 2 ? plan::MoveKind::Linear : plan::MoveKind::Print,
           {0.1, -1.9, 1.7, -1.2, -1.4, 0.05 * i}, 0.1, i % 40 < 2 ? 0.0 : 0.3);
  for (const char* sense : {"part", "tool"}) {
    ProgramInput in = input();
    in.options.own["tableSense"] = std::string(sense);
    in.options.own["tableUnwind"] = std::string("count");
    in.options.own["tableTurns"] = 1000.0; // it counts on
    const plan::ReadProgram on =
        readProgram("gcode-bc", writeProgram("gcode-bc", in).files, process::Tooling(process_));
    in.options.own["tableTurns"] = 1.0;
    const plan::Program program = writeProgram("gcode-bc", in);
    const plan::ReadProgram back =
        readProgram("gcode-bc", program.files, process::Tooling(process_));
    EXPECT_TRUE(back.complete && back.defects.empty());
    ASSERT_EQ(back.motions.size(), on.motions.size());
    for (std::size_t m = 0; m < on.motions.size(); ++m) {
      EXPECT_LT((back.motions[m].position - on.motions[m].position).norm(), 2e-4);
      EXPECT_LT((back.motions[m].direction - on.motions[m].direction).norm(), 1e-6);
      EXPECT_EQ(back.motions[m].viaPoints.size(), on.motions[m].viaPoints.size());
      EXPECT_EQ(back.motions[m].durationS, on.motions[m].durationS);
    }
    std::vector<std::string> lines;
    std::istringstream text(program.files[0].text);
    for (std::string line; std::getline(text, line);)
      lines.push_back(line);
    std::size_t counts = 0;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      if (const std::size_t at = lines[l].find(" C"); lines[l].starts_with("G1 X")) {
        // A turn, and the turn that a bead of 38 points adds.
        EXPECT_LT(std::abs(std::stod(lines[l].substr(at + 2))), 360.0 + 42.0 * 3.0);
      }
      if (!lines[l].starts_with("G92 C"))
        continue;
      ++counts;
      EXPECT_LE(std::abs(std::stod(lines[l].substr(5))), 180.0 + 1e-9);
      // Without it the table would turn back, and by another number it is another place.
      for (const std::string& harm :
           {std::string(), "G92 C" + std::to_string(std::stod(lines[l].substr(5)) + 1.0),
            "G92 C0 ;" + lines[l]}) {
        std::string damaged;
        for (std::size_t k = 0; k < lines.size(); ++k)
          damaged += (k == l ? harm : lines[k]) + "\n";
        const plan::ReadProgram seen =
            readProgram("gcode-bc", {{program.files[0].name, damaged}}, process::Tooling(process_));
        bool same = seen.defects.empty() && seen.motions.size() == back.motions.size();
        for (std::size_t m = 0; same && m < back.motions.size(); ++m)
          same = seen.motions[m].viaPoints.size() == back.motions[m].viaPoints.size();
        EXPECT_FALSE(same) << lines[l] << " -> " << harm;
      }
    }
    EXPECT_GE(counts, 5u);
  }
}

plan::ReadProgram readTable(const std::string& text) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram("gcode-bc", {{"file", text}}, process::Tooling(process));
}

TEST(TableReader, TimesByTheMode) {
  const auto back = readTable("G90\nM82\nG92 E0\nG94\nG1 Z50 F600\nG1 B0 C0 F600\n"
                              "G1 X0 Y0 Z1 F600\nG1 X3 Y4 F300\nG1 C30\nG93\nG1 X0 F120 E1\n"
                              "G94\nM104 S0\nM84\n; end\n");
  EXPECT_TRUE(back.complete && back.defects.empty());
  ASSERT_EQ(back.motions.size(), 4u);
  EXPECT_DOUBLE_EQ(back.motions[1].durationS, 1.0); // 5 mm at 5 mm/s
  EXPECT_DOUBLE_EQ(back.motions[2].durationS, 6.0); // 30 degrees at 5 degrees/s
  EXPECT_DOUBLE_EQ(back.motions[3].durationS, 0.5);
  EXPECT_TRUE(back.motions[3].extruding);
  // The part has turned by 30 degrees below the nozzle, which remains at 3, 4.
  const double c = std::cos(base::kPi / 6), s = std::sin(base::kPi / 6);
  EXPECT_LT((back.motions[2].position - Vector3d(3 * c + 4 * s, -3 * s + 4 * c, 1)).norm(), 1e-12);
}

TEST(TableReader, NamesWordsThatItCannotRead) {
  const std::string head = "G1 Z50 F600\nG1 B0 C0 F600\nG93\nG1 X0 Y0 Z1 F60\n";
  const struct {
    const char *line, *part;
  } cases[] = {{"G1 X1\n", "without F"},      {"G0 X1 F60\n", "G0 under G93"},
               {"G92 C10\n", "origin"},       {"G1 X1 A5 F60\n", "word A"},
               {"G43.4 H1\n", "unknown G"},   {"G95\n", "unknown G"},
               {"G94\nG1 X1\n", "any speed"}, {"; plate over the tilt axis, mm: X Z\n", "tilt"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    const auto back = readTable(head + c.line + "M104 S0\nM84\n; end\n");
    ASSERT_FALSE(back.defects.empty());
    EXPECT_NE(base::english(back.defects.front().reason).find(c.part), std::string::npos)
        << base::english(back.defects.front().reason);
  }
  EXPECT_FALSE(readTable("G1 B0 C0 F600\n").defects.empty());
  EXPECT_FALSE(readTable("G1 Z9 F600\nG1 X0 Y0\nM104 S0\nM84\n; end\n").defects.empty());
}

// As PrusaSlicer writes them, shortened.
TEST(PlainReader, TakesSlicersPrograms) {
  const std::string text = R"(; generated by PrusaSlicer 2.7.0 on 2024-01-01

;TYPE:Custom
M862.3 P "MK3S" ; printer model check
G90 ; use absolute coordinates
M83 ; extruder relative mode
M104 S215 ; set extruder temp
M140 S60 ; set bed temp
M190 S60
M109 S215
G28 W ; home all without mesh bed level
G80
M204 P800 R1250 T1250
G1 Z0.2 F720
G1 Y-3 F1000 ; go outside print area
G92 E0
G1 X60 E9 F1000 ; intro line
M107
;LAYER_CHANGE
;Z:0.2
G1 E-.8 F2100
G1 Z.4 F7800
G1 X101.5 Y90.25
G1 Z.2
G1 E.8 F1500
;TYPE:External perimeter
;WIDTH:0.45
G1 F1200
G1 X110 Y90.25 E.34
M106 S85.2
G1 X110 Y100 E.41
G1 F4800
G1 X108 Y100 E-.76
G92 E0
M104 S0
M140 S0
M107
M84
; prusaslicer_config = begin
; prusaslicer_config = end
)";
  EXPECT_EQ(detectDialect("part.gcode", text)->id, "gcode");
  process::Process process;
  process.material = process::Material();
  const auto back = readProgram("gcode", {{"file", text}}, process::Tooling(process));
  for (const auto& d : back.defects)
    ADD_FAILURE() << d.line << ": " << base::english(d.reason);
  EXPECT_TRUE(back.complete);
  EXPECT_FALSE(back.tellsDirections);
  ASSERT_EQ(back.motions.size(), 7u);
  const double area = base::kPi / 4 * 1.75 * 1.75;
  EXPECT_EQ(back.motions[0].position, Vector3d(60, -3, 0.2));
  EXPECT_NEAR(back.motions[0].volumeMm3, 9 * area, 1e-12);
  EXPECT_FALSE(back.motions[1].extruding || back.motions[2].extruding || back.motions[3].extruding);
  EXPECT_EQ(back.motions[3].position, Vector3d(101.5, 90.25, 0.2));
  EXPECT_NEAR(back.motions[4].volumeMm3, 0.34 * area, 1e-12); // retracted filament is not counted
  EXPECT_DOUBLE_EQ(back.motions[4].speedMmPerS, 20.0);
  EXPECT_NEAR(back.motions[5].volumeMm3, 0.41 * area, 1e-12);
  EXPECT_FALSE(back.motions[6].extruding);
  for (const char* word : {"M600\n", "M221 S95\n", "G2 X1 Y1 I3 E1\n", "G1 X1 B3\n"}) {
    std::string other = text;
    const std::size_t at = other.find("M106");
    other.insert(at, word);
    const auto refused = readProgram("gcode", {{"file", other}}, process::Tooling(process));
    ASSERT_FALSE(refused.defects.empty()) << word;
    EXPECT_EQ(refused.defects.front().line, 30u) << word;
  }
}

TEST(Kinds, OfGcodeAreDetectedByTheirMotions) {
  const auto idOf = [](const char* text) { return detectDialect("a.txt", text)->id; };
  EXPECT_EQ(idOf("G21\nG1 X1 Y2 Z3\nG1 X1 nX0 nY0 nZ1\n"), "gcode-extended");
  EXPECT_EQ(idOf("G21\nG1 X1 Y2 Z3 B5\n"), "gcode-bc");
  EXPECT_EQ(idOf("G93\nG1 X1 F60\n"), "gcode-bc");
  EXPECT_EQ(idOf("G21 ; nX B C\nG1 X1 Y2 Z3\n"), "gcode");
  EXPECT_EQ(idOf(";FLAVOR:Marlin\n;a picture\n"), "gcode");
  EXPECT_EQ(detectDialect("a.gcode", "G21\nG1 X1\n")->id, "gcode");
}

// Leaning directions are refused before anything is written, in one line that names suitable
// formats.
TEST_F(TablePrograms, PlainGcodeRefusesLeaningDirections) {
  const Dialect& plain = findDialect("gcode");
  const std::vector<Vector3d> upright = {leaning(0.05, 9)}, leans = {leaning(0, 0), leaning(1, 9)};
  EXPECT_NO_THROW(requireUpright(plain, upright));
  EXPECT_NO_THROW(requireUpright(findDialect("gcode-bc"), leans));
  appendRandom(1, 60);
  for (const auto& refuse : {std::function<void()>([&] { requireUpright(plain, leans); }),
                             std::function<void()>([&] { writeProgram("gcode", input()); })})
    try {
      refuse();
      FAIL();
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::Usage);
      EXPECT_NE(std::string(e.what()).find("cannot tilt the nozzle"), std::string::npos);
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
}

} // namespace
} // namespace voluta::program
