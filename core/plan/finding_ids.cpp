// The rows of findings by their ids, also by those of older versions.
#include "plan/finding_kinds.h"

#include <algorithm>
#include <iterator>

namespace voluta::plan {

namespace {
using enum FindingKind;

// Kinds of older versions, as their ids in project files.
struct OldKind {
  std::string_view id;
  FindingKind kind;
  bool more = true; // Finding::more
};
constexpr OldKind kOldKinds[] = {
    {"shadowedUnderFacetAndMore", ShadowedUnderFacet},
    {"shadowedUnreachedAndMore", ShadowedUnreached},
    {"moreShadowed", MissedGroups, false},
    {"moreUnreached", MissedGroups, false},
    {"moreUnreachable", Unreachable},
    {"moreUnconnected", Unconnected},
    {"moreBeyondRod", BeyondRod},
    {"moreHeadInPart", HeadInPart},
    {"moreHeadInPlatform", HeadInPlatform},
    {"moreCollisions", Collision},
    {"moreMeetOnCloserLook", MeetsOnCloserLook},
    {"moreReplayedCollisions", ReplayedCollision},
    {"moreLimits", JointRange},
};

const OldKind* oldKind(std::string_view id) {
  const auto* found = std::ranges::find(kOldKinds, id, &OldKind::id);
  return found == std::end(kOldKinds) ? nullptr : found;
}
} // namespace

const FindingRow* rowWithId(std::string_view id) {
  if (const OldKind* old = oldKind(id))
    return &rowOf(old->kind);
  const std::span<const FindingRow> rows = findingRows();
  const auto found = std::ranges::find(rows, id, &FindingRow::id);
  return found == rows.end() ? nullptr : &*found;
}

bool isIdOfMore(std::string_view id) {
  const OldKind* old = oldKind(id);
  return old && old->more;
}

} // namespace voluta::plan
