#include "geometry/formats/threemf_parts.h"

#include "base/error.h"
#include "geometry/formats/threemf_build.h"
#include "geometry/formats/threemf_cut.h"
#include "geometry/measures.h"
#include "geometry/meshes_meet.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace voluta::geometry {

namespace {
using Eigen::Vector3d;

constexpr double kTouchMm = 0.01;

// Pieces that form one part, by index.
using Group = std::vector<std::size_t>;

TriangleMesh moved(TriangleMesh mesh, const Vector3d& shift) {
  for (Vector3d& v : mesh.vertices)
    v += shift;
  return mesh;
}

TriangleMesh placedMesh(const ThreemfPiece& piece) {
  std::vector<Facet> facets;
  appendPlaced(piece, piece.mm_T_object, facets);
  return shareVertices(facets);
}

// Returns the first piece of the group of each piece: pieces that touch are in one group.
std::vector<std::size_t> touching(const std::vector<TriangleMesh>& meshes) {
  std::vector<std::size_t> first(meshes.size());
  std::iota(first.begin(), first.end(), 0);
  for (std::size_t a = 0; a < meshes.size(); ++a)
    for (std::size_t b = a + 1; b < meshes.size(); ++b)
      if (first[a] != first[b] && touch(meshes[a], meshes[b])) {
        const auto [low, high] = std::minmax({first[a], first[b]});
        std::ranges::replace(first, high, low);
      }
  return first;
}

// Divides the pieces of one build item, all of `item`, into parts.
std::vector<Group> partsOf(const std::vector<ThreemfPiece>& pieces, const Group& item) {
  if (item.size() == 1 || item.size() > kMaxPartsOfFile)
    return {item};
  std::vector<TriangleMesh> meshes;
  for (const std::size_t piece : item)
    meshes.push_back(placedMesh(pieces[piece]));
  const std::vector<std::size_t> first = touching(meshes);
  std::vector<Group> groups(item.size());
  std::vector<Eigen::AlignedBox3d> boxes(item.size());
  for (std::size_t i = 0; i < item.size(); ++i) {
    groups[first[i]].push_back(item[i]);
    boxes[first[i]].extend(bounds(meshes[i]));
  }
  std::erase_if(groups, [](const Group& group) { return group.empty(); });
  std::erase_if(boxes, [](const Eigen::AlignedBox3d& box) { return box.isEmpty(); });
  const bool isLevel = std::ranges::all_of(boxes, [&](const Eigen::AlignedBox3d& box) {
    return std::abs(box.min().z() - boxes.front().min().z()) <= kTouchMm;
  });
  return isLevel ? groups : std::vector<Group>{item};
}

std::vector<Group> partsOf(const std::vector<ThreemfPiece>& pieces) {
  std::vector<Group> parts;
  for (std::size_t i = 0; i < pieces.size();) {
    Group item;
    for (const std::size_t of = pieces[i].item; i < pieces.size() && pieces[i].item == of; ++i)
      item.push_back(i);
    for (Group& part : partsOf(pieces, item))
      parts.push_back(std::move(part));
  }
  return parts;
}

// `isWholeItem`: the group has all pieces of its build item.
PartOfFile partOf(const std::vector<ThreemfPiece>& pieces, const Group& group, bool isWholeItem,
                  const std::string& name) {
  const ThreemfPiece& first = pieces[group.front()];
  PartOfFile part;
  part.name = isWholeItem && !first.itemName.empty() ? first.itemName : first.name;
  part.placeMm = first.mm_T_object.translation();
  FacetSoup soup;
  soup.format = "3MF";
  for (const std::size_t i : group) {
    Eigen::Affine3d part_T_object = pieces[i].mm_T_object;
    part_T_object.translation() -= part.placeMm;
    appendPlaced(pieces[i], part_T_object, soup.facets);
  }
  part.file = meshOf(std::move(soup), part.name.empty() ? name : name + ", " + part.name);
  return part;
}

// Returns the modifier in the coordinates of a part with that place in the file; its mesh is empty
// if it has no valid facet.
ModifierOfFile modifierOf(const ThreemfPiece& piece, const Vector3d& placeMm) {
  Eigen::Affine3d part_T_object = piece.mm_T_object;
  part_T_object.translation() -= placeMm;
  std::vector<Facet> facets;
  appendPlaced(piece, part_T_object, facets);
  return {piece.name, soundMesh(facets), 0.0, 0.0, piece.settings, piece.isPainted};
}

Eigen::AlignedBox3d boxInFile(const TriangleMesh& mesh, const Vector3d& placeMm) {
  Eigen::AlignedBox3d box = bounds(mesh);
  return box.translate(placeMm);
}

// Gives the parts the ranges of heights of their items. `items`: of each part.
void addRanges(const ThreemfBuild& build, const std::vector<std::size_t>& items,
               std::vector<PartOfFile>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (const auto ranges = build.ranges.find(items[i]); ranges != build.ranges.end())
      for (const ThreemfRange& range : ranges->second)
        parts[i].modifiers.push_back({{}, {}, range.fromMm, range.toMm, range.settings});
}

// Gives changes of the tool to all parts, other events to the highest one: all parts wait for it.
void addEvents(const ThreemfBuild& build, std::vector<PartOfFile>& parts) {
  const auto highest = std::ranges::max_element(parts, {}, [](const PartOfFile& part) {
    return part.placeMm.z() + bounds(part.file.mesh).max().z();
  });
  for (const EventOfFile& event : build.events)
    for (auto part = parts.begin(); part != parts.end(); ++part)
      if (part == highest || event.kind == EventOfFileKind::Tool)
        part->events.push_back(event);
}

// Gives each modifier to the parts of its item that it meets, or to the first one, which reports
// that it is outside; one that is an item of its own, as Cura has it, to all parts that it meets.
void addModifiers(const ThreemfBuild& build, const std::vector<std::size_t>& items,
                  std::vector<PartOfFile>& parts) {
  for (const ThreemfPiece& piece : build.modifiers) {
    const bool isOwnItem = std::ranges::find(items, piece.item) == items.end();
    const ModifierOfFile inFile = modifierOf(piece, Vector3d::Zero());
    if (inFile.mesh.empty())
      continue;
    const Eigen::AlignedBox3d box = bounds(inFile.mesh);
    std::vector<std::size_t> meant, met;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (isOwnItem || items[i] == piece.item) {
        meant.push_back(i);
        if (box.intersects(boxInFile(parts[i].file.mesh, parts[i].placeMm)))
          met.push_back(i);
      }
    if (met.empty())
      met = {meant.front()};
    for (const std::size_t i : met)
      parts[i].modifiers.push_back(modifierOf(piece, parts[i].placeMm));
  }
}

// Of everything as one part. Ranges of several items count from the lowest point of each, and are
// left out.
PartOfFile wholeOf(const ThreemfBuild& build, const std::string& name) {
  std::vector<PartOfFile> parts{{{}, meshOf(soupOf(build), name), Vector3d::Zero(), {}, {}}};
  const std::size_t item = build.pieces.empty() ? 0 : build.pieces.front().item;
  const bool isOneItem = std::ranges::all_of(
      build.pieces, [&](const ThreemfPiece& piece) { return piece.item == item; });
  if (isOneItem)
    addRanges(build, {item}, parts);
  else if (!build.ranges.empty())
    parts.front().file.repairs.emplace_back(
        "not used: settings of ranges of height: the objects of the file are one "
        "part"_text);
  for (const ThreemfPiece& piece : build.modifiers)
    if (ModifierOfFile modifier = modifierOf(piece, Vector3d::Zero()); !modifier.mesh.empty())
      parts.front().modifiers.push_back(std::move(modifier));
  addEvents(build, parts);
  return std::move(parts.front());
}
} // namespace

void requirePrintable(std::size_t parts, const std::string& file) {
  if (parts > kMaxPartsOfFile)
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("contains {parts} parts, of which {limit} can be printed"_text,
                                    parts, kMaxPartsOfFile),
                      file, "open it as one part"_text);
}

bool touch(const TriangleMesh& a, const TriangleMesh& b) {
  Eigen::AlignedBox3d wide = bounds(a);
  wide.min().array() -= kTouchMm;
  wide.max().array() += kTouchMm;
  if (!wide.intersects(bounds(b)))
    return false;
  // Faces that lie on each other do not cross until they are pressed together. The direction is in
  // no plane that a drawing is likely to have.
  const Vector3d press = kTouchMm * Vector3d(0.36, 0.48, 0.8);
  return meetingPoint(a, b) || meetingPoint(moved(a, press), b) ||
         meetingPoint(moved(a, -press), b);
}

PartOfFile read3mfWhole(std::string_view bytes, const std::string& name) {
  return wholeOf(read3mfBuild(bytes, name), name);
}

std::vector<PartOfFile> read3mfParts(std::string_view bytes, const std::string& name) {
  const ThreemfBuild build = read3mfBuild(bytes, name);
  const std::vector<Group> groups = partsOf(build.pieces);
  if (groups.size() < 2)
    return {wholeOf(build, name)};
  requirePrintable(groups.size(), name);
  std::vector<PartOfFile> parts;
  std::vector<std::size_t> items;
  for (const Group& group : groups) {
    const std::size_t item = build.pieces[group.front()].item;
    items.push_back(item);
    const bool isWholeItem =
        group.size() == static_cast<std::size_t>(std::ranges::count(
                            build.pieces, item, [](const ThreemfPiece& p) { return p.item; }));
    parts.push_back(partOf(build.pieces, group, isWholeItem, name));
  }
  addRanges(build, items, parts);
  addModifiers(build, items, parts);
  addEvents(build, parts);
  auto& notes = parts.front().file.repairs;
  notes.insert(notes.begin(), build.notes.begin(), build.notes.end());
  return parts;
}

} // namespace voluta::geometry
