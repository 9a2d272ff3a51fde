// Ids of the remedies that findings offer.
#pragma once

#include <cstdint>

namespace voluta::plan {

// A remedy that a button applies; the pipeline implements it.
enum class RemedyId : std::uint8_t {
  ThickenSurface,
  WallSurface,
  CloseRims,
  DropToPlate,
  ShrinkPlatform,
  MakePlatform,
  CellPlate,
  AddSupports,
  WidenPlatform,
  AdaptLayers,
  AddSkin,
  LowerLayers,
  MoreTurns,
  LessClearance,
  MoreClearance,
  ShorterMotions,
  LongerMotions,
  RotateToMinRiskyArea,
  OrientPart,
  StandBest,
  NarrowVoxels,
  ScaleUp,
  FinerProcess,
  UnitsMetres,
  UnitsInches,
  UnitsMicrometres,
  ScaleToFit,
  ScaleToReach,
  ScaleToPlate,
  Shrink,
  Enlarge,
  CentrePart,
  UsualProcess,
  UsualCell,
  LargerCell,
  PrintFlat,
  ChooseStrategy,
  PrintOnPlate,
  PrintByLayer,
  AcceptShare
};

} // namespace voluta::plan
