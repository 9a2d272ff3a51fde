#include "geometry/formats/cad_text.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>

namespace voluta::geometry {

namespace {

using base::Error;
using base::ErrorCode;

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::size_t kLetterColumn = 72; // of an IGES line, which names its section

Error unreadable(const base::Message& problem, const std::string& name,
                 const base::Message& remedy = {}) {
  return {ErrorCode::UnreadableFile, problem, name, remedy};
}

bool isBlank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string_view withoutBlanks(std::string_view text) {
  if (text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  while (!text.empty() && isBlank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && (isBlank(text.back()) || text.back() == '\0'))
    text.remove_suffix(1);
  return text;
}

char sectionOf(std::string_view line) {
  return line.size() > kLetterColumn ? line[kLetterColumn] : ' ';
}

// Number of lines in each section; the last line states them.
struct IgesLines {
  std::array<long long, 4> counts{}; // of S, G, D and P
  std::string_view last;
};

constexpr std::string_view kIgesSections = "SGDP";

IgesLines igesLinesOf(std::string_view text) {
  IgesLines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (withoutBlanks(line).empty())
      continue;
    if (const std::size_t section = kIgesSections.find(sectionOf(line));
        section != std::string_view::npos)
      ++lines.counts[section];
    lines.last = line;
  }
  return lines;
}

// The last line is "S      1G      3D     40P     25 ... T      1".
bool isWholeIges(std::string_view text) {
  const IgesLines lines = igesLinesOf(text);
  if (sectionOf(lines.last) != 'T')
    return false;
  constexpr std::size_t kField = 8;
  for (std::size_t i = 0; i < kIgesSections.size(); ++i) {
    const std::string_view number = withoutBlanks(lines.last.substr(i * kField + 1, kField - 1));
    if (lines.last[i * kField] != kIgesSections[i] || integerOf(number) != lines.counts[i])
      return false;
  }
  return true;
}

class Bytes {
public:
  Bytes(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::string_view take(std::uint64_t count) {
    if (count > bytes_.size())
      throw damaged();
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class T> T value() {
    T read{};
    std::memcpy(&read, take(sizeof(T)).data(), sizeof(T));
    return read;
  }
  Eigen::Vector3d point() {
    const auto xyz = value<std::array<double, 3>>();
    return {xyz[0], xyz[1], xyz[2]};
  }
  bool atEnd() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }
  Error damaged() const { return unreadable("is damaged: the reader failed"_text, name_); }

private:
  std::string_view bytes_;
  const std::string& name_;
};

CadBody readBody(Bytes& bytes) {
  CadBody body;
  body.name = bytes.take(bytes.value<std::uint64_t>());
  body.placeMm = bytes.point();
  const auto facets = bytes.value<std::uint64_t>();
  if (facets > bytes.left() / sizeof(Facet))
    throw bytes.damaged();
  body.facets.resize(facets);
  for (Facet& facet : body.facets)
    for (Eigen::Vector3d& corner : facet)
      corner = bytes.point();
  return body;
}

} // namespace

CadKind cadKindOf(std::string_view bytes, const std::string& name) {
  const std::string_view text = withoutBlanks(bytes);
  if (text.empty())
    throw unreadable("the file is empty"_text, name);
  const auto cut = [&](const base::Message& lacking) {
    return unreadable(base::message("is cut short: {lacking}"_text, lacking), name,
                      "copy or export it again"_text);
  };
  if (text.starts_with("ISO-10303-21")) {
    if (text.rfind("END-ISO-10303-21") == std::string_view::npos)
      throw cut("the end of a STEP file is missing"_text);
    return CadKind::Step;
  }
  const std::string_view start = bytes.starts_with(kByteOrderMark) ? bytes.substr(3) : bytes;
  if (sectionOf(start.substr(0, start.find_first_of("\r\n"))) == 'S') {
    if (!isWholeIges(start))
      throw cut("the last line of an IGES file is missing, or names other numbers of lines"_text);
    return CadKind::Iges;
  }
  if (looksLikeStl(bytes))
    throw unreadable("is an STL, not a STEP or IGES file"_text, name,
                     "give it the ending .stl"_text);
  throw unreadable("not a STEP or IGES file"_text, name);
}

CadFacets readCadFacets(std::string_view output, const std::string& name) {
  constexpr std::string_view kMagic = "VCAD0001";
  Bytes bytes(output, name);
  if (bytes.take(kMagic.size()) != kMagic)
    throw bytes.damaged();
  CadFacets read;
  read.missingFaces = bytes.value<std::uint64_t>();
  read.curves = bytes.value<std::uint64_t>();
  for (auto bodies = bytes.value<std::uint64_t>(); bodies > 0; --bodies)
    read.bodies.push_back(readBody(bytes));
  if (!bytes.atEnd())
    throw bytes.damaged();
  return read;
}

} // namespace voluta::geometry
