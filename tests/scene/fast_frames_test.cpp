// While dragging, a large print has less detail: about the same outline and colours. At rest the
// picture is that of before.
#include "helpers/large_prints.h"
#include "platform/platform_solid.h"
#include "scene/offscreen_target.h"
#include "scene/size_marks.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vtkRenderer.h>

namespace {
using namespace voluta;

constexpr int kWidth = 480, kHeight = 360;

struct Sum {
  double pixels = 0.0, rgb[3] = {0.0, 0.0, 0.0};
};

class FastFrames : public testing::Test {
protected:
  scene::Image imageOf(bool dragging) {
    view.dragging = dragging;
    scene.setView(view);
    if (!framed_)
      scene.standardView(scene::StandardView::Isometric);
    framed_ = true;
    session_.draw();
    return session_.image();
  }
  // `name`: of pictures in the folder VOLUTA_TEST_PICTURES. `share`: of the pixels that may differ
  // in being of the print.
  void expectAboutTheSame(const std::string& name, double share = 0.07) {
    framed_ = false;
    const scene::ViewState shown = view;
    view = {};
    view.part = false;
    const scene::Image nothing = imageOf(true);
    view = shown;
    framed_ = false;
    const scene::Image rest = imageOf(false);
    const scene::Image dragged = imageOf(true);
    EXPECT_EQ(imageOf(true).rgb, dragged.rgb) << "it stays the same while dragging";
    EXPECT_EQ(imageOf(false).rgb, rest.rgb) << "and it is whole again";
    EXPECT_NE(rest.rgb, dragged.rgb) << "less detail";
    keep(rest, name + "-rest");
    keep(dragged, name + "-dragged");
    Sum fine, coarse;
    double different = 0.0;
    for (std::size_t i = 0; i < rest.rgb.size(); i += 3) {
      const bool inRest = isPrint(rest, nothing, i), inDragged = isPrint(dragged, nothing, i);
      different += inRest != inDragged;
      if (inRest)
        add(rest, i, fine);
      if (inDragged)
        add(dragged, i, coarse);
    }
    ASSERT_GT(fine.pixels, 0.05 * kWidth * kHeight);
    EXPECT_LT(different, share * fine.pixels) << "pixels of the outline";
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(fine.rgb[k] / fine.pixels, coarse.rgb[k] / coarse.pixels, 12.0) << k;
  }

  scene::Scene scene{scene::lightTheme()};
  scene::ViewState view;

  static void keep(const scene::Image& image, const std::string& name) {
    if (const char* folder = std::getenv("VOLUTA_TEST_PICTURES"))
      std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary)
          << scene::pngBytes(image);
  }

private:
  static bool isPrint(const scene::Image& image, const scene::Image& nothing, std::size_t i) {
    int difference = 0;
    for (std::size_t k = 0; k < 3; ++k)
      difference += std::abs(int(image.rgb[i + k]) - int(nothing.rgb[i + k]));
    return difference > 12;
  }
  static void add(const scene::Image& image, std::size_t i, Sum& sum) {
    ++sum.pixels;
    for (std::size_t k = 0; k < 3; ++k)
      sum.rgb[k] += image.rgb[i + k];
  }
  scene::OffscreenTarget target_;
  scene::OffscreenTarget::Session session_{target_, scene, kWidth, kHeight};
  bool framed_ = false;
};

TEST_F(FastFrames, OfBeads) {
  for (const double spacing : {0.8, 2.0}) {
    const auto paths = scene::drawPaths(test::wavedTower(30, spacing));
    scene.setPaths(paths);
    view = {};
    view.part = false;
    view.paths = true;
    view.draggedTriangles = 9'000;
    const std::string name = spacing < 1.0 ? "solid" : "sparse";
    expectAboutTheSame(name);
    view.lastLayer = 14;
    expectAboutTheSame(name + "-half");
    view.firstLayer = 4;
    expectAboutTheSame(name + "-some");
    // So few that layers are left out.
    view.lastLayer = scene::kAllLayers;
    view.draggedTriangles = 2'500;
    expectAboutTheSame(name + "-few", 0.12);
  }
}

TEST_F(FastFrames, OfVoxels) {
  scene.setVoxels(scene::drawVoxels(test::lumpyBall(120), {.layerHeightMm = 2.0}));
  view.part = false;
  view.voxels = true;
  view.draggedTriangles = 10'000;
  expectAboutTheSame("voxels");
  view.lastLayer = 25;
  expectAboutTheSame("voxels-half");
  view.firstLayer = 12;
  expectAboutTheSame("voxels-some");
}

TEST_F(FastFrames, OfLayers) {
  scene.setLayers(scene::drawLayers(test::shellsOf(test::lumpyBall(140), 1.5)));
  view.part = false;
  view.layers = true;
  view.draggedTriangles = 10'000;
  expectAboutTheSame("layers", 0.07);
  view.lastLayer = 30;
  expectAboutTheSame("layers-half", 0.07);
}

TEST_F(FastFrames, DarkCornersKeepTheOutline) {
  scene.setVoxels(scene::drawVoxels(test::lumpyBall(60), {.layerHeightMm = 2.0}));
  scene.setPlatform(scene::drawPlatform(
      platform::PlatformSolid{{-60, -60}, {60, -60}, {60, 60}, {-60, 60}}, 80.0));
  view.part = false;
  view.voxels = true;
  const scene::Image plain = imageOf(false);
  view.ambientOcclusion = true;
  const scene::Image dark = imageOf(false);
  keep(plain, "corners-plain");
  keep(dark, "corners-dark");
  std::size_t darker = 0, brighter = 0;
  for (std::size_t i = 0; i < plain.rgb.size(); i += 3) {
    darker += dark.rgb[i + 1] + 12 < plain.rgb[i + 1];
    brighter += dark.rgb[i + 1] > plain.rgb[i + 1] + 12;
  }
  const std::size_t pixels = plain.rgb.size() / 3;
  EXPECT_GT(darker, pixels / 200);
  EXPECT_LT(darker, pixels / 3) << "not the whole picture";
  EXPECT_LT(brighter, pixels / 50);
  view.ambientOcclusion = false;
  EXPECT_EQ(imageOf(false).rgb, plain.rgb);
}

// A picture of 480 pixels with a part of 3 mm on a plate: its labels have little room.
TEST_F(FastFrames, LabelsOfASmallPartDoNotOverlap) {
  scene::SizeMarks marks(scene.renderer());
  const Eigen::AlignedBox3d part(Eigen::Vector3d(-1.5, -1.5, 0.0), Eigen::Vector3d(1.5, 1.5, 3.0));
  marks.show(part, {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}}, Eigen::Isometry3d::Identity());
  imageOf(false);
  for (const scene::StandardView from :
       {scene::StandardView::Isometric, scene::StandardView::Front, scene::StandardView::Top}) {
    scene.standardView(from);
    scene.lookAt(part.center(), 90.0);
    marks.update();
    const std::vector<Eigen::AlignedBox2d> areas = marks.areas();
    ASSERT_EQ(areas.size(), 4u);
    for (std::size_t i = 0; i < areas.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_TRUE(areas[i].intersection(areas[j]).isEmpty()) << i << " and " << j;
  }
}

} // namespace
