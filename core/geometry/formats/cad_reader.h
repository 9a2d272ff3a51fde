// STEP and IGES files. A separate program, voluta-cad-reader, reads them with Open CASCADE: a
// damaged file can only crash that program, and only that program contains the kernel.
#pragma once

#include "geometry/formats/part_of_file.h"

#include <chrono>
#include <filesystem>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::geometry {

// How closely facets follow the surfaces of a CAD file.
struct Tessellation {
  double chordMm = 0.02;   // largest distance of a facet from its surface
  double angleRad = 0.087; // largest angle between neighbouring facets of a surface

  bool operator==(const Tessellation&) const = default;
};

// Returns a chord of 2 % of the bead width, which no bead shows.
Tessellation tessellationFor(double beadWidthMm);

// Returns whether the name ends as that of a CAD file.
bool isCad(const std::filesystem::path& file);

constexpr std::chrono::milliseconds kCadLimit = std::chrono::seconds(300);

// Returns a part for each solid and for each surface of no solid; of an assembly, for each use,
// named after its product. A file of one part: readCad(), at the origin. Lengths are converted from
// the file's unit to mm. Omitted content is among the repairs of the first part. Throws
// Error{UnreadableFile} if the file is missing, empty, truncated, damaged, not of these formats,
// takes longer than the limit or more memory than the reader has, or the reader is missing;
// Error{UnusableInput} if it has no solid and no surface, or more than kMaxPartsOfFile; Cancelled.
std::vector<PartOfFile> readCadParts(const std::filesystem::path& file,
                                     const Tessellation& tessellation, const base::RunContext& ctx,
                                     std::chrono::milliseconds limit = kCadLimit);

// Same, all as one mesh in its place in the file, of any number of bodies.
MeshFile readCad(const std::filesystem::path& file, const Tessellation& tessellation,
                 const base::RunContext& ctx, std::chrono::milliseconds limit = kCadLimit);

} // namespace voluta::geometry
