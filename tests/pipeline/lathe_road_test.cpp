// From parts to replayed programs around rods and on given surfaces.
#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/given_parameters.h"
#include "helpers/lathe_parts.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <string>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

using geometry::TriangleMesh;

base::RunContext context() {
  return base::RunContext(base::CancelToken(), 2);
}

std::shared_ptr<const LoadedPart> loaded(TriangleMesh mesh) {
  return loadedFrom("part.stl", std::make_shared<TriangleMesh>(std::move(mesh)), {}, true, {});
}

PlanRequest latheRequest(TriangleMesh part,
                         const std::map<std::string, std::string>& parameters = {}) {
  PlanRequest request;
  request.item().loaded = loaded(std::move(part));
  request.choices.item().mode = "lathe";
  request.choices.cell = "lathe";
  request.choices.tool().process = "fdm-0.35";
  request.choices.item().platform = project::Platform("rod:5x200");
  request.choices.formats = {"rapid"};
  test::giveParameters(request.choices, parameters);
  return request;
}

// Of layers of one height; shorter than life along x, so that a plan takes seconds.
TriangleMesh shortened(const std::vector<Eigen::Vector2d>& section) {
  TriangleMesh part = test::revolved(section, 192);
  for (Eigen::Vector3d& p : part.vertices)
    p.x() *= 0.3;
  return part;
}

void expectPrinted(const PlanResult& planned, const std::string& name) {
  const Report& r = planned.job.report;
  for (const plan::Finding& f : r.findings)
    EXPECT_FALSE(f.blocking) << name << ": " << plan::reportId(f) << ": "
                             << voluta::plan::englishReason(f);
  EXPECT_TRUE(nothingBlocks(r)) << name;
  EXPECT_TRUE(r.replay.passed) << name;
  EXPECT_EQ(r.motion.unreachable, 0u) << name;
  EXPECT_EQ(r.replay.collisions, 0u) << name;
  const double printed = geometry::volume(planned.job.item().printed());
  EXPECT_NEAR(r.item().layers.areaMm2 * r.item().layers.thicknessMeanMm / printed, 1.0, 2e-3)
      << name;
  EXPECT_NEAR(r.toolpath.materialMm3 / printed, 1.0, 0.03) << name;
}

TEST(LatheRoad, Tube) {
  // As it comes from a drawing: anywhere, its axis along z.
  TriangleMesh part = test::revolved(test::tubeSection(), 256);
  for (Eigen::Vector3d& p : part.vertices)
    p = Eigen::Vector3d(p.y() + 30, p.z() - 7, p.x() + 12);
  const PlanResult planned = planPart(latheRequest(std::move(part)), context());
  expectPrinted(planned, "tube");
  const Report& r = planned.job.report;
  EXPECT_EQ(r.item().decomposition.pieces, 1);
  EXPECT_EQ(r.item().decomposition.layers, 10);
  EXPECT_EQ(r.item().decomposition.riskyAreaMm2, 0.0);
  EXPECT_EQ(r.item().layers.count, 10);
  const Eigen::AlignedBox3d box = r.item().model.boundsMm;
  EXPECT_NEAR((box.min() - Eigen::Vector3d(-25, -5, -5)).norm(), 0.0, 1e-3);
  ASSERT_TRUE(planned.job.item().platform.rod);
  EXPECT_EQ(planned.job.item().platform.rod->profile.front(), Eigen::Vector2d(-100, 2.5));
}

TEST(LatheRoad, Shoulders) {
  expectPrinted(planPart(latheRequest(shortened(test::shoulderSection())), context()), "shoulders");
}
TEST(LatheRoad, TaperedEnds) {
  std::vector<Eigen::Vector2d> section = test::taperedSection();
  expectPrinted(planPart(latheRequest(shortened(section)), context()), "tapered");
}
TEST(LatheRoad, HexagonalRod) {
  expectPrinted(
      planPart(latheRequest(test::hexagonalTube(4.8, 10, 15), {{"rodSides", "6"}}), context()),
      "hexagonal rod");
}
TEST(LatheRoad, HalfTurnSector) {
  PlanRequest request = latheRequest(test::halfTube(4.8, 10, 15));
  expectPrinted(planPart(request, context()), "sector");
}

// Layers on a body from a file, in the files' own coordinates.
class SurfaceRoad : public ::testing::Test {
protected:
  PlanRequest request(const TriangleMesh& body, TriangleMesh part,
                      std::map<std::string, std::string> parameters) const {
    const std::filesystem::path file = folder_ / "body.stl";
    base::writeFile(file, geometry::writeStl(body));
    PlanRequest made;
    made.item().loaded = loaded(std::move(part));
    made.choices.item().mode = "substrate";
    made.choices.tool().process = "fdm-0.35";
    made.choices.item().platform = project::Platform("mesh:" + file.string());
    made.choices.formats = {"urscript"};
    parameters.insert({"layerHeightMm", "0.2"});
    test::giveParameters(made.choices, parameters);
    return made;
  }
  const test::TemporaryFolder folder_;
};

constexpr double kHatch = 0.657079633; // table 5.1, h 0.2

TEST_F(SurfaceRoad, RibOverAGableRoof) {
  // Both moved equally: the platform's body is in the middle, the rib moves with it.
  TriangleMesh body = test::gableRoof(40, 30),
               part = test::gableRib(40, 10 * kHatch, 0.25 + 9 * 0.2, 20);
  for (TriangleMesh* mesh : {&body, &part})
    for (Eigen::Vector3d& p : mesh->vertices)
      p += Eigen::Vector3d(31, -17, 4);
  const PlanResult planned = planPart(request(body, part, {{"firstLayerMm", "0.25"}}), context());
  expectPrinted(planned, "gable roof");
  EXPECT_EQ(planned.job.report.item().layers.count, 10);
  EXPECT_NEAR(planned.job.report.item().model.boundsMm.min().z(), 20.0, 1e-4);
  EXPECT_NEAR(planned.job.report.item().model.boundsMm.center().x(), 0.0, 1e-4);
  EXPECT_EQ(planned.job.item().platform.polygon.size(), 4u);
}

TEST_F(SurfaceRoad, RibOnAHalfCylinder) {
  const PlanResult planned = planPart(
      request(test::halfCylinder(40, 30), test::halfCylinderRib(40, 10 * kHatch, 2.05, 1.1),
              {{"firstLayerMm", "0.25"}, {"layerShape", "cylinder"}}),
      context());
  expectPrinted(planned, "half cylinder");
  EXPECT_EQ(planned.job.report.item().layers.count, 10);
}

TEST_F(SurfaceRoad, PentagonThatFlattens) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * base::kPi * i / 5 + 0.3;
    corners.emplace_back(6 * std::cos(a), 6 * std::sin(a), 17);
  }
  const PlanResult planned =
      planPart(request(test::halfCylinder(40, 30), test::drawnOut(corners, {0, 0, 4.5}),
                       {{"layerShape", "flatten"}}),
               context());
  expectPrinted(planned, "pentagon");
}

TEST(LatheRoad, CandelabrumGivesLayersAndAnOverhangFinding) {
  VOLUTA_MODEL_OR_SKIP(file, "candelabrum_tentacles.stl");
  PlanRequest request = latheRequest(geometry::readMesh(file).mesh, {{"rodAxis", "z"}});
  request.choices.tool().process = "fdm-1.0";
  request.until = Stage::Layers;
  const PlanResult planned = planPart(request, context());
  EXPECT_GT(planned.job.report.item().layers.count, 20);
  for (const plan::Finding& f : planned.job.report.findings) {
    EXPECT_FALSE(voluta::plan::englishReason(f).empty());
    EXPECT_FALSE(voluta::plan::englishRemedy(f).empty());
  }
  EXPECT_TRUE(std::any_of(
      planned.job.report.findings.begin(), planned.job.report.findings.end(),
      [](const plan::Finding& f) { return voluta::plan::reportId(f) == "overhang" && f.where; }));
}

void expectRefusal(const PlanRequest& request, base::ErrorCode code, const std::string& what) {
  try {
    planPart(request, context());
    ADD_FAILURE() << what;
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), code) << e.what();
    EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    EXPECT_TRUE(!e.remedy().empty() || code == base::ErrorCode::UnreadableFile) << what;
  }
}

TEST(LatheRoad, BadInputGivesAnErrorOfOneLine) {
  const TriangleMesh tube = test::revolved(test::tubeSection(), 96);
  const auto with = [&](auto&& change, TriangleMesh part) {
    PlanRequest request = latheRequest(std::move(part));
    request.until = Stage::Layers;
    change(request.choices);
    return request;
  };
  using base::ErrorCode;
  expectRefusal(with([](Choices& c) { c.item().platform = project::Platform("rod:12x200"); }, tube),
                ErrorCode::UnusableInput, "the rod is thicker than the part");
  expectRefusal(with([](Choices& c) { c.item().platform = project::Platform("rod:5x300"); }, tube),
                ErrorCode::UnusableInput, "the cell has room for 100");
  expectRefusal(with([](Choices& c) { c.item().platform = project::Platform("rod:5x40"); }, tube),
                ErrorCode::UnusableInput, "beyond an end of the rod");
  expectRefusal(with([](Choices& c) { c.item().placement.centreMm.y() = 20; }, tube),
                ErrorCode::UnusableInput, "the part misses the rod");
  expectRefusal(with([](Choices& c) { c.cell = "ur5-fixed"; }, tube), ErrorCode::Usage, "has none");
  expectRefusal(with([](Choices& c) { c.item().platform = project::Platform("disc:80"); }, tube),
                ErrorCode::Usage, "does not print on platform disc");
  expectRefusal(with([](Choices& c) { c.item().parameters["orient"] = "leastRisky"; }, tube),
                ErrorCode::Usage, "orient=leastRisky");
  expectRefusal(with([](Choices& c) { c.item().parameters["rodProfile"] = "1,2 x"; }, tube),
                ErrorCode::Usage, "'x' is neither a pair");
  expectRefusal(with([](Choices& c) { c.item().parameters["firstLayerMm"] = "2"; }, tube),
                ErrorCode::Usage, "outside the limits of process fdm-0.35");
  expectRefusal(with([](Choices&) {}, test::box({-5, -5, -5}, {5, 5, 5})), ErrorCode::UnusableInput,
                "no clear axis");
  expectRefusal(
      with([](Choices& c) { c.item().platform = project::Platform("mesh:nowhere.stl"); }, tube),
      ErrorCode::UnreadableFile, "no such file");
}

TEST(LatheRoad, APartBeyondTheCellsRadiusIsAFinding) {
  PlanRequest request = latheRequest(
      test::revolved({{-5, 2}, {-5, 4}, {-1, 4}, {-1, 51}, {1, 51}, {1, 4}, {5, 4}, {5, 2}}, 64));
  request.choices.tool().process = "fdm-1.0";
  request.until = Stage::Decompose;
  const PlanResult planned = planPart(request, context());
  const plan::Findings& findings = planned.job.report.findings;
  const auto found = std::find_if(findings.begin(), findings.end(), [](const plan::Finding& f) {
    return voluta::plan::reportId(f) == "beyondCell";
  });
  ASSERT_NE(found, findings.end());
  EXPECT_TRUE(found->blocking);
  EXPECT_NEAR(found->where->tail<2>().norm(), 51.0, 1e-6);
  EXPECT_EQ(planned.job.report.item().decomposition.riskyAreaMm2,
            0.0); // the disc's sides are upright
}

TEST(LatheRoad, ScaleFitKeepsWithinTheCellsRadiusAndTheRodsLength) {
  const auto scaleOf = [](double length, double radius) {
    PlanRequest request = latheRequest(test::revolved(
        {{-length / 2, 2}, {-length / 2, radius}, {length / 2, radius}, {length / 2, 2}}, 64));
    request.choices.item().scale = "fit";
    request.until = Stage::Load;
    return planPart(request, context()).job.item().scale;
  };
  EXPECT_NEAR(scaleOf(100, 20), 1.0, 1e-8);
  EXPECT_NEAR(scaleOf(100, 200), 0.25, 1e-8);
  EXPECT_NEAR(scaleOf(400, 20), 0.5, 1e-8);
}

TEST(LatheRoad, AProfileIsPutIntoTheRod) {
  PlanRequest request =
      latheRequest(test::revolved(test::tubeSection(), 96), {{"rodProfile", "-10,3 0,3.5"}});
  request.choices.item().platform = project::Platform("fit");
  request.until = Stage::Decompose;
  const PlanResult planned = planPart(request, context());
  const std::vector<Eigen::Vector2d> expected{{-100, 2.5}, {-10, 2.5}, {-10, 3},
                                              {0, 3.5},    {0, 2.5},   {100, 2.5}};
  EXPECT_EQ(planned.job.item().platform.rod->profile, expected);
}

TEST(LatheRoad, ABodyOnTheRodIsTakenOutOfThePartToo) {
  const test::TemporaryFolder folder;
  TriangleMesh part = test::revolved(test::tubeSection(), 128),
               collar = test::revolved({{-10, 2}, {-10, 3.5}, {10, 3.5}, {10, 2}}, 128);
  for (TriangleMesh* mesh : {&part, &collar})
    for (Eigen::Vector3d& p : mesh->vertices)
      p = Eigen::Vector3d(p.y() + 30, p.z() - 7, p.x() + 12);
  base::writeFile(folder / "collar.stl", geometry::writeStl(collar));
  PlanRequest request = latheRequest(part);
  request.choices.item().platform = project::Platform("mesh:" + (folder / "collar.stl").string());
  request.until = Stage::Layers;
  const PlanResult planned = planPart(request, context());
  const double pi = base::kPi;
  EXPECT_NEAR(geometry::volume(planned.job.item().printed()) /
                  (pi * (25 * 50 - 6.25 * 30 - 12.25 * 20)),
              1.0, 2e-3);
  EXPECT_TRUE(nothingBlocks(planned.job.report));
  ASSERT_TRUE(planned.job.item().platform.rod && planned.job.item().platform.mesh);
  EXPECT_NEAR(geometry::bounds(*planned.job.item().platform.mesh).max().x(), 10.0, 1e-4);
}

} // namespace
