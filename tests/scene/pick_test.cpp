#include "curved/decomposition.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "platform/rod_shape.h"
#include "process/process.h"
#include "robot/cell.h"
#include "scene/offscreen_target.h"

#include "helpers/shapes.h"
#include "robot/shape/arm_look.h"

#include <gtest/gtest.h>

namespace {
using namespace voluta;

constexpr int kWidth = 200, kHeight = 160;

class Picking : public ::testing::Test {
protected:
  scene::OffscreenTarget target_;
  scene::Scene scene_{scene::lightTheme()};
  scene::OffscreenTarget::Session session_{target_, scene_, kWidth, kHeight};

  std::optional<scene::Hit> middle() const { return scene_.pick(kWidth / 2, kHeight / 2); }
};

TEST_F(Picking, PartFacetWithItsNormal) {
  scene_.setPart(scene::drawPart(test::box({-10, -20, 0}, {10, 20, 30})));
  scene_.standardView(scene::StandardView::Front);
  const auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::Part);
  EXPECT_NEAR(hit->point.y(), -20.0, 1e-3);
  EXPECT_NEAR(hit->normal.y(), -1.0, 1e-9);
  EXPECT_FALSE(scene_.pick(1, 1));
}

TEST_F(Picking, PartsCutAwayByASectionAreNotHit) {
  scene_.setPart(scene::drawPart(test::box({-10, -20, 0}, {10, 20, 30})));
  scene_.standardView(scene::StandardView::Front);
  scene::ViewState view;
  view.sectionOn = true;
  view.sectionNormal = -Eigen::Vector3d::UnitY();
  scene_.setView(view);
  const auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.y(), 20.0, 1e-3);
}

TEST_F(Picking, OtherPartsByTheirItemWhileShown) {
  scene_.setPart(scene::drawPart(test::box({-10, -20, 0}, {10, 20, 30})));
  scene_.setOtherParts({nullptr, scene::drawPart(test::box({30, -20, 0}, {50, 20, 30})),
                        scene::drawPart(test::box({-10, -60, 0}, {10, -40, 30}))});
  scene::ViewState view;
  scene_.setView(view);
  scene_.standardView(scene::StandardView::Front);
  EXPECT_EQ(middle()->what, scene::Hit::What::Part) << "the others are hidden and not framed";
  view.otherParts = true;
  scene_.setView(view);
  scene_.lookAt({0, 0, 15}, 30.0);
  const auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::OtherPart);
  EXPECT_EQ(hit->item, 2u);
  EXPECT_NEAR(hit->point.y(), -60.0, 1e-3);
  scene_.setOtherParts({});
  EXPECT_EQ(middle()->what, scene::Hit::What::Part);
}

TEST_F(Picking, VoxelOfTheLayersShown) {
  curved::Decomposition d;
  d.grid.size = {5, 5, 5};
  for (std::size_t c = 0; c < d.grid.cellCount(); ++c)
    d.rank.push_back(d.grid.cell(c).z() + 1);
  scene_.setVoxels(scene::drawVoxels(d));
  scene::ViewState view;
  view.voxels = true;
  scene_.setView(view);
  scene_.standardView(scene::StandardView::Top);
  auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::Voxel);
  EXPECT_EQ(hit->layer, 4);
  EXPECT_EQ(hit->voxel, d.grid.index(2, 2, 4));
  view.lastLayer = 1;
  scene_.setView(view);
  hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->layer, 1);
  EXPECT_NEAR(hit->point.z(), 2.0, 1e-6);
}

TEST_F(Picking, WaypointOfTheNearestBead) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 2; ++layer) {
    plan::ToolPath path;
    path.first = plan.position.size();
    path.count = 11;
    path.layer = layer;
    plan.paths.push_back(path);
    for (int i = 0; i <= 10; ++i) {
      plan.position.emplace_back(i - 5.0, 0.0, 1.0 + layer);
      plan.direction.push_back(Eigen::Vector3d::UnitZ());
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(1.0f);
      plan.speedMmPerS.push_back(20.0f);
    }
  }
  scene_.setPaths(scene::drawPaths(plan));
  scene::ViewState view;
  view.paths = true;
  scene_.setView(view);
  scene_.standardView(scene::StandardView::Top);
  auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::Path);
  EXPECT_EQ(hit->path, 1u);
  EXPECT_EQ(hit->waypoint, 11u + 5u);
  view.lastLayer = 0;
  scene_.setView(view);
  hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->path, 0u);
  EXPECT_EQ(hit->layer, 0);
}

TEST_F(Picking, BodyOfTheCell) {
  const auto process = process::loadProcess("fdm-1.0");
  const std::vector<Eigen::Vector2d> plate{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, plate);
  scene_.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  scene::ViewState view;
  view.cell = true;
  view.world = scene::World::Base;
  scene_.setView(view);
  scene_.standardView(scene::StandardView::Top);
  const auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::Cell);
  EXPECT_LT(hit->body, cell.bodies().size());
}

TEST_F(Picking, ARodAndABodyArePlatform) {
  platform::PlatformSolid rod;
  rod.rod = platform::straightRod(5.0, 200.0);
  scene_.setPlatform(scene::drawPlatform(rod, 100.0));
  scene_.standardView(scene::StandardView::Top);
  auto hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::Platform);
  EXPECT_NEAR(hit->point.z(), 2.5, 0.03);

  platform::PlatformSolid body({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}});
  body.mesh = std::make_shared<geometry::TriangleMesh>(test::box({-10, -10, 0}, {10, 10, 12}));
  scene_.setPlatform(scene::drawPlatform(body, 100.0));
  hit = middle();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->what, scene::Hit::What::Platform);
  EXPECT_NEAR(hit->point.z(), 12.0, 1e-3);
}

} // namespace
