// The drawn shape of an imported arm: the meshes of its description, in the frames of its bodies.
#include "robot/urdf/link_meshes.h"

#include "base/files.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "resource_fixture.h"
#include "urdf_arms.h"

#include <gtest/gtest.h>

namespace voluta::robot {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

class LinkMeshes : public test::WithResources {
protected:
  fs::path at(const std::string& name) const { return folder_ / fs::path(name); }
  // Links 1 and 2 have a mesh for the eye, link 3 one that is missing, link 4 a box beside one.
  fs::path written() {
    base::writeFile(at("bar.stl"), geometry::writeStl(test::box({0, 0, 0}, {0.1, 0.2, 0.3})));
    const auto mesh = [](const std::string& file, const std::string& more = "") {
      return "<visual>" + more + "<geometry><mesh filename=\"" + file +
             "\" scale=\"1 1 2\"/></geometry></visual>";
    };
    const test::UrdfArm arm = test::irb1200();
    const std::string text = test::urdfOf(arm, [&](std::size_t i) -> std::string {
      switch (i) {
      case 1:
        return mesh("bar.stl");
      case 2:
        return mesh("bar.stl", "<origin xyz=\"0 0 1\" rpy=\"0 0 3.141592653589793\"/>") +
               mesh("bar.stl");
      case 3:
        return mesh("none.stl");
      case 4:
        return mesh("bar.stl") + "<visual><geometry><box size=\"1 1 1\"/></geometry></visual>";
      default:
        return urdfTube(arm.links[i].front());
      }
    });
    base::writeFile(at("arm.urdf"), text);
    return at("arm.urdf");
  }
  static Eigen::AlignedBox3d boundsOf(const LinkMesh& link) { return geometry::bounds(link.mesh); }

  const test::TemporaryFolder folder_;
};

TEST_F(LinkMeshes, AreThoseForTheEyeInTheirFrames) {
  const std::vector<LinkMesh> meshes = urdfLinkMeshes(written(), {});
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].frame, 1);
  EXPECT_LT((boundsOf(meshes[0]).max() - Vector3d(100, 200, 600)).norm(), 1e-3);
  EXPECT_LT(boundsOf(meshes[0]).min().norm(), 1e-3);
  // Two of them, one turned by half a turn and a metre up.
  EXPECT_EQ(meshes[1].frame, 2);
  EXPECT_LT((boundsOf(meshes[1]).min() - Vector3d(-100, -200, 0)).norm(), 1e-3);
  EXPECT_LT((boundsOf(meshes[1]).max() - Vector3d(100, 200, 1600)).norm(), 1e-3);
  EXPECT_EQ(meshes[1].mesh.triangles.size(), 24u);
}

TEST_F(LinkMeshes, AreKeptBesideTheRobotsFile) {
  const std::vector<LinkMesh> meshes = urdfLinkMeshes(written(), {});
  const fs::path robot = at("mine.json");
  EXPECT_TRUE(readLinkMeshes(robot).empty());
  writeLinkMeshes(robot, meshes);
  const std::vector<LinkMesh> read = readLinkMeshes(robot);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1].frame, 2);
  EXPECT_TRUE(boundsOf(read[1]).isApprox(boundsOf(meshes[1]), 1e-5));
  // One that is damaged is not there; without any there is no folder.
  base::writeFile(at("mine.links/1.stl"), "no mesh");
  EXPECT_EQ(readLinkMeshes(robot).size(), 1u);
  writeLinkMeshes(robot, {});
  EXPECT_FALSE(fs::exists(at("mine.links")));
  EXPECT_TRUE(linkMeshesOf("ur5").empty());
  EXPECT_TRUE(linkMeshesOf("no-such-arm").empty());
}

} // namespace
} // namespace voluta::robot
