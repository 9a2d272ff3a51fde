// The result of a mode's decomposition; each kind of mode has its own type.
#pragma once

#include <memory>
#include <variant>

namespace voluta::curved {
struct Decomposition;
}
namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::planar {
struct PlanarDecomposition;
}

namespace voluta::project {

// Levels above a ground. `part`: the part without the volume that the ground occupies; null: the
// whole part.
struct ReducedPlatform {
  std::shared_ptr<const geometry::TriangleMesh> part;
};
using Voxels = std::shared_ptr<const curved::Decomposition>;       // ranks and a field; not null
using Pieces = std::shared_ptr<const planar::PlanarDecomposition>; // not null

using ModeResult = std::variant<ReducedPlatform, Voxels, Pieces>;
enum class ResultKind { OnGround, InVoxels, InPieces }; // in the order of the variant

inline ResultKind kindOf(const ModeResult& result) {
  return static_cast<ResultKind>(result.index());
}

// Returns the result if it is of that kind; else null.
template <typename T> T resultAs(const ModeResult& result) {
  const T* is = std::get_if<T>(&result);
  return is ? *is : T();
}

} // namespace voluta::project
