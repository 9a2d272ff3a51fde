// 3MF: what is built stands where it is built, in mm; damage is told with its place.
#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
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
  EXPECT_THAT(voluta::base::english(inches.repairs.at(0)), HasSubstr("from inch into mm"));
  const MeshFile ells = readMesh(package3mf(plainModel("ell")), "part.3mf");
  EXPECT_NEAR(volume(ells.mesh), 1.0 / 6.0, 1e-12);
  EXPECT_THAT(voluta::base::english(ells.repairs.at(0)), HasSubstr("'ell' is not known"));
}

TEST(ThreeMf, ObjectsStandWhereTheyAreUsed) {
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
  // The second one is turned by a quarter: its y lies along -x.
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

TEST(ThreeMf, DamageIsToldWithItsPlace) {
  std::string package = package3mf(plainModel(), false);
  package[package.find("<vertex x=") + 11] = '7';
  EXPECT_THAT(messageOf(package), HasSubstr("part.3mf: '3D/3dmodel.model' in it is damaged"));
  EXPECT_THAT(messageOf(package3mf(plainModel()).substr(0, 300)), HasSubstr("cut short"));

  std::string model = plainModel();
  model.replace(model.find("v3=\"3\""), 6, "v3=\"4\"");
  EXPECT_THAT(messageOf(package3mf(model)),
              HasSubstr("3D/3dmodel.model, line 7: a triangle of vertex 4, which is not there"));
  model = plainModel();
  model.replace(model.find("x=\"1\""), 5, "x=\"one\"");
  EXPECT_THAT(messageOf(package3mf(model)), HasSubstr("line 4: 'x' is no number"));
  model = plainModel();
  EXPECT_THAT(messageOf(package3mf(model.substr(0, model.size() - 20))), HasSubstr("line"));
  EXPECT_THAT(messageOf(package3mf(modelOf("", "<item objectid=\"5\"/>"))),
              HasSubstr("object '5' is not there"));
  EXPECT_THAT(messageOf(package3mf(modelOf("<object id=\"1\">" + kMesh + "</object>", ""))),
              HasSubstr("no triangle"));
}

TEST(ThreeMf, ObjectsThatHoldOneAnotherComeToAnEnd) {
  const std::string cycle = "<object id=\"1\"><components><component objectid=\"1\"/>"
                            "</components></object>";
  EXPECT_THAT(messageOf(package3mf(modelOf(cycle, "<item objectid=\"1\"/>"))),
              HasSubstr("without end"));
  // Twice the one before, forty times over.
  std::string doubling = "<object id=\"0\"/>";
  for (int i = 1; i <= 40; ++i) {
    const std::string component = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    doubling += "<object id=\"" + std::to_string(i) + "\"><components>" + component + component +
                "</components></object>";
  }
  EXPECT_THAT(messageOf(package3mf(modelOf(doubling, "<item objectid=\"40\"/>"))),
              HasSubstr("more than can be read"));
}

} // namespace
} // namespace voluta::geometry
