// Sparse infill: densities in closed form, lines that do not cross, and skins on flat, tilted and
// curved stacks.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "patch_shapes.h"
#include "process/bead_model.h"
#include "toolpath/options.h"
#include "toolpath/sparse/cover_layers.h"
#include "toolpath/sparse/layer_count.h"
#include "toolpath/sparse/patterns.h"
#include "toolpath/sparse/sparse_lines.h"
#include "toolpath/sparse/split_layers.h"
#include "toolpath/sparse/stack_layers.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>
#include <utility>

namespace {

using namespace voluta;
using Eigen::Vector3d;
using toolpath::SparsePattern;

constexpr double kHeight = 0.8;

// Squares on top of each other, turned by `rotation` about the origin. Raised by `unevenMm` on one
// side, they are no even planes.
layers::LayerStack stackOf(int count, double side,
                           const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity(),
                           double unevenMm = 0.0) {
  layers::LayerStack stack;
  stack.layerCount = count;
  for (int k = 0; k < count; ++k) {
    layers::Patch patch = test::patchOver(
        {test::rectangle(side, side)}, 1.5,
        [&](const Eigen::Vector2d& p) {
          const double raisedMm = p.x() > 0.0 ? unevenMm : 0.0;
          return Vector3d(rotation * Vector3d(p.x(), p.y(), (k + 0.5) * kHeight + raisedMm));
        },
        [](const Vector3d&) { return kHeight; }, 1U + static_cast<unsigned>(k));
    for (Vector3d& d : patch.direction)
      d = rotation * Vector3d::UnitZ();
    patch.clearDirection = patch.direction;
    patch.layer = k;
    stack.patches.push_back(std::move(patch));
  }
  return stack;
}

double areaOf(const layers::Patch& patch) {
  double area = 0.0;
  for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
    const Vector3d a = patch.surface.corner(t, 0);
    area += 0.5 * (patch.surface.corner(t, 1) - a).cross(patch.surface.corner(t, 2) - a).norm();
  }
  return area;
}

toolpath::ToolpathOptions sparseOptions(double density = 0.2) {
  toolpath::ToolpathOptions o;
  o.infillDensity = density;
  return o;
}

double hatch() {
  const process::Process p;
  return process::hatchOf(p.beadWidthMm, p.layerHeightMm);
}

class Patterns : public testing::TestWithParam<std::string> {
protected:
  const SparsePattern& pattern() const { return toolpath::sparsePattern(GetParam()); }
};

// By the crossings of random lines (Cauchy-Crofton).
double lengthPerArea(const SparsePattern& pattern, double period) {
  constexpr double kStep = 0.2;
  constexpr int kLines = 1500, kSteps = 750;
  const toolpath::PatternValue value = pattern.value(period, process::Process{}.beadWidthMm);
  std::mt19937_64 random(7);
  const auto number = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  double crossings = 0.0;
  for (int k = 0; k < kLines; ++k) {
    const double angle = base::kPi * number();
    Vector3d p(500 * number(), 500 * number(), 500 * number());
    const Vector3d step = kStep * Vector3d(std::cos(angle), std::sin(angle), 0.0);
    double last = std::floor(value(p, {}) + 0.5);
    for (int i = 0; i < kSteps; ++i) {
      p += step;
      const double now = std::floor(value(p, {}) + 0.5);
      crossings += std::abs(now - last);
      last = now;
    }
  }
  return 0.5 * base::kPi * crossings / (kStep * kLines * kSteps);
}

TEST_P(Patterns, HaveTheDensityOfTheirPeriod) {
  for (const double density : {0.1, 0.2, 0.4}) {
    const double period = pattern().periodMm(density, hatch(), process::Process{}.beadWidthMm);
    EXPECT_NEAR(lengthPerArea(pattern(), period) * hatch() / density, 1.0, 0.02)
        << density << ", period " << period;
  }
}

// A completed branching gives the pattern of half the period's lines, twice as many.
TEST_P(Patterns, BranchesMoveByTheGivenDistance) {
  constexpr double kPeriod = 14.0;
  const toolpath::PatternValue value = pattern().value(kPeriod, 1.2);
  const double quarter = 0.25 * pattern().spacing * kPeriod;
  int ends = 0, sames = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p(0.37 * i, 0.11 * i, 0.05 * i);
    const auto line = [&](const toolpath::Branching& b) { return std::floor(value(p, b) + 0.5); };
    // At its two ends a branching gives the same lines.
    const double end = line({0, quarter}), next = line({1, 0.0});
    const Vector3d q = p + Vector3d(0.37, 0.11, 0.05);
    const double end2 = std::floor(value(q, {0, quarter}) + 0.5),
                 next2 = std::floor(value(q, {1, 0.0}) + 0.5);
    ++ends;
    sames += end2 - end == next2 - next;
  }
  EXPECT_GT(sames, 0.97 * ends);
}

// Beads of a layer neither cross nor run beside each other closer than their hatch allows.
TEST_P(Patterns, LinesDoNotCross) {
  const layers::Patch patch = test::patchOver({test::circle(22)}, 0.9);
  layers::LayerStack stack;
  stack.patches.push_back(patch);
  const toolpath::LayerCount count(stack, base::RunContext{});
  const process::Process process;
  for (const double density : {0.15, 0.4}) {
    const auto o = [&] {
      toolpath::ToolpathOptions options = sparseOptions(density);
      options.topLayers = 0; // No branches
      options.sparsePattern = GetParam();
      return options;
    }();
    const std::vector<toolpath::Bead> beads =
        toolpath::sparseBeads(patch, {stack, 0, count, {}}, process, o, base::RunContext{});
    ASSERT_FALSE(beads.empty());
    std::size_t near = 0, all = 0;
    for (std::size_t a = 0; a < beads.size(); ++a)
      for (const toolpath::BeadPoint& p : beads[a].points) {
        ++all;
        bool isNear = false;
        for (std::size_t b = 0; b < beads.size() && !isNear; ++b)
          for (std::size_t i = 0; b != a && i < beads[b].points.size() && !isNear; ++i)
            isNear = (beads[b].points[i].middle - p.middle).norm() < 0.5 * process.beadWidthMm;
        near += isNear;
      }
    EXPECT_LE(static_cast<double>(near), 0.02 * static_cast<double>(all)) << density;
  }
}

std::vector<std::string> patternIds() {
  std::vector<std::string> ids;
  for (const SparsePattern& pattern : toolpath::sparsePatterns())
    ids.emplace_back(pattern.id);
  return ids;
}
std::string nameOf(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}
INSTANTIATE_TEST_SUITE_P(All, Patterns, testing::ValuesIn(patternIds()), nameOf);

TEST(SparsePattern, UnknownNamesTheNearest) {
  try {
    toolpath::sparsePattern("giroid");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(base::english(e.remedy()).find("gyroid"), std::string::npos);
  }
}

const Eigen::Quaterniond kTurns[] = {
    Eigen::Quaterniond::Identity(), Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d::UnitX())),
    Eigen::Quaterniond(Eigen::AngleAxisd(1.5, Vector3d(1, 2, 0).normalized()))};

TEST(LayerCount, CountsUpToTheSurface) {
  for (const Eigen::Quaterniond& rotation : kTurns) {
    const layers::LayerStack stack = stackOf(9, 12.0, rotation);
    const toolpath::LayerCount count(stack, base::RunContext{});
    const Vector3d up = rotation * Vector3d::UnitZ();
    for (std::size_t k = 0; k < 9; ++k) {
      const Vector3d place =
          rotation * Vector3d(1.1, -0.7, (static_cast<double>(k) + 0.5) * kHeight);
      const int above = 8 - static_cast<int>(k);
      EXPECT_EQ(count.along(k, place, up, kHeight, 5).count, std::min(5, above)) << k;
      EXPECT_EQ(count.along(k, place, -up, kHeight, 20).count, static_cast<int>(k)) << k;
      EXPECT_EQ(count.patchBelow(k, place, up, kHeight), static_cast<int>(k) - 1);
    }
  }
}

TEST(LayerCount, AGapASupportOrAnotherDirectionEndsTheCount) {
  layers::LayerStack gap = stackOf(8, 12.0);
  gap.patches.erase(gap.patches.begin() + 4);
  const Vector3d place(1, 1, 0.5 * kHeight), up = Vector3d::UnitZ();
  EXPECT_EQ(toolpath::LayerCount(gap, {}).along(0, place, up, kHeight, 9).count, 3);
  layers::LayerStack support = stackOf(8, 12.0);
  support.patches[4].group = layers::kSupportGroup;
  EXPECT_EQ(toolpath::LayerCount(support, {}).along(0, place, up, kHeight, 9).count, 3);
  layers::LayerStack tilted = stackOf(8, 12.0);
  for (Vector3d& d : tilted.patches[4].direction)
    d = Vector3d(1, 0, 1).normalized();
  EXPECT_EQ(toolpath::LayerCount(tilted, {}).along(0, place, up, kHeight, 9).count, 3);
}

toolpath::SplitLayers splitAll(const layers::LayerStack& stack, const toolpath::StackLayers& layers,
                               const process::Tooling& tooling,
                               const toolpath::ToolpathOptions& options) {
  const toolpath::CoverRules rules{options, tooling};
  return toolpath::splitLayers(stack, layers, {&rules, 1}, {});
}

toolpath::LayerCovers coverAll(const layers::LayerStack& stack, const process::Tooling& tooling,
                               const toolpath::ToolpathOptions& options) {
  const toolpath::CoverRules rules{options, tooling};
  return toolpath::coverLayers(stack, {&rules, 1}, 1.0, {});
}

// Planes are split as polygons, and uneven ones as surfaces.
const std::pair<Eigen::Quaterniond, double> kEvenAndUneven[] = {
    {kTurns[0], 0.0}, {kTurns[1], 0.0}, {kTurns[2], 0.0}, {kTurns[0], 1e-4}, {kTurns[2], 1e-4}};

// The interior of a block is known in closed form.
TEST(SplitLayers, LeaveWallsAndSkinsSolid) {
  constexpr int kLayers = 12;
  constexpr double kSide = 26.0;
  const process::Tooling tooling{process::Process{}};
  for (const auto& [rotation, unevenMm] : kEvenAndUneven) {
    const layers::LayerStack stack = stackOf(kLayers, kSide, rotation, unevenMm);
    const toolpath::StackLayers layers(stack, false, base::RunContext{});
    toolpath::ToolpathOptions o = sparseOptions();
    o.topLayers = 2;
    o.bottomLayers = 4;
    const toolpath::SplitLayers split = splitAll(stack, layers, tooling, o);
    const double inner = kSide - 2.0 * o.walls * hatch();
    for (std::size_t k = 0; k < kLayers; ++k) {
      const bool isSkin = k < 4 || k >= kLayers - 2;
      ASSERT_EQ(split.sparse[k].has_value(), !isSkin) << k;
      if (isSkin) {
        EXPECT_EQ(split.solid.patches[k].surface.triangles.size(),
                  stack.patches[k].surface.triangles.size());
        continue;
      }
      EXPECT_NEAR(areaOf(*split.sparse[k]) / (inner * inner), 1.0, 0.01);
      EXPECT_NEAR(areaOf(*split.sparse[k]) + areaOf(split.solid.patches[k]),
                  areaOf(stack.patches[k]), 0.01);
    }
  }
}

TEST(SplitLayers, SkinThicknessCountsBesideTheNumber) {
  const layers::LayerStack stack = stackOf(12, 26.0);
  const toolpath::StackLayers layers(stack, false, base::RunContext{});
  toolpath::ToolpathOptions o = sparseOptions();
  o.topLayers = o.bottomLayers = 1;
  o.skinMm = 3.2; // Four layers
  const toolpath::SplitLayers split =
      splitAll(stack, layers, process::Tooling{process::Process{}}, o);
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_EQ(split.sparse[k].has_value(), k >= 4 && k < 8) << k;
}

// A layer that is wider than the one above it has a skin where that one ends.
TEST(SplitLayers, AStepHasASkin) {
  layers::LayerStack stack = stackOf(20, 40.0);
  const layers::LayerStack narrow = stackOf(20, 20.0);
  for (std::size_t k = 10; k < 20; ++k)
    stack.patches[k] = narrow.patches[k];
  const toolpath::StackLayers layers(stack, false, base::RunContext{});
  const toolpath::SplitLayers split =
      splitAll(stack, layers, process::Tooling{process::Process{}}, sparseOptions());
  ASSERT_TRUE(split.sparse[8].has_value());
  ASSERT_TRUE(split.sparse[5].has_value());
  EXPECT_GT(areaOf(*split.sparse[5]), 1200.0); // Inside the walls
  EXPECT_LT(areaOf(*split.sparse[8]), 400.0);  // Below the narrow part only
}

TEST(CoverLayers, FillsTheInteriorAtItsDensity) {
  const layers::LayerStack stack = stackOf(10, 40.0);
  process::Process process;
  process.bridgeMm = 30.0; // No branches
  const process::Tooling tooling{process};
  for (const double density : {0.0, 0.2, 0.4}) {
    toolpath::ToolpathOptions o = sparseOptions(density);
    o.sparsePattern = "lines";
    const toolpath::LayerCovers made = coverAll(stack, tooling, o);
    ASSERT_GT(made.sparseMm3, 0.0);
    // Beads that join the lines come on top.
    EXPECT_GE(made.sparseBeadMm3 / made.sparseMm3, 0.93 * density);
    EXPECT_LE(made.sparseBeadMm3 / made.sparseMm3, 1.25 * density);
    EXPECT_NEAR(made.fill.at(0).openMm3, made.sparseMm3 - made.sparseBeadMm3, 1e-6);
    EXPECT_GT(made.fill.at(0).shellMm, 1.0);
    for (std::size_t k = 0; k < 10; ++k)
      for (const toolpath::Bead& bead : made.covers[k].beads)
        EXPECT_EQ(bead.kind == plan::PathKind::Bridge,
                  k == 7 &&
                      (bead.kind == plan::PathKind::Bridge || bead.kind == plan::PathKind::Infill));
  }
  const toolpath::LayerCovers solid = coverAll(stack, tooling, sparseOptions(1.0));
  EXPECT_TRUE(solid.fill.empty());
  EXPECT_EQ(solid.sparseMm3, 0.0);
}

// Without layers of a skin there is none, however thick it should be: the replay expects none.
TEST(CoverLayers, NoSkinLayersAreNoShell) {
  toolpath::ToolpathOptions o = sparseOptions();
  o.topLayers = o.bottomLayers = 0;
  o.skinMm = 3.0;
  const toolpath::LayerCovers made =
      coverAll(stackOf(10, 40.0), process::Tooling{process::Process{}}, o);
  EXPECT_EQ(made.fill.at(0).shellMm, 0.0);
}

} // namespace
