// The amounts that a firmware would extrude: modes of positions and amounts, units, arcs,
// retraction.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "program/gcode/tilting_table.h"
#include "sliced/gcode_machine.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;

namespace {

sliced::SlicedFile followed(const std::string& text) {
  return sliced::followGcode(text, "part.gcode", base::RunContext());
}

struct Totals {
  double lengthMm = 0.0, extruded = 0.0;
};
Totals totalsOf(const sliced::SlicedFile& file) {
  Totals totals;
  for (const sliced::SlicedPath& path : file.paths)
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      totals.lengthMm += (path.points[i].position - path.points[i - 1].position).norm();
      totals.extruded += path.points[i].extruded;
    }
  return totals;
}

// A square of 10 mm, 4 mm of filament, as different files state it.
struct Case {
  const char* name;
  const char* text;
};
const Case kSquares[] = {
    {"absolute", "G28\nG90\nM82\nG1 X10 Y10 Z.2 F600\nG1 X20 E1\nG1 Y20 E2\nG1 X10 E3\nG1 Y10 E4"},
    {"relative amounts",
     "G28\nM83\nG1 X10 Y10 Z.2 F600\nG1 X20 E1\nG1 Y20 E1\nG1 X10 E1\nG1 Y10 E1"},
    {"relative positions",
     "G28\nG1 X10 Y10 Z.2 F600\nG91\nG1 X10 E1\nG1 Y10 E1\nG1 X-10 E1\nG1 Y-10 E1"},
    {"shifted origin", "G28\nG1 X30 Y40 Z1.2 F600\nG92 X10 Y10 Z.2 E5\nG1 X20 E6\nG1 Y20 E7\n"
                       "G1 X10 E8\nG1 Y10 E9"},
    {"counts set back",
     "G28\nG1 X10 Y10 Z.2 F600\nG1 X20 E1\nG92 E0\nG1 Y20 E1\nG92\nG1 X10 E1\nG92 E7\nG1 Y10 E8"},
    {"inches", "G28\nG20\nG1 X.3937007874 Y.3937007874 Z.0078740157 F23.622047\n"
               "G1 X.7874015748 E.03937007874\nG1 Y.7874015748 E.07874015748\n"
               "G1 X.3937007874 E.11811023622\nG1 Y.3937007874 E.15748031496"},
    {"line numbers and checksums", "N1 G28*18\nN2 G1 X10 Y10 Z.2 F600*35\nN3 G1 X20 E1*3\n"
                                   "N4 G1 Y20 E2*4\nN5 G1 X10 E3*5\nN6 G1 Y10 E4*6"},
    {"lower case without blanks", "g28\ng1x10y10z.2f600\ng1x20e1\ng1y20e2\ng1x10e3\ng1y10e4"},
    {"retraction and hop",
     "G28\nG1 X10 Y10 Z.2 F600\nG1 X20 E1\nG1 E-1\nG1 Z2\nG1 X50\nG1 X20\nG1 Z.2\nG1 E1\n"
     "G1 Y20 E2\nG10\nG1 X0\nG1 X20\nG11\nG1 X10 E3\nG1 Y10 E4"},
    {"return while moving", "G28\nM83\nG1 X10 Y10 Z.2 F600\nG1 E-2\nG1 X20 E3\nG1 Y20 E1\n"
                            "G1 X10 E1\nG1 Y10 E1"},
    {"flow and speed", "G28\nM83\nM221 S50\nM220 S200\nG1 X10 Y10 Z.2 F300\nG1 X20 E2\nG1 Y20 E2\n"
                       "G1 X10 E2\nG1 Y10 E2"},
    {"macros and remarks", "START_PRINT BED=60\nG28\nM117 G1 X9 E9\n(a remark)\n"
                           "G1 X10 Y10 Z.2 F600 (there)\nG1 X20 E1 ; G1 X0 E9\nG1 Y20 E2\nG1 X10 "
                           "E3\nG1 Y10 E4\nM84"},
};

TEST(GcodeMachine, ASquareIsTheSameInEveryManner) {
  for (const Case& c : kSquares) {
    const sliced::SlicedFile file = followed(c.text);
    const Totals totals = totalsOf(file);
    EXPECT_NEAR(totals.lengthMm, 40.0, 1e-6) << c.name;
    EXPECT_NEAR(totals.extruded, 4.0, 1e-6) << c.name;
    ASSERT_FALSE(file.paths.empty()) << c.name;
    for (const sliced::SlicedPath& path : file.paths)
      for (const sliced::SlicedPoint& point : path.points)
        EXPECT_NEAR(point.speedMmPerS, 10.0, 1e-6) << c.name;
  }
}

TEST(GcodeMachine, ArcsHaveTheLengthOfTheirCircle) {
  // A quarter, three quarters, a whole circle, a helix; by centre and by radius.
  const struct {
    const char* move;
    double lengthMm;
  } kCases[] = {
      {"G3 X0 Y10 I-10 J0 E1", 0.5 * base::kPi * 10.0},
      {"G2 X0 Y10 I-10 J0 E1", 1.5 * base::kPi * 10.0},
      {"G3 X0 Y10 R10 E1", 0.5 * base::kPi * 10.0},
      {"G3 X0 Y10 R-10 E1", 1.5 * base::kPi * 10.0},
      {"G2 X0 Y10 R10 E1", 0.5 * base::kPi * 10.0},
      {"G2 X10 Y0 I-10 E1", 2.0 * base::kPi * 10.0},
      {"G3 X10 Y0 Z4.2 I-10 E1", std::hypot(2.0 * base::kPi * 10.0, 4.0)},
  };
  for (const auto& c : kCases) {
    const sliced::SlicedFile file = followed(std::string("G28\nG1 X10 Y0 Z.2 F600\n") + c.move);
    const Totals totals = totalsOf(file);
    EXPECT_NEAR(totals.lengthMm, c.lengthMm, 1e-3 * c.lengthMm) << c.move;
    EXPECT_NEAR(totals.extruded, 1.0, 1e-9) << c.move;
  }
}

TEST(GcodeMachine, VolumesAndStartCodeAreKeptApart) {
  EXPECT_TRUE(followed("M200 D1.75\nG28\nG1 X9 F600\nG1 X10 E1").volumetric);
  const sliced::SlicedFile file =
      followed("G28\nG1 Z.3 F600\nG1 Y100 E15\nG92 E0\n;LAYER:0\n;TYPE:SKIN\nG1 E1\nG1 X5 E2\n");
  EXPECT_NEAR(file.inStartCode, 15.0, 1e-9);
  EXPECT_NEAR(file.atRest, 1.0, 1e-9);
  EXPECT_NEAR(totalsOf(file).extruded, 1.0, 1e-9);
}

TEST(GcodeMachine, DirectionsOfExtendedFilesAreKept) {
  const sliced::SlicedFile file =
      followed("G28\nG1 X0 Y0 Z1 nX0 nY0 nZ1 F600\nG1 X10 nX0 nY0.6 nZ0.8 E1");
  ASSERT_EQ(file.paths.size(), 1u);
  EXPECT_LT((file.paths[0].points[1].direction - Vector3d(0.0, 0.6, 0.8)).norm(), 1e-9);
}

std::string refusal(const std::string& text) {
  try {
    followed(text);
  } catch (const base::Error& e) {
    EXPECT_NE(e.code(), base::ErrorCode::Internal) << e.what();
    return e.what();
  }
  return "";
}

TEST(GcodeMachine, BadLinesAreRefusedWithTheirPlaceAndHelp) {
  const struct {
    const char* text;
    const char* says;
  } kCases[] = {
      {"G28\nG1 X1O F600", "part.gcode, line 2: the letter O has no number (the file may be"},
      {"G28\nG1 X1,5 F600", "line 2: not understood: 'G1 X1,5 F600' (the file may be"},
      {"G28\nG1 X1 X2 F6", "line 2: not understood"},
      {"G28\nG1 X1 E1 F0", "line 2: a speed that is not positive (give F in mm per minute)"},
      {"G1 X5 E1 F60", "line 1: a bead from an unknown position (home the axes (G28)"},
      {"G28\nG2 X5 E1 F60", "line 2: an arc that does not pass through its ends (give its centre"},
      {"G28\nG2 X5 R1 E1 F60", "line 2: an arc that does not"},
      {"G28\nG3 X5 Y5 I1 J0 E1 F60", "line 2: an arc that does not"},
      {"G28\nG1 X9999999 F60", "line 2: a position more than a kilometre away"},
      {"G28\nG18", "line 2: G18 is not understood (export straight lines"},
      {"G28\nG5 X1 Y1", "line 2: G5 is not understood"},
      {"G28\nG1 X1 A30 E1 F60", "line 2: a motion with a word A, U, V or W"},
      {"G28\nX10 Y10 E1", "line 2: a position without G0 or G1"},
      {"G28\nG1 X1 nX0 nY0 nZ0 E1 F60", "line 2: a direction of length 0"},
  };
  for (const auto& c : kCases)
    EXPECT_NE(refusal(c.text).find(c.says), std::string::npos) << c.text << ": " << refusal(c.text);
}

// Random beads on a table that tilts and turns come back as points and directions on the part.
TEST(GcodeMachine, ATableThatTiltsGivesDirections) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-40.0, 40.0), tilt(-1.2, 1.2), rotation(-6.0, 6.0);
  for (const double sense : {1.0, -1.0}) {
    const program::TableFrame frame{3.0, 12.5};
    std::string text = "; plate over the tilt axis, mm: X3.000 Z12.500\n";
    if (sense < 0.0)
      text += "; B and C count the tool's turn, not the part's\n";
    text += "G28\nM83\nG93\n";
    std::vector<plan::NozzlePoint> expected;
    for (int k = 0; k < 40; ++k) {
      const Eigen::Vector3d tip(at(random), at(random), std::abs(at(random)));
      const program::TablePose pose =
          program::tablePose(frame, tip, {tilt(random), rotation(random)});
      expected.push_back(program::nozzleAt(frame, pose));
      char line[160];
      std::snprintf(line, sizeof line, "G1 X%.6f Y%.6f Z%.6f B%.7f C%.7f F12%s\n", pose.axesMm.x(),
                    pose.axesMm.y(), pose.axesMm.z(),
                    sense * base::radiansToDegrees(pose.angles.tilt),
                    sense * base::radiansToDegrees(pose.angles.rotation), k > 0 ? " E1" : "");
      text += line;
    }
    const sliced::SlicedFile file = followed(text);
    ASSERT_EQ(file.paths.size(), 1u);
    std::size_t next = 0;
    for (const sliced::SlicedPoint& point : file.paths[0].points)
      if (next < expected.size() && (point.position - expected[next].position).norm() < 1e-4 &&
          (point.direction - expected[next].direction).norm() < 1e-5)
        ++next;
    EXPECT_EQ(next, expected.size()) << sense;
    EXPECT_NEAR(totalsOf(file).extruded, 39.0, 1e-9);
    // F12 under G93: a twelfth of a minute.
    EXPECT_NEAR(file.paths[0].points.back().speedMmPerS,
                (expected[39].position - expected[38].position).norm() / 5.0, 1e-3);
  }
}

TEST(GcodeMachine, ToolsAndTemperaturesAreKept) {
  const sliced::SlicedFile file = sliced::followGcode(
      "M104 S230\nM140 S65\nM104 T1 S180\nG28\nM83\nG1 X0 Y0 Z.2 F600\nG1 X2 E1\nM104 S215\n"
      "G1 X20 E9\nT1\nG1 X30 E5\nT255\nM190 R60\nT0\nG1 X40 E5\nM104 S0\nM140 S0\n",
      "part.gcode", base::RunContext());
  ASSERT_EQ(file.paths.size(), 3u);
  EXPECT_EQ(file.paths[0].tool, 0);
  EXPECT_EQ(file.paths[1].tool, 1);
  EXPECT_EQ(file.paths[2].tool, 0);
  EXPECT_EQ(file.nozzleC, (std::map<int, int>{{0, 215}, {1, 180}}));
  EXPECT_EQ(file.bedC, 65);
}

} // namespace
