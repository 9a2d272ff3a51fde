// Pictures themselves, and the command that makes them with and without a display.
#include "base/error.h"
#include "base/files.h"
#include "curved/decomposition.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pictures/job_picture.h"
#include "process/process.h"
#include "project/job.h"
#include "project/loaded_part.h"
#include "robot/cell.h"
#include "robot/shape/arm_look.h"
#include "scene/offscreen_target.h"

#include <EGL/egl.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <sys/wait.h>
#include <thread>
#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace fs = std::filesystem;

namespace {
using namespace voluta;

struct Pixel {
  int r, g, b;
  bool red() const { return r > 150 && g < r / 2 && b < r / 2; }
};

Pixel at(const scene::Image& image, int x, int y) {
  const auto* p = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
  return {p[0], p[1], p[2]};
}

std::size_t redPixels(const scene::Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      count += at(image, x, y).red();
  return count;
}

scene::Image picture(scene::Scene& scene, const scene::ViewState& view,
                     scene::StandardView from = scene::StandardView::Isometric) {
  scene.setView(view);
  scene::OffscreenTarget target;
  return target.imageOf(scene, 320, 200, [&] { scene.standardView(from); });
}

TEST(Render, PartIsInTheMiddleAndTheBackgroundAround) {
  scene::Scene scene(scene::lightTheme());
  scene.setPart(scene::drawPart(test::sphere({0, 0, 20}, 20)));
  const scene::Image image = picture(scene, {});
  ASSERT_EQ(image.rgb.size(), 3u * 320 * 200);
  const Pixel middle = at(image, 160, 100), corner = at(image, 310, 10);
  EXPECT_GT(middle.b, middle.r + 5) << "grey-blue";
  EXPECT_GT(corner.r, 225);
  EXPECT_LT(middle.r, corner.r - 20);
}

TEST(Render, ARodHasNoGroundAroundItAndIsFramedBesideThePart) {
  platform::PlatformSolid platform;
  platform.rod = platform::straightRod(5.0, 200.0);
  scene::Scene scene(scene::lightTheme());
  scene.setPlatform(scene::drawPlatform(platform, 100.0));
  const scene::Image rod = picture(scene, {}, scene::StandardView::Front);
  scene::Scene empty(scene::lightTheme());
  const scene::Image nothing = picture(empty, {}, scene::StandardView::Front);
  const auto differing = [&](int y) {
    int count = 0;
    for (int x = 40; x < 280; ++x)
      count += at(rod, x, y).r != at(nothing, x, y).r;
    return count;
  };
  EXPECT_GT(differing(100), 200);
  for (const int y : {40, 70, 130})
    EXPECT_EQ(differing(y), 0) << y;

  // 20 mm of a rod of 200: the shown part is on it.
  scene.setPart(scene::drawPart(test::box({-10, -8, -8}, {10, 8, 8})));
  const scene::Image part = picture(scene, {}, scene::StandardView::Front);
  int covered = 0;
  for (int x = 0; x < 320; ++x)
    covered += at(part, x, 110).b > at(part, x, 110).r + 5;
  EXPECT_GT(covered, 90);
}

TEST(Render, ThePlateOfACellIsThereAndFramedWithThePlatform) {
  const std::vector<Eigen::Vector2d> plate{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  const robot::Cell cell = robot::loadCell("ur5-fixed", process::loadProcess("fdm-1.0"), plate);
  scene::Scene scene(scene::lightTheme());
  scene.setPlatform(scene::drawPlatform(plate, 0.0));
  EXPECT_EQ(picture(scene, {}).rgb.size(), 3u * 320 * 200);
  scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  scene::ViewState view;
  view.cell = true;
  view.world = scene::World::Base;
  const scene::Image with = picture(scene, view);
  view.roles[static_cast<std::size_t>(robot::BodyRole::Platform)] = false;
  EXPECT_NE(with.rgb, picture(scene, view).rgb);
}

TEST(Render, CheckedSolidsAreDrawnOverTheArmIfEnabled) {
  const std::vector<Eigen::Vector2d> plate{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  const robot::Cell cell = robot::loadCell("ur5-moving", process::loadProcess("fdm-1.0"), plate);
  scene::Scene scene(scene::lightTheme());
  scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  scene::ViewState view;
  view.cell = true;
  view.world = scene::World::Base;
  const scene::Image arm = picture(scene, view);
  view.collisionSolids = true;
  const scene::Image both = picture(scene, view);
  int changed = 0;
  for (int y = 0; y < arm.height; ++y)
    for (int x = 0; x < arm.width; ++x)
      changed += at(arm, x, y).r != at(both, x, y).r;
  EXPECT_GT(changed, 1000);
  view.collisionSolids = false;
  EXPECT_EQ(arm.rgb, picture(scene, view).rgb);
}

TEST(Render, AViewThatDoesNotFrameTheCellShowsThePartInIt) {
  const std::vector<Eigen::Vector2d> plate{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  const robot::Cell cell = robot::loadCell("ur5-moving", process::loadProcess("fdm-1.0"), plate);
  scene::Scene scene(scene::lightTheme());
  scene.setPart(scene::drawPart(test::sphere({0, 0, 20}, 20)));
  scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  const auto distance = [&](const scene::ViewState& view) {
    picture(scene, view);
    return scene.renderer()->GetActiveCamera()->GetDistance();
  };
  scene::ViewState view;
  const double part = distance(view);
  view.cell = true;
  const double all = distance(view);
  EXPECT_GT(all, 4.0 * part);
  view.cellFramed = false;
  EXPECT_LT(distance(view), 0.8 * all);
  EXPECT_GT(distance(view), 2.0 * part);
}

// Of a part that is cut open the underside is seen from inside, and the plate not through it.
TEST(Render, ThePlateOfACellDoesNotFlickerThroughThePart) {
  const std::vector<Eigen::Vector2d> plate{{-60, -60}, {60, -60}, {60, 60}, {-60, 60}};
  const robot::Cell cell = robot::loadCell("ur5-moving", process::loadProcess("fdm-1.0"), plate);
  scene::Scene scene(scene::lightTheme());
  scene.setPart(scene::drawPart(test::box({-40, -40, 0}, {40, 40, 20})));
  scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  scene::ViewState view;
  view.cell = true;
  view.cellFramed = false;
  view.roles = {};
  view.sectionOn = true;
  view.sectionNormal = -Eigen::Vector3d::UnitY();
  scene.setView(view);
  scene::OffscreenTarget target;
  const auto taken = [&](bool part, bool platform) {
    view.part = part;
    view.roles[static_cast<std::size_t>(robot::BodyRole::Platform)] = platform;
    return target.imageOf(scene, 320, 200, [&] {
      scene.setView(view);
      scene.lookAt({0, 20, 10}, 60.0);
    });
  };
  const scene::Image nothing = taken(false, false), part = taken(true, false),
                     both = taken(true, true);
  int seen = 0, hidden = 0;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) {
      if (at(part, x, y).b == at(nothing, x, y).b)
        continue;
      ++seen;
      hidden += std::abs(at(both, x, y).b - at(part, x, y).b) > 8; // beige inside, grey plate
    }
  EXPECT_GT(seen, 5000);
  EXPECT_LT(hidden, 0.02 * seen); // at its edges
}

TEST(Camera, PrintIsFramedWithItsSurroundings) {
  using Eigen::Vector3d;
  const auto sizes = [](const Eigen::AlignedBox3d& box) { return box.sizes().transpose().eval(); };
  const Eigen::AlignedBox3d machine(Vector3d(-800, -100, -200), Vector3d(200, 100, 800));
  const auto cube = [](double edge) {
    return Eigen::AlignedBox3d(Vector3d(-edge, -edge, 0) / 2, Vector3d(edge, edge, 2 * edge) / 2);
  };
  // A third of the machine about a small print, three of its own lengths about a larger one.
  EXPECT_EQ(sizes(scene::printInMachine(cube(10), machine)), Eigen::RowVector3d(505, 200, 510));
  EXPECT_EQ(sizes(scene::printInMachine(cube(200), machine)), Eigen::RowVector3d(900, 200, 1000));
  EXPECT_EQ(sizes(scene::printInMachine(cube(10), {})), Eigen::RowVector3d(10, 10, 10));
  EXPECT_EQ(sizes(scene::printInMachine({}, machine)), sizes(machine));
}

TEST(Render, ARodIsSeenToTurnInItsCell) {
  platform::PlatformSolid platform;
  platform.rod = platform::straightRod(20.0, 200.0, 6);
  const robot::Cell cell = robot::loadCell("lathe", process::loadProcess("fdm-0.35"), platform);
  scene::Scene scene(scene::lightTheme());
  scene.setPlatform(scene::drawPlatform(platform, 0.0));
  scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  scene::ViewState view;
  view.cell = true;
  view.world = scene::World::Base;
  view.roles = {};
  view.roles[static_cast<std::size_t>(robot::BodyRole::Platform)] = true;
  view.joints = cell.home();
  const scene::Image still = picture(scene, view);
  view.joints[cell.armDof()] += 0.4;
  EXPECT_NE(still.rgb, picture(scene, view).rgb);
  view.roles = {};
  const scene::Image without = picture(scene, view);
  view.joints[cell.armDof()] += 0.4;
  EXPECT_EQ(without.rgb, picture(scene, view).rgb);
}

// The place of a finding is in the middle of its mark.
TEST(Render, MarkSurroundsItsPlaceAndHidesNothingThere) {
  scene::Scene scene(scene::lightTheme());
  scene.setPart(scene::drawPart(test::sphere({0, 0, 20}, 20)));
  const scene::Image without = picture(scene, {});
  scene::ViewState view;
  view.marker = Eigen::Vector3d(0, 0, 20); // inside: the mark is seen all the same
  const scene::Image with = picture(scene, view);
  int fromMiddle = 0, changed = 0;
  for (int y = 0; y < with.height; ++y)
    for (int x = 0; x < with.width; ++x) {
      const Pixel a = at(without, x, y), b = at(with, x, y);
      if (a.r == b.r && a.g == b.g && a.b == b.b)
        continue;
      ++changed;
      fromMiddle += std::hypot(x - 160, y - 100) > 2.0;
    }
  EXPECT_GT(changed, 20);
  EXPECT_EQ(fromMiddle, changed);
}

TEST(Render, SamePictureTwice) {
  scene::Scene scene(scene::darkTheme());
  scene.setPart(scene::drawPart(test::sphere({0, 0, 20}, 20)));
  const scene::Image first = picture(scene, {});
  EXPECT_EQ(first.rgb, picture(scene, {}).rgb);
}

// All pictures of a process are drawn on one display, and one that is done leaves it to the others.
TEST(Render, PicturesAreDrawnSideBySide) {
  scene::Scene first(scene::lightTheme()), second(scene::lightTheme());
  for (scene::Scene* scene : {&first, &second})
    scene->setPart(scene::drawPart(test::sphere({0, 0, 20}, 20)));
  const scene::Image alone = picture(first, {});
  auto ended = std::make_unique<scene::OffscreenTarget>();
  scene::OffscreenTarget target;
  ended.reset();
  second.setView({});
  const scene::Image after = target.imageOf(
      second, 320, 200, [&] { second.standardView(scene::StandardView::Isometric); });
  EXPECT_EQ(after.rgb, alone.rgb);

  constexpr int kPictures = 6;
  int same = 0;
  std::thread other([&] {
    for (int i = 0; i < kPictures; ++i)
      same += picture(first, {}).rgb == alone.rgb;
  });
  scene::Scene third(scene::lightTheme());
  third.setPart(scene::drawPart(test::sphere({0, 0, 20}, 20)));
  for (int i = 0; i < kPictures; ++i)
    EXPECT_EQ(picture(third, {}).rgb, alone.rgb) << i;
  other.join();
  EXPECT_EQ(same, kPictures);
}

TEST(Render, MissedVoxelsShineThroughAndNothingElseIsRed) {
  curved::Decomposition d;
  d.grid.size = {9, 9, 9};
  for (std::size_t c = 0; c < d.grid.cellCount(); ++c)
    d.rank.push_back(d.grid.cell(c).z() + 1);
  scene::ViewState view;
  view.part = false;
  view.voxels = true;
  scene::Scene scene(scene::lightTheme());
  scene.setVoxels(scene::drawVoxels(d));
  EXPECT_EQ(redPixels(picture(scene, view)), 0u);
  const auto before = picture(scene, view, scene::StandardView::Front);
  for (int i = 3; i < 6; ++i)
    d.rank[d.grid.index(i, 8, 4)] = -1; // at the back
  scene.setVoxels(scene::drawVoxels(d));
  const auto after = picture(scene, view, scene::StandardView::Front);
  EXPECT_GT(at(after, 160, 100).r, at(before, 160, 100).r + 30);
  EXPECT_GT(redPixels(picture(scene, view, scene::StandardView::Back)), 100u);
}

TEST(Render, GrowthShowsItsStepsTheFrontAndTheGhosts) {
  curved::Decomposition d;
  d.grid.size = {9, 9, 9};
  for (std::size_t c = 0; c < d.grid.cellCount(); ++c)
    d.rank.push_back(d.grid.cell(c).z() + 1);
  scene::VoxelLook look;
  look.bySteps = true;
  scene::Scene scene(scene::lightTheme());
  scene.setGrowth(scene::drawVoxels(d, look));
  scene.setFront(scene::drawFront(test::sphere({4.5, 4.5, 4.5}, 9.0)));
  scene::ViewState view;
  view.part = false;
  view.voxels = true;
  const auto coloured = [](const scene::Image& image) {
    std::size_t pink = 0, drawn = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const Pixel p = at(image, x, y);
        pink += p.r > p.g + 60 && p.b > p.g + 30;
        drawn += std::max({p.r, p.g, p.b}) - std::min({p.r, p.g, p.b}) > 40;
      }
    return std::pair(pink, drawn);
  };
  view.axes = false;
  view.growthStep = 0;
  EXPECT_EQ(coloured(picture(scene, view)).second, 0u) << "nothing is laid";
  view.growthStep = 4;
  const auto four = coloured(picture(scene, view));
  EXPECT_GT(four.first, 500u) << "the step being laid, from above";
  EXPECT_GT(four.second, four.first + 500u) << "those before it";
  const auto plain = picture(scene, view).rgb;
  view.ghosts = true;
  const auto ghosts = picture(scene, view).rgb;
  EXPECT_NE(plain, ghosts);
  view.front = true;
  EXPECT_NE(ghosts, picture(scene, view).rgb);
  view.growthStep = 9;
  EXPECT_GT(coloured(picture(scene, view)).second, four.second);
}

TEST(Render, SeenThroughOnlyMissedVoxelsKeepTheirColour) {
  curved::Decomposition d;
  d.grid.size = {9, 9, 9};
  for (std::size_t c = 0; c < d.grid.cellCount(); ++c)
    d.rank.push_back(d.grid.cell(c).z() + 1);
  for (int i = 3; i < 6; ++i)
    d.rank[d.grid.index(i, 4, 4)] = -1; // in the heart
  scene::Scene scene(scene::lightTheme());
  scene.setVoxels(scene::drawVoxels(d));
  scene::ViewState view;
  view.part = false;
  view.voxels = true;
  const auto fullRed = [&] {
    const scene::Image image = picture(scene, view);
    std::size_t count = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        count += at(image, x, y).r > 170 && at(image, x, y).g < 70;
    return count;
  };
  EXPECT_EQ(fullRed(), 0u) << "tinted only";
  view.seeThrough = true;
  EXPECT_GT(fullRed(), 100u);
}

TEST(Render, WrongSizeIsRefused) {
  scene::Scene scene(scene::lightTheme());
  scene::OffscreenTarget target;
  EXPECT_THROW(target.imageOf(scene, 4, 4), base::Error);
  EXPECT_THROW(target.imageOf(scene, 100000, 400), base::Error);
}

project::Job ballJob() {
  project::Job job;
  job.item().partName = "ball.stl";
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(test::sphere({0, 0, 20}, 20));
  auto loaded = std::make_shared<project::LoadedPart>();
  loaded->name = job.item().partName;
  loaded->source = loaded->mesh = mesh;
  job.item().loaded = loaded;
  job.item().part = mesh;
  job.item().platform = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
  return job;
}

// A thread that has drawn frees OpenGL's data when it ends, which a thread of a pool does while the
// process ends.
TEST(JobPicture, LeavesNoOpenGlInTheCallingThread) {
  EGLenum left = EGL_NONE;
  std::thread asking([&] {
    pictures::PictureOptions options;
    options.show = "part";
    options.width = options.height = 64;
    EXPECT_EQ(pictures::jobPicture(ballJob(), options).width, 64);
    left = eglQueryAPI();
  });
  asking.join();
  EXPECT_EQ(left, static_cast<EGLenum>(EGL_OPENGL_ES_API)) << "the state of a new thread";
}

TEST(JobPicture, PassesOnWhyItCannotBeDrawn) {
  pictures::PictureOptions options;
  options.show = "layers";
  EXPECT_THROW(pictures::jobPicture(ballJob(), options), base::Error);
}

class RenderCommand : public ::testing::Test {
protected:
  void SetUp() override { project::writeJob(folder_ / "job.voluta", ballJob()); }

  int run(const std::string& before, const std::string& words) const {
    const std::string line = before + " " + VOLUTA_CLI + " render " +
                             (folder_ / "job.voluta").string() + " " + words + " 2> " +
                             (folder_ / "stderr").string();
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string picturePath(const char* name) const { return (folder_ / name).string(); }
  std::string complaint() const { return base::readFile(folder_ / "stderr"); }

  const test::TemporaryFolder folder_;
};

TEST_F(RenderCommand, SamePictureWithAndWithoutADisplay) {
  ASSERT_EQ(run("env -u DISPLAY -u WAYLAND_DISPLAY",
                "--show part --size 400x300 -o " + picturePath("a.png")),
            0)
      << complaint();
  const std::string bytes = base::readFile(picturePath("a.png"));
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  if (std::system("command -v xvfb-run > /dev/null") != 0)
    GTEST_SKIP() << "no xvfb-run";
  ASSERT_EQ(run("xvfb-run -a -s '-screen 0 800x600x24 +extension GLX'",
                "--show part --size 400x300 -o " + picturePath("b.png")),
            0)
      << complaint();
  EXPECT_EQ(bytes, base::readFile(picturePath("b.png")));
}

TEST_F(RenderCommand, NamesMissingResultsOfTheJobInOneLine) {
  for (const char* what : {"voxels", "layers", "paths", "robot"}) {
    EXPECT_EQ(run("", std::string("--show ") + what + " -o " + picturePath("none.png")), 3);
    const std::string line = complaint();
    EXPECT_NE(line.find("the job contains no"), std::string::npos) << line;
    EXPECT_NE(line.find("voluta-cli plan"), std::string::npos) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
    EXPECT_FALSE(fs::exists(picturePath("none.png")));
  }
}

TEST_F(RenderCommand, RefusesUnknownChoicesBeforeItDraws) {
  const std::string to = " -o " + picturePath("none.png");
  EXPECT_EQ(run("", "--show prat" + to), 2);
  EXPECT_NE(complaint().find("part"), std::string::npos);
  EXPECT_EQ(run("", "--show part --size 12" + to), 2);
  EXPECT_EQ(run("", "--show part --size 4x4" + to), 2);
  EXPECT_EQ(run("", "--show part --colour blu" + to), 2);
  EXPECT_EQ(run("", "--show part --view abovee" + to), 2);
  EXPECT_FALSE(fs::exists(picturePath("none.png")));
}

TEST_F(RenderCommand, UnwritablePlaceIsAnErrorAndLeavesNothing) {
  EXPECT_EQ(run("", "--show part -o " + (folder_ / "missing" / "a.png").string()), 2);
  EXPECT_FALSE(fs::exists(folder_ / "missing"));
}

} // namespace
