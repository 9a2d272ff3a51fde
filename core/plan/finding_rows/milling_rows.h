// Findings of the replay of a milled part's program.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr base::Text kPassValues =
    "only you know which cutter and block you have: change the values of the passes"_text;

inline constexpr FindingRow kMillingRows[] = {
    mismatch(OtherMotion, "otherMotion", "another motion than planned"_text),
    mismatch(RapidInBlock, "rapidInBlock", "a rapid move through the block"_text,
             {.reportId = "collision"}),
    mismatch(SpindleChanged, "spindleChanged", "the spindle has another speed than planned"_text),
    mismatch(FeedChanged, "feedChanged", "another feed than planned"_text,
             {.reportId = "speedChanged"}),
    mismatch(CutterBelowBlock, "cutterBelowBlock",
             "the cutter cuts into the fixture below the block"_text, {.reportId = "collision"}),
    mismatch(BlockTurnedBelow, "blockTurnedBelow",
             "the block turns while the cutter is not home"_text, {.reportId = "blockTurned"}),
    mismatch(BlockTurnedElsewhere, "blockTurnedElsewhere",
             "the block is turned by neither 0 nor 180 degrees"_text, {.reportId = "blockTurned"}),
    mismatch(OtherSide, "otherSide", "coordinates of another side"_text),
    error(PartCut, "partCut", "the cutter takes up to {depth:.3f} from the part"_text,
          "write the program again, or use smaller cells for the part's map"_text,
          {.reportId = "gouge", .whyNoRemedy = kPassValues}),
    error(
        MaterialLeft, "materialLeft",
        "{volume:.0f} of the block stay in slots, undercuts or holes that should be free, up to {height:.1f} high"_text,
        "use a smaller cutter or a smaller stepover, or rotate the part"_text,
        {.whyNoRemedy = kPassValues}),
};

} // namespace voluta::plan::finding_rows
