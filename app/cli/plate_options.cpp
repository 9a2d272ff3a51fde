#include "cli/plate_options.h"

#include "base/error.h"
#include "base/number_list.h"
#include "base/units.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "project/cad_parts.h"
#include "regions/region_text.h"

#include <charconv>
#include <fmt/format.h>
#include <utility>

namespace voluta::cli {

namespace {

base::Error badText(const std::string& option, const std::string& text, const std::string& form) {
  return {base::ErrorCode::Usage,
          base::message("{option} {text}: not of the form {form}"_text, option, text, form)};
}

// Splits "NUMBER:REST". Throws Error{Usage} if there is no part of that number.
std::pair<std::size_t, std::string> numbered(const std::string& option, const std::string& text,
                                             const std::string& form, std::size_t parts) {
  const std::size_t colon = text.find(':');
  std::size_t number = 0;
  const char* end = text.data() + std::min(colon, text.size());
  if (colon == std::string::npos || std::from_chars(text.data(), end, number).ptr != end ||
      number == 0)
    throw badText(option, text, form);
  if (number > parts)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("{option} {text}: no such part, the last one is {parts}"_text,
                                    option, text, parts));
  return {number - 1, text.substr(colon + 1)};
}

void place(project::ItemChoices& item, const std::string& text, const std::string& rest) {
  constexpr const char* kForm = "NUMBER:X,Y, NUMBER:X,Y,TURN or NUMBER:X,Y,TURN,Z";
  double x = 0.0, y = 0.0, rotation = 0.0, z = item.placement.liftMm;
  if (!base::readNumbers(rest, ',', {&x, &y}) &&
      !base::readNumbers(rest, ',', {&x, &y, &rotation}) &&
      !base::readNumbers(rest, ',', {&x, &y, &rotation, &z}))
    throw badText("--place", text, kForm);
  if (z < 0.0)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("--place {text}: the part would be below the plate"_text, text),
                      {}, "give a height of 0 or more"_text);
  item.placement.centreMm = {x, y};
  item.placement.liftMm = z;
  item.placement.rotation =
      Eigen::AngleAxisd(base::degreesToRadians(rotation), Eigen::Vector3d::UnitZ()) *
      item.placement.rotation;
}

void setOwn(pipeline::PlanRequest& request, std::size_t number, const std::string& text,
            const std::string& rest) {
  const std::size_t equals = rest.find('=');
  if (equals == std::string::npos)
    throw badText("--part", text, "NUMBER:KEY=VALUE");
  const std::string key = rest.substr(0, equals), value = rest.substr(equals + 1);
  project::ItemChoices& item = request.choices.item(number);
  if (key == "mode") {
    item.automatic = value == "auto";
    if (!item.automatic)
      item.mode = value;
  } else if (key == "scale") {
    item.scale = value;
  } else {
    for (const base::Message& note : pipeline::setItemParameters(item, {rest}))
      fmt::print(stderr, "note: {}\n", base::english(note));
  }
}

// Adds a region to the part of that number, or to every part. No shape begins with a digit.
void addRegion(pipeline::PlanRequest& request, const std::string& text,
               const base::RunContext& ctx) {
  if (!text.empty() && text.front() >= '0' && text.front() <= '9') {
    const auto [number, rest] =
        numbered("--region", text, "NUMBER:SHAPE", request.choices.items.size());
    request.choices.item(number).regions.push_back(regions::parsedRegion(rest, ctx));
    return;
  }
  const project::Region region = regions::parsedRegion(text, ctx);
  for (project::ItemChoices& item : request.choices.items)
    item.regions.push_back(region);
}

// Prints a note if parts of a file touch: the plan refuses parts that overlap.
void noteTouching(const std::string& file, const std::vector<project::PartInFile>& parts) {
  if (const auto pair = project::touchingParts(parts))
    fmt::print(stderr, "note: {}: parts {} ({}) and {} ({}) touch; --as-one makes them one part\n",
               file, pair->first + 1, parts[pair->first].part->name, pair->second + 1,
               parts[pair->second].part->name);
}

// Returns the facets that the option or else the tool's bead asks for, in lengths of the file.
geometry::Tessellation tessellationOf(const PlateOptions& options,
                                      const pipeline::PlanRequest& request, double scale) {
  if (options.facets.empty())
    return geometry::tessellationFor(
        process::loadProcess(request.choices.tool().process).beadWidthMm / scale);
  geometry::Tessellation asked;
  double degrees = base::radiansToDegrees(asked.angleRad);
  if ((!base::readNumbers(options.facets, ',', {&asked.chordMm}) &&
       !base::readNumbers(options.facets, ',', {&asked.chordMm, &degrees})) ||
      !(asked.chordMm > 0.0) || !(degrees > 0.0 && degrees <= 90.0))
    throw badText("--facets", options.facets, "MM or MM,DEGREES");
  asked.angleRad = base::degreesToRadians(degrees);
  return asked;
}

// Adds an item for each part of the file.
void addFile(pipeline::PlanRequest& request, const std::string& file,
             const project::ItemChoices& choices, const PlateOptions& options,
             const base::RunContext& ctx) {
  const double scale = std::max(project::parsedScale(choices.scale), 0.0);
  const double factor = scale > 0.0 ? scale : 1.0;
  const std::size_t tools = request.choices.tools.size();
  std::vector<project::PartInFile> parts;
  if (project::mayHoldSeveral(file)) {
    const geometry::Tessellation facets = tessellationOf(options, request, factor);
    parts = options.asOne ? std::vector{project::PartInFile{
                                project::loadAsOne(file, choices.repair, facets, ctx), {}}}
                          : project::loadParts(file, choices.repair, facets, ctx);
  }
  for (project::PartInFile& part : parts)
    part.part = project::withToolsOfJob(part.part, tools);
  if (parts.size() < 2) {
    const auto loaded = parts.empty() ? nullptr : parts.front().part;
    for (int copy = 0; copy < options.copies; ++copy) {
      request.items.push_back({file, loaded});
      request.choices.items.push_back(choices);
      if (loaded && !options.noFileRegions)
        project::takeFromFile(request.choices.items.back(), *loaded);
    }
    return;
  }
  if (options.parts.size() == 1 && options.copies == 1)
    noteTouching(file, parts);
  project::Choices one = request.choices;
  one.items = {choices};
  const std::vector<geometry::Placement> places = project::placesInFile(
      parts, pipeline::unitMm(*parts.front().part, one) * factor, choices.placement.rotation);
  for (int copy = 0; copy < options.copies; ++copy)
    for (std::size_t i = 0; i < parts.size(); ++i) {
      request.items.push_back({file, parts[i].part});
      request.choices.items.push_back(choices);
      request.choices.items.back().placement = places[i];
      if (!options.noFileRegions)
        project::takeFromFile(request.choices.items.back(), *parts[i].part);
    }
}

} // namespace

pipeline::PlanRequest withParts(pipeline::PlanRequest request, const PlateOptions& options,
                                const base::RunContext& ctx) {
  const project::ItemChoices choices = request.choices.item();
  request.items.clear();
  request.choices.items.clear();
  for (const std::string& part : options.parts)
    addFile(request, part, choices, options, ctx);
  const std::size_t count = request.items.size();
  for (const std::string& text : options.own) {
    const auto [number, rest] = numbered("--part", text, "NUMBER:KEY=VALUE", count);
    setOwn(request, number, text, rest);
  }
  for (const std::string& text : options.regions)
    addRegion(request, text, ctx);
  for (const std::string& text : options.places) {
    const auto [number, rest] = numbered("--place", text, "NUMBER:X,Y,TURN,Z", count);
    place(request.choices.item(number), text, rest);
  }
  for (std::size_t i = 0; i < count; ++i) {
    project::ItemChoices& item = request.choices.item(i);
    if (!item.automatic && !item.platformStays)
      item.platform = pipeline::usualPlatform(project::onlyItem(request.choices, i));
  }
  const bool areOfOneFile = options.parts.size() == 1 && options.copies == 1;
  if (areOfOneFile || !options.places.empty())
    return request;
  return pipeline::withArrangedParts(std::move(request), ctx);
}

} // namespace voluta::cli
