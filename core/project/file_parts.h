// The parts of a file that may hold several: 3MF, STEP, IGES.
#pragma once

#include "geometry/placement.h"
#include "project/loaded_part.h"

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace voluta::project {

struct ItemChoices;

struct PartInFile {
  std::shared_ptr<const LoadedPart> part;
  Eigen::Vector3d placeMm{0.0, 0.0, 0.0}; // of its mesh's origin in the file
};

// Returns whether files with this ending may hold several parts.
bool mayHoldSeveral(const std::string& file);

// Returns the parts of a 3MF (geometry::read3mfParts()) or of a CAD file (project/cad_parts.h),
// named after their objects; else, and of a 3MF with one part or with tool-paths, the only part, as
// loadPart() does. Throws as loadPart().
std::vector<PartInFile> loadParts(const std::string& part, bool repair,
                                  const base::RunContext& ctx);

// Gives an item the regions of its part's file, and the events of layers unless it has its own.
void takeFromFile(ItemChoices& item, const LoadedPart& part);

// Returns the part without the tools of its regions that a job with so many tools does not have,
// with a note for each; itself if the job has all.
std::shared_ptr<const LoadedPart> withToolsOfJob(std::shared_ptr<const LoadedPart> part,
                                                 std::size_t tools);

// Returns placements of that rotation that keep the parts' places relative to each other, with the
// centre of the whole at the origin and its lowest point on the plate; parts at most 0.01 mm above
// it are put on it. `scale`: of the whole, > 0. Precondition: the meshes are not empty.
std::vector<geometry::Placement> placesInFile(std::span<const PartInFile> parts, double scale,
                                              const Eigen::Quaterniond& rotation);

// Returns the first two parts that touch or overlap; nullopt if there are none.
std::optional<std::pair<std::size_t, std::size_t>> touchingParts(std::span<const PartInFile> parts);

} // namespace voluta::project
