// Only geometry that cannot be seen is left out of a picture: counted against plain enumeration.
#include "curved/decomposition.h"
#include "layers/layer_stack.h"
#include "scene/colour_values.h"
#include "scene/drawing_data.h"
#include "scene/fill_order.h"
#include "scene/visible_beads.h"

#include "base/units.h"
#include "helpers/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace {
using namespace voluta;
using scene::Stretch;

std::size_t total(const std::vector<Stretch>& stretches) {
  std::size_t sum = 0;
  for (const Stretch& s : stretches)
    sum += s.count;
  return sum;
}

std::size_t total(const scene::VisibleBeads& beads) {
  return total(beads.stretches);
}

TEST(VoxelDrawing, ShowsTheFacesBetweenShownAndHiddenCells) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> anyRank(0, 5);
  curved::Decomposition d;
  d.grid.size = {6, 5, 7};
  d.rank.resize(d.grid.cellCount());
  for (auto& rank : d.rank)
    rank = anyRank(random);
  const auto drawing = scene::drawVoxels(d);
  ASSERT_EQ(scene::layerCount(*drawing), 5);

  for (int first = 0; first < 5; ++first)
    for (int last = first; last < 5; ++last) {
      const auto shown = [&](int i, int j, int k) {
        if (!d.grid.contains(i, j, k))
          return false;
        const int layer = d.rank[d.grid.index(i, j, k)] - 1;
        return layer >= first && layer <= last;
      };
      std::size_t expected = 0;
      for (int k = 0; k <= 7; ++k)
        for (int j = 0; j <= 5; ++j)
          for (int i = 0; i <= 6; ++i)
            expected += std::size_t(shown(i, j, k) != shown(i - 1, j, k)) +
                        std::size_t(shown(i, j, k) != shown(i, j - 1, k)) +
                        std::size_t(shown(i, j, k) != shown(i, j, k - 1));
      std::vector<Stretch> faces;
      drawing->outer.append(faces, first, last, -scene::kNeverHidden);
      drawing->upper.append(faces, first, last, last);
      drawing->lower.append(faces, first, last, -first);
      EXPECT_EQ(total(faces), 2 * expected) << first << " to " << last;
    }
}

// Two cells high, by rank one above the other; the field puts all in one layer but the top.
curved::Decomposition tower() {
  curved::Decomposition d;
  d.grid.size = {1, 1, 6};
  d.rank = {1, 2, 3, -1, -1, -1};
  d.field = {0.1f, 0.2f, 1.0f, NAN, NAN, NAN};
  d.loss = {curved::Loss::None,     curved::Loss::None,      curved::Loss::None,
            curved::Loss::Shadowed, curved::Loss::Unreached, curved::Loss::Cascade};
  d.support = {1, 0, 0, 0, 0, 0};
  return d;
}

std::array<int, 3> colourOfPoint(vtkPolyData* data, vtkIdType point) {
  const auto* scalars = data->GetPointData()->GetScalars();
  return {int(const_cast<vtkDataArray*>(scalars)->GetComponent(point, 0)),
          int(const_cast<vtkDataArray*>(scalars)->GetComponent(point, 1)),
          int(const_cast<vtkDataArray*>(scalars)->GetComponent(point, 2))};
}

TEST(VoxelDrawing, IsShownByLayerOrByStepAndColouredByEither) {
  const curved::Decomposition d = tower();
  scene::VoxelLook look;
  look.layerHeightMm = 0.8;
  const auto byLayer = scene::drawVoxels(d, look);
  EXPECT_EQ(scene::layerCount(*byLayer), 2);
  EXPECT_EQ(byLayer->colouredBy, scene::ColourBy::Layer);
  look.bySteps = true;
  const auto bySteps = scene::drawVoxels(d, look);
  EXPECT_EQ(scene::layerCount(*bySteps), 3);
  EXPECT_EQ(bySteps->colouredBy, scene::ColourBy::Layer);
  EXPECT_EQ(bySteps->highest, 2);
  look.colourBy = scene::ColourBy::GrowthStep;
  EXPECT_EQ(scene::drawVoxels(d, look)->highest, 3);
  look.colourBy = scene::ColourBy::Peeling;
  EXPECT_EQ(scene::drawVoxels(d, look)->colouredBy, scene::ColourBy::Layer) << "not known";
  look.peeling = std::make_shared<const std::vector<std::int32_t>>(std::vector{0, 4, 3, 2, 1, 1});
  EXPECT_EQ(scene::drawVoxels(d, look)->highest, 4);
  EXPECT_EQ(scene::drawVoxels(d)->colouredBy, scene::ColourBy::GrowthStep) << "no layers known";
}

TEST(VoxelDrawing, SupportAndEveryReasonHaveAColourAndALineInTheLegend) {
  const auto drawing = scene::drawVoxels(tower());
  EXPECT_EQ(drawing->support, 1u);
  for (std::size_t reason = 0; reason < scene::kLossCount; ++reason) {
    EXPECT_EQ(drawing->lost[reason], 1u);
    EXPECT_GT(drawing->missedFaces[reason].count, 0u);
  }
  std::map<std::array<int, 3>, int> found;
  for (vtkIdType p = 0; p < drawing->outside->GetNumberOfPoints(); ++p)
    ++found[colourOfPoint(drawing->outside, p)];
  EXPECT_EQ(found.size(), 3u) << "support and two ranks";
  const scene::Legend legend = scene::voxelLegend(*drawing, scene::lightTheme());
  ASSERT_EQ(legend.marks.size(), 4u);
  EXPECT_EQ(base::english(legend.marks[0].label), "Support");
  EXPECT_EQ(base::english(legend.marks[1].text()), "Missed, shadowed (1)");
  EXPECT_EQ(legend.marks[1].colour, scene::lightTheme().blocked);
}

TEST(LayersDrawing, SpacingIsCentredOnTheNominalHeightWithItsLimitsMarked) {
  scene::ColourValues values;
  values.height = {0.2f, 0.4f, 0.8f, 1.0f, 1.3f};
  values.layer = {0, 0, 0, 0, 0};
  EXPECT_EQ(scene::shownColouring(values, scene::ColourBy::Spacing), scene::ColourBy::Layer);
  values.heights = {0.8, 0.4, 1.0};
  ASSERT_EQ(scene::shownColouring(values, scene::ColourBy::Spacing), scene::ColourBy::Spacing);
  const auto rgb = scene::coloursOf(values, scene::ColourBy::Spacing, 1);
  const auto expectColour = [&](std::size_t i, const scene::Colour& colour) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(rgb[3 * i + k], 255.0 * colour[k], 3.0) << i;
  };
  expectColour(0, scene::tooThinColour());
  expectColour(1, scene::divergingColour(0.0));
  expectColour(2, scene::divergingColour(0.5));
  expectColour(3, scene::divergingColour(1.0));
  expectColour(4, scene::tooThickColour());
  const scene::Legend legend = scene::legendOf(values, scene::ColourBy::Spacing);
  ASSERT_EQ(legend.entries.size(), 5u);
  EXPECT_EQ(base::english(legend.entries[0].text()), "0.40 (limit)");
  EXPECT_EQ(base::english(legend.entries[2].text()), "0.80 (nominal)");
  EXPECT_EQ(legend.marks.size(), 2u);
}

TEST(LayersDrawing, GroupsOfRegionsAndSupportHaveNames) {
  scene::ColourValues values;
  values.group = {0, 1, layers::kSupportGroup, layers::kRegionGroups + 2};
  const scene::Legend legend = scene::legendOf(values, scene::ColourBy::Group);
  ASSERT_EQ(legend.entries.size(), 4u);
  EXPECT_EQ(base::english(legend.entries[0].text()), "Support");
  EXPECT_EQ(base::english(legend.entries[1].text()), "1");
  EXPECT_EQ(base::english(legend.entries[2].text()), "2");
  EXPECT_EQ(base::english(legend.entries[3].text()), "Region 3");
}

// A block of straight beads, 1 mm apart in y and z.
plan::ToolPlan block(int layers, int beads, int waypoints) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < layers; ++layer)
    for (int bead = 0; bead < beads; ++bead) {
      plan::ToolPath path;
      path.first = plan.position.size();
      path.count = static_cast<std::size_t>(waypoints);
      path.layer = layer;
      for (int i = 0; i < waypoints; ++i) {
        plan.position.emplace_back(i, bead, layer + 1);
        plan.direction.push_back(Eigen::Vector3d::UnitZ());
        plan.widthMm.push_back(1.0f);
        plan.heightMm.push_back(1.0f);
        plan.speedMmPerS.push_back(20.0f);
      }
      plan.paths.push_back(path);
    }
  return plan;
}

TEST(PathsDrawing, LeavesOutBeadsSurroundedByLaterOnes) {
  const plan::ToolPlan plan = block(12, 12, 30);
  const auto drawing = scene::drawPaths(plan);
  const std::size_t segments = 12 * 12 * 29;
  EXPECT_EQ(drawing->coarse.front().front(), segments);

  scene::ViewState view;
  const std::size_t all = total(scene::visibleBeads(*drawing, view));
  // The outermost two rings of beads at least; not the heart of the block.
  EXPECT_GE(all, 2 * (12 * 12 - 10 * 10) * 29u);
  EXPECT_LT(all, 2 * segments * 3 / 4);

  // A section along the beads lays open those next to it.
  view.sectionOn = true;
  view.sectionOrigin = {0, 6.0, 0};
  view.sectionNormal = Eigen::Vector3d::UnitY();
  EXPECT_GE(total(scene::visibleBeads(*drawing, view)), all + 2 * 2 * 8 * 29u);

  view = {};
  view.dragging = true;
  EXPECT_EQ(total(scene::visibleBeads(*drawing, view)), all) << "few enough for fast frames";
  view.draggedTriangles = all / 2;
  // Straight beads need no waypoints in between, apart from those of the uppermost layers.
  const std::size_t fast = total(scene::visibleBeads(*drawing, view));
  EXPECT_LE(fast, view.draggedTriangles);
  EXPECT_GE(fast, 2 * (12 * 12 - 10 * 10) / 2u);
}

// A tube of many turns around a core that nobody sees from outside.
TEST(PathsDrawing, FastFramesLeaveOutTheInsideOfAClosedPrint) {
  constexpr int kLayers = 20, kWaypoints = 400;
  plan::ToolPlan plan;
  const auto addRing = [&](int layer, double radius) {
    plan::ToolPath path;
    path.first = plan.position.size();
    path.count = kWaypoints + 1;
    path.layer = layer;
    path.closed = true;
    for (int i = 0; i <= kWaypoints; ++i) {
      const double angle = base::kTwoPi * i / kWaypoints;
      plan.position.emplace_back(radius * std::cos(angle), radius * std::sin(angle), layer + 1.0);
      plan.direction.push_back(Eigen::Vector3d::UnitZ());
      plan.widthMm.push_back(1.0f);
      plan.heightMm.push_back(1.0f);
      plan.speedMmPerS.push_back(20.0f);
    }
    plan.paths.push_back(path);
  };
  for (int layer = 0; layer < kLayers; ++layer)
    if (layer == 0 || layer == kLayers - 1)
      for (int ring = 0; ring <= 40; ++ring)
        addRing(layer, 0.5 + ring);
    else
      for (const double radius : {15.0, 40.5})
        addRing(layer, radius);
  const auto drawing = scene::drawPaths(plan);
  scene::ViewState view;
  const auto radii = [&](double from, double to) {
    std::size_t count = 0;
    for (const Stretch& s : scene::visibleBeads(*drawing, view).stretches)
      for (std::size_t i = s.first / 2; i < (s.first + s.count) / 2; ++i) {
        const std::uint32_t w = drawing->arrival[i];
        const double radius = plan.position[w].head<2>().norm();
        count += radius > from && radius < to && plan.position[w].z() > 1.5 &&
                 plan.position[w].z() < kLayers - 1.5;
      }
    return count;
  };
  EXPECT_GT(radii(14.0, 16.0), 0u) << "the whole print has it";
  view.dragging = true;
  view.draggedTriangles = 12'000;
  EXPECT_EQ(radii(14.0, 16.0), 0u);
  EXPECT_GT(radii(40.0, 41.0), 0u);
  EXPECT_LE(total(scene::visibleBeads(*drawing, view)), view.draggedTriangles);
  view.lastLayer = kLayers / 2; // open at its top
  EXPECT_GT(radii(14.0, 16.0), 0u);
  EXPECT_LE(total(scene::visibleBeads(*drawing, view)), view.draggedTriangles);
  // Even a few triangles are an outline from bottom to top.
  view.lastLayer = scene::kAllLayers;
  view.draggedTriangles = 2'000;
  const scene::VisibleBeads few = scene::visibleBeads(*drawing, view);
  EXPECT_GT(few.everyLayer, 1);
  EXPECT_GT(radii(40.0, 41.0), 0u);
}

TEST(VoxelDrawing, ManyFacesHaveBlocksForFastFrames) {
  curved::Decomposition ball;
  constexpr int kCells = 130;
  ball.grid.size = {kCells, kCells, kCells};
  ball.rank.assign(ball.grid.cellCount(), 0);
  std::size_t voxels = 0;
  for (std::size_t c = 0; c < ball.rank.size(); ++c) {
    const Eigen::Vector3i cell = ball.grid.cell(c);
    if ((cell.cast<double>() - Eigen::Vector3d::Constant(0.5 * kCells)).norm() > 0.48 * kCells)
      continue;
    ball.rank[c] = cell.z() + 1;
    ++voxels;
  }
  const auto drawing = scene::drawVoxels(ball);
  ASSERT_NE(drawing->coarse, nullptr);
  const scene::VoxelDrawing& coarse = *drawing->coarse;
  EXPECT_LT(coarse.outer.size(), drawing->outer.size() / 3);
  EXPECT_GT(coarse.outer.size(), drawing->outer.size() / 20);
  // The outline and the colours are about the same.
  double fine[6], blocks[6];
  drawing->outside->GetBounds(fine);
  coarse.outside->GetBounds(blocks);
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(fine[k], blocks[k], 2.0) << k;
  for (vtkIdType p = 0; p < coarse.outside->GetNumberOfPoints(); p += 97) {
    double at[3];
    coarse.outside->GetPoint(p, at);
    const scene::Colour colour = scene::sequentialColour(at[2] / kCells);
    const auto shown = colourOfPoint(coarse.outside, p);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(shown[k], 255.0 * colour[k], 16.0) << at[2];
  }
  EXPECT_EQ(scene::drawVoxels(tower())->coarse, nullptr);
}

TEST(PathsDrawing, HiddenKindsAreLeftOutAndShowTheBeadsThatTheyCover) {
  plan::ToolPlan plan = block(12, 12, 30);
  scene::ViewState view;
  const std::size_t all = total(scene::visibleBeads(*scene::drawPaths(plan), view));
  // The outermost beads are walls, all others infill.
  for (plan::ToolPath& path : plan.paths) {
    const double y = plan.position[path.first].y();
    path.kind = y < 1.0 || y > 10.0 ? plan::PathKind::Wall : plan::PathKind::Infill;
  }
  const auto drawing = scene::drawPaths(plan);
  EXPECT_EQ(total(scene::visibleBeads(*drawing, view)), all);
  view.hiddenKinds = 1U << static_cast<unsigned>(plan::PathKind::Wall);
  std::size_t segments = 0;
  for (const scene::Stretch& stretch : scene::visibleBeads(*drawing, view).stretches)
    for (std::size_t i = stretch.first / 2; i < (stretch.first + stretch.count) / 2; ++i) {
      ++segments;
      EXPECT_EQ(drawing->values.kind[drawing->arrival[i]],
                static_cast<std::int32_t>(plan::PathKind::Infill));
    }
  std::size_t infill = 0;
  for (const plan::ToolPath& path : plan.paths)
    infill += path.kind == plan::PathKind::Infill ? path.count - 1 : 0;
  EXPECT_EQ(segments, infill) << "also those that only walls covered";
  view.hiddenKinds = ~0U;
  EXPECT_TRUE(scene::visibleBeads(*drawing, view).stretches.empty());
}

TEST(PathsDrawing, TopLayerIsThereInFullForEveryRange) {
  const plan::ToolPlan plan = block(10, 12, 20);
  const auto drawing = scene::drawPaths(plan);
  for (int last = 0; last < 10; ++last) {
    scene::ViewState view;
    view.lastLayer = last;
    std::vector<char> seen(plan.waypointCount(), 0);
    for (const Stretch& s : scene::visibleBeads(*drawing, view).stretches)
      for (std::size_t i = s.first / 2; i < (s.first + s.count) / 2; ++i) {
        const auto arrival = drawing->arrival[i];
        EXPECT_FALSE(seen[arrival]) << "drawn twice";
        seen[arrival] = 1;
        EXPECT_LE(drawing->layerOfPath[drawing->pathOf[arrival]], last);
      }
    for (const plan::ToolPath& path : plan.paths)
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
        if (path.layer == last) {
          EXPECT_TRUE(seen[i]) << "layer " << last << ", waypoint " << i;
        }
  }
}

TEST(PathsDrawing, MovesAndPrintedWaypointsClampThePrintOrder) {
  const plan::ToolPlan plan = block(6, 8, 10);
  const auto drawing = scene::drawPaths(plan);
  const auto highest = [&](const scene::ViewState& view) {
    std::size_t maximum = 0;
    for (const Stretch& s : scene::visibleBeads(*drawing, view).stretches)
      for (std::size_t i = s.first / 2; i < (s.first + s.count) / 2; ++i)
        maximum = std::max<std::size_t>(maximum, drawing->arrival[i]);
    return maximum;
  };
  scene::ViewState view;
  view.lastLayer = 3;
  view.moves = 25;
  EXPECT_EQ(scene::waypointsOfLayer(*drawing, 3).size(), 80u);
  EXPECT_EQ(highest(view), scene::waypointsOfLayer(*drawing, 3)[24]);
  view.moves = 0;
  EXPECT_LT(highest(view), scene::waypointsOfLayer(*drawing, 3)[0]);

  view = {};
  view.printedWaypoints = 137;
  EXPECT_EQ(highest(view), 136u);
  view.printedWaypoints = 0;
  EXPECT_TRUE(scene::visibleBeads(*drawing, view).stretches.empty());
}

TEST(PathsDrawing, TravelsBelongToTheLayerTheyLeadTo) {
  const plan::ToolPlan plan = block(3, 4, 5);
  const auto drawing = scene::drawPaths(plan);
  scene::ViewState view;
  EXPECT_EQ(total(scene::visibleTravels(*drawing, view)), 11u);
  view.firstLayer = view.lastLayer = 1;
  EXPECT_EQ(total(scene::visibleTravels(*drawing, view)), 4u);
  view.moves = 6; // the second bead of the layer has begun
  EXPECT_EQ(total(scene::visibleTravels(*drawing, view)), 2u);
}

TEST(LayersDrawing, SidesThatOtherLayersCoverAreLeftOut) {
  constexpr int kSquares = 30;
  layers::LayerStack stack;
  for (int layer = 0; layer < 3; ++layer) {
    layers::Patch patch;
    patch.layer = layer;
    for (int j = 0; j <= kSquares; ++j)
      for (int i = 0; i <= kSquares; ++i)
        patch.surface.vertices.emplace_back(i, j, layer + 0.5);
    for (int j = 0; j < kSquares; ++j)
      for (int i = 0; i < kSquares; ++i) {
        const int a = (kSquares + 1) * j + i;
        patch.surface.triangles.push_back({a, a + 1, a + kSquares + 2});
        patch.surface.triangles.push_back({a, a + kSquares + 2, a + kSquares + 1});
      }
    patch.thicknessMm.assign(patch.surface.vertices.size(), 1.0);
    patch.direction.assign(patch.surface.vertices.size(), Eigen::Vector3d::UnitZ());
    stack.patches.push_back(patch);
  }
  stack.layerCount = 3;
  const auto drawing = scene::drawLayers(stack);
  EXPECT_EQ(scene::layerCount(*drawing), 3);
  const auto shown = [&](const scene::LayeredFaces& faces, int first, int last, int key) {
    std::vector<Stretch> stretches;
    faces.append(stretches, first, last, key);
    return total(stretches);
  };
  constexpr std::size_t whole = 2 * kSquares * kSquares;
  EXPECT_EQ(shown(drawing->slabs.bands, 0, 2, -scene::kNeverHidden), 3 * 2 * 4u * kSquares);
  // One side in full; of the covered ones only those near the edge.
  const std::size_t upper = shown(drawing->slabs.upper, 0, 2, 2);
  const std::size_t edge = (upper - whole) / 2;
  EXPECT_GT(edge, 4u * kSquares);
  EXPECT_LT(edge, whole * 6 / 10);
  EXPECT_EQ(upper, whole + 2 * edge);
  EXPECT_EQ(shown(drawing->slabs.upper, 0, scene::kAllLayers, scene::kAllLayers), upper);
  EXPECT_EQ(shown(drawing->slabs.upper, 0, 1, 1), whole + edge);
  EXPECT_EQ(shown(drawing->slabs.lower, 0, 2, 0), whole + 2 * edge);
  EXPECT_EQ(shown(drawing->slabs.lower, 1, 2, -1), whole + edge);
}

// Rings about the x axis, seven layers: the outermost one is in sight all around.
TEST(FillOrder, BeadsUnderARodAreNotClosedFromBelow) {
  plan::ToolPlan plan;
  constexpr int kAround = 48;
  for (int layer = 0; layer < 7; ++layer)
    for (int ring = -4; ring <= 4; ++ring) {
      const double radius = 3.0 + 0.25 * layer;
      plan.paths.push_back(
          {plan.position.size(), kAround + 1, plan::PathKind::Infill, layer, layer, 0, true});
      for (int i = 0; i <= kAround; ++i) {
        const double angle = 2 * base::kPi * i / kAround;
        const Eigen::Vector3d out(0.0, std::cos(angle), std::sin(angle));
        plan.position.push_back(radius * out + Eigen::Vector3d(0.65 * ring, 0, 0));
        plan.direction.push_back(out);
        plan.widthMm.push_back(0.7f);
        plan.heightMm.push_back(0.25f);
        plan.speedMmPerS.push_back(20.0f);
      }
    }
  const scene::FillOrder order(plan);
  for (const plan::ToolPath& path : plan.paths) {
    if (path.layer < 6)
      continue;
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      EXPECT_EQ(order.surroundedAt(plan, i), scene::kNeverFilled) << i;
  }
}

} // namespace
