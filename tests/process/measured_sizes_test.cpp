// Corrections of sizes from parts that were measured.
#include "process/measured_sizes.h"

#include "base/error.h"
#include "process/library.h"
#include "process/process_text.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::process {
namespace {

// A machine with errors in sizes.
struct Machine {
  double factorX = 1.0, factorY = 1.0, outlineMm = 0.0, holeMm = 0.0;

  // Returns the printed size of a nominal one, with the corrections of the process.
  double printed(const MeasuredSize& size, const Process& p) const {
    const bool isOuter = size.kind == SizeKind::Length;
    const double scale = size.kind == SizeKind::Hole ? 0.5 * (p.scaleX + p.scaleY)
                         : size.axis == 'x'          ? p.scaleX
                                                     : p.scaleY;
    const double factor = size.kind == SizeKind::Hole ? 0.5 * (factorX + factorY)
                          : size.axis == 'x'          ? factorX
                                                      : factorY;
    const double planned =
        scale * size.nominalMm + 2.0 * (isOuter ? p.outlineOffsetMm : p.holeOffsetMm);
    return factor * planned + 2.0 * (isOuter ? outlineMm : -holeMm);
  }
};

// The sizes of the source's plates.
std::vector<MeasuredSize> plates(const Machine& machine, const Process& p) {
  std::vector<MeasuredSize> sizes;
  for (const double length : {50.0, 100.0, 210.0, 260.0, 310.0, 360.0}) {
    sizes.push_back({SizeKind::Length, 'x', length});
    sizes.push_back({SizeKind::Length, 'y', 20.0});
    sizes.push_back({SizeKind::Slot, 'x', length - (length < 200.0 ? 40.0 : 50.0)});
    sizes.push_back({SizeKind::Slot, 'y', 5.0});
    sizes.push_back({SizeKind::Hole, 'x', 10.0});
  }
  for (MeasuredSize& size : sizes)
    size.measuredMm = machine.printed(size, p);
  return sizes;
}

Machine randomMachine(std::mt19937& random) {
  const auto pick = [&](double maximum) {
    return std::uniform_real_distribution<double>(-maximum, maximum)(random);
  };
  return {1.0 + pick(0.004), 1.0 + pick(0.004), pick(0.2), pick(0.3)};
}

double worstError(const Machine& machine, const Process& p) {
  double worst = 0.0;
  for (const MeasuredSize& size : plates(machine, p))
    worst = std::max(worst, std::abs(machine.printed(size, p) - size.nominalMm));
  return worst;
}

TEST(MeasuredSizes, KnownErrorsAreCorrected) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Machine machine = randomMachine(random);
    const SizeFit fit = fitSizes(plates(machine, Process()), Process());
    EXPECT_LT(fit.residualMm, 0.005) << i;
    EXPECT_LT(worstError(machine, fit.process), 0.005) << i;
    // Once corrected, measured sizes change nothing.
    const SizeFit again = fitSizes(plates(machine, fit.process), fit.process);
    EXPECT_NEAR(again.process.scaleX, fit.process.scaleX, 2e-5) << i;
    EXPECT_NEAR(again.process.outlineOffsetMm, fit.process.outlineOffsetMm, 2e-3) << i;
    EXPECT_NEAR(again.process.holeOffsetMm, fit.process.holeOffsetMm, 2e-3) << i;
  }
}

TEST(MeasuredSizes, RoundedSizesStillGiveAHundredth) {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    const Machine machine = randomMachine(random);
    std::vector<MeasuredSize> sizes = plates(machine, Process());
    for (MeasuredSize& size : sizes)
      size.measuredMm = std::round(100.0 * size.measuredMm) / 100.0; // A calliper's digits
    EXPECT_LT(worstError(machine, fitSizes(sizes, Process()).process), 0.015) << i;
  }
}

TEST(MeasuredSizes, OneSizeIsCorrectedToo) {
  for (const auto& [kind, nominal, measured] :
       std::vector<std::tuple<SizeKind, double, double>>{{SizeKind::Length, 50.0, 49.7},
                                                         {SizeKind::Slot, 10.0, 9.6},
                                                         {SizeKind::Hole, 10.0, 9.6}}) {
    const MeasuredSize size{kind, 'x', nominal, measured};
    const Process p = fitSizes({&size, 1}, Process()).process;
    const double planned =
        (kind == SizeKind::Hole ? 0.5 * (p.scaleX + p.scaleY) : p.scaleX) * nominal +
        2.0 * (kind == SizeKind::Length ? p.outlineOffsetMm : p.holeOffsetMm);
    EXPECT_NEAR(planned - nominal, nominal - measured, 0.01);
  }
}

// One short length is corrected as an excess: as a factor it would be 1.25 %. Its scale is named as
// unknown; a long and a short length determine it.
TEST(MeasuredSizes, OneShortLengthDoesNotDetermineTheScale) {
  const MeasuredSize shortOne{SizeKind::Length, 'x', 20.0, 19.75};
  const SizeFit fit = fitSizes({&shortOne, 1}, Process());
  EXPECT_NEAR(fit.process.scaleX, 1.0, 0.0003);
  EXPECT_NEAR(fit.process.outlineOffsetMm, 0.12, 0.01);
  EXPECT_FALSE(tellsScale(fit.scaleDeviationX));
  EXPECT_NEAR(fit.scaleDeviationX, kUnknownFactor, 0.05 * kUnknownFactor);
  EXPECT_NEAR(fit.scaleDeviationY, kUnknownFactor, 1e-12);
  const std::vector<MeasuredSize> two{shortOne, {SizeKind::Length, 'x', 200.0, 199.75}};
  EXPECT_TRUE(tellsScale(fitSizes(two, Process()).scaleDeviationX));
  EXPECT_FALSE(tellsScale(fitSizes(two, Process()).scaleDeviationY));
}

// Readings that contradict each other on a small plate.
TEST(MeasuredSizes, DoubtfulReadingsGiveNoFactorOfPercents) {
  const std::vector<MeasuredSize> sizes{{SizeKind::Length, 'x', 50.0, 49.85},
                                        {SizeKind::Length, 'y', 20.0, 19.9},
                                        {SizeKind::Slot, 'x', 10.0, 9.72},
                                        {SizeKind::Slot, 'y', 5.0, 4.75},
                                        {SizeKind::Hole, 'x', 10.0, 9.6}};
  const SizeFit fit = fitSizes(sizes, Process());
  EXPECT_NEAR(fit.process.scaleX, 1.0, 0.01);
  EXPECT_NEAR(fit.process.scaleY, 1.0, 0.01);
  EXPECT_LT(fit.residualMm, 0.1);
}

TEST(MeasuredSizes, RightSizesChangeNothing) {
  const Process p = fitSizes(plates({}, Process()), Process()).process;
  EXPECT_EQ(p.scaleX, 1.0);
  EXPECT_EQ(p.scaleY, 1.0);
  EXPECT_EQ(std::abs(p.outlineOffsetMm), 0.0);
  EXPECT_EQ(std::abs(p.holeOffsetMm), 0.0);
}

TEST(MeasuredSizes, AreReadFromATable) {
  const auto sizes = readMeasuredSizes("# plate of 50\nlength x 50 49.8\n\nslot,y, 5,4.8\r\n"
                                       "hole;10;9.6 # once\n",
                                       "sizes.txt");
  ASSERT_EQ(sizes.size(), 3u);
  EXPECT_EQ(sizes[0].kind, SizeKind::Length);
  EXPECT_EQ(sizes[1].axis, 'y');
  EXPECT_EQ(sizes[2].measuredMm, 9.6);
}

TEST(MeasuredSizes, BadTablesAreRefusedInOneLine) {
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"", "no measured sizes"},
           {"width x 50 49", "'width' is not a kind of size"},
           {"length z 50 49", "not a kind, an axis and two sizes"},
           {"length x 50", "not a kind, an axis and two sizes"},
           {"length x 50 0", "'0' is not a size"},
           {"length x 50 nan", "'nan' is not a size"},
           {"hole 10 9.6 9.7", "not a kind"},
           {"length x 50 498", "too far"}})
    try {
      readMeasuredSizes(text, "sizes.txt");
      ADD_FAILURE() << text;
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
      EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
    }
}

TEST(MeasuredSizes, CorrectionsBeyondTheRangesAreRefused) {
  const MeasuredSize size{SizeKind::Length, 'x', 50.0, 41.0};
  EXPECT_THROW(fitSizes({&size, 1}, Process()), base::Error);
}

TEST(MeasuredSizes, CorrectionsAreInTheProcessFile) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  Process p = loadProcess("fdm-1.0");
  EXPECT_EQ(processText(p).find("scaleX"), std::string::npos);
  p.scaleX = 1.002;
  p.outlineOffsetMm = -0.05;
  p.holeOffsetMm = 0.12;
  const Process back = readProcessText(processText(p), "x");
  EXPECT_TRUE(sameProcess(p, back));
  EXPECT_EQ(back.outlineOffsetMm, -0.05);
  for (const auto& [was, is] : std::vector<std::pair<std::string, std::string>>{
           {"1.002", "0.5"}, {"1.002", "1.5"}, {"-0.05", "-3"}, {"-0.05", "3"}}) {
    std::string text = processText(p);
    text.replace(text.find(was), was.size(), is);
    EXPECT_THROW(readProcessText(text, "x"), base::Error) << is;
  }
}

} // namespace
} // namespace voluta::process
