// A box as if it had been read from a file.
#pragma once

#include "helpers/shapes.h"
#include "pipeline/load_stage.h"

#include <memory>
#include <string>

namespace voluta::test {

inline std::shared_ptr<const pipeline::LoadedPart> loadedBox(const Eigen::Vector3d& low,
                                                             const Eigen::Vector3d& high,
                                                             const std::string& name = "box.stl") {
  return pipeline::loadedFrom(name, std::make_shared<geometry::TriangleMesh>(box(low, high)), {},
                              true, {});
}

} // namespace voluta::test
