#include "plan/finding_kinds.h"

#include "base/error.h"
#include "plan/finding_rows.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace voluta::plan {

namespace {
using enum FindingKind;
using enum Stage;
using finding_rows::kRows;

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

bool hasPlace(base::Text text, std::string_view name) {
  return std::ranges::count(base::placeNames(text.english()), name) > 0;
}

const OldKind* oldKind(std::string_view id) {
  const auto* found = std::ranges::find(kOldKinds, id, &OldKind::id);
  return found == std::end(kOldKinds) ? nullptr : found;
}

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (static_cast<std::size_t>(kRows[i].kind) != i)
      return false;
  return kRows.size() == static_cast<std::size_t>(ForeignRefused) + 1;
}
static_assert(inOrder(), "a row a kind, in the order of FindingKind");
} // namespace

std::span<const FindingRow> findingRows() {
  return kRows;
}

const FindingRow& rowOf(FindingKind kind) {
  const auto i = static_cast<std::size_t>(kind);
  base::require(i < kRows.size(), "a kind of finding");
  return kRows[i];
}

std::vector<std::string_view> valueNames(const FindingRow& row, bool more) {
  std::vector<std::string_view> names;
  const auto add = [&](std::string_view name) {
    if (std::ranges::find(names, name) == names.end())
      names.push_back(name);
  };
  if (!more || hasPlace(row.more, kReason))
    std::ranges::for_each(base::placeNames(row.reason.english()), add);
  if (more)
    for (const std::string_view name : base::placeNames(row.more.english()))
      if (name != kCount && name != kReason)
        add(name);
  std::ranges::for_each(base::placeNames(row.remedy.english()), add);
  return names;
}

const FindingRow* rowWithId(std::string_view id) {
  if (const OldKind* old = oldKind(id))
    return &rowOf(old->kind);
  const auto* found =
      std::find_if(kRows.begin(), kRows.end(), [&](const FindingRow& row) { return row.id == id; });
  return found == kRows.end() ? nullptr : found;
}

bool isIdOfMore(std::string_view id) {
  const OldKind* old = oldKind(id);
  return old && old->more;
}

plan::Stage stageOf(const Finding& finding) {
  if (const base::Value* word = finding.value(kVerbatimStage))
    return stageNamed(base::english(*word)).value_or(Load);
  return rowOf(finding.kind).stage;
}

std::string reportId(const Finding& finding) {
  if (const base::Value* word = finding.value(kVerbatimKind);
      word && finding.kind == FindingKind::Verbatim)
    return base::english(*word);
  return std::string(rowOf(finding.kind).reportId);
}

Finding verbatimFinding(plan::Stage stage, std::string kind, std::string reason,
                        std::string remedy) {
  Finding f;
  f.kind = FindingKind::Verbatim;
  f.values = {{kVerbatimStage, stageName(stage)},
              {kVerbatimKind, std::move(kind)},
              {kVerbatimReason, std::move(reason)},
              {kVerbatimRemedy, std::move(remedy)}};
  return f;
}

Finding stoppedFinding(plan::Stage stage, base::Message what) {
  Finding f = makeFinding(FindingKind::Stopped, {{"what", std::move(what)}});
  f.values.push_back({kVerbatimStage, stageName(stage)});
  return f;
}

} // namespace voluta::plan
