// The plan that the beads of all patches make: order, seams, islands.
#include "toolpath/order/assemble.h"

#include "base/run_context.h"
#include "process/bead_model.h"
#include "toolpath/order/island_order.h"
#include "toolpath/order/print_turn.h"
#include "toolpath/order/seam.h"
#include "toolpath/patch_shapes.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <optional>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHeight = 0.8;

test::Lift atLayer(int layer) {
  return [layer](const Vector2d& p) { return Vector3d(p.x(), p.y(), (layer + 0.5) * kHeight); };
}

// Layers of islands, each a square at a place of its own.
layers::LayerStack islands(int layerCount, const std::vector<Vector2d>& places, double sizeMm) {
  layers::LayerStack stack;
  stack.layerCount = layerCount;
  for (int layer = 0; layer < layerCount; ++layer)
    for (const Vector2d& place : places) {
      test::Loop loop = test::rectangle(sizeMm, sizeMm);
      for (Vector2d& p : loop)
        p += place;
      stack.patches.push_back(test::patchOver({loop}, 0.8, atLayer(layer)));
      stack.patches.back().layer = layer;
    }
  return stack;
}

std::vector<PatchCover> coversOf(const layers::LayerStack& stack) {
  std::vector<PatchCover> covers;
  for (const layers::Patch& patch : stack.patches)
    covers.push_back(coverPatch(patch, process::Process{}, {}, base::RunContext{}));
  return covers;
}

std::vector<Vector2d> randomPlaces(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<int> cells(25);
  for (int i = 0; i < 25; ++i)
    cells[static_cast<std::size_t>(i)] = i;
  std::ranges::shuffle(cells, random);
  std::vector<Vector2d> places;
  for (int i = 0; i < count; ++i)
    places.emplace_back(12.0 * (cells[static_cast<std::size_t>(i)] % 5),
                        12.0 * (cells[static_cast<std::size_t>(i)] / 5));
  return places;
}

double travelOf(const plan::ToolPlan& plan) {
  double mm = 0.0;
  for (std::size_t k = 1; k < plan.paths.size(); ++k)
    mm += (plan.position[plan.paths[k].first] - plan.position[plan.paths[k].first - 1]).norm();
  return mm;
}

double volumeOf(const plan::ToolPlan& plan) {
  double mm3 = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const auto section = [&](std::size_t j) {
        return process::beadArea(static_cast<double>(plan.widthMm[j]),
                                 static_cast<double>(plan.heightMm[j]));
      };
      mm3 += process::beadVolume(section(i - 1), section(i),
                                 (plan.position[i] - plan.position[i - 1]).norm());
    }
  return mm3;
}

TEST(Assemble, EveryRowOfTheTableOfSeamsLaysAllBeadsInTheirTurns) {
  layers::LayerStack stack = islands(2, {{0, 0}, {20, 0}}, 9.0);
  const test::Lift cap = test::onSphere(20);
  stack.patches.push_back(test::patchOver({test::circle(12), test::circle(4, true)}, 0.8, cap));
  stack.patches.back().layer = 2;
  stack.layerCount = 3;
  const std::vector<PatchCover> covers = coversOf(stack);
  std::size_t beads = 0;
  for (const PatchCover& c : covers)
    beads += c.beads.size();
  const process::Tooling tooling{process::Process{}};
  const double volume = volumeOf(assemble(stack, covers, tooling).plan);
  for (const SeamKind& kind : seamKinds()) {
    SCOPED_TRACE(kind.id);
    const Assembled made = assemble(stack, covers, tooling, {std::string(kind.id), true});
    EXPECT_EQ(made.plan.paths.size(), beads);
    EXPECT_EQ(made.clearDirection.size(), made.plan.waypointCount());
    EXPECT_NEAR(made.travelMm, travelOf(made.plan), 1e-6);
    EXPECT_NEAR(volumeOf(made.plan), volume, 1e-4 * volume);
    int layer = 0;
    for (std::size_t k = 0; k < made.plan.paths.size(); ++k) {
      const plan::ToolPath& path = made.plan.paths[k];
      EXPECT_GE(path.layer, layer);
      layer = path.layer;
      if (path.closed) {
        EXPECT_EQ(made.plan.position[path.first], made.plan.position[path.first + path.count - 1]);
      }
      if (k == 0 || made.plan.paths[k - 1].patch != path.patch) {
        EXPECT_EQ(path.kind, plan::PathKind::Wall);
      } else if (made.plan.paths[k - 1].kind == plan::PathKind::GapFill) {
        EXPECT_NE(path.kind, plan::PathKind::Infill);
      }
    }
  }
}

// Nearest first, in the order of the stack, as PrusaSlicer chains beads: no plan travels further.
TEST(Assemble, IslandsInTheOrderOfMinimumTravelNeverTravelFurther) {
  const process::Tooling tooling{process::Process{}};
  // Covers of squares are those of the first one, moved.
  const layers::LayerStack one = islands(1, {{0, 0}}, 6.0);
  const PatchCover cover = coversOf(one).front();
  double given = 0.0, ordered = 0.0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const int count = 2 + static_cast<int>(seed % 20);
    layers::LayerStack stack;
    std::vector<PatchCover> covers;
    for (int layer = 0; layer < 3; ++layer)
      for (const Vector2d& place : randomPlaces(seed, count)) {
        const Vector3d move(place.x(), place.y(), layer * kHeight);
        layers::Patch patch = one.patches.front();
        patch.layer = layer;
        for (Vector3d& v : patch.surface.vertices)
          v += move;
        stack.patches.push_back(std::move(patch));
        PatchCover& c = covers.emplace_back(cover);
        for (Bead& bead : c.beads)
          for (BeadPoint& p : bead.points)
            p.middle += move;
      }
    stack.layerCount = 3;
    const Assembled asGiven = assemble(stack, covers, tooling, {"nearest", false});
    const Assembled inOrder = assemble(stack, covers, tooling, {"nearest", true});
    EXPECT_LE(inOrder.travelMm, asGiven.travelMm + 1e-9);
    EXPECT_EQ(inOrder.plan.paths.size(), asGiven.plan.paths.size());
    int layer = 0;
    for (const plan::ToolPath& path : inOrder.plan.paths) {
      EXPECT_GE(path.layer, layer);
      layer = path.layer;
    }
    for (std::size_t k = 1; k < asGiven.plan.paths.size(); ++k)
      EXPECT_GE(asGiven.plan.paths[k].patch, asGiven.plan.paths[k - 1].patch);
    given += asGiven.travelMm;
    ordered += inOrder.travelMm;
  }
  EXPECT_LT(ordered, 0.8 * given);
}

TEST(Assemble, AlignedSeamsOfAStackAreAboveEachOther) {
  layers::LayerStack stack;
  for (int layer = 0; layer < 8; ++layer) {
    stack.patches.push_back(test::patchOver(
        {test::circle(10)}, 0.8, atLayer(layer), [](const Vector3d&) { return kHeight; },
        static_cast<unsigned>(layer + 1)));
    stack.patches.back().layer = layer;
  }
  stack.layerCount = 8;
  const process::Tooling tooling{process::Process{}};
  const Assembled made = assemble(stack, coversOf(stack), tooling, {"aligned", true});
  std::array<std::optional<double>, 2> first; // per wall: its x in the first layer
  for (const plan::ToolPath& path : made.plan.paths)
    if (path.kind == plan::PathKind::Wall) {
      const Vector3d& seam = made.plan.position[path.first];
      std::optional<double>& x = first.at(path.ring == 0 ? 0 : 1);
      x = x.value_or(seam.x());
      EXPECT_NEAR(seam.x(), *x, 0.2);
      EXPECT_LT(std::abs(seam.x()), 1.0);
      EXPECT_GT(seam.y(), 7.0);
    }
}

TEST(IslandRuns, AreOfOneFlatLayer) {
  layers::LayerStack stack = islands(2, {{0, 0}, {20, 0}, {40, 0}}, 9.0);
  EXPECT_EQ(islandRuns(stack), (std::vector<IslandRun>{{0, 3}, {3, 6}}));
  stack.patches[1].group = 1;
  EXPECT_EQ(islandRuns(stack), (std::vector<IslandRun>{{0, 1}, {1, 2}, {2, 3}, {3, 6}}));
  stack.patches[1].group = 0;
  for (int layers::Patch::*const field : {&layers::Patch::item, &layers::Patch::tool}) {
    stack.patches[5].*field = 1;
    EXPECT_EQ(islandRuns(stack), (std::vector<IslandRun>{{0, 3}, {3, 5}, {5, 6}}));
    stack.patches[5].*field = 0;
  }
  // A thicker patch has its mid-surface elsewhere; a curved one may carry another.
  stack.patches[4].surface.vertices.front().z() += 0.1;
  EXPECT_EQ(islandRuns(stack), (std::vector<IslandRun>{{0, 3}, {3, 4}, {4, 5}, {5, 6}}));
  layers::LayerStack caps;
  for (int k = 0; k < 2; ++k)
    caps.patches.push_back(test::patchOver({test::circle(5)}, 0.8, test::onSphere(20)));
  EXPECT_EQ(islandRuns(caps), (std::vector<IslandRun>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(islandOrders(caps).empty());
  EXPECT_TRUE(islandRuns({}).empty());
}

// Each layer has the order of the first one, for any order of the islands in the stack.
TEST(OrderAsBelow, IsThatOfTheFirstLayer) {
  std::mt19937 random(3);
  const layers::LayerStack sorted = islands(5, {{0, 0}, {20, 0}, {40, 0}, {0, 20}}, 9.0);
  for (int seed = 0; seed < 100; ++seed) {
    layers::LayerStack stack = sorted;
    for (std::size_t layer = 0; layer < 5; ++layer)
      std::shuffle(stack.patches.begin() + static_cast<std::ptrdiff_t>(4 * layer),
                   stack.patches.begin() + static_cast<std::ptrdiff_t>(4 * layer + 4), random);
    const std::vector<std::size_t> order = orderAsBelow(stack);
    ASSERT_EQ(order.size(), 20u);
    for (std::size_t k = 4; k < order.size(); ++k) {
      const Vector3d below = stack.patches[order[k - 4]].surface.vertices.front(),
                     above = stack.patches[order[k]].surface.vertices.front();
      EXPECT_LT((above - below).head<2>().norm(), 1.0);
      EXPECT_GT(stack.patches[order[k]].layer, stack.patches[order[k - 4]].layer);
    }
  }
}

} // namespace
} // namespace voluta::toolpath
