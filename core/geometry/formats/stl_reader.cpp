#include "geometry/formats/facet_soup.h"

#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/formats/text_scanner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <optional>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;
// A file that lacks more than this share of its facets is rejected.
constexpr double kMissingShare = 0.01;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

std::uint32_t announcedFacets(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

// Words separated by white space, with their line.
class Words {
public:
  explicit Words(std::string_view text) : text_(text) {}

  // Returns the next word in lower case; empty at the end.
  std::string next() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
      line_ += endsLine(at_++);
    std::string word;
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[at_])))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_++])));
    return word;
  }
  void skipLine() {
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r')
      ++at_;
  }
  int line() const { return line_; }

private:
  // LF, or CR without LF.
  bool endsLine(std::size_t at) const {
    return text_[at] == '\n' || (text_[at] == '\r' && text_.substr(at + 1, 1) != "\n");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

bool looksLikeText(std::string_view bytes) {
  Words words(bytes.substr(0, 4096));
  if (words.next() != "solid")
    return false;
  words.skipLine();
  const std::string word = words.next();
  return word == "facet" || word == "endsolid" || (word == "end" && words.next() == "solid");
}

FacetSoup readText(std::string_view bytes, const std::string& name) {
  FacetSoup soup;
  soup.format = "STL (text)";
  Words words(bytes);
  std::vector<Vector3d> loop;
  bool ended = false;
  std::size_t polygons = 0;
  long long firstPolygon = 0; // its line
  const auto fail = [&](const base::Message& what) {
    throw Error(ErrorCode::UnreadableFile, base::message("damaged STL: {what}"_text, what),
                base::lineOf(name, words.line()));
  };
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    if (word == "end") // "end solid" and the like
      word += words.next();
    if (word == "solid" || word == "endsolid") {
      ended = word == "endsolid";
      words.skipLine();
    } else if (word == "vertex") {
      Vector3d v;
      for (int k = 0; k < 3; ++k) {
        const std::string number = words.next();
        if (number.empty())
          break; // the end of the file, reported below
        const std::optional<double> value = numberOf(number);
        if (!value)
          fail(base::message("'{text}' is not a number"_text, number.substr(0, 40)));
        v[k] = *value;
      }
      loop.push_back(v);
    } else if (word == "endloop") {
      if (loop.size() < 3)
        fail("a facet with fewer than three vertices"_text);
      if (loop.size() > 3 && polygons++ == 0)
        firstPolygon = words.line();
      addPolygon(loop, soup.facets);
      loop.clear();
    } else if (word == "facet") {
      words.skipLine(); // the normal follows from the vertices
    } else if (word != "outer" && word != "loop" && word != "endfacet") {
      fail(base::message("'{text}' is not expected here"_text, word.substr(0, 40)));
    }
  }
  if (!loop.empty())
    fail("truncated within a facet"_text);
  if (polygons > 0)
    soup.repairs.emplace_back(
        "divided into triangles: {count} facet of more than three vertices, in line {line}|"
        "divided into triangles: {count} facets of more than three vertices, the first in line {line}"_plural,
        std::vector<base::Value>{polygons, firstPolygon});
  if (!ended)
    soup.repairs.push_back("the file ends without \"endsolid\": it may be truncated"_text);
  return soup;
}

FacetSoup readBinary(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kHeader)
    throw Error(
        ErrorCode::UnreadableFile,
        base::message("truncated: {bytes} bytes are too few for an STL file"_text, bytes.size()),
        name);
  FacetSoup soup;
  soup.format = "STL (binary)";
  const std::size_t announced = announcedFacets(bytes), there = (bytes.size() - kHeader) / kFacet;
  std::size_t count = std::min(announced, there);
  if (announced > there) {
    const double missing = static_cast<double>(announced - there);
    const base::Message what = base::message(
        "{there} of the {promised} facets stated in the header are present"_text, there, announced);
    if (missing > kMissingShare * static_cast<double>(announced))
      throw Error(ErrorCode::UnreadableFile,
                  base::message("truncated, or not a mesh: {what}"_text, what), name,
                  "export or copy the file again"_text);
    soup.repairs.push_back(base::message("the file is truncated: {what}"_text, what));
  } else if (announced == 0 && there > 0 && bytes.size() == kHeader + kFacet * there) {
    count = there; // streaming writers leave the count at zero
    soup.repairs.push_back(base::message("the header states no facets; {facets} read"_text, there));
  } else if (there > announced) {
    soup.repairs.push_back(base::message(
        "not used: {bytes} bytes behind the {facets} facets that the header states"_text,
        bytes.size() - kHeader - kFacet * announced, announced));
  }
  soup.facets.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + kHeader + kFacet * i, sizeof numbers);
    for (std::size_t k = 0; k < 3; ++k)
      soup.facets[i][k] = {numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]};
  }
  return soup;
}

} // namespace

bool isBinaryStl(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * announcedFacets(bytes);
}

bool looksLikeStl(std::string_view bytes) {
  return isBinaryStl(bytes) || looksLikeText(bytes);
}

FacetSoup readStl(std::string_view bytes, const std::string& name) {
  // The header of a binary STL may also begin with "solid", so check the size first.
  return !isBinaryStl(bytes) && looksLikeText(bytes) ? readText(bytes, name)
                                                     : readBinary(bytes, name);
}

std::string writeStl(const TriangleMesh& mesh) {
  if (mesh.triangles.size() > 0xffffffffu)
    throw Error(ErrorCode::CannotWrite, "too many triangles for an STL file"_text);
  std::string bytes(80, ' ');
  const std::string title = "Voluta, mm";
  bytes.replace(0, title.size(), title);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.reserve(kHeader + kFacet * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d cross =
        (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
    const Vector3d normal = cross.norm() > 0.0 ? Vector3d(cross.normalized()) : cross;
    std::array<float, 12> numbers;
    for (std::size_t k = 0; k < 3; ++k)
      numbers[k] = static_cast<float>(normal[static_cast<Eigen::Index>(k)]);
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k)
        numbers[static_cast<std::size_t>(3 + 3 * c + k)] = static_cast<float>(mesh.corner(t, c)[k]);
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

} // namespace voluta::geometry
