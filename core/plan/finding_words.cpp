// The names in the sentences of findings, and the words by which reports and files call them.
#include "plan/finding_kinds.h"

#include <algorithm>
#include <utility>

namespace voluta::plan {

namespace {
bool hasPlace(base::Text text, std::string_view name) {
  return std::ranges::count(base::placeNames(text.english()), name) > 0;
}
} // namespace

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

plan::Stage stageOf(const Finding& finding) {
  if (const base::Value* word = finding.value(kVerbatimStage))
    return stageNamed(base::english(*word)).value_or(Stage::Load);
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
