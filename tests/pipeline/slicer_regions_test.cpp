// 3MF files of slicers from the package to the layers of their regions.
#include "base/files.h"
#include "command_line_fixture.h"
#include "helpers/given_parameters.h"
#include "helpers/models.h"
#include "helpers/slicer_packages.h"
#include "helpers/temporary_folder.h"
#include "motion/layer_event_text.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/trajectory.h"
#include "project/file_parts.h"
#include "project/file_regions.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace voluta::pipeline {
namespace {

using test::reasons, test::SlicerKind, test::SlicerPart;
using ::testing::Contains, ::testing::HasSubstr;

std::string written(const test::TemporaryFolder& folder, const std::string& package) {
  const auto file = folder.path() / "part.3mf";
  std::ofstream(file, std::ios::binary) << package;
  return file.string();
}

// As the doors of the program open a file.
PlanRequest requestFor(const std::string& file, const std::string& mode = "flat") {
  PlanRequest request;
  const std::vector<project::PartInFile> parts = project::loadParts(file, true, {});
  const auto part = project::withToolsOfJob(parts.front().part, request.choices.tools.size());
  request.item().loaded = part;
  request.choices.item().mode = mode;
  project::takeFromFile(request.choices.item(), *part);
  request.until = project::Stage::Layers;
  return request;
}

struct Case {
  test::SlicerSettings dense, sparse, heights;
};
const Case kPrusa{{{"perimeters", "4"}, {"fill_density", "60%"}, {"extruder", "2"}},
                  {{"fill_density", "10%"}, {"fill_pattern", "grid"}, {"layer_height", "0.1"}},
                  {{"layer_height", "0.2"}, {"extruder", "0"}, {"top_solid_layers", "2"}}};
const Case kBambu{
    {{"wall_loops", "4"}, {"sparse_infill_density", "60%"}, {"extruder", "2"}},
    {{"sparse_infill_density", "10%"}, {"sparse_infill_pattern", "grid"}, {"layer_height", "0.1"}},
    {{"layer_height", "0.2"}, {"extruder", "0"}, {"top_shell_layers", "2"}}};

// A body of 40 x 40 x 24 mm with all kinds of volumes: modifiers in it and half outside, a range,
// a cut below both, and volumes for supports.
SlicerPart partOf(const Case& settings) {
  return {{{"body", {-20, -20, 0}, {20, 20, 24}},
           {"dense", {-10, -10, 8}, {10, 10, 16}, SlicerKind::Modifier, settings.dense},
           {"half", {12, -10, 17.6}, {40, 10, 20.8}, SlicerKind::Modifier, settings.sparse},
           {"cut", {-20, -20, 20}, {-15, 20, 30}, SlicerKind::Negative},
           {"on", {0, 0, 0}, {5, 5, 5}, SlicerKind::Enforcer},
           {"off", {6, 6, 0}, {9, 9, 5}, SlicerKind::Blocker}},
          {{1.6, 4.8, settings.heights}},
          {{12, 1}}};
}

TEST(SlicerRegions, LayersOfRegionsHaveTheirVolumes) {
  const test::TemporaryFolder folder;
  for (const std::string& package :
       {test::prusaPackage({partOf(kPrusa)}), test::bambuPackage({partOf(kBambu)}, true),
        test::bambuPackage({partOf(kBambu)}, false)}) {
    const PlanRequest request = requestFor(written(folder, package));
    const auto& regions = request.choices.item().regions;
    ASSERT_EQ(regions.size(), 5u);
    using Parameters = std::map<std::string, std::string>;
    EXPECT_EQ(regions[0].parameters, (Parameters{{"topLayers", "2"}}));
    EXPECT_EQ(regions[1].parameters, (Parameters{{"walls", "4"}, {"infillDensity", "0.6"}}));
    EXPECT_EQ(regions[2].parameters,
              (Parameters{{"infillDensity", "0.1"}, {"sparsePattern", "grid"}}));
    EXPECT_EQ(regions[3].parameters, (Parameters{{"supports", "always"}}));
    EXPECT_EQ(regions[4].parameters, (Parameters{{"supports", "none"}}));
    EXPECT_EQ(request.choices.item().parameters.at("layerEvents"), "z12 pause");
    const PlanResult plan = planPart(request, {});
    const auto& figures = plan.job.report.item().layers.regions;
    ASSERT_EQ(figures.size(), 5u) << reasons(plan);
    EXPECT_NEAR(figures[0].volumeMm3 / (40.0 * 40.0 * 3.2), 1.0, 0.01);
    EXPECT_NEAR(figures[1].volumeMm3 / (20.0 * 20.0 * 8.0), 1.0, 0.01);
    EXPECT_NEAR(figures[2].volumeMm3 / (8.0 * 20.0 * 3.2), 1.0, 0.01);
    const std::vector<std::string> notes = base::english(request.item().loaded->notes);
    for (const char* note :
         {"region 'height:1.6,4.8' from the file: 1 setting",
          "region 'dense' from the file: 3 settings", "region 'half' from the file: 2 settings",
          "region 'on' from the file: 1 setting", "region 'off' from the file: 1 setting",
          "from the file: a pause at a height of 12 mm",
          "not used: tool 2 of region 'dense' from the file: the job has 1"})
      EXPECT_THAT(notes, Contains(note));
    for (const char* part :
         {"cut away: negative volume 'cut'",
          "region 'half' from the file without a counterpart: 'layer_height = 0.1'",
          "region 'height:1.6,4.8' from the file without a counterpart: 'layer_height = 0.2'"})
      EXPECT_THAT(notes, Contains(HasSubstr(part)));
    EXPECT_EQ(notes.size(), 10u) << ::testing::PrintToString(notes);
  }
}

// Each row of the table gives a value that regions accept.
TEST(SlicerRegions, CounterpartsAreSettingsOfRegions) {
  const base::ParameterTable table = allParameters();
  for (const project::SlicerSetting& row : project::slicerSettings()) {
    const base::ParameterSpec* spec = table.find(row.parameter);
    ASSERT_TRUE(spec) << row.parameter;
    EXPECT_EQ(spec->scope, base::ParameterScope::Region) << row.parameter;
    for (const char* value :
         {"0",    "1",         "2",     "20",        "21",         "100",    "101",
          "180",  "1000",      "50%",   "-1",        "gyroid",     "line",   "rectilinear",
          "grid", "triangles", "cubic", "honeycomb", "concentric", "zig-zag"}) {
      const auto converted = row.convert(value);
      if (!converted || converted->empty() || row.parameter == "tool") // the job has few tools
        continue;
      EXPECT_NO_THROW(base::parseParameter(*spec, *converted)) << row.key << " " << value;
    }
  }
}

// An arm of 20 mm with an enforcer below its far half, paint on the post, and all kinds of events,
// as each slicer writes it: everything is read, or has one line.
TEST(SlicerRegions, EnforcersPaintAndEventsAreRead) {
  const test::TemporaryFolder folder;
  for (const bool isPrusa : {true, false}) {
    SlicerPart part{{{"post", {0, 0, 0}, {10, 4, 20}},
                     {"arm", {10, 0, 16}, {30, 4, 20}},
                     {"on", {20, -5, 0}, {40, 10, 30}, SlicerKind::Enforcer}},
                    {},
                    {{6.2, 1, 1, "Nut"},
                     {8.2, 0, 1, "", "#FF0000"},
                     {10.2, 2, 2},
                     {15.2, 2, 1},
                     {16.2, 2, 3},
                     {17.2, 4}}};
    part.layerHeightMm = 0.2;
    part.onTriangle =
        isPrusa
            ? R"(slic3rpe:custom_supports="8" slic3rpe:custom_seam="4" slic3rpe:mmu_segmentation="8")"
            : R"(paint_supports="8" paint_seam="4" paint_color="8")";
    const std::string file =
        written(folder, isPrusa ? test::prusaPackage({part}) : test::bambuPackage({part}, true));
    PlanRequest request = requestFor(file);
    request.choices.tools.resize(2);
    const auto loaded = project::withToolsOfJob(project::loadParts(file, true, {}).front().part, 2);
    request.item().loaded = loaded;
    request.choices.item().regions.clear();
    project::takeFromFile(request.choices.item(), *loaded);
    const auto& item = request.choices.item();
    EXPECT_EQ(item.parameters.at("layerEvents"),
              "z6 pause Nut; z8 filament Change to colour #FF0000");
    EXPECT_EQ(motion::layerEventsOf(item.parameters.at("layerEvents")).size(), 2u);
    std::vector<std::string> said;
    for (const project::Region& region : item.regions)
      for (const auto& [key, value] : region.parameters)
        said.push_back(region.shape.substr(0, region.shape.find(',')) + " " + key + "=" + value);
    std::vector<std::string> expected{"height:10 tool=2", "height:15 tool=1",
                                      "mesh:on supports=always"};
    // Both parts of the body are painted; in one mesh they are one surface.
    for (const std::string paint :
         {"painted:0.5 seamHere=always", "painted:0.5 supports=none", "painted:2 tool=2"})
      for (int i = 0; i < (isPrusa ? 1 : 2); ++i)
        expected.push_back(paint);
    EXPECT_THAT(said, ::testing::UnorderedElementsAreArray(expected));
    const std::vector<std::string> notes = base::english(loaded->notes);
    for (const char* note : {"from the file: a pause at a height of 6 mm",
                             "from the file: a change of colour at a height of 8 mm",
                             "from the file: a change to extruder 2 at a height of 10 mm",
                             "from the file: a change to extruder 1 at a height of 15 mm",
                             "from the file: a change to extruder 3 at a height of 16 mm",
                             "not used: tool 3 of region 'height:16,100000' from the file: the job "
                             "has 2",
                             "region 'on' from the file: 1 setting"})
      EXPECT_THAT(notes, Contains(note));
    EXPECT_THAT(notes, Contains(HasSubstr("not used: custom G-code at a height of 17.2 mm")));
    // Besides: the slicer's settings, G-code, and that post and arm touch.
    const std::size_t paints = isPrusa ? 3 : 6, events = 5, lines = 5;
    EXPECT_EQ(notes.size(), events + paints + lines) << ::testing::PrintToString(notes);
    // The enforcer has its columns, although the job has no supports; painted blockers, which are
    // later, take the half of the arm's underside that is painted.
    request.choices.tools.resize(1);
    request.choices.item().platform = project::Platform("disc:200");
    std::erase_if(request.choices.item().regions,
                  [](const project::Region& region) { return region.parameters.contains("tool"); });
    const auto carried = [&] {
      const PlanResult plan = planPart(request, {});
      return plan.job.report.item().decomposition.supportVolumeMm3 / (10.6 * 4.0 * 16.0);
    };
    const double blocked = carried();
    EXPECT_GT(blocked, 0.4);
    EXPECT_LT(blocked, 0.8);
    std::erase_if(request.choices.item().regions,
                  [](const project::Region& region) { return region.shape != "mesh:on"; });
    EXPECT_NEAR(carried(), 1.0, 0.02);
  }
}

// A pause of the file is an event of the program.
TEST(SlicerRegions, PausesOfAFileAreInTheProgram) {
  const test::TemporaryFolder folder;
  SlicerPart part{{{"body", {0, 0, 0}, {20, 20, 8}}}, {}, {{4.0, 1, 1, "Put in the nut"}}};
  PlanRequest request = requestFor(written(folder, test::prusaPackage({part})));
  request.choices.formats = {"rapid"};
  request.until = project::Stage::Replay;
  const PlanResult plan = planPart(request, {});
  EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << reasons(plan);
  std::size_t pauses = 0;
  for (const plan::TrajectoryEvent& event : plan.job.trajectory->events)
    if (event.text.starts_with("Put in the nut (layer 6 of 10"))
      ++pauses;
  EXPECT_EQ(pauses, 1u);
}

TEST(SlicerRegions, ARegionOutsideThePartIsReported) {
  const test::TemporaryFolder folder;
  SlicerPart part = partOf(kPrusa);
  part.volumes = {part.volumes[0],
                  {"far", {100, 0, 0}, {110, 10, 10}, SlicerKind::Modifier, {{"perimeters", "3"}}}};
  const PlanResult plan = planPart(requestFor(written(folder, test::prusaPackage({part}))), {});
  EXPECT_THAT(reasons(plan), HasSubstr("region mesh:far is outside the part"));
}

class SlicerRegionsOfTheProgram : public test::CommandLine {};

// The command line takes the regions of each part of a file, and those of its options besides.
TEST_F(SlicerRegionsOfTheProgram, APlanHasThem) {
  SlicerPart first{
      {{"body", {0, 0, 0}, {20, 20, 8}},
       {"dense", {5, 5, 0}, {15, 15, 4}, SlicerKind::Modifier, {{"perimeters", "4"}}}}};
  SlicerPart second{{{"body", {0, 0, 0}, {20, 20, 8}}}, {{2.4, 4.8, {{"fill_density", "50%"}}}}};
  for (const auto& [parts, isOne] : std::vector<std::pair<std::vector<SlicerPart>, bool>>{
           {{first}, true}, {{first, second}, false}}) {
    const std::string file = (folder_ / "part.3mf").string(),
                      out = (folder_ / (isOne ? "one" : "two")).string();
    std::ofstream(file, std::ios::binary) << test::prusaPackage(parts);
    const test::Ended ended = run({"plan", file, "-o", out, "--mode", "flat", "--until", "layers",
                                   "--region", "1:height:6.4,8;walls=3"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const auto report = nlohmann::json::parse(base::readFile(out + "/report.json"));
    const auto regionsOf = [&](std::size_t item) {
      return report.at("items").at(item).at("layers").at("regions");
    };
    ASSERT_EQ(regionsOf(0).size(), 2u);
    EXPECT_NEAR(regionsOf(0)[0].at("volumeMm3").get<double>(), 400.0, 4.0);
    EXPECT_NEAR(regionsOf(0)[1].at("volumeMm3").get<double>(), 640.0, 6.4);
    if (!isOne) {
      ASSERT_EQ(regionsOf(1).size(), 1u);
      EXPECT_NEAR(regionsOf(1)[0].at("volumeMm3").get<double>(), 960.0, 9.6);
    }
  }
}

TEST(SlicerRegions, RealFilesArePlanned) {
  for (const char* name : {"cases/prusa_modifier.3mf", "cases/prusa_negative.3mf", "peer/torus.3mf",
                           "peer/Bearing.3mf", "peer/two_cubes.3mf"}) {
    const auto file = test::modelFolder() / name;
    if (!std::filesystem::exists(file))
      GTEST_SKIP() << "model not here: " << name << " (set VOLUTA_MODELS)";
    for (const project::PartInFile& part : project::loadParts(file.string(), true, {})) {
      EXPECT_FALSE(part.part->mesh->empty());
      EXPECT_TRUE(part.part->regions.empty()) << "none of them has settings";
    }
  }
}

} // namespace
} // namespace voluta::pipeline
