// Obstacles from files: as they were drawn, and refused in a line where nothing can be made of
// them.
#include "cells/obstacle_file.h"

#include "base/error.h"
#include "base/files.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"

#include <gmock/gmock.h>

namespace voluta::cells {
namespace {

using Eigen::Vector3d;

class ObstacleFiles : public ::testing::Test {
protected:
  std::filesystem::path written(const std::string& name, const std::string& bytes) {
    const std::filesystem::path file = folder_ / std::filesystem::path(name);
    base::writeFile(file, bytes);
    return file;
  }
  static std::vector<robot::Shape> read(const std::filesystem::path& file, double mmPerUnit = 1.0) {
    return obstacleOfFile(file, mmPerUnit, base::RunContext{}).solids;
  }
  static void expectBox(const std::vector<robot::Shape>& shapes, const Vector3d& low,
                        const Vector3d& high) {
    ASSERT_EQ(shapes.size(), 1u);
    const auto* box = std::get_if<robot::Box>(&shapes.front());
    ASSERT_NE(box, nullptr);
    EXPECT_LT((box->frame_T_box.translation() - 0.5 * (low + high)).norm(), 1e-3);
    EXPECT_LT((2.0 * box->half - (high - low)).norm(), 1e-3);
  }
  const test::TemporaryFolder folder_;
};

TEST_F(ObstacleFiles, KeepTheCoordinatesOfTheFile) {
  const auto block = test::box({-20, 300, 0}, {60, 340, 250});
  expectBox(read(written("post.stl", geometry::writeStl(block))), {-20, 300, 0}, {60, 340, 250});
  expectBox(
      read(written("metres.stl", geometry::writeStl(test::box({-0.5, 0.25, 0}, {0.5, 0.75, 2}))),
           1000.0),
      {-500, 250, 0}, {500, 750, 2000});
  EXPECT_NEAR(obstacleOfFile(folder_ / std::filesystem::path("post.stl"), 1.0, base::RunContext{})
                  .longestMm,
              250.0, 1e-3);
  std::string obj;
  for (const Vector3d& p : block.vertices)
    obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
           std::to_string(p.z()) + "\n";
  for (const auto& t : block.triangles)
    obj += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
           std::to_string(t[2] + 1) + "\n";
  expectBox(read(written("post.obj", obj)), {-20, 300, 0}, {60, 340, 250});
}

// By the program that reads others' formats; glTF counts in metres and has y up.
TEST_F(ObstacleFiles, AreUprightAndInMm) {
  const auto block = test::box({0, 0, 0}, {0.2, 0.3, 0.1});
  std::string bytes;
  for (const Vector3d& p : block.vertices)
    for (int k = 0; k < 3; ++k) {
      const auto value = static_cast<float>(p[k]);
      bytes.append(reinterpret_cast<const char*>(&value), 4);
    }
  for (const auto& t : block.triangles)
    for (const int v : t) {
      const auto index = static_cast<std::uint16_t>(v);
      bytes.append(reinterpret_cast<const char*>(&index), 2);
    }
  written("post.bin", bytes);
  const auto file = written("post.gltf", R"({"asset":{"version":"2.0"},"scene":0,
"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"uri":"post.bin","byteLength":168}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},
{"buffer":0,"byteOffset":96,"byteLength":72}],
"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3",
"min":[0,0,0],"max":[0.2,0.3,0.1]},
{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}]})");
  expectBox(read(file), {0, -100, 0}, {200, 0, 300});
}

TEST_F(ObstacleFiles, FilesWithoutASolidAreRefused) {
  const auto refused = [&](const std::filesystem::path& file) {
    try {
      read(file);
    } catch (const base::Error& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused(folder_ / std::filesystem::path("none.stl")), ::testing::HasSubstr("none"));
  EXPECT_THAT(refused(written("words.stl", "no mesh at all")), ::testing::HasSubstr("words.stl"));
  EXPECT_THAT(refused(written("half.dae", "<COLLADA")), ::testing::HasSubstr("half.dae"));
  geometry::TriangleMesh point;
  point.vertices.assign(3, Vector3d(1, 2, 3));
  point.triangles = {{0, 1, 2}};
  EXPECT_FALSE(refused(written("point.stl", geometry::writeStl(point))).empty());
}

} // namespace
} // namespace voluta::cells
