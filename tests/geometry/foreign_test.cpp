// Formats that come through the program beside this one.
#include "base/error.h"
#include "base/files.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/measures.h"
#include "helpers/temporary_folder.h"

#include <cstring>
#include <gmock/gmock.h>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

// A box of 0.2 x 0.1 x 0.3 in the file's unit, its corner at 0.
std::string collada(const std::string& up, const std::string& metresInUnit) {
  std::string points;
  for (int i = 0; i < 8; ++i)
    points +=
        std::string(i & 1 ? "0.2 " : "0 ") + (i & 2 ? "0.1 " : "0 ") + (i & 4 ? "0.3 " : "0 ");
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter=")" +
         metresInUnit + R"("/><up_axis>)" + up + R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">)" +
         points + R"(</float_array><technique_common><accessor source="#a" count="8" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

class Foreign : public ::testing::Test {
protected:
  std::filesystem::path written(const std::string& name, const std::string& bytes) {
    const std::filesystem::path file = folder_ / std::filesystem::path(name);
    base::writeFile(file, bytes);
    return file;
  }
  std::string complaint(const std::filesystem::path& file,
                        std::chrono::milliseconds limit = std::chrono::seconds(30)) {
    try {
      readForeign(file, ForeignFrame::Upright, limit);
    } catch (const base::Error& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      return e.what();
    }
    return {};
  }
  static Vector3d sizeOf(const MeshFile& file) { return bounds(file.mesh).sizes(); }

  const test::TemporaryFolder folder_;
};

TEST_F(Foreign, ColladaHasItsUnitAndItsUp) {
  const auto z = written("z.dae", collada("Z_UP", "1")), y = written("y.DAE", collada("Y_UP", "1")),
             cm = written("cm.dae", collada("Z_UP", "0.01"));
  ASSERT_TRUE(isForeign(y));
  EXPECT_FALSE(isForeign("part.stl"));
  const MeshFile upright = readForeign(z, ForeignFrame::Upright);
  EXPECT_EQ(upright.format, "COLLADA");
  EXPECT_EQ(upright.mesh.triangles.size(), 12u);
  EXPECT_EQ(upright.mesh.vertices.size(), 8u);
  EXPECT_LT((sizeOf(upright) - Vector3d(200, 100, 300)).norm(), 1e-3);
  EXPECT_LT((sizeOf(readForeign(y, ForeignFrame::Upright)) - Vector3d(200, 300, 100)).norm(), 1e-3);
  EXPECT_LT((sizeOf(readForeign(cm, ForeignFrame::Upright)) - Vector3d(2, 1, 3)).norm(), 1e-5);
  // Files referenced by a URDF: metres, axes as in the file.
  EXPECT_LT((sizeOf(readForeign(y, ForeignFrame::AsWritten)) - Vector3d(0.2, 0.1, 0.3)).norm(),
            1e-6);
  EXPECT_LT(
      (sizeOf(readForeign(cm, ForeignFrame::AsWritten)) - 0.01 * Vector3d(0.2, 0.1, 0.3)).norm(),
      1e-6);
}

TEST_F(Foreign, GltfTakesTheBufferBesideIt) {
  const float points[9] = {0, 0, 0, 0.2F, 0, 0, 0, 0.1F, 0};
  const std::string bytes(reinterpret_cast<const char*>(points), sizeof(points));
  written("corner.bin", bytes);
  const auto file = written("corner.gltf", R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "buffers":[{"uri":"corner.bin","byteLength":36}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                  "min":[0,0,0],"max":[0.2,0.1,0]}]})");
  const MeshFile corner = readForeign(file, ForeignFrame::Upright);
  EXPECT_EQ(corner.mesh.triangles.size(), 1u);
  EXPECT_LT((sizeOf(corner) - Vector3d(200, 0, 100)).norm(), 1e-3); // y is up in glTF
  std::filesystem::remove(folder_ / std::filesystem::path("corner.bin"));
  EXPECT_THAT(complaint(file), HasSubstr("corner.gltf"));
}

TEST_F(Foreign, DamagedFilesAreRefusedWithAReason) {
  const std::string whole = collada("Z_UP", "1");
  EXPECT_THAT(complaint(folder_ / std::filesystem::path("none.dae")), HasSubstr("no such file"));
  EXPECT_THAT(complaint(written("empty.dae", "")), HasSubstr("cannot be read"));
  EXPECT_THAT(complaint(written("words.glb", "not a mesh at all")), HasSubstr("cannot be read"));
  EXPECT_THAT(complaint(written("half.dae", whole.substr(0, whole.size() / 2))),
              HasSubstr("half.dae"));
  std::string astray = whole; // an index far beyond the points
  astray.replace(astray.find("<p>0 2 1"), 8, "<p>0 2 99999999");
  EXPECT_THAT(complaint(written("astray.dae", astray)), HasSubstr("astray.dae"));
  EXPECT_THAT(complaint(written("slow.dae", whole), std::chrono::milliseconds(0)),
              HasSubstr("too long"));
}

} // namespace
} // namespace voluta::geometry
