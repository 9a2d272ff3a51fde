// Shared helpers of the readers of 3MF packages (3MF core specification 1.3).
#pragma once

#include "geometry/formats/zip_package.h"

#include <optional>
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

// Returns the mm per unit of a model's lengths ("millimeter", "inch", ...); nullopt if the unit is
// unknown.
std::optional<double> threemfUnitMm(const std::string& unit);

} // namespace voluta::geometry
