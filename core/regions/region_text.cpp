#include "regions/region_text.h"

#include "base/error.h"
#include "geometry/repair/repair.h"
#include "project/loaded_part.h"
#include "regions/region_kinds.h"
#include "regions/region_uses.h"

#include <filesystem>

namespace voluta::regions {

namespace {
std::shared_ptr<const geometry::TriangleMesh> closedMesh(const std::string& file,
                                                         const base::RunContext& ctx) {
  const auto loaded = project::loadPart(file, true, ctx);
  if (!geometry::isWatertight(*loaded->mesh))
    throw base::Error(base::ErrorCode::UnusableInput, "the body of a region is not closed"_text,
                      file, "repair it in a modelling program"_text);
  return loaded->mesh;
}
// Throws as findUse().
std::string checkedUse(const std::string& use) {
  findUse(use);
  return use;
}
} // namespace

project::Region parsedRegion(const std::string& text, const base::RunContext& ctx) {
  project::Region region;
  std::size_t end = text.find(';');
  region.shape = text.substr(0, end);
  const Shape shape = parsedShape(region.shape);
  region.use = shape.kind->usualUse;
  while (end != std::string::npos) {
    const std::size_t begin = end + 1;
    end = text.find(';', begin);
    const std::string setting = text.substr(begin, end == std::string::npos ? end : end - begin);
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw base::Error(
          base::ErrorCode::Usage,
          base::message("region '{text}': '{setting}' is no setting"_text, text, setting), {},
          base::message("write {form}"_text, kRegionForm));
    const std::string key = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (key == "use")
      region.use = checkedUse(value);
    else if (key == "name")
      region.name = value;
    else
      region.parameters[key] = value;
  }
  if (shape.kind->mesh == ShapeMesh::Painted)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("region '{text}' has no painted surface"_text, text), {},
                      "paint it in the window, or give a body"_text);
  if (shape.kind->mesh == ShapeMesh::File) {
    region.mesh = closedMesh(shape.file, ctx);
    region.shape =
        std::string(shape.kind->word) + ":" + std::filesystem::path(shape.file).filename().string();
  }
  return region;
}

} // namespace voluta::regions
