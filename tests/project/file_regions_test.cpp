// Regions from modifiers and ranges of heights of slicers.
#include "project/file_regions.h"

#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "helpers/loaded_box.h"
#include "project/file_parts.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace voluta::project {
namespace {

using geometry::ModifierOfFile;
using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;
using Settings = std::vector<std::pair<std::string, std::string>>;
using Parameters = std::map<std::string, std::string>;

ModifierOfFile boxWith(Settings settings, const std::string& name = "dense") {
  return {name, test::box({0, 0, 0}, {5, 6, 7}), 0.0, 0.0, std::move(settings)};
}

struct Made {
  std::vector<Region> regions;
  std::vector<std::string> notes;
};
Made madeFrom(const std::vector<ModifierOfFile>& modifiers) {
  std::vector<base::Message> notes;
  std::vector<Region> regions = regionsOfFile(modifiers, notes, {});
  return {std::move(regions), base::english(notes)};
}

TEST(FileRegions, SettingsOfTheSlicersHaveTheirCounterparts) {
  for (const auto& [settings, expected] : std::vector<std::pair<Settings, Parameters>>{
           {{{"perimeters", "3"},
             {"fill_density", "20%"},
             {"fill_pattern", "rectilinear"},
             {"top_solid_layers", "5"},
             {"bottom_solid_layers", "4"},
             {"fill_angle", "225"}},
            {{"walls", "3"},
             {"infillDensity", "0.2"},
             {"sparsePattern", "lines"},
             {"topLayers", "5"},
             {"bottomLayers", "4"},
             {"infillAngle", "45"}}},
           {{{"wall_loops", "0"},
             {"sparse_infill_density", "100%"},
             {"sparse_infill_pattern", "gyroid"},
             {"top_shell_layers", "0"},
             {"bottom_shell_layers", "1"},
             {"infill_direction", "-45"},
             {"extruder", "2"}},
            {{"walls", "0"},
             {"infillDensity", "1"},
             {"sparsePattern", "gyroid"},
             {"topLayers", "0"},
             {"bottomLayers", "1"},
             {"infillAngle", "135"},
             {"tool", "2"}}},
           {{{"wall_line_count", "4"},
             {"infill_sparse_density", "12.5"},
             {"infill_pattern", "zigzag"}},
            {{"walls", "4"}, {"infillDensity", "0.125"}, {"sparsePattern", "lines"}}},
           {{{"top_shell_thickness", "0.8"}, {"bottom_shell_thickness", "0.8"}},
            {{"skinMm", "0.8"}}}}) {
    const Made made = madeFrom({boxWith(settings)});
    ASSERT_EQ(made.regions.size(), 1u);
    EXPECT_EQ(made.regions[0].parameters, expected);
    EXPECT_EQ(made.regions[0].name, "dense");
    EXPECT_EQ(made.regions[0].shape, "mesh:dense");
    EXPECT_EQ(made.regions[0].use, "settings");
    EXPECT_NEAR(geometry::volume(*made.regions[0].mesh), 210.0, 1e-9);
    EXPECT_THAT(made.notes,
                ElementsAre(fmt::format("region 'dense' from the file: {} setting{}",
                                        expected.size(), expected.size() == 1 ? "" : "s")));
  }
}

TEST(FileRegions, SettingsThatAreLeftOutAreNamed) {
  const Made made = madeFrom({boxWith({{"perimeters", "2"},
                                       {"layer_height", "0.1"},
                                       {"fill_pattern", "stars"},
                                       {"fill_density", "abc%"},
                                       {"top_solid_layers", "1.5"},
                                       {"bottom_solid_layers", "-1"},
                                       {"fill_angle", "nan"}})});
  ASSERT_EQ(made.regions.size(), 1u);
  EXPECT_EQ(made.regions[0].parameters, (Parameters{{"walls", "2"}}));
  EXPECT_THAT(made.notes,
              ElementsAre("not used: settings of region 'dense' from the file without a "
                          "counterpart: 'layer_height = 0.1', 'fill_pattern = stars'",
                          "not used: invalid settings of region 'dense' from the file: "
                          "'fill_density = abc%', 'top_solid_layers = 1.5', "
                          "'bottom_solid_layers = -1', 'fill_angle = nan'",
                          "region 'dense' from the file: 1 setting"));
}

TEST(FileRegions, TheThickerSkinCounts) {
  for (const auto& [top, bottom] :
       std::vector<std::pair<std::string, std::string>>{{"0.6", "1.2"}, {"1.2", "0.6"}}) {
    const Made made = madeFrom(
        {boxWith({{"top_solid_min_thickness", top}, {"bottom_solid_min_thickness", bottom}})});
    ASSERT_EQ(made.regions.size(), 1u);
    EXPECT_EQ(made.regions[0].parameters, (Parameters{{"skinMm", "1.2"}}));
    EXPECT_THAT(made.notes,
                ElementsAre(HasSubstr("the larger one of top and bottom"), HasSubstr("1 setting")));
  }
}

TEST(FileRegions, RangesOfHeightsAreRegionsOfThePlate) {
  const Made made = madeFrom({{"", {}, 4.0, 8.25, {{"perimeters", "3"}}},
                              {"", {}, 8.0, 4.0, {{"perimeters", "3"}}},
                              {"", {}, 9.0, 1e12, {{"perimeters", "3"}}},
                              {"", {}, 1.0, 2.0, {{"layer_height", "0.2"}}}});
  ASSERT_EQ(made.regions.size(), 2u);
  EXPECT_EQ(made.regions[0].shape, "height:4,8.25");
  EXPECT_EQ(made.regions[1].shape, "height:9,100000");
  EXPECT_FALSE(made.regions[0].mesh);
  EXPECT_THAT(made.notes,
              ElementsAre("region 'height:4,8.25' from the file: 1 setting",
                          HasSubstr("the range of heights from 8 mm to 4 mm in the file, which is "
                                    "empty"),
                          "region 'height:9,100000' from the file: 1 setting",
                          HasSubstr("without a counterpart: 'layer_height = 0.2'")));
}

TEST(FileRegions, BodiesAreClosedOrLeftOut) {
  ModifierOfFile open = boxWith({{"perimeters", "2"}}), sheet = open, bare = boxWith({}, "bare");
  open.mesh.triangles.pop_back();
  sheet.name = "sheet";
  sheet.mesh.triangles.resize(1);
  const Made made = madeFrom({open, sheet, bare});
  ASSERT_EQ(made.regions.size(), 1u);
  EXPECT_TRUE(geometry::isWatertight(*made.regions[0].mesh));
  EXPECT_NEAR(geometry::volume(*made.regions[0].mesh), 210.0, 1e-9);
  EXPECT_THAT(made.notes,
              ElementsAre("region 'dense' from the file: its mesh is open, and was closed",
                          "region 'dense' from the file: 1 setting",
                          "not used: region 'sheet' from the file: its mesh is not closed",
                          "not used: region 'bare' from the file, which has no settings"));
}

TEST(FileRegions, EnforcersBlockersAndPaintAreRegions) {
  ModifierOfFile paint = boxWith({{"paint_seam", "1"}}, "body");
  paint.isPainted = true;
  paint.mesh.triangles.resize(2); // an open surface stays open
  ModifierOfFile supports = paint, never = paint, colour = paint, damaged = paint;
  supports.settings = {{"paint_supports", "2"}};
  never.settings = {{"paint_seam", "2"}};
  colour.settings = {{"paint_color", "3"}};
  damaged.settings = {{"paint_seam", "3"}};
  const Made made = madeFrom({boxWith({{"volume_type", "SupportEnforcer"}}, "on"),
                              boxWith({{"volume_type", "SupportBlocker"}}, "off"), paint, supports,
                              never, colour, damaged});
  ASSERT_EQ(made.regions.size(), 6u);
  EXPECT_EQ(made.regions[0].parameters, (Parameters{{"supports", "always"}}));
  EXPECT_EQ(made.regions[0].shape, "mesh:on");
  EXPECT_EQ(made.regions[1].parameters, (Parameters{{"supports", "none"}}));
  EXPECT_EQ(made.regions[2].parameters, (Parameters{{"seamHere", "always"}}));
  EXPECT_EQ(made.regions[2].name, "body, seamHere=always");
  EXPECT_EQ(made.regions[2].shape, "painted:0.5");
  EXPECT_EQ(made.regions[2].mesh->triangles.size(), 2u);
  EXPECT_EQ(made.regions[3].parameters, (Parameters{{"supports", "none"}}));
  EXPECT_EQ(made.regions[4].parameters, (Parameters{{"seamHere", "never"}}));
  EXPECT_EQ(made.regions[5].parameters, (Parameters{{"tool", "3"}}));
  EXPECT_EQ(made.regions[5].shape, "painted:2");
  ASSERT_EQ(made.notes.size(), 7u);
  EXPECT_THAT(made.notes.back(), HasSubstr("invalid settings"));
}

TEST(FileRegions, ThereIsALimit) {
  const Made made = madeFrom(std::vector<ModifierOfFile>(200, boxWith({{"perimeters", "2"}})));
  EXPECT_EQ(made.regions.size(), kMaxRegionsOfFile);
  EXPECT_EQ(made.notes.size(), kMaxRegionsOfFile + 1);
  EXPECT_EQ(made.notes.back(), "not used: 100 further regions of the file");
}

TEST(FileRegions, ToolsThatTheJobLacksAreLeftOut) {
  LoadedPart part;
  std::vector<base::Message> notes;
  part.regions = regionsOfFile(
      {boxWith({{"extruder", "2"}, {"perimeters", "3"}}), boxWith({{"extruder", "3"}}, "third")},
      notes, {});
  const auto loaded = std::make_shared<const LoadedPart>(part);
  EXPECT_EQ(withToolsOfJob(loaded, 3), loaded);
  const auto two = withToolsOfJob(loaded, 2);
  EXPECT_EQ(two->regions.size(), 1u);
  EXPECT_THAT(base::english(two->notes),
              ElementsAre("not used: tool 3 of region 'third' from the file: the job has 2"));
  const auto one = withToolsOfJob(loaded, 1);
  ASSERT_EQ(one->regions.size(), 1u);
  EXPECT_EQ(one->regions[0].parameters, (Parameters{{"walls", "3"}}));
  EXPECT_EQ(one->readNotes.size(), 2u);
}

} // namespace
} // namespace voluta::project
