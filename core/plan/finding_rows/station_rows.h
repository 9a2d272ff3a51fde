// Findings of a station: of its order of work, which follows the motion, and of the common run of
// its programs.
#pragma once

#include "plan/finding_rows/row.h"

namespace voluta::plan::finding_rows {

inline constexpr base::Text kFurtherApart =
    "place the machines further apart, or the parts further from the border"_text;
inline constexpr base::Text kPlaceMachines =
    "change the places of the machines in their table"_text;
inline constexpr base::Text kWriteAllAgain = "write the programs of all machines again"_text;

inline constexpr FindingRow kWorkOrderRows[] = {
    info(
        PlatesOverlap, "platesOverlap",
        "the plates of machine {one} ({cell}) and machine {two} ({other}) overlap by {depth:.1f} ({area:.0f})"_text,
        "place the machines further apart if they stand at two plates"_text),
    error(
        MachinesOverlap, "machinesOverlap",
        "the part of machine {one} or {two} is inside the part, the plate or an obstacle of the other"_text,
        kFurtherApart, {.reportId = "machines", .whyNoRemedy = kPlaceMachines}),
    error(MachinesStartClose, "machinesStartClose",
          "in their home poses machines {one} and {two} are too close to each other"_text,
          "move them apart, or change a home pose"_text,
          {.reportId = "machines", .whyNoRemedy = kPlaceMachines}),
    error(MachineMeetsBody, "machineMeetsBody",
          "{body} of machine {one} meets {obstacle} of machine {two} ({layer})"_text, kFurtherApart,
          {.reportId = "machines", .whyNoRemedy = kPlaceMachines}),
    error(
        MachinesHinder, "machinesHinder",
        "no order of work keeps the machines apart: {first} of machine {one} and {second} of machine {two} hinder each other"_text,
        "place the machines further apart, the parts further from the border, or the arms at rest further from it"_text,
        {.reportId = "machines", .whyNoRemedy = kPlaceMachines}),
    error(NoWorkOrder, "noWorkOrder",
          "every two machines can work together, but no order of work was found for all"_text,
          kFurtherApart, {.reportId = "machines", .whyNoRemedy = kPlaceMachines}),
};

inline constexpr FindingRow kCommonRunRows[] = {
    error(
        MarkPassedEarly, "markPassedEarly",
        "machine {machine} passes the mark in line {line} before machine {other} has reached it, if signals are still on or the programs are not started at once"_text,
        kWriteAllAgain, {.reportId = "marks", .whyNoRemedy = kOnlyWriteAgain}),
    error(MarkNotReached, "markNotReached",
          "machine {machine} waits in line {line} for a mark that the other does not reach"_text,
          kWriteAllAgain, {.reportId = "marks", .whyNoRemedy = kOnlyWriteAgain}),
    error(
        MachinesMeet, "machinesMeet",
        "{body} of machine {one} meets {obstacle} of machine {two} after {time}; collisions of the machines: {collisions}"_text,
        "increase the minimum distance of moving arms, or place the machines further apart"_text,
        {.reportId = "collision", .whyNoRemedy = kPlaceMachines}),
    error(MachineRefused, "machineRefused", "machine {machine}: {reason}"_text,
          "see the report of that machine"_text,
          {.reportId = "programRefused", .whyNoRemedy = kOthersHelp}),
    error(MachineDiffers, "machineDiffers", "machine {machine} is {verdict}: {reason}"_text,
          "see the report of that machine"_text,
          {.whyNoRemedy = "see the remedies in the job of that machine"_text,
           .concern = Concern::Part}),
};

} // namespace voluta::plan::finding_rows
