// Parsing of the rod's profile as typed by the user.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::modes {

// Returns the pairs of a profile as text, separated by blanks or line breaks. `value`: "x,r x,r
// ..." or the name of a file with such pairs; empty stays empty. Throws Error{Usage}, with the
// pair's number, if the value is neither, and Error{UnreadableFile}, with the file's name, if the
// file has no pairs.
std::string rodProfileText(const std::string& value);

// Parses the text returned by rodProfileText() into points (x, radius) [mm]. Throws Error{Usage}.
std::vector<Eigen::Vector2d> rodProfile(const std::string& text);

} // namespace voluta::modes
