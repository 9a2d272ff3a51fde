// Values of MELFA-BASIC V: numbers, positions and joints, and a program's variables.
#pragma once

#include "plan/program.h"
#include "program/common/script_values.h"

#include <Eigen/Geometry>
#include <optional>
#include <string_view>

namespace voluta::program {

// Positions are lists x, y, z [mm], a, b, c [degrees] and optional further components; joints are
// lists of degrees. Besides variables, the scanner knows P_NBase, P_NTool, M_NSpd, M_NOvrd,
// M_NJOvrd; Rad, Deg, Sqr, Abs, Inv; components of positions (angles in radians), and &H and &B
// numbers. The product of positions is that of their frames; sums are computed per component.
class MelfaScanner : public ScriptScanner {
public:
  MelfaScanner(std::string_view text, const ScriptVariables& variables)
      : ScriptScanner(text, variables, '(') {}

  // Returns a variable's name with its type mark (%, #, !, $), in lower case; empty if there is
  // none.
  std::string variableName();

protected:
  bool named(std::string_view name, ScriptValue& value) override;
  bool behindList(ScriptValue& list) override; // Flags, which do not affect the pose
  bool oddNumber(double& value) override;
  bool operate(char op, const ScriptValue& a, const ScriptValue& b, ScriptValue& result) override;

private:
  bool part(ScriptValue& value);
};

// Returns a position's frame; nullopt if it is not a position, or far outside any robot's reach.
std::optional<Eigen::Isometry3d> melfaPose(const ScriptValue& value);
std::optional<Eigen::Isometry3d> melfaPose(const Eigen::Vector3d& mm,
                                           const Eigen::Vector3d& degrees);

// For a work held by the flange and moved under a nozzle: converts targets of the TCP in Base to
// targets of the nozzle relative to that work.
void seeFromHeldWork(plan::ReadProgram& program, const Eigen::Isometry3d& base_T_nozzle);

// Sets component `name` (x, y, z, a, b, c) of a position. Returns false if there is no such
// component.
bool setMelfaPart(ScriptValue& position, std::string_view name, double value);

// Value of `M_NSpd`: as fast as the arm can move.
inline constexpr double kMelfaFastestMmPerS = 10000.0;

} // namespace voluta::program
