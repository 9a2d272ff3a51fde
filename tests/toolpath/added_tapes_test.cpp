// Tapes in a plan: where they are inserted, where they are cut, and whether plastic covers them.
#include "toolpath/fibre/add_tapes.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/path_figures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::toolpath {
namespace {

using Eigen::Vector3d;

constexpr double kLengthMm = 120.0, kWidthMm = 30.0, kLayerMm = 0.6;

process::Tooling tooling(const char* second = "tape-5") {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return process::Tooling({{process::loadProcess("fdm-1.0")}, {process::loadProcess(second)}});
}

// Layers of a plate, and beads along it on each of them.
struct Plate {
  layers::LayerStack stack;
  plan::ToolPlan plan;

  explicit Plate(int layers, double topWidthMm = kWidthMm) {
    for (int k = 0; k < layers; ++k) {
      const double z = (k + 0.5) * kLayerMm, width = k + 1 < layers ? kWidthMm : topWidthMm;
      layers::Patch patch = test::patchOver(
          {test::rectangle(kLengthMm, kWidthMm)}, 2.0,
          [&](const Eigen::Vector2d& p) { return Vector3d(p.x(), p.y(), z); },
          [](const Vector3d&) { return kLayerMm; });
      patch.layer = k;
      stack.patches.push_back(std::move(patch));
      for (double y = 0.5 - 0.5 * width; y < 0.5 * width; y += 1.0)
        addBead(k, y);
    }
    stack.layerCount = layers;
  }

  void addBead(int layer, double y) {
    plan::ToolPath path{.first = plan.waypointCount(), .count = 2};
    path.kind = plan::PathKind::Infill;
    path.layer = path.patch = layer;
    for (const double x : {-0.5 * kLengthMm, 0.5 * kLengthMm}) {
      plan.position.emplace_back(x, y, (layer + 1) * kLayerMm);
      plan.direction.emplace_back(Vector3d::UnitZ());
      plan.widthMm.push_back(1.2F);
      plan.heightMm.push_back(static_cast<float>(kLayerMm));
      plan.speedMmPerS.push_back(20.0F);
    }
    plan.paths.push_back(path);
  }
};

bool has(const plan::Findings& findings, plan::FindingKind kind) {
  return std::ranges::find(findings, kind, &plan::Finding::kind) != findings.end();
}

TEST(AddedTapes, FollowTheBeadsOfTheirLayer) {
  Plate plate(4);
  plate.plan.fill = {{3.0, 100.0}};
  const plan::ToolPlan before = plate.plan;
  const process::Tooling tools = tooling();
  plan::ToolpathStatistics s;
  const plan::Findings findings =
      addTapes(plate.plan, plate.stack, tools, {.everyLayers = 1}, s, {});
  EXPECT_TRUE(findings.empty());
  setPathFigures(plate.plan, 1, tools, s);
  EXPECT_EQ(s.tapes, 3u * 6u) << "none on the last layer";
  EXPECT_NEAR(s.tapeMm, 18 * 115.0, 0.5);
  // Closed form: length x width x thickness x density.
  EXPECT_NEAR(s.tapeG, s.tapeMm * 5.0 * 0.08 * 0.88e-3, 1e-9);
  EXPECT_GT(s.tapeCoveredFraction, 0.98);
  EXPECT_EQ(s.tapeBareMm, 0.0);

  const plan::ToolPlan& plan = plate.plan;
  EXPECT_EQ(plan.fill.size(), 1u);
  std::vector<plan::ToolPath> beads;
  int layer = 0;
  double mm3 = 0.0;
  std::size_t next = 0;
  for (const plan::ToolPath& path : plan.paths) {
    EXPECT_EQ(path.first, next);
    next += path.count;
    EXPECT_GE(path.layer, layer);
    layer = path.layer;
    if (path.kind != plan::PathKind::Tape) {
      beads.push_back(path);
      continue;
    }
    EXPECT_EQ(path.tool, 1);
    for (std::size_t w = path.first; w < path.first + path.count; ++w) {
      EXPECT_NEAR(plan.position[w].z(), (path.layer + 1) * kLayerMm + 0.08, 1e-6);
      EXPECT_NEAR(plan.direction[w].z(), 1.0, 1e-9);
      if (w > path.first)
        mm3 += process::beadArea(plan.widthMm[w], plan.heightMm[w]) *
               (plan.position[w] - plan.position[w - 1]).norm();
    }
  }
  EXPECT_EQ(next, plan.waypointCount());
  EXPECT_EQ(beads.size(), before.paths.size());
  EXPECT_NEAR(mm3, s.tapeMm * 5.0 * 0.08, 1e-3 * mm3) << "the paths' section is the tape's";
  for (std::size_t k = 1; k < plan.paths.size(); ++k) {
    const plan::ToolPath &last = plan.paths[k - 1], &path = plan.paths[k];
    if (last.kind == plan::PathKind::Tape && path.kind != plan::PathKind::Tape) {
      EXPECT_EQ(path.layer, last.layer + 1) << "one change a layer";
    }
  }
}

TEST(AddedTapes, HaveAWaypointWhereTheyAreCut) {
  Plate plate(2);
  const process::Tooling tools = tooling();
  const double ahead = tools.at(1).process.tape->cutAheadMm;
  plan::ToolpathStatistics s;
  addTapes(plate.plan, plate.stack, tools, {.everyLayers = 1, .endMm = 7.3}, s, {});
  setPathFigures(plate.plan, 1, tools, s);
  ASSERT_GT(s.tapes, 0u);
  for (const plan::ToolPath& path : plate.plan.paths) {
    if (path.kind != plan::PathKind::Tape)
      continue;
    double left = 0.0, nearest = 1e9;
    for (std::size_t w = path.first + path.count - 1; w > path.first; --w) {
      const double step = (plate.plan.position[w] - plate.plan.position[w - 1]).norm();
      EXPECT_GT(step, 0.05);
      left += step;
      nearest = std::min(nearest, std::abs(left - ahead));
    }
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST(AddedTapes, AreOnTheChosenLayersOnly) {
  Plate plate(8);
  plan::ToolpathStatistics s;
  addTapes(plate.plan, plate.stack, tooling(),
           {.everyLayers = 2, .firstLayer = 3, .maxPerLayer = 1, .rotationDeg = 20.0}, s, {});
  std::vector<int> layers;
  std::vector<double> angles; // [deg]
  for (const plan::ToolPath& path : plate.plan.paths)
    if (path.kind == plan::PathKind::Tape) {
      layers.push_back(path.layer);
      const Vector3d along =
          plate.plan.position[path.first + path.count - 1] - plate.plan.position[path.first];
      angles.push_back(base::radiansToDegrees(std::atan(along.y() / along.x())));
    }
  EXPECT_EQ(layers, (std::vector<int>{2, 4, 6}));
  ASSERT_EQ(angles.size(), 3u);
  for (std::size_t i = 0; i < angles.size(); ++i)
    EXPECT_NEAR(angles[i], 20.0 * static_cast<double>(i), 0.1);
}

TEST(AddedTapes, TapesNotCoveredByPlasticGiveAFinding) {
  Plate plate(3, 16.0); // the last layer is narrower: it covers two of six tapes
  plan::ToolpathStatistics s;
  const plan::Findings findings =
      addTapes(plate.plan, plate.stack, tooling(), {.everyLayers = 1}, s, {});
  EXPECT_TRUE(has(findings, plan::FindingKind::TapesBare));
  EXPECT_NEAR(s.tapeBareMm, 4 * 115.0, 0.5);
}

TEST(AddedTapes, TapesThatDoNotFitGiveAFinding) {
  Plate plate(3);
  plan::ToolpathStatistics s;
  const plan::Findings none = addTapes(plate.plan, plate.stack, tooling(),
                                       {.everyLayers = 1, .angleDeg = 90.0}, s, {}); // 25 long
  setPathFigures(plate.plan, 1, tooling(), s);
  EXPECT_EQ(s.tapes, 0u);
  EXPECT_TRUE(has(none, plan::FindingKind::NoTape));

  Plate corners(3);
  const plan::Findings bent = addTapes(corners.plan, corners.stack, tooling(),
                                       {.everyLayers = 1, .paths = "contour"}, s, {});
  EXPECT_TRUE(has(bent, plan::FindingKind::TapesLeftOut));
}

TEST(AddedTapes, NeedATool) {
  Plate plate(3);
  plan::ToolpathStatistics s;
  EXPECT_THROW(addTapes(plate.plan, plate.stack, tooling("fdm-0.4"), {.everyLayers = 1}, s, {}),
               base::Error);
  const std::size_t paths = plate.plan.paths.size();
  EXPECT_TRUE(addTapes(plate.plan, plate.stack, tooling("fdm-0.4"), {}, s, {}).empty());
  EXPECT_EQ(plate.plan.paths.size(), paths);
}

} // namespace
} // namespace voluta::toolpath
