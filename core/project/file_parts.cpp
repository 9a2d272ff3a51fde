#include "project/file_parts.h"

#include "base/error.h"
#include "base/files.h"
#include "build3mf/build_reader.h"
#include "geometry/formats/threemf_parts.h"
#include "geometry/measures.h"
#include "project/cad_parts.h"
#include "project/choices.h"
#include "project/file_events.h"
#include "project/file_regions.h"
#include "project/part_formats.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace voluta::project {

namespace {
using Eigen::Vector3d;

constexpr double kReadShare = 0.3; // of the progress of loading CAD parts

// Returns a name that can be part of a file name; empty if nothing is left of it.
std::string fileNameOf(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' '; },
      '-');
  return name.find_first_not_of(". -") == std::string::npos ? std::string() : name;
}

std::vector<PartInFile> loadedParts(std::vector<geometry::PartOfFile> parts,
                                    const std::string& file, bool repair,
                                    const base::RunContext& ctx) {
  std::vector<PartInFile> loaded;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    geometry::PartOfFile& part = parts[i];
    const std::string own = fileNameOf(part.name);
    const double from = static_cast<double>(i) / static_cast<double>(parts.size());
    const double to = static_cast<double>(i + 1) / static_cast<double>(parts.size());
    std::vector<base::Message> notes = std::move(part.file.repairs);
    FileEvents events = eventsOfFile(
        part.events, part.placeMm.z() + geometry::bounds(part.file.mesh).max().z(), notes);
    std::vector<Region> regions = std::move(events.tools);
    std::ranges::move(regionsOfFile(part.modifiers, notes, ctx), std::back_inserter(regions));
    std::shared_ptr<const LoadedPart> one =
        loadedFrom(own.empty() ? file : own,
                   std::make_shared<const geometry::TriangleMesh>(std::move(part.file.mesh)),
                   std::move(notes), repair, ctx.sub(from, to));
    if (!regions.empty() || !events.layerEvents.empty()) {
      auto divided = std::make_shared<LoadedPart>(*one);
      divided->regions = std::move(regions);
      divided->layerEvents = std::move(events.layerEvents);
      one = std::move(divided);
    }
    loaded.push_back({std::move(one), part.placeMm});
  }
  return loaded;
}
} // namespace

bool mayHoldSeveral(const std::string& file) {
  const PartFormat* format = partFormatOf(file);
  return format && format->holdsSeveral;
}

std::vector<PartInFile> loadParts(const std::string& part, bool repair,
                                  const base::RunContext& ctx) {
  return loadParts(part, repair, {}, ctx);
}

std::vector<PartInFile> loadParts(const std::string& part, bool repair,
                                  const geometry::Tessellation& tessellation,
                                  const base::RunContext& ctx) {
  if (geometry::isCad(part))
    return loadedParts(geometry::readCadParts(part, tessellation, ctx),
                       std::filesystem::path(part).filename().string(), repair,
                       ctx.sub(kReadShare, 1.0));
  if (mayHoldSeveral(part)) {
    const std::string bytes = base::readFile(part);
    if (!build3mf::holdsToolpaths(bytes)) {
      std::vector<geometry::PartOfFile> parts = geometry::read3mfParts(bytes, part);
      if (parts.size() > 1)
        return loadedParts(std::move(parts), std::filesystem::path(part).filename().string(),
                           repair, ctx);
    }
  }
  return {{loadPart(part, repair, ctx), Vector3d::Zero()}};
}

std::shared_ptr<const LoadedPart> loadAsOne(const std::string& part, bool repair,
                                            const geometry::Tessellation& tessellation,
                                            const base::RunContext& ctx) {
  if (!geometry::isCad(part))
    return loadPart(part, repair, ctx);
  geometry::MeshFile file = geometry::readCad(part, tessellation, ctx);
  return loadedFrom(std::filesystem::path(part).filename().string(),
                    std::make_shared<const geometry::TriangleMesh>(std::move(file.mesh)),
                    std::move(file.repairs), repair, ctx.sub(kReadShare, 1.0));
}

void takeFromFile(ItemChoices& item, const LoadedPart& part) {
  item.regions = part.regions;
  if (!part.layerEvents.empty())
    item.parameters.try_emplace("layerEvents", part.layerEvents);
}

std::shared_ptr<const LoadedPart> withToolsOfJob(std::shared_ptr<const LoadedPart> part,
                                                 std::size_t tools) {
  const std::string key = "tool";
  const auto lacks = [&](const Region& region) {
    const auto tool = region.parameters.find(key);
    return tool != region.parameters.end() && std::stoul(tool->second) > tools;
  };
  if (std::ranges::none_of(part->regions, lacks))
    return part;
  auto fitting = std::make_shared<LoadedPart>(*part);
  for (Region& region : fitting->regions) {
    if (!lacks(region))
      continue;
    const base::Message note = base::message(
        "not used: tool {tool} of region '{region}' from the file: the job has {tools}"_text,
        region.parameters.at(key), region.name.empty() ? region.shape : region.name, tools);
    region.parameters.erase(key);
    fitting->readNotes.push_back(note);
    fitting->notes.push_back(note);
  }
  std::erase_if(fitting->regions, [](const Region& region) { return region.parameters.empty(); });
  return fitting;
}

std::vector<geometry::Placement> placesInFile(std::span<const PartInFile> parts, double scale,
                                              const Eigen::Quaterniond& rotation) {
  std::vector<Eigen::AlignedBox3d> boxes;
  Eigen::AlignedBox3d whole;
  for (const PartInFile& part : parts) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& v : part.part->mesh->vertices)
      box.extend(scale * (rotation * (v + part.placeMm)));
    boxes.push_back(box);
    whole.extend(box);
  }
  constexpr double kOnPlateMm = 0.01; // programs round the heights of parts on the plate
  std::vector<geometry::Placement> places;
  for (const Eigen::AlignedBox3d& box : boxes) {
    const double lift = box.min().z() - whole.min().z();
    places.push_back(
        {rotation, (box.center() - whole.center()).head<2>(), lift < kOnPlateMm ? 0.0 : lift});
  }
  return places;
}

std::optional<std::pair<std::size_t, std::size_t>>
touchingParts(std::span<const PartInFile> parts) {
  std::vector<geometry::TriangleMesh> meshes;
  for (const PartInFile& part : parts) {
    meshes.push_back(*part.part->mesh);
    for (Vector3d& v : meshes.back().vertices)
      v += part.placeMm;
  }
  for (std::size_t a = 0; a < meshes.size(); ++a)
    for (std::size_t b = a + 1; b < meshes.size(); ++b)
      if (geometry::touch(meshes[a], meshes[b]))
        return std::pair(a, b);
  return std::nullopt;
}

} // namespace voluta::project
