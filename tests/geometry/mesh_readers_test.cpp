#include "geometry/formats/mesh_reader.h"

#include "base/error.h"
#include "geometry/formats/mesh_formats.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "project/sample_part.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;
using geometry::readMesh;
using geometry::TriangleMesh;
using testing::HasSubstr;

namespace {

const Vector3d kLow(-1, 2, 3), kHigh(4, 7.5, 11);

TriangleMesh boxMesh() {
  return test::box(kLow, kHigh);
}

std::string asciiStl(const TriangleMesh& m) {
  std::string s = "solid a name with facet words\n";
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    s += "  facet normal 0 0 0\n    outer loop\n";
    for (int k = 0; k < 3; ++k)
      s += fmt::format("      vertex {} +{} {:e}\r\n", m.corner(t, k).x(), m.corner(t, k).y(),
                       m.corner(t, k).z());
    s += "    endloop\n  endfacet\n";
  }
  return s + "endsolid\n";
}

std::string obj(const TriangleMesh& m) {
  std::string s = "# a box\no box\n";
  for (const auto& v : m.vertices)
    s += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& t : m.triangles)
    s += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return s;
}

std::string off(const TriangleMesh& m) {
  std::string s = fmt::format("OFF\n{} {} 0\n", m.vertices.size(), m.triangles.size());
  for (const auto& v : m.vertices)
    s += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& t : m.triangles)
    s += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return s;
}

std::string plyHeader(const TriangleMesh& m, const char* format) {
  return fmt::format("ply\nformat {} 1.0\ncomment made here\nelement vertex {}\nproperty float x\n"
                     "property float y\nproperty float z\nelement face {}\n"
                     "property list uchar int vertex_indices\nend_header\n",
                     format, m.vertices.size(), m.triangles.size());
}

std::string asciiPly(const TriangleMesh& m) {
  std::string s = plyHeader(m, "ascii");
  for (const auto& v : m.vertices)
    s += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& t : m.triangles)
    s += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return s;
}

std::string binaryPly(const TriangleMesh& m) {
  std::string s = plyHeader(m, "binary_little_endian");
  for (const auto& v : m.vertices)
    for (int k = 0; k < 3; ++k) {
      const auto x = static_cast<float>(v[k]);
      s.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
  for (const auto& t : m.triangles) {
    s += '\3';
    s.append(reinterpret_cast<const char*>(t.data()), sizeof t);
  }
  return s;
}

// A file of the mesh in each format, by its name; packages (3MF) have their own tests.
std::vector<std::pair<std::string, std::string>> filesOf(const TriangleMesh& m) {
  return {{"a.stl", geometry::writeStl(m)},
          {"b.STL", asciiStl(m)},
          {"c.obj", obj(m)},
          {"d.off", off(m)},
          {"e.ply", asciiPly(m)},
          {"f.ply", binaryPly(m)}};
}

std::string messageOf(const std::string& bytes, const std::string& name) {
  try {
    readMesh(bytes, name);
  } catch (const base::Error& e) {
    EXPECT_NE(e.code(), base::ErrorCode::Internal);
    return e.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

} // namespace

TEST(Readers, EveryFormatGivesTheSameBox) {
  const TriangleMesh m = boxMesh();
  auto files = filesOf(m);
  files.emplace_back("no extension", asciiStl(m));
  files.emplace_back("wrong.txt", asciiPly(m));
  for (const auto& [name, bytes] : files) {
    const auto file = readMesh(bytes, name);
    EXPECT_EQ(file.mesh.vertices.size(), 8u) << name;
    EXPECT_EQ(file.mesh.triangles.size(), 12u) << name;
    EXPECT_NEAR(geometry::volume(file.mesh), geometry::volume(m), 1e-4) << name;
    EXPECT_TRUE(geometry::bounds(file.mesh).min().isApprox(kLow, 1e-6)) << name;
    EXPECT_TRUE(file.repairs.empty()) << name;
  }
}

TEST(Readers, EveryFormatWithAReaderIsTested) {
  const auto files = filesOf(boxMesh());
  for (const geometry::MeshFormat& format : geometry::meshFormats())
    if (!format.foreign() && format.ending != ".3mf") {
      EXPECT_TRUE(std::ranges::any_of(files, [&](const auto& file) {
        return geometry::meshFormatOf(file.first) == &format;
      })) << format.ending;
    }
}

TEST(Readers, PolygonsAreCutIntoTriangles) {
  const auto file =
      readMesh("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 0.2 0\nv 0 1 0\nf 1 2 3 4 5\n", "p.obj");
  EXPECT_EQ(file.mesh.triangles.size(), 3u);
  EXPECT_NEAR(geometry::area(file.mesh), 1.2, 1e-6);
}

// Shapes that are not read are named, each kind once; colours and groups are none.
TEST(Readers, ShapesThatAreNotReadAreNamed) {
  const std::string face = "v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n";
  EXPECT_TRUE(readMesh("mtllib a.mtl\ng a\nusemtl red\n" + face, "p.obj").repairs.empty());
  for (const std::string word : {"surf", "curv", "curv2", "call"}) {
    const auto notes = base::english(
        readMesh(face + word + " 0 1 0 1 1 2 3\n" + word + " 0 1 0 1\n", "p.obj").repairs);
    ASSERT_EQ(notes.size(), 1u) << word;
    EXPECT_EQ(notes[0], "not used: 2 statements '" + word + "', the first in line 5");
  }
  const auto edges = base::english(
      readMesh("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
               "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n0 1\n1 2\n",
               "p.ply")
          .repairs);
  EXPECT_EQ(edges, std::vector<std::string>{"not used: 2 entries of the element 'edge'"});
}

// Negative numbers separate the strips of one list; repeated vertices join strips.
TEST(Readers, StripsOfTrianglesAreRead) {
  const auto file =
      readMesh("ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
               "property float z\nelement tristrips 1\n"
               "property list int int vertex_indices\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 0\n3 1 0\n"
               "9 0 1 2 3 -1 1 4 3 5\n",
               "p.ply");
  EXPECT_TRUE(file.repairs.empty());
  ASSERT_EQ(file.mesh.triangles.size(), 4u);
  EXPECT_NEAR(geometry::area(file.mesh), 3.0, 1e-12);
  for (std::size_t t = 0; t < 4; ++t)
    EXPECT_GT((file.mesh.corner(t, 1) - file.mesh.corner(t, 0))
                  .cross(file.mesh.corner(t, 2) - file.mesh.corner(t, 0))
                  .z(),
              0.0)
        << t;
}

TEST(Readers, FacetsOfMoreVerticesInAnStlAreNamed) {
  const std::string triangle = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\n"
                               "vertex 2 1 0\nendloop\nendfacet\n";
  std::string polygon = triangle;
  polygon.insert(polygon.find("endloop"), "vertex 1 0.2 0\nvertex 0 1 0\n");
  EXPECT_TRUE(readMesh("solid a\n" + triangle + "endsolid\n", "a.stl").repairs.empty());
  const auto file = readMesh("solid a\n" + triangle + polygon + "endsolid\n", "a.stl");
  EXPECT_NEAR(geometry::area(file.mesh), 1.0 + 1.2, 1e-12);
  EXPECT_EQ(base::english(file.repairs),
            std::vector<std::string>{"divided into triangles: 1 facet of more than three vertices, "
                                     "in line 16"});
}

TEST(Readers, BinaryHeaderMayBeginWithSolid) {
  std::string bytes = geometry::writeStl(boxMesh());
  bytes.replace(0, 11, "solid facet");
  EXPECT_EQ(readMesh(bytes, "s.stl").format, "STL (binary)");
}

// As two files that were joined: data behind the stated facets is named, not dropped silently.
TEST(Readers, DataBehindTheStatedFacetsIsNamed) {
  const std::string bytes = geometry::writeStl(boxMesh());
  const auto read = readMesh(bytes + bytes, "two.stl");
  EXPECT_EQ(read.mesh.triangles.size(), 12u);
  EXPECT_THAT(voluta::base::english(read.repairs),
              ::testing::Contains(HasSubstr("behind the 12 facets that the header states")));
  EXPECT_TRUE(readMesh(bytes, "one.stl").repairs.empty());
}

TEST(Readers, MissingLastFacetsAreNamedAsARepair) {
  const TriangleMesh m = project::samplePart();
  const std::string bytes = geometry::writeStl(m);
  const auto file = readMesh(bytes.substr(0, bytes.size() - 130), "s.stl");
  EXPECT_EQ(file.mesh.triangles.size(), m.triangles.size() - 3);
  ASSERT_EQ(file.repairs.size(), 1u);
  EXPECT_THAT(voluta::base::english(file.repairs[0]), HasSubstr("truncated"));
  EXPECT_THAT(messageOf(bytes.substr(0, bytes.size() / 2), "s.stl"), HasSubstr("truncated"));
}

TEST(Readers, BadCoordinatesAreLeftOutOrRefused) {
  const TriangleMesh m = project::samplePart();
  std::string bytes = geometry::writeStl(m);
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 84 + 50 * 7 + 16, &bad, sizeof bad);
  const auto file = readMesh(bytes, "s.stl");
  EXPECT_EQ(file.mesh.triangles.size(), m.triangles.size() - 1);
  ASSERT_EQ(file.repairs.size(), 1u);
  EXPECT_THAT(voluta::base::english(file.repairs[0]), HasSubstr("first at facet 8"));
  for (std::size_t f = 0; f < 1000; ++f)
    std::memcpy(bytes.data() + 84 + 50 * f + 16, &bad, sizeof bad);
  EXPECT_THAT(messageOf(bytes, "s.stl"), HasSubstr("1000 of"));
}

TEST(Readers, ClearErrors) {
  EXPECT_THAT(messageOf("", "a.stl"), HasSubstr("empty"));
  EXPECT_THAT(messageOf("hello", "a.txt"), HasSubstr("not a mesh"));
  EXPECT_THAT(messageOf("hello", "a.stl"), HasSubstr("truncated"));
  EXPECT_THAT(messageOf(geometry::writeStl({}), "a.stl"), HasSubstr("no triangle"));
  EXPECT_THAT(messageOf("OFF\n0 0 0\n", "a.off"), HasSubstr("a.off"));
  EXPECT_THAT(messageOf("v 0 0 0\n", "a.obj"), HasSubstr("a.obj"));
  EXPECT_THAT(messageOf("not ply", "a.ply"), HasSubstr("a.ply"));
  EXPECT_THAT(messageOf("PKnot", "a.3mf"), HasSubstr("a.3mf"));
  EXPECT_THAT(messageOf("solid\nfacet normal 0 0 0\nouter loop\nvertex 1 2 x\n", "a.stl"),
              HasSubstr("line 4"));
  EXPECT_THROW(readMesh(std::filesystem::temp_directory_path()), base::Error);
  EXPECT_THROW(readMesh(std::filesystem::path("/no/such/file.stl")), base::Error);
}

// A damaged file is a mesh or an Error, never anything else.
TEST(Readers, DamagedFilesNeverCrash) {
  const TriangleMesh m = test::sphere({0, 0, 0}, 5.0, 5);
  std::mt19937 random(7);
  int errors = 0, meshes = 0;
  for (const auto& [name, bytes] : filesOf(m))
    for (int trial = 0; trial < 1500; ++trial) {
      std::string damaged = bytes;
      if (trial % 3 == 0)
        damaged.resize(random() % damaged.size());
      for (unsigned change = trial % 3 == 0 ? 0 : 1 + random() % 6; change > 0; --change) {
        const std::size_t at = trial % 2 ? random() % damaged.size()
                                         : random() % std::min<std::size_t>(damaged.size(), 200);
        switch (random() % 3) {
        case 0:
          damaged[at] = static_cast<char>(random());
          break;
        case 1:
          damaged.erase(at, 1 + random() % 8);
          break;
        default:
          damaged.insert(at, 1, "0123456789-.\n e"[random() % 15]);
        }
        if (damaged.empty())
          break;
      }
      try {
        const auto file = readMesh(damaged, name);
        ++meshes;
        ASSERT_FALSE(file.mesh.empty());
        for (const auto& t : file.mesh.triangles)
          for (const int v : t)
            ASSERT_TRUE(v >= 0 && static_cast<std::size_t>(v) < file.mesh.vertices.size());
        for (const auto& v : file.mesh.vertices)
          ASSERT_TRUE(v.allFinite());
      } catch (const base::Error& e) {
        ++errors;
        ASSERT_NE(e.code(), base::ErrorCode::Internal) << e.what();
      }
    }
  EXPECT_GT(errors, 1000);
  EXPECT_GT(meshes, 300);
}

TEST(Placement, CentresAndDrops) {
  const auto box = geometry::bounds(geometry::placeOnPlate(boxMesh(), 2.0));
  EXPECT_TRUE(box.min().isApprox(Vector3d(-5, -5.5, 0), 1e-12));
  EXPECT_TRUE(box.max().isApprox(Vector3d(5, 5.5, 16), 1e-12));
  EXPECT_THROW(geometry::placeOnPlate(boxMesh(), 0.0), base::Error);
}

TEST(Placement, UnusualUnitsAreGuessedAndNotChanged) {
  EXPECT_TRUE(geometry::guessUnits(boxMesh()).note.empty());
  EXPECT_EQ(geometry::guessUnits(test::box({0, 0, 0}, {0.1, 0.05, 0.02})).unit, "m");
  EXPECT_EQ(geometry::guessUnits(test::box({0, 0, 0}, {1e5, 1, 1})).unit, "um");
}
