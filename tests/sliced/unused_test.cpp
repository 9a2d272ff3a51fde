// Words of a file that mean more than its motions: tools, volumes, stops, purge lines. Ignored
// words are named.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "sliced/gcode_machine.h"
#include "sliced/sliced_reader.h"
#include "sliced/sliced_sections.h"
#include "sliced/slicer_comments.h"
#include "sliced/stated_amount.h"

#include <array>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

using namespace voluta;
using ::testing::AllOf, ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr;

namespace {

const base::RunContext kCtx;
constexpr double kFilamentMm2 = base::kPi / 4.0 * 1.75 * 1.75;

sliced::ReadSliced readIn(const std::string& text) {
  return sliced::readSliced(text, "part.gcode", kCtx);
}
std::vector<std::string> notesOf(const std::string& text) {
  return base::english(readIn(text).notes);
}

// A square wall of 20 mm, `mm` of filament on each side.
std::string square(double x, double y, double z, double mm = 4.0) {
  return fmt::format("G0 X{0} Y{1} Z{4} F3000\nG1 X{2} E{5} F1200\nG1 Y{3} E{5}\nG1 X{0} E{5}\n"
                     "G1 Y{1} E{5}\n",
                     x, y, x + 20.0, y + 20.0, z, mm);
}

std::string layer(int number) {
  return fmt::format(";LAYER_CHANGE\n;Z:{}\n", 0.8 * (number + 1));
}

const std::string kHead = "; filament_diameter = 1.75,1.75\nG21\nG90\nM83\nG28\n";

// Two squares beside each other, each of one tool, which draws 20 mm back before the change.
std::string twoTools(const std::string& head, bool returnsFirst) {
  std::string text = kHead + head + "T0\n";
  for (int k = 0; k < 6; ++k) {
    text += layer(k);
    for (int round = 0; round < 2; ++round) {
      const int tool = (k + round) % 2;
      if (round > 0)
        text += fmt::format("G1 E-20 F2100\nT{}\n", tool) +
                (k > 0 || returnsFirst ? "G1 E20 F2100\n" : "");
      text += square(tool == 0 ? 60.0 : 110.0, 60.0, 0.8 * (k + 1));
    }
  }
  return text;
}

std::array<double, 2> volumesByTool(const plan::ToolPlan& plan) {
  std::array<double, 2> volumes{};
  for (const plan::ToolPath& path : plan.paths)
    volumes[static_cast<std::size_t>(path.tool)] += sliced::beadsMm3(plan, path);
  return volumes;
}

// What a file that is cut has up to there is read.
TEST(SlicedWords, AFileThatEndsWithinALineIsNoted) {
  std::string print = kHead;
  for (int k = 0; k < 3; ++k)
    print += layer(k) + square(60.0, 60.0, 0.8 * (k + 1));
  const std::string end = "G1 E-2 F2100\nM104 S0\nG1 Z30\nM84\n; filament used = 0.4\n";
  const auto isNoted = [](const std::string& text) {
    const std::vector<std::string> notes = notesOf(text);
    return std::ranges::any_of(notes, [](const std::string& note) {
      return note.starts_with("the file ends within line");
    });
  };
  for (const char* whole : {"", "M84", "M104 S0\n; end", "; end\n", "M104 S0\r\n"})
    EXPECT_FALSE(isNoted(print + whole)) << whole;
  EXPECT_FALSE(isNoted(print + end));
  for (const char* cut : {"G1 X70 Y63.", "G1 X70 Y63", "G0 X7", "G1", "G", "; TYPE:Wal"})
    EXPECT_TRUE(isNoted(print + cut)) << cut;
  EXPECT_TRUE(isNoted(print + "M104 S0\nG1 Z3"));
  // Wherever the last layer is cut, a reader refuses the word or notes the end.
  const std::string sound = print + end;
  for (std::size_t at = sound.rfind("G1 X"); at < print.size(); ++at) {
    if (sound[at - 1] == '\n')
      continue;
    try {
      EXPECT_TRUE(isNoted(sound.substr(0, at))) << sound.substr(at - 20, 20);
    } catch (const base::Error&) {
    }
  }
  const std::vector<std::string> notes = notesOf(print + "G1 X70 Y63.");
  EXPECT_THAT(notes, Contains(HasSubstr("within line 27")));
}

TEST(SlicedWords, FilamentOfOneToolIsNoDebtOfTheOther) {
  for (const bool returnsFirst : {false, true}) {
    const auto volumes = volumesByTool(readIn(twoTools("", returnsFirst)).plan);
    for (const double mm3 : volumes)
      EXPECT_NEAR(mm3, 6 * 16.0 * kFilamentMm2, 1e-3 * mm3);
  }
  // One nozzle: the filament that comes next finds the nozzle empty by 20 mm.
  const auto shared =
      volumesByTool(readIn(twoTools("; single_extruder_multi_material = 1\n", false)).plan);
  EXPECT_NEAR(shared[1], (6 * 16.0 - 20.0) * kFilamentMm2, 1e-2 * shared[1]);
}

TEST(SlicedWords, DiametersOfToolsDiffer) {
  const auto volumes = volumesByTool(
      readIn("; filament_diameter = 1.75,2.85\nM83\nG28\n" + layer(0) + square(0, 0, 0.8) + "T1\n" +
             square(50, 0, 0.8) + layer(1) + square(50, 0, 1.6) + "T0\n" + square(0, 0, 1.6))
          .plan);
  EXPECT_NEAR(volumes[1] / volumes[0], 2.85 * 2.85 / (1.75 * 1.75), 1e-3);
}

TEST(SlicedWords, ASettingMakesAmountsVolumes) {
  const std::string body =
      kHead + layer(0) + square(0, 0, 0.8, 12.0) + layer(1) + square(0, 0, 1.6, 12.0);
  const sliced::ReadSliced read = readIn(body + "; use_volumetric_e = 1\n");
  EXPECT_NEAR(read.volumeMm3, 96.0, 0.01);
  EXPECT_THAT(base::english(read.notes), Contains(HasSubstr("use_volumetric_e")));
  EXPECT_NEAR(readIn(body + "; use_volumetric_e = 0\n").volumeMm3, 96.0 * kFilamentMm2, 0.1);
  // The firmware's own setting has priority.
  EXPECT_NEAR(readIn("M200 D0\n" + body + "; use_volumetric_e = 1\n").volumeMm3,
              96.0 * kFilamentMm2, 0.1);
}

// A line of several commands keeps all of them, or is refused: no bead is lost.
TEST(SlicedWords, CommandsOfOneLineAreAllTaken) {
  const auto bodyWith = [](const std::string& before) {
    std::string text = kHead + layer(0) + square(0, 0, 0.8) + layer(1) + square(0, 0, 1.6);
    for (std::size_t at = text.find("G1 X"); at != std::string::npos;
         at = text.find("G1 X", at + before.size() + 1))
      text.insert(at, before);
    return text;
  };
  const double mm3 = 32.0 * kFilamentMm2;
  for (const char* before : {"", "G21 ", "T0 ", "G90 ", "M106 S255 ", "G21G90 ", "M109 T0 S200 ",
                             "G21 (mm) ", "g94 M83 "})
    EXPECT_NEAR(readIn(bodyWith(before)).volumeMm3, mm3, 1e-3 * mm3) << before;
  for (const char* line : {"G1 X5 E1 G91", "G0 X1 G1 X5 E1", "G92 E0 G1 X5 E1", "G21 X3 G1 Y2"})
    EXPECT_THROW(readIn(bodyWith("") + line + "\n"), base::Error) << line;
  // Texts and other commands' words are no commands.
  for (const char* line : {"M117 G1 X5 E100", "G383 O1 M1 T140", "M486 AG1 X1"})
    EXPECT_NEAR(readIn(bodyWith("") + line + "\n").volumeMm3, mm3, 1e-3 * mm3) << line;
}

TEST(SlicedWords, AShareOfFlowIsThatOfItsTool) {
  const std::string beads = layer(0) + square(0, 0, 0.8) + layer(1) + square(0, 0, 1.6);
  EXPECT_NEAR(readIn(kHead + "T0\nM221 T1 S50\n" + beads).volumeMm3, 32.0 * kFilamentMm2, 0.1);
  EXPECT_NEAR(readIn(kHead + "T0\nM221 T0 S50\n" + beads).volumeMm3, 16.0 * kFilamentMm2, 0.1);
  EXPECT_NEAR(readIn(kHead + "T0\nM221 S50\n" + beads).volumeMm3, 16.0 * kFilamentMm2, 0.1);
  for (const char* line : {"M221 S-50\n", "M220 S0\n"})
    EXPECT_THROW(readIn(kHead + line + beads), base::Error) << line;
}

TEST(SlicedWords, UltiGcodeStatesVolumes) {
  const std::string body = layer(0) + square(0, 0, 0.8, 12.0) + layer(1) + square(0, 0, 1.6, 12.0);
  const sliced::ReadSliced read = readIn(";FLAVOR:UltiGCode\n" + kHead + body);
  EXPECT_NEAR(read.volumeMm3, 96.0, 0.01);
  EXPECT_THAT(base::english(read.notes), Contains(HasSubstr("UltiGCode")));
  EXPECT_NEAR(readIn(";FLAVOR:Marlin\n" + kHead + body).volumeMm3, 96.0 * kFilamentMm2, 0.1);
}

TEST(SlicedWords, AByteOrderMarkHidesNoSetting) {
  const std::string body = "; filament_diameter = 2.85\nG21\nG90\nM83\nG28\n" + layer(0) +
                           square(0, 0, 0.8) + layer(1) + square(0, 0, 1.6);
  EXPECT_DOUBLE_EQ(readIn("\xEF\xBB\xBF" + body).volumeMm3, readIn(body).volumeMm3);
}

std::string refusalOf(const std::string& text) {
  try {
    readIn(text);
  } catch (const base::Error& e) {
    return e.what();
  }
  return "";
}

// Beads after the end would not be printed by the machine of the file.
TEST(SlicedWords, BeadsBehindTheEndOfTheProgramAreRefused) {
  const std::string first = kHead + layer(0) + square(0, 0, 0.8);
  const std::string second = layer(1) + square(0, 0, 1.6);
  for (const std::string end : {"M2", "M30", "M112", "m02", "M2 (end)", "N7 M30*55"}) {
    EXPECT_THAT(refusalOf(first + end + "\n" + second),
                AllOf(HasSubstr("line 13: the program ends here"), HasSubstr("in line 17 would")))
        << end;
    EXPECT_EQ(notesOf(first + second + end + "\n"), notesOf(first + second)) << end;
  }
  // Deletes a file
  EXPECT_EQ(notesOf(first + "M30 /old.gco\n" + second).size(), 1u);
}

TEST(SlicedWords, ARemarkInParenthesesHidesNoCommand) {
  std::string text = kHead + layer(0) + square(0, 0, 0.8) + layer(1) + square(0, 0, 1.6);
  const double mm3 = readIn(text).volumeMm3;
  for (const std::string before : {"(a wall) ", "(a; b*c)(d)", "N10 (x) "}) {
    std::string marked = text;
    for (std::size_t at = marked.find("G1 X"); at != std::string::npos;
         at = marked.find("G1 X", at + before.size() + 1))
      marked.insert(at, before);
    EXPECT_DOUBLE_EQ(readIn(marked).volumeMm3, mm3) << before;
  }
  EXPECT_THAT(notesOf(text + "(only a remark)\n(not closed\n;(\n" + layer(2) + square(0, 0, 2.4)),
              ElementsAre());
}

TEST(SlicedWords, MaterialOfThePrintersOwnCodeIsNamedWhereItIs) {
  const std::string own = ";TYPE:Custom\nG1 X200 Y0 E9 F600\nG1 X200 Y50 E9\n";
  const std::string beads = layer(0) + ";TYPE:Perimeter\n" + square(0, 0, 0.8) + layer(1) +
                            ";TYPE:Perimeter\n" + square(0, 0, 1.6);
  EXPECT_THAT(notesOf(kHead + own + beads),
              ElementsAre(HasSubstr("43 mm3 extruded before the first layer are left out")));
  EXPECT_THAT(notesOf(kHead + beads + own),
              ElementsAre(AllOf(HasSubstr("43 mm3 extruded by the printer's own code"),
                                HasSubstr("from line 23 on"))));
  EXPECT_THAT(notesOf(kHead + beads + "G1 E3\nG1 E3\n" + layer(2) + square(0, 0, 2.4)),
              ElementsAre(AllOf(HasSubstr("extruded at rest"), HasSubstr("from line 22 on"))));
}

TEST(SlicedWords, DiametersThatCannotBeUsedAreQuoted) {
  const std::string body = "G21\nG90\nM83\nG28\n" + layer(0) + square(0, 0, 0.8);
  for (const std::string text : {"nan", "0", "-1.75", "1.75,nan", "1750"})
    EXPECT_THAT(notesOf("; filament_diameter = " + text + "\n" + body),
                ElementsAre(HasSubstr("states the filament diameter '" + text + "': 1.75 mm")))
        << text;
  EXPECT_THAT(notesOf(body), ElementsAre(HasSubstr("states no filament diameter")));
  for (const std::string text : {"1.75", "1.75,2.85", "1.75,"})
    EXPECT_THAT(notesOf("; filament_diameter = " + text + "\n" + body), ElementsAre()) << text;
}

TEST(SlicedWords, StopsAreNamedWithTheirLines) {
  std::string text = kHead;
  for (int k = 0; k < 5; ++k) {
    text += layer(k);
    if (k == 1)
      text += ";COLOR_CHANGE,T0,#46A601\nM600\n";
    else if (k == 2)
      text += ";PAUSE_PRINT\nM117 put the nut in\nM601\n";
    else if (k == 3)
      text += "M0 put the magnet in\n";
    else if (k == 4)
      text += "M25\nPAUSE\n";
    text += square(0, 0, 0.8 * (k + 1));
  }
  const std::vector<std::string> notes = notesOf(text + "M0 take it off\n");
  for (const char* note :
       {"bead 2 in layer 2: Change the filament (M600)", "bead 3 in layer 3: put the nut in (M601)",
        "bead 4 in layer 4: put the magnet in (M0 put the magnet in)",
        "bead 5 in layer 5: Pause (M25)", "bead 5 in layer 5: Pause (PAUSE)"})
    EXPECT_THAT(notes, Contains(HasSubstr(note)));
  EXPECT_THAT(notes, ::testing::Not(Contains(HasSubstr("take it off"))));
  EXPECT_THAT(notes, Contains(HasSubstr("not used: 1 stop behind the last bead")));
  const std::string cut = kHead + layer(0) + square(0, 0, 0.8) + "M0 " + std::string(43, 'a') +
                          "\xC3\xA4 b\n" + layer(1) + square(0, 0, 1.6);
  EXPECT_THAT(notesOf(cut), Contains(HasSubstr("layer 2: " + std::string(43, 'a') + " (M0")))
      << "no half of a character";
  EXPECT_THAT(notesOf(kHead + "M0 click to begin\n" + layer(0) + square(0, 0, 0.8)),
              Contains(HasSubstr("not used: 1 stop before the first bead")));
}

// The bead goes on behind the stop as one of its own.
TEST(SlicedWords, AStopWithinABeadDividesIt) {
  std::string text = kHead + layer(0) + square(0, 0, 0.8) + layer(1) + "G0 X0 Y0 Z1.6 F3000\n" +
                     "G1 X20 E4 F1200\n";
  const std::string rest = "G1 Y20 E4\nG1 X0 E4\nG1 Y0 E4\n";
  EXPECT_EQ(readIn(text + rest).plan.paths.size(), 2u);
  const sliced::ReadSliced stopped = readIn(text + "M600\n" + rest);
  EXPECT_EQ(stopped.plan.paths.size(), 3u);
  EXPECT_THAT(base::english(stopped.notes), Contains(HasSubstr("before bead 3 in layer 2")));
  EXPECT_TRUE(sliced::changesFilament("M600 B5"));
  EXPECT_FALSE(sliced::changesFilament("M601"));
}

std::string tower(int layers = 6) {
  std::string text;
  for (int k = 0; k < layers; ++k)
    text += square(100, 100, 0.8 * (k + 1));
  return text;
}

TEST(SlicedWords, PurgeLinesBesideThePartAreLeftOut) {
  const std::string lines = "G0 X-70 Y20 Z0.8 F3000\nG1 Y220 E40 F1200\nG0 X-69 Y220\nG1 Y20 E40\n";
  const std::string joined = "G0 X-70 Y20 Z0.3 F3000\nG1 Y220 E40 F1200\nG1 X-69 E.2\nG1 Y20 E40\n";
  const std::string without = kHead + tower();
  for (const std::string& purge : {lines, joined}) {
    const sliced::ReadSliced read = readIn(kHead + purge + tower());
    const Eigen::Vector3d size = geometry::bounds(read.solid).sizes();
    EXPECT_LT(size.head<2>().maxCoeff(), 25.0);
    EXPECT_NEAR(read.volumeMm3, readIn(without).volumeMm3, 1e-6);
    EXPECT_THAT(base::english(read.notes), Contains(HasSubstr("purge lines beside the part")));
  }
  // The same lines below the part, or as a part of their own, are material.
  for (const std::string& text : {kHead + "G0 X90 Y110 Z0.8 F3000\nG1 X190 E20 F1200\n" + tower(),
                                  kHead + lines, kHead + ";TYPE:Perimeter\n" + lines + tower()})
    EXPECT_NEAR(readIn(text).volumeMm3,
                kFilamentMm2 * sliced::statedAmount(text, sliced::headerOf(text)).sum, 0.1);
}

// ---- the reader checks itself

TEST(SlicedWords, TheSumOfAmountsIsThatOfTheBeads) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double lo, double hi) {
      return std::uniform_real_distribution(lo, hi)(random);
    };
    // The material that leaves the nozzles is known here.
    const bool isAbsolute = seed % 2 == 0;
    std::string text = isAbsolute ? "M82\nG28\n" : "M83\nG28\n";
    double e = 0.0, deposited = 0.0;
    std::array<double, 3> owed{};
    std::size_t tool = 0;
    const auto feed = [&](double mm) {
      e += mm;
      return isAbsolute ? e : mm;
    };
    text += "G0 X50 Y50 Z0.5 F3000\n";
    for (int k = 0; k < 200; ++k) {
      const auto choice = random() % 10;
      const double mm = uniform(0.5, 3.0);
      if (choice == 0) {
        text += fmt::format("G1 E{:.6f}\n", feed(-mm));
        owed[tool] += mm;
      } else if (choice == 1) {
        text += fmt::format("G1 E{:.6f}\n", feed(owed[tool]));
        owed[tool] = 0.0;
      } else if (choice == 2) {
        tool = random() % 3;
        text += fmt::format("T{}\n", tool);
      } else if (choice == 3) {
        text += "G92 E0\n";
        e = 0.0;
      } else {
        text +=
            fmt::format("G1 X{:.3f} Y{:.3f} E{:.6f}\n", uniform(0, 99), uniform(0, 99), feed(mm));
        const double out = std::max(0.0, mm - owed[tool]);
        owed[tool] = std::max(0.0, owed[tool] - mm);
        deposited += out;
      }
    }
    const sliced::SlicedFile file = sliced::followGcode(text, "part.gcode", kCtx);
    double beads = file.atRest + file.purged;
    for (const sliced::SlicedPath& path : file.paths)
      for (const sliced::SlicedPoint& point : path.points)
        beads += point.extruded;
    EXPECT_NEAR(beads, deposited, 1e-3) << seed;
    EXPECT_NEAR(sliced::statedAmount(text, file.header).sum, deposited, 1e-3) << seed;
  }
}

namespace {
// The values of the note that the beads are not what the file states; empty: there is none.
std::vector<base::Value> amountNote(const std::string& text) {
  for (const base::Message& note : readIn(text).notes)
    if (note.text.english() == sliced::kAmountNote.english())
      return note.values;
  return {};
}

double mm3(const base::Value& value) {
  return std::get<base::Quantity>(value.data()).number;
}

std::string lineOf(const std::vector<base::Value>& note) {
  return base::english(std::get<std::vector<base::Message>>(note.at(2).data()).at(0));
}
} // namespace

// Whatever a line that extrudes has as its command, its E word is a part of the sum: the reader
// that does not know the command is caught.
TEST(SlicedWords, ALineThatTheReaderIgnoresIsFoundByItsAmount) {
  std::string text = kHead;
  for (int k = 0; k < 3; ++k)
    text += layer(k) + square(0, 0, 0.8 * (k + 1));
  EXPECT_TRUE(amountNote(text).empty());
  const auto line = std::ranges::count(text, '\n') + 1;
  for (const std::string command : {"G6", "G5.1", "G1.5", "G123"}) {
    const std::vector<base::Value> note =
        amountNote(text + command + " X60 Y60 E8 F1200\n" + layer(3) + square(0, 0, 3.2));
    ASSERT_EQ(note.size(), 3u) << command;
    EXPECT_NEAR(mm3(note[0]) - mm3(note[1]), 8.0 * kFilamentMm2, 0.1) << command;
    EXPECT_EQ(lineOf(note), fmt::format("in line {} first", line)) << command;
  }
  // No damaged number makes a sum that cannot be stored.
  EXPECT_TRUE(amountNote(text + "G6 E" + std::string(400, '9') + "\nM221 T99 S50\n" +
                         "M221 T-1 S100\n" + layer(3) + square(0, 0, 3.2))
                  .empty());
  // Others have texts and settings behind an E, no amounts.
  for (const std::string other :
       {"M117 E8 G1 E8", "; G1 X9 E8", "(G1 X9 E8)", "M92 E420", "M205 E5", "SET_PRESSURE E8",
        "G28 E8", "M900 K0 (E8)", "N5 M117 G1 E8*42"})
    EXPECT_TRUE(amountNote(text + other + "\n" + layer(3) + square(0, 0, 3.2)).empty()) << other;
}

// Arcs, tools of other diameters, inches, shares of flow, relative and absolute amounts, one
// command behind another in a line: both counts know them.
TEST(SlicedWords, TheSumOfAmountsKnowsTheWordsThatTheReaderKnows) {
  const std::string arcs =
      "G0 X0 Y0 Z0.8 F3000\nG2 X20 Y0 I10 J0 E6 F1200\nG3 X0 Y0 R10 E6\nG1X20Y20E.5\n";
  for (const std::string& text :
       {kHead + layer(0) + arcs + layer(1) + arcs,
        kHead + "M221 S80\n" + layer(0) + square(0, 0, 0.8) + "M221 T1 S120\nT1\n" +
            square(60, 0, 0.8),
        "; filament_diameter = 1.75,2.85\nG21\nG90\nM83\nG28\n" + layer(0) + square(0, 0, 0.8) +
            "T1\n" + square(60, 0, 0.8),
        kHead + "M82\nG92 E0\n" + layer(0) +
            "G0 X0 Y0 Z0.8 F3000\nG1 X20 E4 F1200\nG1 E2\nG1 E4\nG1 Y20 E8\nG92 E0\nG1 X0 E4\n",
        kHead + "G20\n" + layer(0) + "G0 X0 Y0 Z0.03 F100\nG1 X1 E0.2 F50\nG1 Y1 E0.2\n",
        kHead + layer(0) + "M83 G90 G1 X0 Y0 Z0.8 F3000\nN7 G1 X20 E4 F1200*9\ng1 y20 e4 ; E9\n"}) {
    const std::vector<base::Value> note = amountNote(text);
    EXPECT_TRUE(note.empty()) << text << (note.empty() ? "" : lineOf(note));
  }
}

// ---- statements of a file that are ignored are named, each once

TEST(SlicedWords, IgnoredStatementsAreNamedOnce) {
  ASSERT_THAT(notesOf(kHead + layer(0) + square(0, 0, 0.8) + layer(1) + square(0, 0, 1.6)),
              ElementsAre());
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const std::string n = std::to_string(random() % 900 + 10);
    // Each with its name in the notes
    const std::vector<std::pair<std::string, std::string>> all{
        {"M106 S" + n, "M106"},
        {"G4 P" + n, "G4 "},
        {"M600 ; " + n, "(M600)"},
        {"M0 look " + n, "(M0 look " + n + ")"},
        {"M42 P4 S" + n, "M42"},
        {"M280 P0 S" + n, "M280"},
        {"M141 S" + n, "M141"},
        {"M3 S" + n, "M3 "},
        {"MACRO_" + n, "MACRO_" + n},
        {"SET_LED RED=1", "SET_LED"},
        {"G54", "G54"},
        {"G68 R10", "G68"},
        {"M92 E" + n, "M92 "},
        {"M206 X" + n, "M206 "},
        {"M290 Z" + n, "M290 "},
        {"G10 L2 P1 X" + n, "G10 L2"},
        {"G10 P0 S" + n, "G10 P0"},
        {"M104 S9" + n + "00", "M104 S9" + n},
        {"M226 P2 S1", "(M226 P2 S1)"},
        {"@pause", "(@pause)"},
        {"M98 P\"x" + n + ".g\"", "M98"}};
    std::string text = kHead;
    std::vector<std::string> needles;
    std::vector<std::string> lines;
    for (const auto& [line, needle] : all)
      if (random() % 3 == 0) {
        lines.push_back(line);
        needles.push_back(needle);
      }
    for (int k = 0; k < 4; ++k) {
      text += layer(k) + square(0, 0, 0.8 * (k + 1));
      for (const std::string& line : lines)
        if (k < 2 && (k == 0 || line.find("look") == std::string::npos) &&
            (k == 0 || (line[0] != '@' && !line.starts_with("M600") && !line.starts_with("M226"))))
          text += line + "\n";
    }
    const std::vector<std::string> notes = notesOf(text);
    for (const std::string& needle : needles) {
      std::size_t count = 0;
      for (const std::string& note : notes)
        for (std::size_t at = note.find(needle); at != std::string::npos;
             at = note.find(needle, at + 1))
          ++count;
      EXPECT_EQ(count, 1u) << seed << ": " << needle << "\n" << ::testing::PrintToString(notes);
    }
  }
}

} // namespace
