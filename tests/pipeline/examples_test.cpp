// The examples in the headers of the stages, run one after the other: the whole way from a file to
// a verdict by hand. A header's lines are here word for word, and the last test checks it.
#include "collision/growing_part.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/placement.h"
#include "geometry/repair/repair.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "pipeline/outputs.h"
#include "pipeline/road.h"
#include "planar/search/beam_search.h"
#include "planar/slicing/slicing.h"
#include "process/tooling.h"
#include "program/dialect.h"
#include "replay/verification.h"
#include "substrate/lathe_layers.h"
#include "substrate/rod_surface.h"
#include "toolpath/plan_toolpaths.h"
#include "voxel/solid_voxels.h"
#include "voxel/voxel_object.h"

#include "base/files.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace voluta {
namespace {

const base::RunContext ctx;

geometry::TriangleMesh readExample(const std::filesystem::path& stl) {
  const geometry::MeshFile file = geometry::readMesh(stl);
  const geometry::RepairResult mended = geometry::repair(file.mesh);
  const geometry::TriangleMesh part = geometry::placeOnPlate(mended.mesh, 1.0);
  EXPECT_TRUE(mended.diagnosis.clean());
  return part;
}

plan::ToolPlan coverExample(const layers::LayerStack& stack, const robot::Cell& cell,
                            const process::Tooling& tooling, const platform::PlatformSolid& plate) {
  toolpath::ToolpathOptions options;
  options.platform = plate;
  const toolpath::ToolpathResult made = toolpath::planToolpaths(stack, cell, tooling, options, ctx);
  EXPECT_GT(made.statistics.coveredFraction, 0.9);
  return made.plan;
}

plan::Trajectory moveExample(const plan::ToolPlan& toolPlan, const robot::Cell& cell,
                             const process::Tooling& tooling) {
  const double pitch = collision::growingPitch(toolPlan, tooling);
  const collision::GrowingPart growing(toolPlan, pitch, ctx);
  motion::MotionOptions options;
  options.purge.primesBeside = true;
  motion::MotionPlanner planner(toolPlan, cell, tooling, growing, options);
  const motion::MotionResult moved = planner.plan(ctx);
  EXPECT_TRUE(moved.skipped.empty());
  return moved.trajectory;
}

TEST(Examples, FromAFileToAVerdict) {
  const test::TemporaryFolder folder;
  base::writeFile(folder.path() / "part.stl",
                  geometry::writeStl(test::box({-6, -5, 0}, {6, 5, 4})));
  const geometry::TriangleMesh part = readExample(folder.path() / "part.stl");

  const voxel::SolidVoxels voxels = voxel::solidVoxels(part, 0.8, ctx);

  const std::vector<Eigen::Vector2d> plate = curved::platformFit(voxels, 0.0);
  const curved::Decomposition order = curved::decompose(voxels, plate, {}, ctx);
  EXPECT_EQ(order.missedVoxels, 0u);

  const curved::LayersResult layers = curved::curvedLayers(order, part, {}, ctx);
  EXPECT_NEAR(layers.volumeMm3, 480.0, 5.0);

  const process::Process process = process::loadProcess("fdm-1.0");
  const process::Tooling tooling(process);
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, plate);
  const plan::ToolPlan toolPlan = coverExample(layers.stack, cell, tooling, plate);
  const plan::Trajectory moved = moveExample(toolPlan, cell, tooling);
  const plan::Trajectory trajectory =
      *program::pointsFor("urscript", {toolPlan, moved, cell, tooling, "part"}, ctx).trajectory;

  const program::ProgramInput input{toolPlan, trajectory, cell, tooling, "part"};
  const plan::Program program = program::writeProgram("urscript", input, ctx);
  const plan::ReadProgram read = program::readProgram("urscript", program.files, tooling, ctx);
  EXPECT_TRUE(read.complete);

  const replay::Verification verdict =
      replay::replayProgram({read, toolPlan, trajectory, cell, tooling, part, plate}, {}, ctx);
  EXPECT_TRUE(verdict.passed);
}

TEST(Examples, PiecesAndRods) {
  const geometry::TriangleMesh part = test::box({-6, -5, 0}, {6, 5, 4});
  const planar::PlanarDecomposition pieces = planar::beamDecompose(part, {}, ctx);
  const planar::SliceResult sliced = planar::slicePieces(pieces.pieces, {}, ctx);
  EXPECT_EQ(sliced.statistics.count, 5);

  const geometry::TriangleMesh tube =
      platform::meshOf({{{-4.0, 4.0}, {4.0, 4.0}}}, 0.01); // solid: the rod is taken out of it
  const substrate::RodSurface rod(platform::straightRod(5.0, 200.0));
  const geometry::TriangleMesh around = substrate::partAroundRod(tube, rod);
  const substrate::LatheLayers wound = substrate::latheLayers(around, rod, {}, ctx);
  EXPECT_EQ(wound.stack.layerCount, 6);
}

TEST(Examples, AsOne) {
  const test::TemporaryFolder folder;
  const std::filesystem::path& save = folder.path();
  pipeline::PlanRequest request;
  request.item().part = "sample:vase";
  request.choices.item().mode = "flat";
  request.until = project::Stage::Layers;
  pipeline::PlanResult result = pipeline::planPart(request, ctx);
  pipeline::writeOutputs(result, save, ctx);
  EXPECT_TRUE(std::filesystem::exists(save / "job.voluta"));
}

std::string withoutBlanks(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\n' && c != '\r')
      out += c;
  return out;
}

// The lines behind "// Example:" that are indented by three blanks or more.
std::vector<std::string> examplesIn(const std::filesystem::path& header) {
  std::vector<std::string> examples;
  std::ifstream in(header);
  bool inExample = false;
  for (std::string line; std::getline(in, line);) {
    if (inExample && line.starts_with("//   "))
      examples.back() += line.substr(2);
    else if ((inExample = line.starts_with("// Example:")))
      examples.emplace_back();
  }
  return examples;
}

TEST(Examples, InHeadersAreThoseThatRun) {
  const std::filesystem::path root = VOLUTA_SOURCE_DIR;
  std::ostringstream here;
  here << std::ifstream(root / "tests/pipeline/examples_test.cpp").rdbuf();
  const std::string run = withoutBlanks(here.str());
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "core"))
    if (entry.path().extension() == ".h")
      for (const std::string& example : examplesIn(entry.path())) {
        EXPECT_NE(run.find(withoutBlanks(example)), std::string::npos)
            << entry.path() << " has an example that no test runs:\n"
            << example;
        ++found;
      }
  EXPECT_GE(found, 12u);
}

} // namespace
} // namespace voluta
