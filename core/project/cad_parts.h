// Parts of files whose surfaces become facets as fine as asked: STEP and IGES. Files of other
// formats are read as loadParts() and loadPart() do.
#pragma once

#include "geometry/formats/cad_reader.h"
#include "project/file_parts.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::project {

// Returns the parts of the file (geometry::readCadParts()), named after their products. Throws as
// loadPart().
std::vector<PartInFile> loadParts(const std::string& part, bool repair,
                                  const geometry::Tessellation& tessellation,
                                  const base::RunContext& ctx);

// Returns all bodies of the file as one part. Throws as loadPart().
std::shared_ptr<const LoadedPart> loadAsOne(const std::string& part, bool repair,
                                            const geometry::Tessellation& tessellation,
                                            const base::RunContext& ctx);

} // namespace voluta::project
