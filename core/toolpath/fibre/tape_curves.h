// Curves along which tapes are laid, as text.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::toolpath {

// Returns the polylines in a text like "0,0 50,10 80,10; 0,5 80,5,2": points x,y or x,y,z in the
// work frame [mm], separated by spaces, curves by semicolons. Throws Error{Usage} for anything else
// and for a curve of fewer than two points.
std::vector<std::vector<Eigen::Vector3d>> tapeCurves(const std::string& text);

} // namespace voluta::toolpath
