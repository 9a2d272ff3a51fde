// Parts as plain text (Boge 2019, 5.1.2): rows of 0 and 1, '-' for the platform.
#pragma once

#include "voxel/voxel_object.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::voxel {

// Largest object: cells per side and in all.
inline constexpr int kLargestSide = 4000;
inline constexpr std::size_t kLargestObject = 100'000'000;

// A slice is a block of rows of equal length: columns run along x, rows from the top down. One
// slice is a flat object. Several slices, separated by blank lines (an addition to the source),
// follow one another along y, the front first. If only the first or only the last slice has '-',
// and that slice has no 1, slices are horizontal instead: layers stacked on that platform (fig.
// 5.2), rows from the back to the front.
//
// The platform's surface, z = 0, is the upper side of the highest row that has '-'; if that row
// also contains 1, it is the row's lower side. No 1 may be below it, and at least one 1 must be on
// it. Rows of '-' below are the platform's body: only the highest is stored in `platform`.
//
// White space at the end of rows, blank lines at both ends and a byte order mark are ignored.
// `name` is used in errors, which give line and column, both from 1. Throws Error{UnreadableFile}
// for other characters or for rows or slices of unequal size. Throws Error{UnusableInput} if the
// file is empty, has no 1, no platform, a 1 below it or none on it, or is too large.
VoxelObject readVoxelText(std::string_view text, const std::string& name);

// Returns the object as upright slices, with the platform as their last row: readVoxelText()
// restores it, except if its platform is only below its first or last slice while that slice has no
// 1.
std::string writeVoxelText(const VoxelObject& object);

// Returns whether the first line that is not blank consists only of 0, 1 and '-'.
bool looksLikeVoxelText(std::string_view text);

} // namespace voluta::voxel
