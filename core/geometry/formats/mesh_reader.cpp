#include "geometry/formats/mesh_reader.h"

#include "base/error.h"
#include "base/files.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/mesh_formats.h"
#include "geometry/formats/plain_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <fmt/format.h>
#include <unordered_map>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;

namespace {

constexpr double kLargest = 1e9;
constexpr double kBadShare = 0.01;

struct PointHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const double x : p) {
      h ^= std::bit_cast<std::uint64_t>(x);
      h *= 0xff51afd7ed558ccdu;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
};

// Returns the format by the content if it has a signature, else by the name's ending, or nullptr.
const MeshFormat* formatOf(std::string_view bytes, const std::string& name) {
  const auto ofEnding = [](std::string_view ending) {
    return &*std::ranges::find(meshFormats(), ending, &MeshFormat::ending);
  };
  const MeshFormat* named = meshFormatOf(name);
  if (named && named->foreign())
    named = nullptr;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r"))
    return ofEnding(".ply");
  if (looksLikeStl(bytes))
    return ofEnding(".stl");
  if (!named && bytes.starts_with("OFF"))
    return ofEnding(".off");
  return named;
}

bool usable(const Facet& facet) {
  for (const Vector3d& v : facet)
    if (!v.allFinite() || v.cwiseAbs().maxCoeff() > kLargest)
      return false;
  return true;
}

void dropBadFacets(FacetSoup& soup, const std::string& name) {
  const std::size_t before = soup.facets.size();
  const auto firstBad = std::find_if_not(soup.facets.begin(), soup.facets.end(), usable);
  if (firstBad == soup.facets.end())
    return;
  const std::size_t at = static_cast<std::size_t>(firstBad - soup.facets.begin()) + 1;
  soup.facets.erase(
      std::remove_if(firstBad, soup.facets.end(), [](const Facet& f) { return !usable(f); }),
      soup.facets.end());
  const std::size_t bad = before - soup.facets.size();
  const base::Message what =
      base::message("{bad} of {facets} facets has NaN or out-of-range coordinates, first at "
                    "facet {first}|"
                    "{bad} of {facets} facets have NaN or out-of-range coordinates, first at "
                    "facet {first}"_plural,
                    bad, before, at);
  if (bad > 1 && static_cast<double>(bad) > kBadShare * static_cast<double>(before))
    throw Error(ErrorCode::UnusableInput, what, name);
  soup.repairs.push_back(base::message("omitted: {what}"_text, what));
}

} // namespace

TriangleMesh shareVertices(const std::vector<Facet>& facets) {
  TriangleMesh mesh;
  mesh.triangles.reserve(facets.size());
  std::unordered_map<std::array<double, 3>, int, PointHash> known;
  known.reserve(facets.size());
  for (const Facet& facet : facets) {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      // Adding zero turns -0 into 0.
      const std::array<double, 3> key{facet[k].x() + 0.0, facet[k].y() + 0.0, facet[k].z() + 0.0};
      const auto [entry, isNew] = known.emplace(key, static_cast<int>(mesh.vertices.size()));
      if (isNew)
        mesh.vertices.emplace_back(key[0], key[1], key[2]);
      triangle[k] = entry->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

MeshFile meshOf(FacetSoup soup, const std::string& name) {
  if (soup.facets.empty())
    throw Error(ErrorCode::UnusableInput, "the mesh is empty: the file has no triangles"_text,
                name);
  dropBadFacets(soup, name);
  if (soup.facets.empty())
    throw Error(ErrorCode::UnusableInput, "the mesh is empty: no facet has valid coordinates"_text,
                name);
  return {shareVertices(soup.facets), std::move(soup.format), std::move(soup.repairs)};
}

bool looksLikeMesh(std::string_view bytes) {
  return isBinaryStl(bytes) || formatOf(bytes, {});
}

MeshFile readMesh(const std::filesystem::path& path) {
  return readMesh(base::readFile(path), path.string());
}

MeshFile readMesh(std::string_view bytes, const std::string& name) {
  if (bytes.empty())
    throw Error(ErrorCode::UnreadableFile, "the file is empty"_text, name);
  // The size identifies a binary STL, regardless of its header.
  const PlainText plain = isBinaryStl(bytes) ? PlainText{bytes, {}, {}} : plainText(bytes, name);
  const std::string_view text = plain.text();
  const MeshFormat* format = formatOf(text, name);
  if (!format)
    throw Error(ErrorCode::UnreadableFile, "not a mesh file"_text, name,
                base::message("use one of these formats: {formats}"_text, meshFormatNames()));
  FacetSoup soup = format->read(text, name);
  soup.repairs.insert(soup.repairs.begin(), plain.notes.begin(), plain.notes.end());
  return meshOf(std::move(soup), name);
}

} // namespace voluta::geometry
