// Curves along which tapes are laid, and fields of their direction, as text.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::toolpath {

// Returns the polylines in a text like "0,0 50,10 80,10; 0,5 80,5,2": points x,y or x,y,z in the
// work frame [mm], separated by spaces, curves by semicolons. Throws Error{Usage} for anything
// else, naming the parameter, for a curve of fewer than two points, and for a point beyond a
// kilometre.
std::vector<std::vector<Eigen::Vector3d>> tapeCurves(const std::string& text,
                                                     const std::string& parameter = "fibreCurves");

struct FieldSample {
  Eigen::Vector3d place;     // work frame [mm]
  Eigen::Vector3d direction; // unit; its sign does not matter
  double weight = 1.0;
};
// Returns the samples in a text like "0,0,0,1,0,0 50,0,0,1,0.2,0": x,y,z,dx,dy,dz or, with a
// weight, x,y,z,dx,dy,dz,w, separated by blanks, semicolons or lines. Errors name the parameter.
// Throws Error{Usage} for anything else, for directions without a length, and for places beyond a
// kilometre.
std::vector<FieldSample> tapeField(const std::string& text,
                                   const std::string& parameter = "fibreField");

// Returns the content of the file if the text is a file's name, else the text. Throws
// Error{UnreadableFile} if the file cannot be read or contains no points.
std::string tapeText(const std::string& text);

} // namespace voluta::toolpath
