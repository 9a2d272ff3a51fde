// Text meshes as programs all over the world write them: each is read right, or refused in one line
// that names the reason.
#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::geometry {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// With decimals in every vertex.
TriangleMesh part() {
  return test::box({0.5, -1.25, 2.5}, {3.75, 1.5, 7.25});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string stl() {
  std::string text = "solid part, made by A. Nobody 1,5 2.0\n";
  const TriangleMesh m = part();
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    text += "facet normal 0.0 0.0 1.0\nouter loop\n";
    for (int k = 0; k < 3; ++k)
      text += fmt::format("vertex {:.2f} {:.3f} {:.4e}\n", m.corner(t, k).x(), m.corner(t, k).y(),
                          m.corner(t, k).z());
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

std::string lists(const char* vertex, const char* face, int first) {
  std::string text;
  const TriangleMesh m = part();
  for (const auto& v : m.vertices)
    text += fmt::format("{}{:.2f} {:.2f} {:.2f}\n", vertex, v.x(), v.y(), v.z());
  for (const auto& t : m.triangles)
    text += fmt::format("{}{} {} {}\n", face, t[0] + first, t[1] + first, t[2] + first);
  return text;
}
std::string obj() {
  return "# a part, by nobody\no part\n" + lists("v ", "f ", 1);
}
std::string off() {
  return "OFF\n8 12 0\n" + lists("", "3 ", 0);
}
std::string ply() {
  return "ply\nformat ascii 1.0\ncomment made by A, B\nelement vertex 8\nproperty float x\n"
         "property float y\nproperty float z\nelement face 12\n"
         "property list uchar int vertex_indices\nend_header\n" +
         lists("", "3 ", 0);
}

// Points between digits become commas.
std::string withCommas(std::string text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == '.' && std::isdigit(text[i - 1]) && std::isdigit(text[i + 1]))
      text[i] = ',';
  return text;
}

std::string utf16(const std::string& text, bool isBig, bool hasMark) {
  std::string bytes;
  const auto put = [&](unsigned unit) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xff);
    bytes += isBig ? high : low;
    bytes += isBig ? low : high;
  };
  if (hasMark)
    put(0xfeff);
  for (const char c : text)
    put(static_cast<unsigned char>(c));
  return bytes;
}

std::string refusal(const std::string& bytes, const std::string& name) {
  try {
    readMesh(bytes, name);
  } catch (const base::Error& e) {
    EXPECT_NE(e.code(), base::ErrorCode::Internal);
    return e.what();
  }
  return "was read";
}

void expectRead(const std::string& bytes, const std::string& name, const std::string& how) {
  try {
    const MeshFile file = readMesh(bytes, name);
    EXPECT_EQ(file.mesh.triangles.size(), 12u) << how << " " << name;
    EXPECT_EQ(file.mesh.vertices.size(), 8u) << how << " " << name;
    EXPECT_NEAR(volume(file.mesh), volume(part()), 1e-9) << how << " " << name;
  } catch (const base::Error& e) {
    ADD_FAILURE() << how << ": " << e.what();
  }
}

TEST(TextCustoms, EveryFormatIsReadInEveryWayOfWriting) {
  using Change = std::function<std::string(const std::string&)>;
  const std::pair<const char*, Change> ways[] = {
      {"as it is", [](const std::string& t) { return t; }},
      {"CR LF", [](const std::string& t) { return replaced(t, "\n", "\r\n"); }},
      {"CR alone", [](const std::string& t) { return replaced(t, "\n", "\r"); }},
      {"byte-order mark", [](const std::string& t) { return "\xef\xbb\xbf" + t; }},
      {"decimal commas", withCommas},
      {"UTF-16, little", [](const std::string& t) { return utf16(t, false, true); }},
      {"UTF-16, big", [](const std::string& t) { return utf16(t, true, true); }},
      {"UTF-16 without a mark", [](const std::string& t) { return utf16(t, false, false); }},
      {"all at once", [](const std::string& t) {
         return utf16(replaced(withCommas(t), "\n", "\r"), false, true);
       }}};
  for (const auto& [how, change] : ways) {
    expectRead(change(stl()), "a.stl", how);
    expectRead(change(obj()), "a.obj", how);
    expectRead(change(off()), "a.off", how);
    expectRead(change(ply()), "a.ply", how);
  }
}

TEST(TextCustoms, StlMayEndItsPartsInTwoWords) {
  std::string text = replaced(stl(), "endsolid", "end solid");
  text = replaced(replaced(text, "endfacet", "end facet"), "endloop", "END LOOP");
  expectRead(text, "a.stl", "two words");
  EXPECT_THAT(readMesh(text, "a.stl").repairs, IsEmpty());
}

TEST(TextCustoms, ObjLinesMayContinueInTheNext) {
  std::string text = replaced(obj(), "v 3.75", "v \\\n 3.75");
  text = replaced(text, "f 1 3 4", "f 1\\\n 3 \\\r\n4");
  expectRead(text, "a.obj", "continued");
  EXPECT_THAT(refusal(text + "f 1 2 \\", "a.obj"), HasSubstr("at least three corners"));
}

TEST(TextCustoms, DecimalCommasAreNamedAsARepair) {
  EXPECT_THAT(base::english(readMesh(withCommas(stl()), "a.stl").repairs),
              ::testing::ElementsAre(HasSubstr("decimal commas")));
  EXPECT_THAT(readMesh(obj(), "a.obj").repairs, IsEmpty());
}

TEST(TextCustoms, AmbiguousCommasAreRefused) {
  const std::string triangle = "v 1,500 0 0\nv 0 2,250 0\nv 0 0 3,125\nf 1 2 3\n";
  EXPECT_THAT(refusal(triangle, "a.obj"), HasSubstr("ambiguous number '3,125': decimal comma or "
                                                    "thousands separator"));
  EXPECT_EQ(refusal("v 0,5 0 0\n" + triangle, "a.obj"), "was read");
  EXPECT_THAT(refusal("v 1,5 2.5 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", "a.obj"),
              HasSubstr("line 1: numbers with decimal commas, such as '1,5', mixed with numbers "
                        "with decimal points"));
  EXPECT_THAT(refusal("v 1.0,2.0,3.0\n", "a.obj"), HasSubstr("a vertex needs three numbers"));
}

TEST(TextCustoms, OtherEncodingsAreNamed) {
  std::string utf32("\xff\xfe\0\0", 4);
  for (const char c : stl()) {
    utf32 += c;
    utf32.append(3, '\0');
  }
  EXPECT_THAT(refusal(utf32, "a.stl"), HasSubstr("a.stl: is UTF-32"));
  const std::string cut = utf16(stl(), false, true);
  EXPECT_THAT(refusal(cut.substr(0, cut.size() - 1), "a.stl"), HasSubstr("UTF-16"));
}

} // namespace
} // namespace voluta::geometry
