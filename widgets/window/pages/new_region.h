// The shape that a region has when it is added to a part.
#pragma once

#include "project/region.h"

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::window {

// Returns a region of a kind without a file, in the middle of the part and a third of its size.
// `inFile`, `placed`: the part's boxes in its file's coordinates and in the work frame.
project::Region newRegion(const std::string& kind, const Eigen::AlignedBox3d& inFile,
                          const Eigen::AlignedBox3d& placed);

// Returns the text of a shape.
std::string shapeText(std::string_view kind, const std::vector<double>& numbers);

} // namespace voluta::window
