// Fields of directions for the infill, as text.
#pragma once

#include "toolpath/fibre/tape_curves.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <span>
#include <string>

namespace voluta::toolpath {

// Returns the dyads of the samples' directions at a place, times their weights and the inverse
// square of the distance.
Eigen::Matrix3d dyadsAt(std::span<const FieldSample> samples, const Eigen::Vector3d& place);

// Returns whether the text states one direction, the same everywhere.
bool isOneDirection(const std::string& text);

// Returns the field that a text states [mm, work frame]: one direction "x,y,z"; samples
// "x,y,z,dx,dy,dz" or, with their weight, "x,y,z,dx,dy,dz,w"; or curves, whose points x,y or x,y,z
// are separated by spaces and which semicolons separate. Throws Error{Usage} for anything else.
StrandDyads strandsOf(const std::string& text);

} // namespace voluta::toolpath
