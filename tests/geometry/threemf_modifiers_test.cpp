// Modifiers, ranges of heights and events of slicers in a 3MF.
#include "geometry/formats/threemf_parts.h"
#include "geometry/measures.h"
#include "helpers/slicer_packages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::geometry {
namespace {

using test::SlicerKind, test::SlicerPart;
using ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty,
    ::testing::Not;

SlicerPart partWith(std::vector<test::SlicerVolume> further) {
  SlicerPart part{{{"body", {-20, -20, 0}, {20, 20, 24}}}};
  part.volumes.insert(part.volumes.end(), further.begin(), further.end());
  return part;
}

const test::SlicerVolume kDense{
    "dense", {-10, -10, 8}, {10, 10, 16}, SlicerKind::Modifier, {{"perimeters", "4"}}};

// By each way of writing.
std::vector<std::string> packagesOf(const std::vector<SlicerPart>& parts) {
  return {test::prusaPackage(parts), test::bambuPackage(parts, true),
          test::bambuPackage(parts, false)};
}

std::vector<std::string> notesOf(const PartOfFile& part) {
  return base::english(part.file.repairs);
}

TEST(ThreeMfModifiers, TheyHaveTheirMeshAndTheirSettings) {
  for (const std::string& package :
       packagesOf({partWith({kDense, {"cut", {-5, -5, 20}, {5, 5, 30}, SlicerKind::Negative}})})) {
    const PartOfFile part = read3mfWhole(package, "part.3mf");
    EXPECT_NEAR(volume(part.file.mesh), 38'000.0, 1e-6);
    ASSERT_EQ(part.modifiers.size(), 1u);
    const ModifierOfFile& modifier = part.modifiers[0];
    EXPECT_EQ(modifier.name, "dense");
    EXPECT_NEAR(volume(modifier.mesh), 20.0 * 20.0 * 8.0, 1e-6);
    EXPECT_LT((bounds(modifier.mesh).min() - kDense.from).norm(), 1e-9);
    EXPECT_THAT(modifier.settings,
                ElementsAre(std::pair<std::string, std::string>("perimeters", "4")));
    EXPECT_THAT(notesOf(part), ElementsAre(HasSubstr("cut away: negative volume 'cut'")));
  }
}

// Readers of a mesh alone name modifiers and ranges.
TEST(ThreeMfModifiers, AMeshAloneHasNotesOnly) {
  SlicerPart part = partWith({kDense});
  part.ranges = {{4, 8, {{"perimeters", "3"}}}};
  for (const std::string& package : packagesOf({part}))
    EXPECT_THAT(base::english(readMesh(package, "part.3mf").repairs),
                ElementsAre(HasSubstr("not used: modifier volume 'dense' of 'part 1'"),
                            HasSubstr("not used: settings of ranges of height")));
}

TEST(ThreeMfModifiers, EachPartHasItsOwn) {
  SlicerPart second = partWith({{"other", {-3, -3, 1}, {3, 3, 5}, SlicerKind::Modifier}});
  second.ranges = {{2, 6, {{"fill_density", "10%"}, {"extruder", "0"}}}};
  for (const std::string& package : packagesOf({partWith({kDense}), second})) {
    const std::vector<PartOfFile> parts = read3mfParts(package, "part.3mf");
    ASSERT_EQ(parts.size(), 2u);
    ASSERT_EQ(parts[0].modifiers.size(), 1u);
    EXPECT_LT((bounds(parts[0].modifiers[0].mesh).max() - kDense.to).norm(), 1e-9);
    ASSERT_EQ(parts[1].modifiers.size(), 2u);
    EXPECT_TRUE(parts[1].modifiers[0].mesh.empty());
    EXPECT_EQ(parts[1].modifiers[0].fromMm, 2.0);
    EXPECT_EQ(parts[1].modifiers[0].toMm, 6.0);
    EXPECT_EQ(parts[1].modifiers[0].settings.size(), 1u);
    EXPECT_LT((bounds(parts[1].modifiers[1].mesh).min() - Eigen::Vector3d(-3, -3, 1)).norm(), 1e-9);
  }
}

// A further instance of PrusaSlicer is an object of its own, without settings.
TEST(ThreeMfModifiers, InstancesHaveThoseOfTheirObject) {
  SlicerPart first = partWith({kDense}), second = partWith({});
  second.ranges = {{2, 6, {{"perimeters", "3"}}}};
  const std::vector<PartOfFile> parts =
      read3mfParts(test::prusaPackage({first, second}, 2), "part.3mf");
  ASSERT_EQ(parts.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(volume(parts[i].file.mesh), 38'400.0, 1e-6) << i;
    EXPECT_EQ(parts[i].modifiers.size(), 1u) << i;
    EXPECT_EQ(parts[i].modifiers[0].mesh.empty(), i >= 2) << i;
  }
  EXPECT_EQ(parts[0].modifiers[0].mesh.vertices, parts[1].modifiers[0].mesh.vertices);
}

TEST(ThreeMfModifiers, ExtrudersAreSettingsWhereTheyDiffer) {
  for (const auto& [extruder, count] :
       std::vector<std::pair<std::string, std::size_t>>{{"1", 0}, {"0", 0}, {"2", 1}})
    for (const std::string& package : packagesOf({partWith(
             {{"m", {-3, -3, 1}, {3, 3, 5}, SlicerKind::Modifier, {{"extruder", extruder}}}})})) {
      const PartOfFile part = read3mfWhole(package, "part.3mf");
      EXPECT_EQ(part.modifiers.at(0).settings.size(), count) << extruder;
      EXPECT_THAT(notesOf(part), IsEmpty());
    }
}

TEST(ThreeMfModifiers, EventsAreOfThePartAndGCodeIsNamed) {
  SlicerPart part = partWith({});
  part.events = {{9.5, 2, 2}, {3, 0}, {6, 1}, {12, 3}, {15, 4}};
  for (const std::string& package : packagesOf({part})) {
    const PartOfFile read = read3mfWhole(package, "part.3mf");
    ASSERT_EQ(read.events.size(), 3u);
    EXPECT_EQ(read.events[0].kind, EventOfFileKind::Colour);
    EXPECT_EQ(read.events[0].heightMm, 3.0);
    EXPECT_EQ(read.events[1].kind, EventOfFileKind::Pause);
    EXPECT_EQ(read.events[1].heightMm, 6.0);
    EXPECT_EQ(read.events[2].kind, EventOfFileKind::Tool);
    EXPECT_EQ(read.events[2].extruder, 2);
    EXPECT_THAT(notesOf(read),
                ElementsAre(HasSubstr("not used: template G-code at a height of 12 mm"),
                            HasSubstr("not used: custom G-code at a height of 15 mm")));
    // Readers of a mesh alone name all.
    EXPECT_THAT(base::english(readMesh(package, "part.3mf").repairs),
                ::testing::UnorderedElementsAre(
                    HasSubstr("not used: a change of colour at a height of 3 mm"),
                    HasSubstr("not used: a pause at a height of 6 mm"),
                    HasSubstr("not used: a change to extruder 2 at a height of 9.5 mm"),
                    HasSubstr("not used: template G-code at a height of 12 mm"),
                    HasSubstr("not used: custom G-code at a height of 15 mm")));
  }
  part.events.assign(50, {3, 4});
  for (const std::string& package : packagesOf({part})) {
    const std::vector<std::string> notes = notesOf(read3mfWhole(package, "part.3mf"));
    EXPECT_EQ(notes.size(), 21u);
    EXPECT_THAT(notes.back(), HasSubstr("not used: 30 further events"));
  }
}

// Slicers state where a layer ends; where it begins follows from their height of layers.
TEST(ThreeMfModifiers, EventsAreWhereTheirLayerBegins) {
  SlicerPart part = partWith({});
  part.events = {{6, 1}};
  part.layerHeightMm = 0.4;
  for (const std::string& package : packagesOf({part}))
    EXPECT_NEAR(read3mfWhole(package, "part.3mf").events.at(0).heightMm, 5.6, 1e-9);
}

TEST(ThreeMfModifiers, ThePartsOfAFileShareItsEvents) {
  SlicerPart low = partWith({}), high{{{"body", {-20, -20, 0}, {20, 20, 60}}}};
  low.events = {{9.5, 2, 2}, {6, 1}};
  for (const std::string& package : packagesOf({low, high})) {
    const std::vector<PartOfFile> parts = read3mfParts(package, "part.3mf");
    ASSERT_EQ(parts.size(), 2u);
    ASSERT_EQ(parts[0].events.size(), 1u) << "all wait for the highest one";
    EXPECT_EQ(parts[0].events[0].kind, EventOfFileKind::Tool);
    EXPECT_EQ(parts[1].events.size(), 2u);
  }
}

TEST(ThreeMfModifiers, PaintIsNamedWithTheObjectForAMeshAlone) {
  SlicerPart part = partWith({});
  part.onTriangle = R"(slic3rpe:custom_supports="4" paint_color="8" custom_seam="4")";
  for (const std::string& package : packagesOf({part})) {
    const std::vector<std::string> notes = base::english(readMesh(package, "part.3mf").repairs);
    EXPECT_EQ(notes.size(), 3u);
    for (const char* what : {"painted supports", "painted colours", "a painted seam"})
      EXPECT_THAT(notes,
                  Contains(HasSubstr("not used: " + std::string(what) + " on 1 triangle of '")));
    for (const std::string& note : notes)
      EXPECT_THAT(note, ::testing::AnyOf(HasSubstr("of 'part 1'"), HasSubstr("of 'body'")));
    EXPECT_EQ(read3mfWhole(package, "part.3mf").modifiers.size(), 3u);
  }
}

TEST(ThreeMfModifiers, DamagedMembersAreNamed) {
  const auto notesWith = [](const std::string& member, const std::string& text) {
    test::ZipWriter zip(true);
    test::addRelations(zip);
    zip.add(
        "3D/3dmodel.model",
        test::slicerModel("<object id=\"1\">" + test::boxesMesh(partWith({}).volumes) + "</object>",
                          "<item objectid=\"1\"/>"));
    zip.add(member, text);
    return notesOf(read3mfWhole(zip.bytes(), "part.3mf"));
  };
  const std::string ranges = "Metadata/layer_config_ranges.xml";
  EXPECT_THAT(notesWith(ranges, "<objects><object id="), ElementsAre(HasSubstr("are damaged")));
  EXPECT_THAT(
      notesWith(ranges,
                R"(<objects><object id="1"><range min_z="a" max_z="2"/></object></objects>)"),
      ElementsAre(HasSubstr("are damaged")));
  EXPECT_THAT(
      notesWith(ranges,
                R"(<objects><object id="7"><range min_z="1" max_z="2"/></object></objects>)"),
      ElementsAre(HasSubstr("of object 7, which does not exist")));
  EXPECT_THAT(notesWith("Metadata/custom_gcode_per_layer.xml", R"(<a><layer top_z="high"/></a>)"),
              ElementsAre(HasSubstr("are damaged")));
}

// A modifier of Cura is an object of its own.
TEST(ThreeMfModifiers, AnObjectThatIsAModifierBelongsToThePartsThatItMeets) {
  const auto object = [](int id, const std::string& mesh, const std::string& settings) {
    return fmt::format(
        "<object id=\"{}\" name=\"o{}\"><metadatagroup>{}</metadatagroup>{}</object>", id, id,
        settings, mesh);
  };
  const std::string body = test::boxesMesh(partWith({}).volumes);
  std::string model = test::slicerModel(
      object(1, body, "") + object(2, body, "") +
          object(3, test::boxesMesh({kDense}),
                 "<metadata name=\"cura:infill_mesh\">True</metadata>"
                 "<metadata name=\"cura:wall_line_count\">5</metadata>"),
      "<item objectid=\"1\"/><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 90 0 0\"/>"
      "<item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 90 0 0\"/>");
  model.insert(model.find(" xmlns:slic3rpe"),
               " xmlns:cura=\"http://software.ultimaker.com/xml/cura/3mf/2015/10\"");
  test::ZipWriter zip(true);
  test::addRelations(zip);
  zip.add("3D/3dmodel.model", model);
  const std::vector<PartOfFile> parts = read3mfParts(zip.bytes(), "part.3mf");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(parts[0].modifiers.empty());
  ASSERT_EQ(parts[1].modifiers.size(), 1u);
  EXPECT_LT((bounds(parts[1].modifiers[0].mesh).min() - kDense.from).norm(), 1e-9);
  EXPECT_EQ(parts[1].modifiers[0].settings.size(), 1u);
}

} // namespace
} // namespace voluta::geometry
