// Values of MELFA-BASIC V: numbers, positions, joints; what a program keeps of them.
#pragma once

#include "plan/program.h"
#include "program/common/script_values.h"

#include <Eigen/Geometry>
#include <optional>
#include <string_view>

namespace voluta::program {

// Positions are lists x, y, z (mm), a, b, c (degrees) and whatever further; joints lists of
// degrees. Known besides variables: P_NBase, P_NTool, M_NSpd, M_NOvrd, M_NJOvrd; Rad, Deg, Sqr,
// Abs, Inv; parts of positions (angles in radians), &H and &B numbers. The product of positions is
// that of their frames, sums are taken part by part.
class MelfaScanner : public ScriptScanner {
public:
  MelfaScanner(std::string_view text, const ScriptVariables& variables)
      : ScriptScanner(text, variables, '(') {}

  // A variable's name with its mark of type (%, #, !, $), in small letters; empty: there is none.
  std::string variableName();

protected:
  bool named(std::string_view name, ScriptValue& value) override;
  bool behindList(ScriptValue& list) override; // flags, which say nothing of where it is
  bool oddNumber(double& value) override;
  bool operate(char op, const ScriptValue& a, const ScriptValue& b, ScriptValue& result) override;

private:
  bool part(ScriptValue& value);
};

// A position's frame; nullopt: it is none, or far outside any robot's reach.
std::optional<Eigen::Isometry3d> melfaPose(const ScriptValue& value);
std::optional<Eigen::Isometry3d> melfaPose(const Eigen::Vector3d& mm,
                                           const Eigen::Vector3d& degrees);

// A work that the flange holds is moved under a nozzle: targets of the TCP in Base become the
// nozzle's on that work.
void seeFromHeldWork(plan::ReadProgram& program, const Eigen::Isometry3d& base_T_nozzle);

// Sets part `name` (x, y, z, a, b, c) of a position. false: there is no such part.
bool setMelfaPart(ScriptValue& position, std::string_view name, double value);

// What `M_NSpd` is: as fast as the arm can.
inline constexpr double kMelfaFastestMmPerS = 10000.0;

} // namespace voluta::program
