// Findings on what is asked for at places of a part, of several stages.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr FindingRow kBlockedRows[] = {
    info(
        OverhangBlocked, "overhangBlocked",
        "{area:.3g} overhangs by more than {angle} where regions block supports; here is most of it"_text,
        "turn the part, or let the region have supports if the overhang sags"_text,
        {.reportId = "overhang", .remedies = kOffers<RotateToMinRiskyArea>}),
};
inline constexpr FindingRow kPlaneRows[] = {
    info(PlanesWithoutSupports, "planesWithoutSupports",
         "layers along given planes have no supports: those asked for are left out"_text,
         "remove `layerPlanes`, or set `supports=none`"_text),
};
inline constexpr FindingRow kRestRows[] = {
    info(StatementBeforeRest, "statementBeforeRest",
         "the rest does not run your statement before its beginning: {statement}"_text,
         "run it on the controller if the rest needs it"_text),
};

} // namespace voluta::plan::finding_rows
