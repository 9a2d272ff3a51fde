// 3MF: build items keep their place, in mm; errors name the place of the damage.
#include "base/error.h"
#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "geometry/repair/repair.h"
#include "helpers/package_3mf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::geometry {
namespace {

using test::package3mf;
using ::testing::HasSubstr;

// A tetrahedron of a sixth of a cubic unit.
const std::string kMesh = R"(<mesh><vertices>
<vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/>
</vertices><triangles>
<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>
<triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/>
</triangles></mesh>)";

std::string modelOf(const std::string& resources, const std::string& build,
                    const std::string& unit = "millimeter") {
  return "<?xml version=\"1.0\"?>\n<model unit=\"" + unit +
         "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>" +
         resources + "</resources>\n<build>" + build + "</build>\n</model>\n";
}

std::string plainModel(const std::string& unit = "millimeter") {
  return modelOf("<object id=\"1\">" + kMesh + "</object>", "<item objectid=\"1\"/>", unit);
}

std::string messageOf(const std::string& package) {
  try {
    readMesh(package, "part.3mf");
  } catch (const base::Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(ThreeMf, IsReadPackedOrNot) {
  for (const bool deflates : {true, false}) {
    const MeshFile file = readMesh(package3mf(plainModel(), deflates), "part.3mf");
    EXPECT_EQ(file.format, "3MF");
    EXPECT_EQ(file.mesh.vertices.size(), 4u);
    EXPECT_NEAR(volume(file.mesh), 1.0 / 6.0, 1e-12);
    EXPECT_TRUE(file.repairs.empty());
  }
}

TEST(ThreeMf, LengthsBecomeMillimetres) {
  const MeshFile inches = readMesh(package3mf(plainModel("inch")), "part.3mf");
  EXPECT_NEAR(volume(inches.mesh), 25.4 * 25.4 * 25.4 / 6.0, 1e-9);
  EXPECT_THAT(voluta::base::english(inches.repairs.at(0)), HasSubstr("from inch to mm"));
  const MeshFile ells = readMesh(package3mf(plainModel("ell")), "part.3mf");
  EXPECT_NEAR(volume(ells.mesh), 1.0 / 6.0, 1e-12);
  EXPECT_THAT(voluta::base::english(ells.repairs.at(0)), HasSubstr("unknown unit 'ell'"));
}

TEST(ThreeMf, ObjectsAreTransformedByItemsAndComponents) {
  const std::string resources = "<object id=\"1\">" + kMesh +
                                "</object><object id=\"2\"><components>"
                                "<component objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 0 0 0\"/>"
                                "<component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 5 0 0\"/>"
                                "</components></object>";
  const MeshFile file =
      readMesh(package3mf(modelOf(resources, "<item objectid=\"2\" "
                                             "transform=\"1 0 0 0 1 0 0 0 1 0 0 7\"/>")),
               "part.3mf");
  EXPECT_EQ(file.mesh.triangles.size(), 8u);
  EXPECT_NEAR(volume(file.mesh), 9.0 / 6.0, 1e-12);
  const Eigen::AlignedBox3d box = bounds(file.mesh);
  // The second one is rotated by 90 degrees: its y points along -x.
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(0, 0, 7)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(5, 2, 9)));
}

TEST(ThreeMf, AMirroredObjectIsNotInsideOut) {
  const MeshFile file = readMesh(package3mf(modelOf("<object id=\"1\">" + kMesh + "</object>",
                                                    "<item objectid=\"1\" "
                                                    "transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>")),
                                 "part.3mf");
  EXPECT_NEAR(volume(file.mesh), 1.0 / 6.0, 1e-12);
}

TEST(ThreeMf, ModelsBesideTheMainOneAreFound) {
  const MeshFile file = readMesh(
      package3mf(modelOf("<object id=\"9\"><components><component "
                         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/"
                         "06\" p:path=\"/3D/further.model\" objectid=\"1\"/></components></object>",
                         "<item objectid=\"9\"/>"),
                 true, plainModel()),
      "part.3mf");
  EXPECT_EQ(file.mesh.triangles.size(), 4u);
}

TEST(ThreeMf, ErrorsNameThePlaceOfTheDamage) {
  std::string package = package3mf(plainModel(), false);
  package[package.find("<vertex x=") + 11] = '7';
  EXPECT_THAT(messageOf(package), HasSubstr("part.3mf: '3D/3dmodel.model' in it is damaged"));
  EXPECT_THAT(messageOf(package3mf(plainModel()).substr(0, 300)), HasSubstr("truncated"));

  std::string model = plainModel();
  model.replace(model.find("v3=\"3\""), 6, "v3=\"4\"");
  EXPECT_THAT(messageOf(package3mf(model)),
              HasSubstr("3D/3dmodel.model, line 7: a triangle refers to the missing vertex 4"));
  model = plainModel();
  model.replace(model.find("x=\"1\""), 5, "x=\"one\"");
  EXPECT_THAT(messageOf(package3mf(model)), HasSubstr("line 4: 'x' is not a number"));
  model = plainModel();
  EXPECT_THAT(messageOf(package3mf(model.substr(0, model.size() - 20))), HasSubstr("line"));
  EXPECT_THAT(messageOf(package3mf(modelOf("", "<item objectid=\"5\"/>"))),
              HasSubstr("object '5' is missing"));
  EXPECT_THAT(messageOf(package3mf(modelOf("<object id=\"1\">" + kMesh + "</object>", ""))),
              HasSubstr("no triangle"));
  // Ids are unique: it would take the place of the first.
  const std::string object = "<object id=\"1\">" + kMesh + "</object>";
  EXPECT_THAT(messageOf(package3mf(modelOf(object + object, "<item objectid=\"1\"/>"))),
              HasSubstr("a second object of the id '1'"));
}

TEST(ThreeMf, CyclicAndDoublingObjectsAreRefused) {
  const std::string cycle = "<object id=\"1\"><components><component objectid=\"1\"/>"
                            "</components></object>";
  EXPECT_THAT(messageOf(package3mf(modelOf(cycle, "<item objectid=\"1\"/>"))),
              HasSubstr("contain each other"));
  // Twice the one before, forty times over.
  std::string doubling = "<object id=\"0\"/>";
  for (int i = 1; i <= 40; ++i) {
    const std::string component = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    doubling += "<object id=\"" + std::to_string(i) + "\"><components>" + component + component +
                "</components></object>";
  }
  EXPECT_THAT(messageOf(package3mf(modelOf(doubling, "<item objectid=\"40\"/>"))),
              HasSubstr("too many to read"));
}

// ---- objects that are not parts

std::string objectOf(const std::string& id, const std::string& type) {
  return "<object id=\"" + id + "\" type=\"" + type + "\">" + kMesh + "</object>";
}

TEST(ThreeMf, OnlyModelsThatArePrintedArePrinted) {
  const std::string resources =
      objectOf("1", "model") + objectOf("2", "support") + objectOf("3", "solidsupport") +
      objectOf("4", "surface") + objectOf("5", "other") +
      // An object of components has the types of its components.
      "<object id=\"6\" type=\"support\"><components><component objectid=\"1\"/>"
      "<component objectid=\"2\"/></components></object>";
  std::string build;
  for (const char* id : {"1", "2", "3", "4", "5", "6"})
    build += std::string("<item objectid=\"") + id + "\"/>";
  build += "<item objectid=\"1\" printable=\"0\"/><item objectid=\"1\" printable=\"1\"/>";
  const MeshFile file = readMesh(package3mf(modelOf(resources, build)), "part.3mf");
  EXPECT_EQ(file.mesh.triangles.size(), 3u * 4u);
  EXPECT_THAT(base::english(file.repairs),
              ::testing::ElementsAre(HasSubstr("skipped: 1 item marked as not printable"),
                                     HasSubstr("skipped: 3 support objects"),
                                     HasSubstr("skipped: 1 object of type 'surface'"),
                                     HasSubstr("skipped: 1 object of type 'other'")));
}

TEST(ThreeMf, ErrorListsTheSkippedObjectsIfNothingIsToBePrinted) {
  EXPECT_THAT(messageOf(package3mf(modelOf(objectOf("1", "support"),
                                           "<item objectid=\"1\"/><item objectid=\"1\"/>"))),
              HasSubstr("part.3mf: contains nothing to print: skipped: 2 support objects"));
  EXPECT_THAT(messageOf(package3mf(modelOf(objectOf("1", "part"), "<item objectid=\"1\"/>"))),
              HasSubstr("an object of the unknown type 'part'"));
}

TEST(ThreeMf, SlicedGcodeIsNamed) {
  test::ZipWriter zip(true);
  zip.add("_rels/.rels", "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/"
                         "relationships\"/>");
  zip.add("Metadata/plate_1.gcode", "G28\n");
  EXPECT_THAT(
      messageOf(zip.bytes()),
      HasSubstr("part.3mf: contains sliced G-code ('Metadata/plate_1.gcode') and no model"));
  test::ZipWriter withModel(true);
  withModel.add("_rels/.rels",
                "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/"
                "relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"r\" Type=\"http://"
                "schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>");
  withModel.add("3D/3dmodel.model", modelOf("", ""));
  withModel.add("Metadata/plate_1.gcode", "G28\n");
  EXPECT_THAT(messageOf(withModel.bytes()), HasSubstr("sliced G-code"));
}

// ---- extensions

std::string extended(const std::string& resources, const std::string& requires_ = {}) {
  return "<?xml version=\"1.0\"?>\n<model unit=\"millimeter\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" "
         "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" "
         "xmlns:x=\"http://example.com/volumes\" requiredextensions=\"" +
         requires_ + "\">\n<resources>" + resources +
         "</resources>\n<build><item objectid=\"1\"/></build>\n</model>\n";
}

std::string latticeOf(const std::string& attributes, const std::string& beams,
                      const std::string& more = {}) {
  return "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" "
         "y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"20\"/></vertices><triangles/>"
         "<b:beamlattice radius=\"1\" minlength=\"0.01\" " +
         attributes + "><b:beams>" + beams + "</b:beams>" + more +
         "</b:beamlattice></mesh></object>";
}

TEST(ThreeMf, SlicesAreRefusedUnlessTheMeshIsTheShape) {
  const auto sliced = [](const std::string& resolution) {
    return package3mf(extended("<s:slicestack id=\"7\" zbottom=\"0\"><s:slice ztop=\"1\">"
                               "<s:vertices><s:vertex x=\"0\" y=\"0\"/></s:vertices></s:slice>"
                               "</s:slicestack><object id=\"1\" s:slicestackid=\"7\" "
                               "s:meshresolution=\"" +
                                   resolution + "\">" + kMesh + "</object>",
                               "s"));
  };
  EXPECT_THAT(messageOf(sliced("lowres")), HasSubstr("object '1' is stored as slices (slicestack), "
                                                     "which cannot be read"));
  EXPECT_EQ(readMesh(sliced("fullres"), "part.3mf").mesh.triangles.size(), 4u);
}

TEST(ThreeMf, BeamsAreRoundBars) {
  // A bar with flat ends, a cone, and balls at the given nodes.
  const auto volumeOf = [](const std::string& model) {
    return volume(readMesh(package3mf(extended(model, "b")), "part.3mf").mesh);
  };
  constexpr double kPi = base::kPi;
  EXPECT_NEAR(volumeOf(latticeOf("cap=\"butt\"", "<b:beam v1=\"0\" v2=\"1\"/>")), kPi * 10, 1e-9);
  EXPECT_NEAR(volumeOf(latticeOf("cap=\"butt\"", "<b:beam v1=\"0\" v2=\"2\" r1=\"2\" r2=\"1\"/>")),
              kPi / 3 * 20 * (4 + 2 + 1), 1e-9);
  // Shells that overlap count twice before they are united.
  EXPECT_NEAR(volumeOf(latticeOf("", "<b:beam v1=\"0\" v2=\"1\" cap1=\"butt\"/>")),
              kPi * 10 + kPi * 4 / 3, 1e-9);
  EXPECT_NEAR(volumeOf(latticeOf("cap=\"butt\" ballmode=\"all\" ballradius=\"3\"",
                                 "<b:beam v1=\"0\" v2=\"1\"/>")),
              kPi * 10 + 2 * kPi * 36, 1e-9);
  EXPECT_NEAR(volumeOf(latticeOf("cap=\"butt\" ballmode=\"mixed\" ballradius=\"3\"",
                                 "<b:beam v1=\"0\" v2=\"1\"/>",
                                 "<b:balls><b:ball vindex=\"1\" r=\"2\"/></b:balls>")),
              kPi * 10 + kPi * 32 / 3, 1e-9);
}

TEST(ThreeMf, ALatticeBecomesOneSolid) {
  const MeshFile file =
      readMesh(package3mf(extended(
                   latticeOf("", "<b:beam v1=\"0\" v2=\"1\"/><b:beam v1=\"0\" v2=\"2\"/>"), "b")),
               "part.3mf");
  EXPECT_THAT(base::english(file.repairs),
              ::testing::ElementsAre(HasSubstr("converted 2 lattice beams into round bars")));
  const RepairResult united = repair(file.mesh);
  EXPECT_EQ(united.diagnosis.components, 1);
  EXPECT_EQ(united.diagnosis.selfIntersections.count, 0u);
  EXPECT_TRUE(united.diagnosis.watertight);
  // Two cylinders that overlap in a quarter of Steinmetz's solid, half a ball at either end, and a
  // quarter of one at the corner.
  EXPECT_NEAR(united.diagnosis.volumeMm3, base::kPi * 30 - 4.0 / 3.0 + base::kPi * 4.0 / 3.0 * 1.25,
              0.3);
}

TEST(ThreeMf, BeamsThatCannotBeReadAreNamed) {
  EXPECT_THAT(messageOf(package3mf(extended(latticeOf("clippingmode=\"inside\" clippingmesh=\"9\"",
                                                      "<b:beam v1=\"0\" v2=\"1\"/>")))),
              HasSubstr("object '1' has a beam lattice clipped by a mesh"));
  EXPECT_THAT(messageOf(package3mf(extended(latticeOf("", "<b:beam v1=\"0\" v2=\"8\"/>")))),
              HasSubstr("a beam refers to the missing vertex 8"));
  EXPECT_THAT(
      messageOf(package3mf(extended(latticeOf("", "<b:beam v1=\"0\" v2=\"1\" r1=\"0\"/>")))),
      HasSubstr("a beam without a radius"));
}

TEST(ThreeMf, AnUnknownExtensionThatItRequiresIsNamed) {
  EXPECT_THAT(messageOf(package3mf(extended("<object id=\"1\">" + kMesh + "</object>", "b x"))),
              HasSubstr("requires the unknown extension 'http://example.com/volumes'"));
}

} // namespace
} // namespace voluta::geometry
