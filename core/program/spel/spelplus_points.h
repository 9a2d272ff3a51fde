// Numbers and points of SPEL+.
#pragma once

#include "base/text.h"
#include "program/common/line_cursor.h"
#include "program/common/procedures.h"

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace voluta::program {

inline constexpr LineSyntax kSpelplusSyntax{'\'', '$'};

// Function NAME [()] and Fend; `name` in small letters, empty where it is not the head of a
// function that is read.
LinePart spelplusPart(LineCursor line, std::string& name);

struct SpelplusPoint {
  std::array<double, 6> parts{}; // X, Y, Z, mm; U, V, W, degrees
  std::vector<double> joints;    // degrees; of AglToPls alone
  int local = 0;
  int elbow = 0; // of an arm of four axes: 1 behind /R, -1 behind /L; 0: neither

  Eigen::Isometry3d pose() const;
};

class SpelplusVariables {
public:
  bool takeNumber(LineCursor& line, double& value) const;
  // XY(x,y,z,u[,v,w]), AglToPls(j1,...) or a point's name, then +X(5), -Z(2), :U(90), /R, /1 and
  // the like. false: it is none, or out of any reach.
  bool takePoint(LineCursor& line, SpelplusPoint& point) const;

  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, SpelplusPoint, std::less<>> points;

private:
  bool takeList(LineCursor& line, std::vector<double>& values) const;
  bool takeOffset(LineCursor& line, SpelplusPoint& point) const;
};

} // namespace voluta::program
