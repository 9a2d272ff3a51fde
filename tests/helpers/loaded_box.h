// A box as if it had been read from a file.
#pragma once

#include "helpers/shapes.h"
#include "project/loaded_part.h"

#include <memory>
#include <string>

namespace voluta::test {

inline std::shared_ptr<const project::LoadedPart> loadedBox(const Eigen::Vector3d& low,
                                                            const Eigen::Vector3d& high,
                                                            const std::string& name = "box.stl") {
  return project::loadedFrom(name, std::make_shared<geometry::TriangleMesh>(box(low, high)), {},
                             true, {});
}

} // namespace voluta::test
