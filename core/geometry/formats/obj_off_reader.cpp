#include "base/error.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/polygon_facets.h"
#include "geometry/formats/text_scanner.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;

namespace {

using WordList = std::vector<std::string_view>;

[[noreturn]] void fail(const std::string& name, int line, const base::Message& what) {
  throw Error(ErrorCode::UnreadableFile, what, base::lineOf(name, line));
}

Vector3d pointOf(const WordList& words, std::size_t from, const std::string& name, int line) {
  Vector3d point;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number =
        from + k < words.size() ? numberOf(words[from + k]) : std::optional<double>{};
    if (!number)
      fail(name, line, "a vertex needs three numbers"_text);
    point[static_cast<Eigen::Index>(k)] = *number;
  }
  return point;
}

// Reads the next non-empty line, joined with those that follow a "\\" at its end.
bool nextWholeLine(LineScanner& scanner, WordList& words) {
  if (!scanner.nextFilledLine(words))
    return false;
  WordList more;
  while (words.back().ends_with('\\')) {
    words.back().remove_suffix(1);
    if (words.back().empty())
      words.pop_back();
    if (!scanner.nextLine(more))
      break;
    words.insert(words.end(), more.begin(), more.end());
    if (more.empty())
      break;
  }
  return true;
}

// Free-form curves and surfaces, and other files, have a shape that is not read.
constexpr std::array<std::string_view, 6> kShapesOfObj{"curv", "curv2", "surf",
                                                       "call", "sp",    "con"};

struct UnusedStatement {
  std::size_t count = 0;
  int line = 0; // the first
};

} // namespace

void addPolygon(const std::vector<Vector3d>& polygon, std::vector<Facet>& facets) {
  for (const auto& t : triangulatePolygon(polygon))
    facets.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
}

FacetSoup readObj(std::string_view bytes, const std::string& name) {
  FacetSoup soup;
  soup.format = "OBJ";
  LineScanner scanner(bytes);
  WordList words;
  std::vector<Vector3d> points, polygon;
  std::map<std::string, UnusedStatement, std::less<>> unused;
  while (nextWholeLine(scanner, words)) {
    if (words.empty())
      continue;
    if (words[0] == "v") {
      points.push_back(pointOf(words, 1, name, scanner.line()));
    } else if (words[0] == "f") {
      if (words.size() < 4)
        fail(name, scanner.line(), "a face needs at least three corners"_text);
      polygon.clear();
      for (std::size_t i = 1; i < words.size(); ++i) {
        const auto index = integerOf(words[i].substr(0, words[i].find('/')));
        const auto count = static_cast<long long>(points.size());
        // Negative indices count back from the last vertex read.
        const long long at = !index ? -1 : *index > 0 ? *index - 1 : count + *index;
        if (!index || *index == 0 || at < 0 || at >= count)
          fail(name, scanner.line(),
               base::message("'{corner}' is not the index of a vertex read so far"_text,
                             words[i].substr(0, 40)));
        polygon.push_back(points[static_cast<std::size_t>(at)]);
      }
      addPolygon(polygon, soup.facets);
    } else if (std::ranges::find(kShapesOfObj, words[0]) != kShapesOfObj.end()) {
      UnusedStatement& statement = unused[std::string(words[0])];
      if (statement.count++ == 0)
        statement.line = scanner.line();
    }
    // Everything else (normals, textures, groups, materials) does not affect the shape.
  }
  for (const auto& [word, statement] : unused)
    soup.repairs.emplace_back(
        "not used: {count} statement '{word}', in line {line}|"
        "not used: {count} statements '{word}', the first in line {line}"_plural,
        std::vector<base::Value>{statement.count, word, statement.line});
  return soup;
}

FacetSoup readOff(std::string_view bytes, const std::string& name) {
  FacetSoup soup;
  soup.format = "OFF";
  LineScanner scanner(bytes);
  WordList words;
  if (!scanner.nextFilledLine(words) || !words[0].ends_with("OFF"))
    fail(name, scanner.line(), "an OFF file begins with \"OFF\""_text);
  if (words[0] == "4OFF" || words[0] == "nOFF")
    fail(name, scanner.line(), "only three-dimensional OFF files can be read"_text);
  // Coordinates are first on their line, whatever other data a vertex has.
  WordList counts(words.begin() + 1, words.end());
  if (counts.empty() && scanner.nextFilledLine(words))
    counts = words;
  const auto vertexCount = counts.size() > 1 ? integerOf(counts[0]) : std::optional<long long>{};
  const auto faceCount = counts.size() > 1 ? integerOf(counts[1]) : std::optional<long long>{};
  if (!vertexCount || !faceCount || *vertexCount < 0 || *faceCount < 0)
    fail(name, scanner.line(), "the numbers of vertices and faces are expected here"_text);
  std::vector<Vector3d> points, polygon;
  for (long long v = 0; v < *vertexCount; ++v) {
    if (!scanner.nextFilledLine(words))
      fail(name, scanner.line(),
           base::message("truncated: {there} of {wanted} vertices"_text, v, *vertexCount));
    points.push_back(pointOf(words, 0, name, scanner.line()));
  }
  for (long long f = 0; f < *faceCount; ++f) {
    if (!scanner.nextFilledLine(words))
      fail(name, scanner.line(),
           base::message("truncated: {there} of {wanted} faces"_text, f, *faceCount));
    const auto corners = integerOf(words[0]);
    if (!corners || *corners < 0 || static_cast<std::size_t>(*corners) >= words.size())
      fail(name, scanner.line(), "a face needs its number of corners, then the corners"_text);
    polygon.clear();
    for (std::size_t i = 1; i <= static_cast<std::size_t>(*corners); ++i) {
      const auto at = integerOf(words[i]);
      if (!at || *at < 0 || *at >= *vertexCount)
        fail(name, scanner.line(),
             base::message("'{corner}' is not the index of a vertex"_text, words[i].substr(0, 40)));
      polygon.push_back(points[static_cast<std::size_t>(*at)]);
    }
    if (polygon.size() >= 3)
      addPolygon(polygon, soup.facets);
  }
  return soup;
}

} // namespace voluta::geometry
