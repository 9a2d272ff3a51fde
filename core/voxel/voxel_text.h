// Parts as plain text (Boge 2019, 5.1.2): rows of 0 and 1, '-' for the platform.
#pragma once

#include "voxel/voxel_object.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::voxel {

// Largest object: cells a side and in all.
inline constexpr int kLargestSide = 4000;
inline constexpr std::size_t kLargestObject = 100'000'000;

// A slice is a block of rows of one length: columns run along x, rows from the top down. One slice
// is a flat object. More slices, parted by blank lines (an addition to the source), follow one
// another along y, the front first. Where only the first or only the last slice has '-' and no 1 is
// in it, slices lie flat instead: layers stacked on that platform (fig. 5.2), rows from the back to
// the front.
//
// The platform's surface, z = 0, is the upper side of the highest row that has '-'; where 1 stands
// in that row too, beside '-', it is the row's lower side. No 1 may lie below, and some 1 stands on
// it. Rows of '-' below are the platform's body: only the highest is told in `platform`.
//
// White space at the end of rows, blank lines at both ends and a byte order mark are passed over.
// `name` is used in errors, which give line and column, both from 1.
// Throws Error{UnreadableFile}: other characters, rows or slices of unequal size.
// Throws Error{UnusableInput}: empty, no 1, no platform, 1 below it or none on it, too large.
VoxelObject readVoxelText(std::string_view text, const std::string& name);

// The object as upright slices, the platform as their last row: readVoxelText() gives it back, but
// for one whose platform lies under its first or last slice alone while that slice has no 1.
std::string writeVoxelText(const VoxelObject& object);

// Is the first line that is not blank made of 0, 1 and '-' alone?
bool looksLikeVoxelText(std::string_view text);

} // namespace voluta::voxel
