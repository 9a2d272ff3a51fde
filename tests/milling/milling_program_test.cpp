// The G-code of milled parts, as its reader returns it.
#include "program/gcode/gcode_milling.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace voluta::program {
namespace {

using enum plan::FactKind;

const std::string kHead = "(part)\nG21\nG90\nG94\n";

// The lines of the defects of a program that begins with kHead.
std::vector<std::size_t> defectLines(const std::string& text) {
  std::vector<std::size_t> lines;
  for (const plan::ProgramDefect& defect : readMillingGcode(kHead + text).defects)
    lines.push_back(defect.line);
  return lines;
}

TEST(MillingProgram, MotionsAndStatementsAreReadInOrder) {
  const plan::ReadProgram read =
      readMillingGcode(kHead + "G53 G0 Z0\nG0 A0\nS8500 M3 ; on\nG54 F300\nG0 X1 Y-2.5 Z3\n"
                               "N70 g1 z-1 F120\nX2 M5\nG53 G0 Z0\nG0 A180\nM30\n");
  EXPECT_TRUE(read.defects.empty());
  EXPECT_TRUE(read.complete);
  EXPECT_EQ(read.format, kMillingFormat);
  ASSERT_EQ(read.motions.size(), 3u);
  EXPECT_EQ(read.motions[0].position, Eigen::Vector3d(1, -2.5, 3));
  EXPECT_EQ(read.motions[0].speedMmPerS, 0.0) << "rapid";
  EXPECT_EQ(read.motions[1].position, Eigen::Vector3d(1, -2.5, -1));
  EXPECT_EQ(read.motions[1].speedMmPerS, 2.0);
  EXPECT_EQ(read.motions[2].position, Eigen::Vector3d(2, -2.5, -1));
  EXPECT_EQ(read.motions[2].line, 11u);
  struct Expected {
    plan::FactKind kind;
    double number;
    std::size_t before;
  };
  const std::vector<Expected> expected{{Home, 1, 0},       {BlockTurned, 0, 0},  {Spindle, 0, 0},
                                       {Spindle, 8500, 0}, {TargetFrame, 54, 0}, {Spindle, 0, 3},
                                       {Home, 1, 3},       {BlockTurned, 180, 3}};
  ASSERT_EQ(read.facts.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(read.facts[i].kind, expected[i].kind) << i;
    EXPECT_EQ(read.facts[i].number, expected[i].number) << i;
    EXPECT_EQ(read.facts[i].before, expected[i].before) << i;
  }
  EXPECT_EQ(read.facts[4].word, "G54");
}

TEST(MillingProgram, WhatIsNotUnderstoodIsADefectAtItsLine) {
  const std::string start = "G54\nF100\nG0 X0 Y0 Z9\n"; // lines 5 to 7
  EXPECT_TRUE(defectLines(start + "G1 X1").empty());
  for (const char* line : {"hello",           "G2 X1 Y1 I1", "G20",        "G91",
                           "G92 X0",          "T1",          "M8",         "G1 X1 E2",
                           "G1 X1 X2",        "G1 X",        "G1 nX1",     "G0 G1 X1",
                           "G1 X1 A90",       "G53 G0 X0",   "G53 G0 Z5",  "F0",
                           "G1 X1 F-5",       "G1 X1e3 (",   "M30\nG1 X1", "G55\nG0 Z1",
                           "G53 G0 Z0\nG0 X1"}) {
    const std::vector<std::size_t> lines = defectLines(start + line);
    ASSERT_EQ(lines.size(), 1u) << line;
    EXPECT_EQ(lines[0], std::string(line).find('\n') == std::string::npos ? 8u : 9u) << line;
  }
  EXPECT_EQ(defectLines("G54\nX1 Y1 Z1"), std::vector<std::size_t>{6}) << "neither G0 nor G1";
  EXPECT_EQ(defectLines("G54\nG1 X1 Y1 Z1"), std::vector<std::size_t>{6}) << "no feed";
}

// A machine may start in inches, with relative positions or with feeds per turn.
TEST(MillingProgram, UnitsAreStatedBeforeTheFirstMotion) {
  for (const char* word : {"G21", "G90", "G94"}) {
    std::string text = kHead + "G54\nG0 X0 Y0 Z9\n";
    text.erase(text.find(word), 3);
    const plan::ReadProgram read = readMillingGcode(text);
    ASSERT_EQ(read.defects.size(), 1u) << word;
    EXPECT_EQ(read.defects[0].line, 6u);
    EXPECT_NE(base::english(read.defects[0].reason).find(word), std::string::npos);
  }
}

} // namespace
} // namespace voluta::program
