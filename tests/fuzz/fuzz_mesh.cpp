// Mesh files: one input, read as each of the formats.
#include "fuzz_target.h"

#include "geometry/formats/mesh_formats.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/shapes.h"
#include "sound_mesh.h"

#include <fmt/format.h>

namespace {

using namespace voluta;

// As programs write it where numbers have commas, and lines end with CR.
std::string withCommas(std::string text) {
  for (char& c : text)
    c = c == '.' ? ',' : c == '\n' ? '\r' : c;
  return text;
}

std::string utf16(const std::string& text) {
  std::string bytes = "\xff\xfe";
  for (const char c : text)
    bytes.append({c, '\0'});
  return bytes;
}

std::string textStl(const geometry::TriangleMesh& mesh) {
  std::string text = "solid part\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int v : t) {
      const Eigen::Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
      text += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

// Vertices and triangles as most text formats list them.
std::string lists(const geometry::TriangleMesh& mesh, const char* vertex, const char* triangle,
                  int first) {
  std::string text;
  for (const Eigen::Vector3d& p : mesh.vertices)
    text += fmt::format("{}{} {} {}\n", vertex, p.x(), p.y(), p.z());
  for (const auto& t : mesh.triangles)
    text += fmt::format("{}{} {} {}\n", triangle, t[0] + first, t[1] + first, t[2] + first);
  return text;
}

std::string plyHeader(const geometry::TriangleMesh& mesh, const char* encoding) {
  return fmt::format("ply\nformat {} 1.0\ncomment a box\nelement vertex {}\nproperty float x\n"
                     "property float y\nproperty float z\nelement face {}\n"
                     "property list uchar int vertex_indices\nend_header\n",
                     encoding, mesh.vertices.size(), mesh.triangles.size());
}

std::string binaryPly(const geometry::TriangleMesh& mesh) {
  std::string bytes = plyHeader(mesh, "binary_little_endian");
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const Eigen::Vector3d& p : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis)
      put(static_cast<float>(p[axis]));
  for (const auto& t : mesh.triangles) {
    put(std::uint8_t{3});
    for (const int v : t)
      put(static_cast<std::int32_t>(v));
  }
  return bytes;
}

void readAs(const std::string& name, const std::string& bytes) {
  fuzz::takenOrRefused([&] { fuzz::expectSound(geometry::readMesh(bytes, name).mesh); });
}

} // namespace

std::vector<std::string> voluta::fuzz::seeds() {
  const geometry::TriangleMesh box = test::box({0, -1.5, 0}, {1, 2, 3.25});
  std::string polygons = lists(box, "v ", "f ", 1);
  polygons += "o other\nvn 0 0 1\nvt 0.5 0.5\nf 1/1/1 3/1/1 4/1/1 2/1/1\nf -1//1 -2//1 -3//1\n";
  return {geometry::writeStl(box),
          textStl(box),
          withCommas(textStl(box)),
          utf16(textStl(box)),
          "\xef\xbb\xbf" + polygons + "v \\\n1 2 3\nf 1 2\\\n 3\n",
          polygons,
          fmt::format("OFF\n{} {} 0\n", box.vertices.size(), box.triangles.size()) +
              lists(box, "", "3 ", 0),
          plyHeader(box, "ascii") + lists(box, "", "3 ", 0),
          binaryPly(box)};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::textOf(data, size);
  for (const geometry::MeshFormat& format : geometry::meshFormats())
    if (!format.foreign())
      readAs("input" + std::string(format.ending), bytes);
  return 0;
}
