// A 3MF of several objects becomes several parts, each in its place in the file.
#include "geometry/formats/threemf_parts.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "helpers/boxes_3mf.h"
#include "helpers/package_3mf.h"
#include "helpers/temporary_folder.h"
#include "project/file_parts.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using test::boxMesh, test::model3mf, test::moved, test::object3mf, test::package3mf, test::use3mf;
using ::testing::HasSubstr;

std::vector<PartOfFile> partsOf(const std::string& resources, const std::string& build,
                                 const std::string& unit = "millimeter") {
  return read3mfParts(package3mf(model3mf(resources, build, unit)), "job.3mf");
}

Eigen::AlignedBox3d boxInFile(const PartOfFile& part) {
  return bounds(part.file.mesh).translated(part.placeMm);
}

const std::string kTwo =
    object3mf(1, "bracket", boxMesh({20, 12, 5})) + object3mf(2, "post", boxMesh({10, 8, 40}));

TEST(ThreeMfParts, EachBuildItemIsAPartInItsPlace) {
  const auto parts =
      partsOf(kTwo, use3mf("item", 1, moved(100, 50)) + use3mf("item", 2, moved(-7, 3)));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "bracket");
  EXPECT_EQ(parts[1].name, "post");
  EXPECT_TRUE(boxInFile(parts[0]).min().isApprox(Vector3d(100, 50, 0)));
  EXPECT_TRUE(boxInFile(parts[1]).max().isApprox(Vector3d(3, 11, 40)));
}

TEST(ThreeMfParts, CopiesOfAnObjectHaveEqualMeshes) {
  const auto parts =
      partsOf(kTwo, use3mf("item", 1, moved(0.1, 0.7)) + use3mf("item", 1, moved(33, 0)));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].file.mesh.vertices, parts[1].file.mesh.vertices);
  EXPECT_EQ(parts[1].placeMm, Vector3d(33, 0, 0));
}

TEST(ThreeMfParts, AFileOfOnePartIsReadAsBefore) {
  const std::string package = package3mf(model3mf(kTwo, use3mf("item", 2, moved(0.1, 0.2))));
  const auto parts = read3mfParts(package, "job.3mf");
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].file.mesh.vertices, readMesh(package, "job.3mf").mesh.vertices);
  EXPECT_EQ(parts[0].placeMm, Vector3d::Zero());
}

std::string assemblyOf(const Eigen::Affine3d& second) {
  return kTwo + object3mf(3, "assembly",
                          "<components>" + use3mf("component", 1, moved(0, 0)) +
                              use3mf("component", 2, second) + "</components>");
}

TEST(ThreeMfParts, ComponentsApartOnOneHeightAreParts) {
  const auto parts = partsOf(assemblyOf(moved(60, 0)), use3mf("item", 3, moved(5, 5)));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "bracket");
  EXPECT_TRUE(boxInFile(parts[1]).min().isApprox(Vector3d(65, 5, 0)));
}

TEST(ThreeMfParts, ComponentsThatTouchOrBeginAtOtherHeightsAreOnePart) {
  const auto touching = partsOf(assemblyOf(moved(20, 2)), use3mf("item", 3, moved(0, 0)));
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].file.mesh.triangles.size(), 24u);
  EXPECT_EQ(partsOf(assemblyOf(moved(60, 0, 4)), use3mf("item", 3, moved(0, 0))).size(), 1u);
  // An assembly of its own beside a part keeps its name.
  const auto beside = partsOf(assemblyOf(moved(20, 2)),
                              use3mf("item", 3, moved(0, 0)) + use3mf("item", 2, moved(90, 0)));
  ASSERT_EQ(beside.size(), 2u);
  EXPECT_EQ(beside[0].name, "assembly");
}

TEST(ThreeMfParts, AnObjectWithoutAMeshIsNoted) {
  const auto parts = partsOf(kTwo + object3mf(4, "empty", ""), use3mf("item", 4, moved(0, 0)) +
                                                                   use3mf("item", 1, moved(0, 0)) +
                                                                   use3mf("item", 2, moved(50, 0)));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "bracket");
  EXPECT_THAT(base::english(parts[0].file.repairs.at(0)), HasSubstr("1 object without a mesh"));
}

TEST(ThreeMfParts, DamageNamesItsPlace) {
  const auto messageOf = [](const std::string& resources, const std::string& build) {
    try {
      partsOf(resources, build);
    } catch (const base::Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  const std::string items = use3mf("item", 1, moved(0, 0)) + use3mf("item", 2, moved(50, 0));
  EXPECT_THAT(messageOf(kTwo, items + use3mf("item", 7, moved(0, 0))),
              HasSubstr("object '7' is missing"));
  std::string broken = kTwo;
  broken.replace(broken.find("v1=\"0\""), 6, "v1=\"8\"");
  EXPECT_THAT(messageOf(broken, items), HasSubstr("refers to the missing vertex 8"));
  EXPECT_THAT(messageOf(kTwo, "<item objectid=\"1\" transform=\"1 0 0\"/>"),
              HasSubstr("twelve numbers"));
  std::string many;
  for (int i = 0; i < 256; ++i)
    many += use3mf("item", 1, moved(30.0 * i, 0));
  EXPECT_THAT(messageOf(kTwo, many), HasSubstr("256 parts"));
}

TEST(ThreeMfParts, NamesOfSlicersAreRead) {
  test::ZipWriter zip(true);
  zip.add("_rels/.rels",
          "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
          "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
          "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
          "</Relationships>");
  zip.add("3D/3dmodel.model",
          model3mf(object3mf(1, "", boxMesh({9, 9, 9})) + object3mf(2, "", boxMesh({5, 5, 5})),
                   use3mf("item", 1, moved(0, 0)) + use3mf("item", 2, moved(50, 0))));
  zip.add("Metadata/Slic3r_PE_model.config",
          R"(<config><object id="1"><metadata type="object" key="name" value="hook.stl"/>)"
          R"(<volume firstid="0"><metadata type="volume" key="name" value="no"/></volume></object>)"
          R"(<object id="2"><metadata type="object" key="name" value="nut"/></object></config>)");
  const auto parts = read3mfParts(zip.bytes(), "job.3mf");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "hook.stl");
  EXPECT_EQ(parts[1].name, "nut");
}

// ---- placement

Eigen::Affine3d randomUse(std::mt19937& random, double x) {
  const auto uniform = [&](double lo, double hi) {
    return std::uniform_real_distribution(lo, hi)(random);
  };
  Eigen::Affine3d at = moved(x, uniform(-200, 200), uniform(0, 30));
  at.rotate(
      Eigen::AngleAxisd(uniform(0, 6), Vector3d(uniform(-1, 1), uniform(-1, 1), 1.0).normalized()));
  return at * Eigen::Scaling(uniform(0.5, 2), uniform(-2, -0.5), uniform(0.5, 2));
}

TEST(ThreeMfParts, PlacedBoxesAreThoseOfTheFile) {
  std::mt19937 random(41);
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "placed_boxes.3mf";
  for (int run = 0; run < 100; ++run) {
    std::string build;
    std::vector<Eigen::AlignedBox3d> boxes;
    Eigen::AlignedBox3d whole;
    const std::array<Vector3d, 2> sizes{Vector3d(20, 12, 5), Vector3d(10, 8, 40)};
    const int count = 2 + run % 4;
    for (int i = 0; i < count; ++i) {
      const Eigen::Affine3d at = randomUse(random, 300.0 * i);
      build += use3mf("item", 1 + i % 2, at);
      Eigen::AlignedBox3d box;
      for (int corner = 0; corner < 8; ++corner)
        box.extend(at * sizes[static_cast<std::size_t>(i % 2)].cwiseProduct(
                            Vector3d(corner & 1, (corner >> 1) & 1, corner >> 2)));
      boxes.push_back(box);
      whole.extend(box);
    }
    std::ofstream(file, std::ios::binary) << package3mf(model3mf(kTwo, build));
    const auto parts = project::loadParts(file.string(), true, {});
    ASSERT_EQ(parts.size(), boxes.size());
    const double scale = run % 3 == 0 ? 0.5 : 1.0;
    const auto places = project::placesInFile(parts, scale, Eigen::Quaterniond::Identity());
    const Vector3d foot(whole.center().x(), whole.center().y(), whole.min().z());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Eigen::AlignedBox3d got = bounds(place(*parts[i].part->mesh, scale, places[i]));
      EXPECT_LT((got.min() - scale * (boxes[i].min() - foot)).norm(), 0.011) << run;
      EXPECT_LT((got.max() - scale * (boxes[i].max() - foot)).norm(), 0.011) << run;
    }
  }
}

TEST(ThreeMfParts, ATurnOfTheWholeTurnsThePlaces) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "turned.3mf";
  std::ofstream(file, std::ios::binary) << package3mf(
      model3mf(kTwo, use3mf("item", 1, moved(0, 0)) + use3mf("item", 2, moved(100, 0))));
  const auto parts = project::loadParts(file.string(), true, {});
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()));
  const auto places = project::placesInFile(parts, 1.0, quarter);
  // The whole is 110 by 12 mm; the post's centre is 50 mm from its middle.
  EXPECT_NEAR(places[1].centreMm.y(), 50.0, 1e-9);
  EXPECT_NEAR(places[1].centreMm.x(), 2.0, 1e-9);
  EXPECT_FALSE(project::touchingParts(parts));
}

} // namespace
} // namespace voluta::geometry
