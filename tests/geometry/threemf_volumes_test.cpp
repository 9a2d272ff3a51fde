// Volumes of slicers in a 3MF: negative ones are cut away, those that are no material are named.
#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/formats/threemf_parts.h"
#include "geometry/measures.h"
#include "geometry/repair/repair.h"
#include "helpers/package_3mf.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using ::testing::AllOf, ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;

using Members = std::vector<std::pair<std::string, std::string>>;

struct Box {
  Vector3d from, to;
};
const Box kBody{{-20, -20, 0}, {20, 20, 24}};   // 38,400 mm3
const Box kPocket{{-10, -10, 8}, {10, 10, 40}}; // 6,400 mm3 of it are in the body
const Box kBeside{{12, -10, 4}, {40, 10, 16}};

// A mesh of boxes, one after the other: 12 triangles each.
std::string meshOf(const std::vector<Box>& boxes) {
  std::string vertices, triangles;
  int first = 0;
  for (const Box& box : boxes) {
    for (int i = 0; i < 8; ++i)
      vertices +=
          fmt::format(R"(<vertex x="{}" y="{}" z="{}"/>)", i & 1 ? box.to.x() : box.from.x(),
                      i & 2 ? box.to.y() : box.from.y(), i & 4 ? box.to.z() : box.from.z());
    constexpr std::array<std::array<int, 3>, 12> kFaces{{{0, 2, 1},
                                                         {1, 2, 3},
                                                         {4, 5, 6},
                                                         {5, 7, 6},
                                                         {0, 1, 4},
                                                         {1, 5, 4},
                                                         {2, 6, 3},
                                                         {3, 6, 7},
                                                         {0, 4, 2},
                                                         {2, 4, 6},
                                                         {1, 3, 5},
                                                         {3, 7, 5}}};
    for (const auto& t : kFaces)
      triangles += fmt::format(R"(<triangle v1="{}" v2="{}" v3="{}"/>)", first + t[0], first + t[1],
                               first + t[2]);
    first += 8;
  }
  return "<mesh><vertices>" + vertices + "</vertices><triangles>" + triangles +
         "</triangles></mesh>";
}

std::string modelOf(const std::string& resources, const std::string& build,
                    const std::string& attributes = {}, const std::string& metadata = {}) {
  return "<model unit=\"millimeter\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:cura=\"http://software.ultimaker.com/xml/cura/3mf/2015/10\"" +
         attributes + ">" + metadata + "<resources>" + resources + "</resources><build>" + build +
         "</build></model>";
}

std::string packageOf(const std::string& model, const Members& members = {}, bool is64 = false) {
  test::ZipWriter zip(true, is64);
  test::addRelations(zip);
  zip.add("3D/3dmodel.model", model);
  for (const auto& [name, text] : members)
    zip.add(name, text);
  return zip.bytes();
}

// An object of two volumes in one mesh, as PrusaSlicer writes it.
std::string prusa(const Box& second, const std::string& kind,
                  const std::string& build = "<item objectid=\"1\"/>") {
  return packageOf(
      modelOf("<object id=\"1\">" + meshOf({kBody, second}) + "</object>", build),
      {{"Metadata/Slic3r_PE_model.config",
        R"(<config><object id="1"><metadata type="object" key="name" value="body"/>)"
        R"(<volume firstid="0" lastid="11"><metadata type="volume" key="volume_type" value="ModelPart"/></volume>)"
        R"(<volume firstid="12" lastid="23"><metadata type="volume" key="name" value="second"/>)"
        R"(<metadata type="volume" key="volume_type" value=")" +
            kind + R"("/></volume></object></config>)"}});
}

// An assembly of two objects in a model beside the main one, as Bambu Studio and OrcaSlicer write.
std::string bambu(const Box& second, const std::string& kind) {
  const std::string path =
      R"( xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" p:path="/3D/Objects/object_1.model")";
  return packageOf(
      modelOf("<object id=\"3\"><components><component" + path + " objectid=\"1\"/><component" +
                  path +
                  " objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 1 2 3\"/></components></object>",
              "<item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 100 100 0\"/>"),
      {{"3D/Objects/object_1.model",
        modelOf("<object id=\"1\">" + meshOf({kBody}) + "</object><object id=\"2\">" +
                    // Where the transform brings it back
                    meshOf({{{second.from.y() - 2, -(second.to.x() - 1), second.from.z() - 3},
                             {second.to.y() - 2, -(second.from.x() - 1), second.to.z() - 3}}}) +
                    "</object>",
                "")},
       {"Metadata/model_settings.config",
        R"(<config><object id="3"><metadata key="name" value="body"/><metadata key="extruder" value="1"/>)"
        R"(<part id="1" subtype="normal_part"><metadata key="name" value="first"/></part>)"
        R"(<part id="2" subtype=")" +
            kind + R"("><metadata key="name" value="second"/></part></object></config>)"}});
}

// Objects of their own, as Cura writes them.
std::string cura(const Box& second, const std::string& kind) {
  return packageOf(modelOf(
      "<object id=\"1\" name=\"body\">" + meshOf({kBody}) +
          "</object><object id=\"2\" name=\"second\"><metadatagroup><metadata name=\"cura:" + kind +
          "\" type=\"xs:string\">True</metadata></metadatagroup>" + meshOf({second}) + "</object>",
      "<item objectid=\"1\"/><item objectid=\"2\"/>"));
}

MeshFile readIn(const std::string& package) {
  return readMesh(package, "part.3mf");
}
std::vector<std::string> notesOf(const std::string& package) {
  return base::english(readIn(package).repairs);
}
std::string messageOf(const std::string& package) {
  try {
    readIn(package);
  } catch (const base::Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(ThreeMfVolumes, NegativeOnesAreCutAway) {
  for (const std::string& package :
       {prusa(kPocket, "NegativeVolume"), bambu(kPocket, "negative_part")}) {
    const MeshFile file = readIn(package);
    EXPECT_NEAR(volume(file.mesh), 32'000.0, 1e-6);
    const RepairResult mended = repair(file.mesh);
    EXPECT_TRUE(mended.repairs.empty());
    EXPECT_TRUE(mended.diagnosis.watertight);
    EXPECT_THAT(base::english(file.repairs),
                ElementsAre(HasSubstr("cut away: negative volume 'second' of 'body'")));
  }
}

TEST(ThreeMfVolumes, VolumesThatAreNotMaterialAreNamedWithTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {prusa(kBeside, "ParameterModifier"), "modifier volume"},
      {prusa(kBeside, "SupportEnforcer"), "support enforcer"},
      {prusa(kBeside, "SupportBlocker"), "support blocker"},
      {bambu(kBeside, "modifier_part"), "modifier volume"},
      {bambu(kBeside, "support_enforcer"), "support enforcer"},
      {bambu(kBeside, "support_blocker"), "support blocker"},
      {cura(kBeside, "infill_mesh"), "modifier volume"},
      {cura(kBeside, "cutting_mesh"), "modifier volume"},
      {cura(kBeside, "support_mesh"), "support enforcer"},
      {cura(kBeside, "anti_overhang_mesh"), "support blocker"}};
  for (const auto& [package, kind] : cases) {
    const MeshFile file = readIn(package);
    EXPECT_NEAR(volume(file.mesh), 38'400.0, 1e-6) << kind;
    EXPECT_THAT(base::english(file.repairs),
                ElementsAre(AllOf(HasSubstr("not used: " + kind + " 'second'"),
                                  ::testing::AnyOf(HasSubstr("at (26, 0, 10)"),
                                                   HasSubstr("at (126, 100, 10)")))));
  }
}

TEST(ThreeMfVolumes, CopiesAreCutEquallyAndNamedOnce) {
  const auto parts =
      read3mfParts(prusa(kPocket, "NegativeVolume",
                         "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0.1 0.7 0\"/>"
                         "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 90.3 0 0\"/>"
                         "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 200 0 0\"/>"),
                   "part.3mf");
  ASSERT_EQ(parts.size(), 3u);
  for (const PartOfFile& part : parts)
    EXPECT_NEAR(volume(part.file.mesh), 32'000.0, 1e-6);
  EXPECT_EQ(parts[0].file.mesh.vertices, parts[1].file.mesh.vertices);
  EXPECT_EQ(parts[0].file.repairs.size(), 1u);
}

TEST(ThreeMfVolumes, RandomPocketsHaveTheVolumeOfTheDifference) {
  std::mt19937 random(5);
  const auto uniform = [&](double lo, double hi) {
    return std::uniform_real_distribution(lo, hi)(random);
  };
  for (int run = 0; run < 20; ++run) {
    const Vector3d from(uniform(-30, 10), uniform(-30, 10), uniform(-10, 20));
    const Box pocket{from, from + Vector3d(uniform(3, 30), uniform(3, 30), uniform(3, 30))};
    const Vector3d common =
        (pocket.to.cwiseMin(kBody.to) - pocket.from.cwiseMax(kBody.from)).cwiseMax(0.0);
    EXPECT_NEAR(
        volume(readIn(run % 2 ? prusa(pocket, "NegativeVolume") : bambu(pocket, "negative_part"))
                   .mesh),
        38'400.0 - common.prod(), 1e-4)
        << run;
  }
}

TEST(ThreeMfVolumes, ANegativeThatTakesEverythingLeavesNothingToPrint) {
  EXPECT_THAT(messageOf(prusa({{-30, -30, -5}, {30, 30, 50}}, "NegativeVolume")),
              HasSubstr("contains nothing to print: cut away: negative volume 'second'"));
}

// An open negative is no solid that could be cut out.
TEST(ThreeMfVolumes, ANegativeThatCannotBeCutIsRefusedByName) {
  std::string package = packageOf(
      modelOf("<object id=\"1\">" + meshOf({kBody}) +
                  "</object><object id=\"2\"><mesh><vertices><vertex x=\"-9\" y=\"-9\" z=\"9\"/>"
                  "<vertex x=\"9\" y=\"-9\" z=\"9\"/><vertex x=\"0\" y=\"9\" z=\"9\"/></vertices>"
                  "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>"
                  "<object id=\"3\" name=\"body\"><components><component objectid=\"1\"/>"
                  "<component objectid=\"2\"/></components></object>",
              "<item objectid=\"3\"/>"),
      {{"Metadata/model_settings.config",
        R"(<config><object id="3"><part id="2" subtype="negative_part">)"
        R"(<metadata key="name" value="sheet"/></part></object></config>)"}});
  EXPECT_THAT(messageOf(package), HasSubstr("the negative volume 'sheet' cannot be cut out of"));
}

TEST(ThreeMfVolumes, ExtrudersOfObjectsAndVolumesAreNamed) {
  const std::string two =
      modelOf("<object id=\"1\">" + meshOf({kBody}) + "</object><object id=\"2\">" +
                  meshOf({kPocket}) + "</object>",
              "<item objectid=\"1\"/><item objectid=\"2\" "
              "transform=\"1 0 0 0 1 0 0 0 1 90 0 0\"/>");
  for (const char* member : {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"})
    EXPECT_THAT(notesOf(packageOf(
                    two, {{member, R"(<config><object id="1"><metadata key="extruder" value="1"/>)"
                                   R"(</object><object id="2"><metadata key="name" value="nut"/>)"
                                   R"(<metadata key="extruder" value="2"/></object></config>)"}})),
                ElementsAre(HasSubstr("not used: extruder 2 of 'nut'")));
  EXPECT_THAT(notesOf(packageOf(modelOf("<object id=\"1\" name=\"nut\"><metadatagroup><metadata "
                                        "name=\"cura:extruder_nr\">1</metadata></metadatagroup>" +
                                            meshOf({kBody}) + "</object>",
                                        "<item objectid=\"1\"/>"))),
              ElementsAre(HasSubstr("not used: extruder 2 of 'nut'")));
}

TEST(ThreeMfVolumes, DamagedSettingsAreNamed) {
  EXPECT_THAT(notesOf(packageOf(modelOf("<object id=\"1\">" + meshOf({kBody}) + "</object>",
                                        "<item objectid=\"1\"/>"),
                                {{"Metadata/Slic3r_PE_model.config", "<config><object id="}})),
              ElementsAre(HasSubstr("they are damaged")));
}

// ---- packages of other programs

TEST(ThreeMfVolumes, PackagesWith64BitSizesAreRead) {
  const std::string model =
      modelOf("<object id=\"1\">" + meshOf({kBody}) + "</object>", "<item objectid=\"1\"/>");
  EXPECT_NEAR(volume(readIn(packageOf(model, {}, true)).mesh), 38'400.0, 1e-6);
  // Numbers of the extension that point out of the file
  std::string damaged = packageOf(model, {}, true);
  for (std::size_t at = damaged.find("PK\x01\x02"); at < damaged.size(); ++at) {
    std::string wrong = damaged;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x55);
    messageOf(wrong); // Read or refused
  }
}

// Cura 4.5 exchanged the namespaces of the core and of its own words.
TEST(ThreeMfVolumes, ExchangedNamespacesAreRead) {
  std::string model = modelOf("<object id=\"1\">" + meshOf({kBody}) +
                                  "<metadatagroup><metadata name=\"cura:infill_mesh\">False"
                                  "</metadata></metadatagroup></object>",
                              "<item objectid=\"1\"/>");
  const std::string core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
  const std::string own = "http://software.ultimaker.com/xml/cura/3mf/2015/10";
  model.replace(model.find(core), core.size(), "FIRST");
  model.replace(model.find(own), own.size(), core);
  model.replace(model.find("FIRST"), 5, own);
  const MeshFile file = readIn(packageOf(model));
  EXPECT_NEAR(volume(file.mesh), 38'400.0, 1e-6);
  EXPECT_THAT(base::english(file.repairs), ElementsAre(HasSubstr("although its namespace is")));
}

// ---- statements that are ignored are named, each once

struct Statement {
  // Of the model
  std::string metadata = {}, onObject = {}, inObject = {}, onTriangle = {}, afterObject = {};
  std::string objectSettings = {}, volumes = {}, plates = {}; // of the slicer
  Members members = {};
  std::string needle = {}; // in the notes, exactly once
};

std::vector<Statement> allStatements(std::mt19937& random) {
  const std::string n = std::to_string(random() % 100000 + 100000);
  const auto setting = [](const std::string& key) {
    return R"(<metadata type="object" key=")" + key + R"(" value="7"/>)";
  };
  const auto range = [&](const std::string& kind) {
    return R"(<volume firstid="12" lastid="23"><metadata type="volume" key="name" value="w)" + n +
           R"("/><metadata type="volume" key="volume_type" value=")" + kind + R"("/></volume>)";
  };
  return {
      {.metadata = "<metadata name=\"x:density" + n + "\">3</metadata>", .needle = "x:density" + n},
      {.metadata = "<metadata name=\"cura:quality" + n + "\">3</metadata>",
       .needle = "cura:quality" + n},
      {.onObject = " x:hollow" + n + "=\"1\"", .needle = "hollow" + n},
      {.onTriangle = " x:paint" + n + "=\"4\"", .needle = "paint" + n},
      {.onTriangle = " slic3rpe:custom_supports=\"4\"", .needle = "custom_supports"},
      {.onTriangle = " paint_color=\"4\"", .needle = "paint_color"},
      {.onObject = " pid=\"9\" pindex=\"0\"",
       .onTriangle = " pid=\"9\" p1=\"1\"",
       .needle = "materials and colours"},
      {.afterObject = "<x:volume" + n + "><x:inner/></x:volume" + n + "><x:volume" + n + "/>",
       .needle = "volume" + n},
      {.afterObject = "<curve" + n + "/>", .needle = "curve" + n},
      {.onObject = " s:slicestackid=\"5\"", .needle = "slice stack"},
      {.inObject =
           "<metadatagroup><metadata name=\"cura:wall" + n + "\">4</metadata></metadatagroup>",
       .needle = "wall" + n},
      {.objectSettings = setting("fill" + n), .needle = "fill" + n},
      {.objectSettings = setting("extruder"), .needle = "extruder 7"},
      {.volumes = range("ParameterModifier"), .needle = "'w" + n},
      {.volumes = range("SupportEnforcer"), .needle = "'w" + n},
      {.volumes = range("SupportBlocker"), .needle = "'w" + n},
      {.volumes = range("Kind" + n), .needle = "Kind" + n},
      {.plates = "<plate><metadata key=\"spiral" + n + "\" value=\"1\"/><model_instance/></plate>",
       .needle = "spiral" + n},
      {.plates = "<plate><model_instance/></plate><plate><model_instance/></plate>",
       .needle = "plates"},
      {.members = {{"Metadata/Slic3r_PE.config", "; x"}}, .needle = "Slic3r_PE.config"},
      {.members = {{"Metadata/layer_heights_profile.txt", "1"}}, .needle = "layer heights"},
      {.members = {{"Metadata/custom_gcode_per_layer.xml",
                    R"(<a><layer top_z="2" type="1"/></a>)"}},
       .needle = "a pause at"},
      {.members = {{"Other/" + n + ".bin", "1"}}, .needle = "Other/" + n},
  };
}

std::string packageOf(const std::vector<Statement>& statements) {
  std::string metadata, onObject, inObject, onTriangle, afterObject, settings, volumes, plates;
  Members members;
  for (const Statement& s : statements) {
    metadata += s.metadata;
    onObject += s.onObject;
    inObject += s.inObject;
    onTriangle += s.onTriangle;
    afterObject += s.afterObject;
    settings += s.objectSettings;
    volumes += s.volumes;
    plates += s.plates;
    members.insert(members.end(), s.members.begin(), s.members.end());
  }
  std::string mesh = meshOf({kBody, kBeside});
  // In two triangles
  for (std::size_t at = mesh.find("<triangle "), i = 0; i < 2;
       ++i, at = mesh.find("<triangle ", at + 9))
    mesh.insert(at + 9, onTriangle);
  members.emplace_back("Metadata/Slic3r_PE_model.config", "<config><object id=\"1\">" + settings +
                                                              volumes + "</object>" + plates +
                                                              "</config>");
  return packageOf(
      modelOf("<basematerials id=\"9\"><base name=\"a\"/><base name=\"b\"/></basematerials>"
              "<object id=\"1\"" +
                  onObject + ">" + inObject + mesh + "</object>" + afterObject,
              "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 99 0 0\"/>",
              " xmlns:x=\"http://example.com/volumes\" "
              "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" "
              "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\"",
              metadata),
      members);
}

std::size_t countOf(const std::vector<std::string>& notes, const std::string& needle) {
  std::size_t count = 0;
  for (const std::string& note : notes)
    for (std::size_t at = note.find(needle); at != std::string::npos;
         at = note.find(needle, at + needle.size()))
      ++count;
  return count;
}

// One material in all is named as well as several.
TEST(ThreeMfVolumes, TheMaterialOfAnObjectIsNamed) {
  const auto notesWith = [](const std::string& onObject, const std::string& onTriangle) {
    std::string mesh = meshOf({kBody});
    mesh.insert(mesh.find("<triangle ") + 9, onTriangle);
    return notesOf(packageOf(
        modelOf("<basematerials id=\"9\"><base name=\"a\"/></basematerials>\n<object id=\"1\"" +
                    onObject + ">" + mesh + "</object>",
                "<item objectid=\"1\"/>")));
  };
  EXPECT_THAT(notesWith("", ""), IsEmpty());
  for (const auto& notes :
       {notesWith(" pid=\"9\" pindex=\"0\"", ""), notesWith("", " pid=\"9\" p1=\"0\"")})
    EXPECT_THAT(notes, ElementsAre(HasSubstr("not used: the material or colour of objects and "
                                             "triangles, from line 2 of 3D/3dmodel.model")));
}

TEST(ThreeMfVolumes, RecommendedExtensionsThatAreNotReadAreNamed) {
  const auto notesWith = [](const std::string& recommended) {
    return notesOf(packageOf(
        modelOf("<object id=\"1\">" + meshOf({kBody}) + "</object>", "<item objectid=\"1\"/>",
                " xmlns:zz=\"http://example.com/zz\" "
                "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
                "recommendedextensions=\"" +
                    recommended + "\"")));
  };
  EXPECT_THAT(notesWith("p"), IsEmpty());
  EXPECT_THAT(notesWith("p zz"),
              ElementsAre(HasSubstr("the recommended extension 'http://example.com/zz'")));
}

TEST(ThreeMfVolumes, TheHeightOfCurasObjectsIsNamedWhereItCounts) {
  const auto notesWith = [](const std::string& value) {
    return notesOf(
        packageOf(modelOf("<object id=\"1\" name=\"nut\"><metadatagroup><metadata "
                          "name=\"cura:drop_to_buildplate\">" +
                              value + "</metadata></metadatagroup>" + meshOf({kBody}) + "</object>",
                          "<item objectid=\"1\"/>")));
  };
  EXPECT_THAT(notesWith("True"), IsEmpty());
  EXPECT_THAT(notesWith("False"), ElementsAre(HasSubstr("'nut' (3D/3dmodel.model): "
                                                        "'drop_to_buildplate'")));
}

TEST(ThreeMfVolumes, AnotherUnitOfAFurtherModelIsNamed) {
  const auto notesWith = [](const std::string& unit) {
    std::string further = modelOf("<object id=\"1\">" + meshOf({kBody}) + "</object>", "");
    further.replace(further.find("millimeter"), 10, unit);
    return notesOf(packageOf(
        modelOf("<object id=\"2\"><components><component objectid=\"1\" "
                "p:path=\"/3D/Objects/o.model\"/></components></object>",
                "<item objectid=\"2\"/>",
                " xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\""),
        {{"3D/Objects/o.model", further}}));
  };
  EXPECT_THAT(notesWith("millimeter"), IsEmpty());
  EXPECT_THAT(notesWith("centimeter"),
              ElementsAre(HasSubstr("not used: the unit centimeter of 3D/Objects/o.model: its "
                                    "lengths are taken in millimeter")));
}

TEST(ThreeMfVolumes, IgnoredStatementsAreNamedOnce) {
  ASSERT_THAT(notesOf(packageOf(std::vector<Statement>())), IsEmpty());
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const std::vector<Statement> all = allStatements(random);
    std::vector<Statement> some{all[seed % all.size()]};
    for (const Statement& s : all)
      // One volume has one kind, and one list of plates.
      if (random() % 3 == 0 && s.needle != some[0].needle &&
          std::ranges::none_of(some, [&](const Statement& other) {
            return (!s.volumes.empty() && !other.volumes.empty()) ||
                   (!s.plates.empty() && !other.plates.empty());
          }))
        some.push_back(s);
    const std::vector<std::string> notes = notesOf(packageOf(some));
    for (const Statement& s : some)
      EXPECT_EQ(countOf(notes, s.needle), 1u) << seed << ": " << s.needle << "\n"
                                              << ::testing::PrintToString(notes);
    EXPECT_LE(notes.size(), some.size()) << seed << "\n" << ::testing::PrintToString(notes);
  }
}

} // namespace
} // namespace voluta::geometry
