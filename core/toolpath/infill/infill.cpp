#include "toolpath/infill/infill.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <array>
#include <string>

namespace voluta::toolpath {

namespace {
constexpr std::array<InfillKind, 7> kKinds{{
    {"zigzag", "zigzag"_text, zigzagInfill, false, true},
    {"concentric", "concentric"_text, concentricInfill},
    {"fermat", "Fermat spiral"_text, fermatInfill},
    {"woven", "woven"_text, wovenInfill, true},
    {"around", "around"_text, aroundInfill, true},
    {"along", "along"_text, alongInfill, true},
    {"helical", "helical"_text, helicalInfill, true},
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
  throw base::Error(base::ErrorCode::Usage,
                    base::message("unknown infill '{id}'"_text, std::string(id)), "infill"_name,
                    base::didYouMean(id, ids));
}

} // namespace voluta::toolpath
