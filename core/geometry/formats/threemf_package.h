// What all readers of 3MF packages need (3MF core specification 1.3).
#pragma once

#include "geometry/formats/zip_package.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// Members are named without the slash that paths begin with.
std::string memberOf(std::string_view path);

// Whether the package's relations name a model. Throws Error{UnreadableFile}: they are damaged.
bool namesModel(const ZipPackage& package, const std::string& name);

// The member that the package's relations name as its model. `name`: of the file, for errors.
// Throws Error{UnreadableFile}: there is none.
std::string mainModel(const ZipPackage& package, const std::string& name);

// mm a unit of a model's lengths ("millimeter", "inch", ...); none: not known.
std::optional<double> threemfUnitMm(const std::string& unit);

} // namespace voluta::geometry
