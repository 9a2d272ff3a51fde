// Planned tool-paths and those of files joined into one plan: order, items, layers, nothing lost.
#include "pipeline/items/joined_plans.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace voluta::pipeline {
namespace {

using layers::PrintOrder;
using plan::PathKind;

// Adds a bead of three waypoints in that layer, whose tip is at `z`.
void addBead(plan::ToolPlan& plan, double z, int layer, int item = 0,
             PathKind kind = PathKind::Wall) {
  plan::ToolPath path{.first = plan.waypointCount(), .count = 3, .kind = kind, .layer = layer};
  path.patch = layer;
  path.item = item;
  const double number = static_cast<double>(plan.paths.size());
  for (const double x : {0.0, 1.0, 2.0}) {
    plan.position.emplace_back(x, number, z);
    plan.direction.emplace_back(0.0, 0.0, 1.0);
    plan.widthMm.push_back(1.2F);
    plan.heightMm.push_back(0.5F);
    plan.speedMmPerS.push_back(static_cast<float>(10.0 + number));
  }
  plan.paths.push_back(path);
}

// Two beads in each of the layers.
plan::ToolPlan stackOf(int layers, double heightMm, int item = 0) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < layers; ++layer)
    for (int bead = 0; bead < 2; ++bead)
      addBead(plan, (layer + 1) * heightMm, layer, item);
  return plan;
}

GivenPlan given(std::size_t item, const plan::ToolPlan& plan) {
  return {item, std::make_shared<plan::ToolPlan>(plan)};
}

std::vector<int> itemsOf(const plan::ToolPlan& plan) {
  std::vector<int> items;
  for (const plan::ToolPath& path : plan.paths)
    items.push_back(path.item);
  return items;
}

std::vector<int> layersOf(const plan::ToolPlan& plan) {
  std::vector<int> layers;
  for (const plan::ToolPath& path : plan.paths)
    layers.push_back(path.layer);
  return layers;
}

// Paths cover the waypoints; those of an item are `own`, in that order and unchanged.
void expectAllOf(const plan::ToolPlan& joined, int item, const plan::ToolPlan& own) {
  std::size_t next = 0, waypoint = 0;
  for (const plan::ToolPath& path : joined.paths) {
    EXPECT_EQ(path.first, waypoint);
    waypoint += path.count;
    if (path.item != item)
      continue;
    ASSERT_LT(next, own.paths.size());
    const plan::ToolPath& was = own.paths[next++];
    EXPECT_EQ(path.kind, was.kind);
    ASSERT_EQ(path.count, was.count);
    for (std::size_t i = 0; i < was.count; ++i) {
      EXPECT_EQ(joined.position[path.first + i], own.position[was.first + i]);
      EXPECT_EQ(joined.direction[path.first + i], own.direction[was.first + i]);
      EXPECT_EQ(joined.widthMm[path.first + i], own.widthMm[was.first + i]);
      EXPECT_EQ(joined.heightMm[path.first + i], own.heightMm[was.first + i]);
      EXPECT_EQ(joined.speedMmPerS[path.first + i], own.speedMmPerS[was.first + i]);
    }
  }
  EXPECT_EQ(next, own.paths.size());
  EXPECT_EQ(waypoint, joined.waypointCount());
}

TEST(JoinedPlans, FollowTheSequence) {
  const plan::ToolPlan planned = stackOf(2, 0.8, 1), a = stackOf(2, 0.5), b = stackOf(1, 0.3);
  const std::vector<GivenPlan> files{given(0, a), given(2, b)};
  const std::vector<std::size_t> sequence{2, 1, 0};
  const plan::ToolPlan joined = joinedPlans(planned, files, PrintOrder::OneAfterAnother, sequence);
  EXPECT_EQ(itemsOf(joined), (std::vector<int>{2, 2, 1, 1, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(layersOf(joined), (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4}));
  expectAllOf(joined, 0, a);
  expectAllOf(joined, 1, planned);
  expectAllOf(joined, 2, b);
}

TEST(JoinedPlans, ByLayerTakeTheLowestLayerNext) {
  // Heights 0.6, 1.2 and 0.4, 0.8, 1.2: the highest ones are one layer.
  const plan::ToolPlan planned = stackOf(2, 0.6, 0), file = stackOf(3, 0.4);
  const plan::ToolPlan joined = joinedPlans(planned, std::vector{given(1, file)},
                                            PrintOrder::ByLayer, std::vector<std::size_t>{0, 1});
  EXPECT_EQ(itemsOf(joined), (std::vector<int>{1, 1, 0, 0, 1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(layersOf(joined), (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3, 3, 3}));
  expectAllOf(joined, 0, planned);
  expectAllOf(joined, 1, file);
}

TEST(JoinedPlans, KeepTheOrderOfAFileThatGoesDownAgain) {
  plan::ToolPlan file; // two objects, one after the other
  for (const double z : {0.5, 1.0, 0.5, 1.0})
    addBead(file, z, static_cast<int>(std::lround(2.0 * z)) - 1);
  const plan::ToolPlan planned = stackOf(2, 0.5, 0);
  for (const PrintOrder order : {PrintOrder::ByLayer, PrintOrder::OneAfterAnother}) {
    const plan::ToolPlan joined =
        joinedPlans(planned, std::vector{given(1, file)}, order, std::vector<std::size_t>{0, 1});
    expectAllOf(joined, 0, planned);
    expectAllOf(joined, 1, file);
  }
}

TEST(JoinedPlans, WasteOfTheJobIsFirstAndThatOfAFileStays) {
  plan::ToolPlan planned;
  addBead(planned, 0.8, 0, 1, PathKind::Skirt);
  addBead(planned, 0.8, 0, 1);
  plan::ToolPlan file;
  addBead(file, 0.4, 0, 0, PathKind::Skirt);
  addBead(file, 0.4, 0);
  for (const PrintOrder order : {PrintOrder::ByLayer, PrintOrder::OneAfterAnother}) {
    const plan::ToolPlan joined =
        joinedPlans(planned, std::vector{given(0, file)}, order, std::vector<std::size_t>{0, 1});
    EXPECT_EQ(itemsOf(joined), (std::vector<int>{1, 0, 0, 1}));
    EXPECT_EQ(layersOf(joined), (std::vector<int>{0, 0, 0, 1}));
    EXPECT_TRUE(joined.primes());
    expectAllOf(joined, 0, file);
  }
}

TEST(JoinedPlans, OfFilesOnly) {
  const plan::ToolPlan file = stackOf(2, 0.5);
  const plan::ToolPlan joined = joinedPlans({}, std::vector{given(0, file), given(1, file)},
                                            PrintOrder::ByLayer, std::vector<std::size_t>{0, 1});
  EXPECT_EQ(itemsOf(joined), (std::vector<int>{0, 0, 1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(layersOf(joined), (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  expectAllOf(joined, 0, file);
  expectAllOf(joined, 1, file);
}

// Equal numbers would be one patch to the motion, which then hops across the gap.
TEST(JoinedPlans, PatchesOfTwoPlansDiffer) {
  const plan::ToolPlan planned = stackOf(3, 0.5, 0), file = stackOf(3, 0.5);
  const plan::ToolPlan joined = joinedPlans(planned, std::vector{given(1, file), given(2, file)},
                                            PrintOrder::ByLayer, std::vector<std::size_t>{0, 1, 2});
  for (const plan::ToolPath& a : joined.paths)
    for (const plan::ToolPath& b : joined.paths) {
      EXPECT_EQ(a.patch == b.patch, a.item == b.item && a.layer == b.layer);
    }
  for (const plan::ToolPath& path : joined.paths)
    if (path.item == 0) {
      EXPECT_LT(path.patch, 3) << "planned patches keep their numbers";
    }
}

TEST(JoinedPlans, EachItemKeepsItsFill) {
  plan::ToolPlan planned = stackOf(1, 0.5, 1), file = stackOf(1, 0.5);
  planned.fill = {{}, {2.0, 30.0}, {}};
  file.fill = {{1.0, 7.0}};
  const plan::ToolPlan joined =
      joinedPlans(planned, std::vector{given(0, file), given(2, stackOf(1, 0.5))},
                  PrintOrder::ByLayer, std::vector<std::size_t>{0, 1, 2});
  ASSERT_EQ(joined.fill.size(), 3u);
  EXPECT_EQ(joined.fill[0].openMm3, 7.0);
  EXPECT_EQ(joined.fill[1].openMm3, 30.0);
  EXPECT_TRUE(joined.fill[2].isSolid());
}

} // namespace
} // namespace voluta::pipeline
