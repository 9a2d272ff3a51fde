#include "plan/finding_kinds.h"

#include "base/error.h"
#include "plan/finding_rows/decompose_rows.h"
#include "plan/finding_rows/layers_rows.h"
#include "plan/finding_rows/load_rows.h"
#include "plan/finding_rows/milling_rows.h"
#include "plan/finding_rows/motion_rows.h"
#include "plan/finding_rows/place_rows.h"
#include "plan/finding_rows/replay_rows.h"
#include "plan/finding_rows/station_rows.h"
#include "plan/finding_rows/toolpath_rows.h"

#include <iterator>

namespace voluta::plan {

namespace {
constexpr std::size_t kKinds = static_cast<std::size_t>(FindingKind::StatementBeforeRest) + 1;

// Findings that state their own stage.
constexpr FindingRow kAnyStageRows[] = {
    {FindingKind::Verbatim,
     "verbatim",
     "",
     Stage::Load,
     Severity::ByAmount,
     "{reason}"_text,
     "{remedy}"_text,
     {},
     "stored as text in an older project: plan again to see remedies"_text},
    {FindingKind::Stopped,
     "stopped",
     "stopped",
     Stage::Load,
     Severity::Error,
     "{what}"_text,
     {},
     finding_rows::kOffers<RemedyId::DropToPlate, RemedyId::ChooseStrategy>,
     "the message says how to fix it"_text},
};

struct JoinedRows {
  std::array<FindingRow, kKinds> rows{};
  std::size_t count = 0;

  constexpr void add(Stage stage, Concern concern, std::span<const FindingRow> more) {
    for (const FindingRow& row : more) {
      FindingRow& added = rows.at(count++);
      added = row;
      added.stage = stage;
      if (row.concern == Concern::ByStage)
        added.concern = concern;
    }
  }
};

constexpr JoinedRows joinedRows() {
  using namespace finding_rows;
  JoinedRows joined;
  joined.add(Stage::Load, Concern::Safety, kAnyStageRows);
  joined.add(Stage::Load, Concern::Part, kLoadRows);
  joined.add(Stage::Decompose, Concern::Part, kDecomposeRows);
  joined.add(Stage::Layers, Concern::Part, kLayersRows);
  joined.add(Stage::Toolpath, Concern::Part, kToolpathRows);
  joined.add(Stage::Motion, Concern::Part, kMotionRows);
  joined.add(Stage::Replay, Concern::Safety, kReplayRows);
  joined.add(Stage::Motion, Concern::Safety, kWorkOrderRows);
  joined.add(Stage::Replay, Concern::Safety, kCommonRunRows);
  joined.add(Stage::Replay, Concern::Safety, kMillingRows);
  joined.add(Stage::Decompose, Concern::Part, kBlockedRows);
  joined.add(Stage::Layers, Concern::Part, kPlaneRows);
  joined.add(Stage::Replay, Concern::Part, kRestRows);
  return joined;
}
constexpr JoinedRows kRows = joinedRows();

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kRows.count; ++i)
    if (static_cast<std::size_t>(kRows.rows.at(i).kind) != i)
      return false;
  return kRows.count == kKinds;
}
static_assert(inOrder(), "a row a kind, in the order of FindingKind");
} // namespace

std::span<const FindingRow> findingRows() {
  return kRows.rows;
}

const FindingRow& rowOf(FindingKind kind) {
  const auto i = static_cast<std::size_t>(kind);
  base::require(i < kKinds, "a kind of finding");
  return kRows.rows.at(i);
}

bool blocksRunning(const Finding& finding) {
  return finding.blocking && rowOf(finding.kind).concern == Concern::Safety;
}

} // namespace voluta::plan
