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

// Recognises Function NAME [()] and Fend; `name` in lower case, empty if it is not a valid function
// header.
LinePart spelplusPart(LineCursor line, std::string& name);

struct SpelplusPoint {
  std::array<double, 6> parts{}; // X, Y, Z, mm; U, V, W, degrees
  std::vector<double> joints;    // degrees; of AglToPls only
  int local = 0;
  int elbow = 0; // of a four-axis arm: 1 after /R, -1 after /L; 0: neither

  Eigen::Isometry3d pose() const;
};

class SpelplusVariables {
public:
  bool takeNumber(LineCursor& line, double& value) const;
  // Takes XY(x,y,z,u[,v,w]), AglToPls(j1,...) or the name of a point, then +X(5), -Z(2), :U(90),
  // /R, /1 etc. Returns false if there is none or it is out of any robot's reach.
  bool takePoint(LineCursor& line, SpelplusPoint& point) const;

  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, SpelplusPoint, std::less<>> points;

private:
  bool takeList(LineCursor& line, std::vector<double>& values) const;
  bool takeOffset(LineCursor& line, SpelplusPoint& point) const;
};

} // namespace voluta::program
