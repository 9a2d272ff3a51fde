#include "toolpath/infill/infill.h"

#include "base/nearest_name.h"

#include <array>

namespace voluta::toolpath {

namespace {
constexpr std::array<InfillKind, 8> kKinds{{
    {"zigzag", "zigzag"_text, zigzagInfill, false, true},
    {kFieldInfill, "along a field"_text, fieldInfill},
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
  return base::rowWithId(infillKinds(), id, "unknown infill '{id}'"_text, "infill"_name);
}

} // namespace voluta::toolpath
