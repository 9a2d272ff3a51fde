#include "toolpath/infill.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <array>
#include <string>

namespace voluta::toolpath {

namespace {
constexpr std::array<InfillKind, 6> kKinds{{
    {"zigzag", zigzagInfill},
    {"concentric", concentricInfill},
    {"woven", wovenInfill, true},
    {"around", aroundInfill, true},
    {"along", alongInfill, true},
    {"helical", helicalInfill, true},
}};
} // namespace

std::span<const InfillKind> infillKinds() {
  return kKinds;
}

const InfillKind& infillKind(std::string_view id) {
  std::vector<std::string> ids;
  for (const InfillKind& kind : kKinds) {
    if (kind.id == id)
      return kind;
    ids.emplace_back(kind.id);
  }
  throw base::Error(base::ErrorCode::Usage, "unknown infill '" + std::string(id) + "'", "infill",
                    "did you mean " + base::nearestName(id, ids) + "?");
}

} // namespace voluta::toolpath
