// Shared helpers of the readers of 3MF packages (3MF core specification 1.3).
#pragma once

#include "geometry/formats/zip_package.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// Returns the member's name, which lacks the leading slash of paths.
std::string memberOf(std::string_view path);

// Returns whether the package's relations name a model. Throws Error{UnreadableFile} if they are
// damaged.
bool namesModel(const ZipPackage& package, const std::string& name);

// Returns the member that the package's relations name as its model. `name`: of the file, for
// errors. Throws Error{UnreadableFile} if there is none.
std::string mainModel(const ZipPackage& package, const std::string& name);

// Type of a model's relations to its layers of tool-paths (3MF Toolpath Extension 1.0, 3.2).
inline constexpr std::string_view kToolpathLayerRelation =
    "http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03/layer";

// Returns the targets of the relations of the member `model` to layers of tool-paths, as absolute
// paths. Throws Error{UnreadableFile} if the relations are damaged.
std::set<std::string> toolpathLayers(const ZipPackage& package, const std::string& model,
                                     const std::string& name);

// Returns the mm per unit of a model's lengths ("millimeter", "inch", ...); nullopt if the unit is
// unknown.
std::optional<double> threemfUnitMm(const std::string& unit);

} // namespace voluta::geometry
