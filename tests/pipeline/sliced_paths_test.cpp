// G-code of slicers ends as checked programs: of a block, a vase and a kitten, in the manner of
// three slicers and by PrusaSlicer itself, flat, tilted by 30 degrees and on a cylinder.
#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "box_request.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/all_seeds.h"
#include "helpers/given_parameters.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "process/bead_model.h"
#include "process/bead_to.h"
#include "project/job.h"
#include "sliced/slicer_writer.h"
#include "sliced/spiral_writer.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;
using test::Manner;

namespace {

const base::RunContext kCtx;

using Parameters = std::map<std::string, std::string>;

struct Ground {
  const char* name;
  Parameters parameters;
  double rotationDeg = 0.0; // About x
};
const Ground kGrounds[] = {{"plate", {}},
                           {"30 degrees", {{"pathsOn", "plane"}}, 30.0},
                           {"cylinder", {{"pathsOn", "cylinder"}, {"pathsRadiusMm", "80"}}}};

PlanRequest requestFor(const std::filesystem::path& file, const Ground& ground = kGrounds[0]) {
  PlanRequest request;
  request.item().part = file.string();
  request.choices.item().automatic = true;
  test::giveParameters(request.choices, ground.parameters);
  if (ground.rotationDeg != 0.0)
    request.choices.item().placement.rotation =
        Eigen::AngleAxisd(base::degreesToRadians(ground.rotationDeg), Eigen::Vector3d::UnitX());
  request.choices.formats = {"urscript"};
  return request;
}

PlanResult plannedFrom(const std::string& text, const Ground& ground, project::Stage until) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "part.gcode", text);
  PlanRequest request = requestFor(folder / "part.gcode", ground);
  request.until = until;
  return planPart(request, kCtx);
}

// The flat tool-paths of a part.
plan::ToolPlan flatPaths(const std::string& part, const Parameters& parameters,
                         const std::string& scale = "1") {
  PlanRequest request;
  request.item().part = part;
  request.choices.item().mode = "flat";
  request.choices.item().scale = scale;
  test::giveParameters(request.choices, parameters);
  request.until = project::Stage::Toolpath;
  return *planPart(request, kCtx).job.toolPlan;
}

plan::ToolPlan blockPaths(const Parameters& parameters = {}) {
  PlanRequest request = test::boxRequest(parameters);
  request.choices.item().mode = "flat";
  request.until = project::Stage::Toolpath;
  return *planPart(request, kCtx).job.toolPlan;
}

// As far as the tool-paths on every ground, in every manner; then one program of each manner, each
// on another ground.
void expectAllManners(const plan::ToolPlan& paths) {
  std::size_t round = 0;
  for (const Manner manner : test::kManners) {
    const test::Written written = test::writtenBy(manner, paths);
    for (const Ground& ground : kGrounds) {
      const std::string name = std::string(test::nameOf(manner)) + ", " + ground.name + ": ";
      const bool replayed = &ground == &kGrounds[round % std::size(kGrounds)];
      const PlanResult planned = plannedFrom(
          written.text, ground, replayed ? project::Stage::Replay : project::Stage::Toolpath);
      EXPECT_TRUE(nothingBlocks(planned.job.report)) << name << test::reasons(planned);
      EXPECT_EQ(planned.job.report.replay.passed, replayed) << name << test::reasons(planned);
      EXPECT_NEAR(planned.job.report.toolpath.lengthMm, written.lengthMm, 1e-3 * written.lengthMm)
          << name;
      EXPECT_NEAR(planned.job.report.toolpath.materialMm3, written.volumeMm3,
                  1e-3 * written.volumeMm3)
          << name;
    }
    ++round;
  }
}

// Beads of the height of their layers, as slicers write them.
const Parameters kPlain{{"rimSupports", "none"}, {"prime", "none"}};

void addRing(plan::ToolPlan& plan, int layer, double radius, double z, double height, int ring) {
  constexpr int kSides = 90;
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.count = kSides + 1;
  path.layer = layer;
  path.ring = ring;
  path.closed = true;
  for (int k = 0; k <= kSides; ++k) {
    const double angle = 2.0 * base::kPi * (k % kSides) / kSides;
    plan.position.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    plan.direction.push_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(static_cast<float>(height));
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back(path);
}

// A vase of two walls with a waist, on a bottom of two layers of rings.
plan::ToolPlan vasePaths() {
  constexpr double kHeight = 0.6;
  constexpr int kLayers = 24;
  const double hatch = process::hatchOf(1.2, kHeight);
  plan::ToolPlan plan;
  for (int layer = 0; layer < kLayers; ++layer) {
    const double z = (layer + 1) * kHeight, outer = 14.0 + 2.0 * std::cos(z / 4.0);
    const int rings = layer < 2 ? static_cast<int>(outer / hatch) : 2;
    for (int ring = 0; ring < rings; ++ring)
      addRing(plan, layer, outer - ring * hatch, z, kHeight, ring);
  }
  return plan;
}

TEST(SlicedPaths, ABlockInEveryManner) {
  expectAllManners(blockPaths(kPlain));
}

TEST(SlicedPaths, ABlockWithSparseInfillInEveryManner) {
  Parameters parameters = kPlain;
  parameters["infillDensity"] = "0.4";
  expectAllManners(blockPaths(parameters));
}

TEST(SlicedPaths, AVaseInEveryManner) {
  expectAllManners(vasePaths());
}

// One wall that rises without a stop, in every manner: as far as the tool-paths, and one program of
// each spiral and each manner.
TEST(SlicedPaths, SpiralVases) {
  const test::Spiral kSpirals[] = {test::cylinderSpiral(), test::squareSpiral(),
                                   test::twistedSpiral()};
  std::size_t round = 0;
  for (const test::Spiral& spiral : kSpirals)
    for (const Manner manner : test::kManners) {
      const test::Written written = test::spiralBy(manner, spiral);
      const bool replayed = round % 4 == 0 || test::allSeeds();
      const Ground& ground = kGrounds[round++ % 2];
      const std::string name = std::string(test::nameOf(manner)) + ", " + ground.name +
                               ", spiral " + std::to_string((round - 1) / 3) + ": ";
      const PlanResult planned = plannedFrom(
          written.text, ground, replayed ? project::Stage::Replay : project::Stage::Toolpath);
      EXPECT_TRUE(nothingBlocks(planned.job.report)) << name << test::reasons(planned);
      EXPECT_EQ(planned.job.report.replay.passed, replayed) << name << test::reasons(planned);
      EXPECT_NEAR(planned.job.report.toolpath.materialMm3, written.volumeMm3,
                  1e-3 * written.volumeMm3)
          << name;
    }
}

TEST(SlicedPaths, AKittenInEveryManner) {
  VOLUTA_MODEL_OR_SKIP(kitten, "kitten.stl");
  expectAllManners(flatPaths(kitten.string(), kPlain, "0.4"));
}

// The volume of skirts, which are not the part's material.
double wasteMm3(const plan::ToolPlan& plan) {
  double mm3 = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; plan::isWaste(path.kind) && i < path.first + path.count;
         ++i)
      mm3 += process::beadTo(plan, i);
  return mm3;
}

TEST(SlicedPaths, ByPrusaSlicer) {
  if (std::system("prusa-slicer --help > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "prusa-slicer is not installed";
  const test::TemporaryFolder folder;
  base::writeFile(folder / "block.stl", geometry::writeStl(test::box({0, 0, 0}, {24, 20, 8})));
  std::vector<std::pair<std::string, std::string>> parts{{(folder / "block.stl").string(), "1"}};
  if (const auto kitten = test::modelFolder() / "kitten.stl"; std::filesystem::exists(kitten))
    parts.emplace_back(kitten.string(), "0.4");
  for (const auto& [part, scale] : parts) {
    const std::string file = (folder / "sliced.gcode").string();
    const std::string command =
        "prusa-slicer --export-gcode --nozzle-diameter 1.0 --layer-height 0.6 "
        "--first-layer-height 0.6 --fill-density 30% --fill-pattern rectilinear --scale " +
        scale + " -o '" + file + "' '" + part + "' > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const std::string text = base::readFile(file);
    const std::string said = "; filament used [mm] = ";
    const std::size_t at = text.find(said);
    ASSERT_NE(at, std::string::npos);
    const double usedMm3 = std::stod(text.substr(at + said.size())) * base::kPi / 4.0 * 1.75 * 1.75;
    for (const Ground& ground : kGrounds) {
      const PlanResult planned = planPart(requestFor(file, ground), kCtx);
      EXPECT_TRUE(planned.job.report.replay.passed)
          << part << ", " << ground.name << ": " << test::reasons(planned);
      EXPECT_NEAR(planned.job.report.toolpath.materialMm3 + wasteMm3(*planned.job.toolPlan),
                  usedMm3, 1e-3 * usedMm3)
          << part << ", " << ground.name;
    }
  }
}

// The block's infill by T1.
std::string twoToolBlock() {
  plan::ToolPlan paths = blockPaths(kPlain);
  const std::string text = test::writtenBy(Manner::Cura, paths).text;
  std::string two;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size() - 1);
    const std::string line = text.substr(from, to + 1 - from);
    if (line.starts_with(";TYPE:"))
      two += line.starts_with(";TYPE:WALL") ? "T0\n" : "T1\n";
    two += line;
    from = to + 1;
  }
  return two;
}

std::ptrdiff_t toolNotes(const PlanResult& planned) {
  return std::ranges::count(base::english(planned.job.report.item().model.repairs),
                            "the job has 1 tool: its first tool prints the file's beads of T1");
}

TEST(SlicedPaths, ToolsOfTheFileAreThoseOfTheJob) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "part.gcode", twoToolBlock());
  PlanRequest request = requestFor(folder / "part.gcode");
  {
    PlanRequest one = request;
    one.until = project::Stage::Toolpath;
    const PlanResult planned = planPart(one, kCtx);
    EXPECT_EQ(toolNotes(planned), 1);
    EXPECT_TRUE(std::ranges::all_of(planned.job.toolPlan->paths,
                                    [](const plan::ToolPath& path) { return path.tool == 0; }));
  }
  request.choices.tools.push_back(project::ToolChoice{});
  const PlanResult planned = planPart(request, kCtx);
  for (const plan::ToolPath& path : planned.job.toolPlan->paths)
    EXPECT_EQ(path.tool, path.kind == plan::PathKind::Wall ? 0 : 1);
  EXPECT_EQ(toolNotes(planned), 0);
  EXPECT_TRUE(planned.job.report.replay.passed) << test::reasons(planned);
  EXPECT_GT(planned.job.report.motion.toolChanges, 3u);
}

TEST(SlicedPaths, AProjectKeepsThemAsTheyWereRead) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "part.gcode", test::writtenBy(Manner::Cura, blockPaths()).text);
  PlanRequest request = requestFor(folder / "part.gcode", kGrounds[2]);
  request.until = project::Stage::Toolpath;
  const PlanResult planned = planPart(request, kCtx);
  project::writeJob(folder / "job.voluta", planned.job);
  const project::Job again = project::readJob(folder / "job.voluta", allParameters());
  ASSERT_TRUE(again.item().loaded->toolPaths);
  EXPECT_EQ(again.item().loaded->hash, planned.job.item().loaded->hash);
  PlanRequest same;
  same.item().loaded = again.item().loaded;
  same.choices = again.choices;
  EXPECT_EQ(stageKeys(same)[project::indexOf(project::Stage::Toolpath)],
            again.stages[project::indexOf(project::Stage::Toolpath)].key);
  same.until = project::Stage::Toolpath;
  const PlanResult replanned = planPart(same, kCtx);
  EXPECT_EQ(replanned.job.toolPlan->waypointCount(), planned.job.toolPlan->waypointCount());
  ASSERT_TRUE(replanned.job.item().platform.mesh);
  // Each parameter of the shape changes the first stage.
  for (const auto& [key, value] : Parameters{{"pathsFlow", "110"},
                                             {"pathsTurn", "3"},
                                             {"pathsTurnBackMm", "2"},
                                             {"pathsOn", "sphere"},
                                             {"pathsRadiusMm", "70"},
                                             {"pathsKeep", "angles"},
                                             {"pathsFrame", "1,2,3,0,0,0"}}) {
    PlanRequest changed = same;
    test::giveParameter(changed.choices, key, value);
    EXPECT_NE(stageKeys(changed)[0], stageKeys(same)[0]) << key;
  }
}

TEST(SlicedPaths, ProgramsDoNotReplaceTheFileTheyWereMadeFrom) {
  const test::TemporaryFolder folder;
  const std::string text = test::writtenBy(Manner::Cura, blockPaths(kPlain)).text;
  base::writeFile(folder / "part.gcode", text);
  PlanRequest request = requestFor(folder / "part.gcode");
  request.choices.formats = {"urscript", "gcode-extended"};
  PlanResult planned = planPart(request, kCtx);
  writeOutputs(planned, folder.path(), kCtx);
  EXPECT_EQ(base::readFile(folder / "part.gcode"), text);
  EXPECT_TRUE(std::filesystem::exists(folder / "robot_part.gcode"));
}

TEST(SlicedPaths, OnAPlaneOfAnotherBody) {
  // A block of 60 x 30 x 40 mm; the paths go onto its side towards -y.
  const test::TemporaryFolder folder;
  base::writeFile(folder / "body.stl", geometry::writeStl(test::box({-30, -15, 0}, {30, 15, 40})));
  base::writeFile(folder / "part.gcode",
                  test::writtenBy(Manner::PrusaSlicer, blockPaths({{"prime", "none"}})).text);
  PlanRequest request = requestFor(folder / "part.gcode");
  request.choices.item().automatic = false;
  request.choices.item().mode = "substrate";
  request.choices.item().platform = project::Platform("mesh:" + (folder / "body.stl").string());
  test::giveParameters(request.choices, {{"pathsFrame", "0,-15,20,90,0,0"}, {"prime", "none"}});
  request.until = project::Stage::Toolpath;
  const PlanResult planned = planPart(request, kCtx);
  for (std::size_t i = 0; i < planned.job.toolPlan->waypointCount(); ++i) {
    EXPECT_LT((planned.job.toolPlan->direction[i] + Eigen::Vector3d::UnitY()).norm(), 1e-9);
    EXPECT_LT(planned.job.toolPlan->position[i].y(), -15.0);
    EXPECT_NEAR(planned.job.toolPlan->position[i].z(), 20.0, 12.0);
  }
}

TEST(SlicedPaths, BadInputIsOneLine) {
  const auto refusal = [](const std::string& text, const Parameters& parameters) {
    try {
      plannedFrom(text, {"", parameters}, project::Stage::Toolpath);
    } catch (const base::Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string block = test::writtenBy(Manner::Cura, blockPaths()).text;
  EXPECT_NE(refusal("G28\nG1 X1 E1 F-3\n", {}).find("part.gcode, line 2: a speed"),
            std::string::npos);
  EXPECT_NE(refusal(block, {{"pathsFrame", "1,2"}}).find("is not a frame (write x,y,z,a,b,c"),
            std::string::npos);
  EXPECT_NE(refusal(block, {{"pathsOn", "cylinder"}, {"pathsRadiusMm", "0"}}).find("give at least"),
            std::string::npos);
  EXPECT_NE(
      refusal(block, {{"pathsOn", "sphere"}, {"pathsRadiusMm", "4"}}).find("round the ground"),
      std::string::npos);
}

} // namespace
