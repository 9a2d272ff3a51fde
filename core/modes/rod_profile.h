// The rod's profile as the user types it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::modes {

// "x,r x,r ..." or a file that holds such pairs, as text that names no file: pairs separated by
// blanks or lines. Empty stays empty. Throws Error{Usage} for what is neither, saying which pair;
// Error{UnreadableFile}.
std::string rodProfileText(const std::string& value);

// Points (x, radius), mm, of rodProfileText's text. Throws Error{Usage}.
std::vector<Eigen::Vector2d> rodProfile(const std::string& text);

} // namespace voluta::modes
