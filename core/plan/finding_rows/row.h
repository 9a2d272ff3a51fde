// Makes the rows of the table of findings (finding_kinds.h), with defaults for the fields that most
// rows share, and has the texts and remedies of several stages. The file of a stage has its rows,
// in the order of FindingKind; finding_table.cpp joins them and sets FindingRow::stage.
#pragma once

#include "plan/finding_kinds.h"

#include <array>

namespace voluta::plan::finding_rows {

using enum FindingKind;
using enum RemedyId;

struct OtherFields {
  std::string_view reportId = {}; // Empty: as the id
  std::span<const RemedyId> remedies = {};
  base::Text whyNoRemedy = {};
  base::Text more = {};
  Concern concern = Concern::ByStage;
};

constexpr FindingRow row(Severity severity, FindingKind kind, std::string_view id,
                         base::Text reason, base::Text remedy, const OtherFields& others) {
  return {.kind = kind,
          .id = id,
          .reportId = others.reportId.empty() ? id : others.reportId,
          .stage = {},
          .severity = severity,
          .reason = reason,
          .remedy = remedy,
          .remedies = others.remedies,
          .whyNoRemedy = others.whyNoRemedy,
          .more = others.more,
          .concern = others.concern};
}

// Return a row of this severity.
constexpr FindingRow error(FindingKind kind, std::string_view id, base::Text reason,
                           base::Text remedy, const OtherFields& others = {}) {
  return row(Severity::Error, kind, id, reason, remedy, others);
}
constexpr FindingRow info(FindingKind kind, std::string_view id, base::Text reason,
                          base::Text remedy, const OtherFields& others = {}) {
  return row(Severity::Info, kind, id, reason, remedy, others);
}
constexpr FindingRow byAmount(FindingKind kind, std::string_view id, base::Text reason,
                              base::Text remedy, const OtherFields& others = {}) {
  return row(Severity::ByAmount, kind, id, reason, remedy, others);
}

// A list of remedies, in the order in which they are offered.
template <RemedyId... Ids> inline constexpr std::array<RemedyId, sizeof...(Ids)> kOffers{Ids...};

inline constexpr std::span<const RemedyId> kForSlivers = kOffers<FinerProcess, Enlarge>;
inline constexpr std::span<const RemedyId> kForRod = kOffers<ScaleToFit, Shrink>;
inline constexpr std::span<const RemedyId> kForHome = kOffers<UsualCell>;

inline constexpr base::Text kOnlyWriteAgain =
    "the program does not match this plan: changing the plan does not help"_text;
inline constexpr base::Text kWriteAgain =
    "write the program again; to keep this change, make it in the plan"_text;
inline constexpr base::Text kOthersHelp = "see the remedies of the findings before this one"_text;
inline constexpr base::Text kCellFile = "change the cell's file: Edit, Edit cell"_text;
inline constexpr base::Text kSlicersPaths =
    "the tool-paths are those of the file: change them where they were made"_text;
inline constexpr base::Text kSameReason = "{reason}"_text; // of a finding with another remedy
inline constexpr base::Text kMovePart =
    "move the part on the plate, or use another cell; its tool-paths are printed as they are"_text;
inline constexpr base::Text kBreakOff = "break it off after printing"_text;
inline constexpr base::Text kRotateOrOther =
    "turn the part (`orient=leastRisky`), or use planar or curved mode"_text;
inline constexpr base::Text kFiner = "use a finer nozzle, or print the part larger"_text;

// The program differs from this plan.
constexpr FindingRow mismatch(FindingKind kind, std::string_view id, base::Text reason,
                              OtherFields others = {}) {
  others.whyNoRemedy = kOnlyWriteAgain;
  return error(kind, id, reason, kWriteAgain, others);
}

} // namespace voluta::plan::finding_rows
