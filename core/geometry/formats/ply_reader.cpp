#include "base/error.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/text_scanner.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;

namespace {

enum class Number { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::optional<Number> numberType(std::string_view word) {
  static constexpr std::pair<std::string_view, Number> kNames[] = {
      {"char", Number::Int8},      {"int8", Number::Int8},       {"uchar", Number::UInt8},
      {"uint8", Number::UInt8},    {"short", Number::Int16},     {"int16", Number::Int16},
      {"ushort", Number::UInt16},  {"uint16", Number::UInt16},   {"int", Number::Int32},
      {"int32", Number::Int32},    {"uint", Number::UInt32},     {"uint32", Number::UInt32},
      {"float", Number::Float32},  {"float32", Number::Float32}, {"double", Number::Float64},
      {"float64", Number::Float64}};
  for (const auto& [known, type] : kNames)
    if (known == word)
      return type;
  return std::nullopt;
}

struct Property {
  std::string name;
  Number type = Number::Float32;
  std::optional<Number> listCount; // set for a list
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

// Reads the numbers of the body in sequence, text or binary.
class Body {
public:
  enum class Kind { Text, Little, Big };

  Body(std::string_view bytes, std::size_t at, Kind kind, const std::string& name)
      : bytes_(bytes), at_(at), kind_(kind), name_(name) {}

  double next(Number type) {
    if (kind_ == Kind::Text)
      return nextWord();
    switch (type) {
    case Number::Int8:
      return raw<std::int8_t>();
    case Number::UInt8:
      return raw<std::uint8_t>();
    case Number::Int16:
      return raw<std::int16_t>();
    case Number::UInt16:
      return raw<std::uint16_t>();
    case Number::Int32:
      return raw<std::int32_t>();
    case Number::UInt32:
      return raw<std::uint32_t>();
    case Number::Float32:
      return raw<float>();
    case Number::Float64:
      break;
    }
    return raw<double>();
  }

  // Returns the length of a list, which cannot exceed the number of remaining bytes.
  std::size_t nextCount(Number type) {
    const double count = next(type);
    if (!(count >= 0.0) || count != std::floor(count) ||
        count > static_cast<double>(bytes_.size() - at_))
      fail("a list has an invalid length"_text);
    return static_cast<std::size_t>(count);
  }

  [[noreturn]] void fail(const base::Message& what) const {
    throw Error(ErrorCode::UnreadableFile, what,
                base::message("{file}, byte {byte}"_text, name_, std::to_string(at_)));
  }

private:
  double nextWord() {
    const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (at_ < bytes_.size() && blank(bytes_[at_]))
      ++at_;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !blank(bytes_[at_]))
      ++at_;
    if (begin == at_)
      fail("truncated"_text);
    const auto number = numberOf(bytes_.substr(begin, at_ - begin));
    if (!number)
      fail(base::message("'{text}' is not a number"_text,
                         bytes_.substr(begin, std::min<std::size_t>(at_ - begin, 40))));
    return *number;
  }

  template <typename T> double raw() {
    if (bytes_.size() - at_ < sizeof(T))
      fail("truncated"_text);
    std::array<char, sizeof(T)> swapped;
    std::memcpy(swapped.data(), bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if (kind_ == Kind::Big)
      std::reverse(swapped.begin(), swapped.end());
    return static_cast<double>(std::bit_cast<T>(swapped));
  }

  std::string_view bytes_;
  std::size_t at_;
  Kind kind_;
  const std::string& name_;
};

struct Header {
  Body::Kind kind = Body::Kind::Text;
  std::vector<Element> elements;
  std::size_t bodyAt = 0;
};

Header readHeader(std::string_view bytes, const std::string& name) {
  Header header;
  LineScanner scanner(bytes);
  std::vector<std::string_view> words;
  bool hasFormat = false;
  const auto fail = [&](const base::Message& what) {
    throw Error(ErrorCode::UnreadableFile, what, base::lineOf(name, scanner.line()));
  };
  if (!scanner.nextLine(words) || words.size() != 1 || words[0] != "ply")
    fail("a PLY file begins with \"ply\""_text);
  while (true) {
    if (!scanner.nextLine(words))
      fail("the header has no end"_text);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
      continue;
    if (words[0] == "end_header")
      break;
    if (words[0] == "format" && words.size() >= 2) {
      hasFormat = true;
      if (words[1] == "ascii")
        header.kind = Body::Kind::Text;
      else if (words[1] == "binary_little_endian")
        header.kind = Body::Kind::Little;
      else if (words[1] == "binary_big_endian")
        header.kind = Body::Kind::Big;
      else
        fail("an unknown PLY format"_text);
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = integerOf(words[2]);
      if (!count || *count < 0)
        fail("an element needs its count"_text);
      header.elements.push_back({std::string(words[1]), *count, {}});
    } else if (words[0] == "property" && !header.elements.empty() && words.size() >= 3) {
      Property property{std::string(words.back()), Number::Float32, {}};
      const bool list = words[1] == "list";
      const auto type = numberType(words[list && words.size() == 5 ? 3 : 1]);
      if (list && words.size() == 5)
        property.listCount = numberType(words[2]);
      if (!type || (list && !property.listCount))
        fail("a property of unknown type"_text);
      property.type = *type;
      header.elements.back().properties.push_back(std::move(property));
    } else {
      fail("an unknown line in the header"_text);
    }
  }
  if (!hasFormat)
    fail("the header states no format"_text);
  header.bodyAt = scanner.position();
  return header;
}

// Adds the triangles of strips, which negative numbers separate: each vertex makes one with the two
// before it, every other one turned over.
void addStrips(const std::vector<double>& list, std::vector<std::vector<double>>& polygons) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] < 0.0)
      from = i + 1;
    if (i < from + 2)
      continue;
    const bool isTurned = (i - from) % 2 == 1;
    const double a = list[i - (isTurned ? 1 : 2)], b = list[i - (isTurned ? 2 : 1)], c = list[i];
    if (a != b && b != c && c != a)
      polygons.push_back({a, b, c});
  }
}
} // namespace

FacetSoup readPly(std::string_view bytes, const std::string& name) {
  const Header header = readHeader(bytes, name);
  FacetSoup soup;
  soup.format = "PLY";
  Body body(bytes, header.bodyAt, header.kind, name);
  std::vector<Vector3d> points, polygon;
  std::vector<std::vector<double>> polygons;
  for (const Element& element : header.elements) {
    const bool isStrip = element.name == "tristrips";
    if (element.count > 0 && element.name != "vertex" && element.name != "face" && !isStrip)
      soup.repairs.push_back(
          base::message("not used: {count} entry of the element '{name}'|"
                        "not used: {count} entries of the element '{name}'"_plural,
                        element.count, element.name));
    // Elements without properties have no data, regardless of their count.
    for (long long i = 0; i < element.count && !element.properties.empty(); ++i) {
      Vector3d point = Vector3d::Zero();
      for (const Property& property : element.properties) {
        if (!property.listCount) {
          const double value = body.next(property.type);
          if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
            point[property.name[0] - 'x'] = value;
          continue;
        }
        std::vector<double> list(body.nextCount(*property.listCount));
        for (double& value : list)
          value = body.next(property.type);
        if (property.name != "vertex_indices" && property.name != "vertex_index")
          continue;
        if (element.name == "face")
          polygons.push_back(std::move(list));
        else if (isStrip)
          addStrips(list, polygons);
      }
      if (element.name == "vertex")
        points.push_back(point);
    }
  }
  for (const std::vector<double>& corners : polygons) {
    polygon.clear();
    for (const double at : corners) {
      if (!(at >= 0.0 && at < static_cast<double>(points.size())))
        throw Error(ErrorCode::UnreadableFile,
                    base::message("a face refers to vertex {vertex} of {vertices}"_text,
                                  base::number(at), points.size()),
                    name);
      polygon.push_back(points[static_cast<std::size_t>(at)]);
    }
    if (polygon.size() >= 3)
      addPolygon(polygon, soup.facets);
  }
  return soup;
}

} // namespace voluta::geometry
