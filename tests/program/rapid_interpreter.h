// As much of RAPID as a module that reads G-code has, run on a text in place of its file: records
// the commands to the arm and the outputs. Independent of core/program.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace voluta::test {

struct RapidMotion {
  std::string word; // MoveL, TriggL, MoveJ, MoveAbsJ
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double speed = 0.0, zoneMm = 0.0; // 0: fine
  bool on = false;
  double flow = 0.0; // of aoFlow, from its beginning on
};

class RapidInterpreter {
public:
  RapidInterpreter(const std::string& module, const std::string& file);
  // Throws std::runtime_error for unknown statements.
  void run();

  std::vector<RapidMotion> motions;
  std::vector<std::pair<double, double>> waits; // seconds, flow then
  std::string opened, refused;
  bool closed = false, on = false;
  double flow = 0.0;

private:
  struct Value {
    enum Kind { Number, Text, List } kind = Number;
    double number = 0.0; // truths are 0 and 1
    std::string text;
    std::vector<Value> list;
  };
  struct Statement {
    enum Kind { Simple, If, While } kind = Simple;
    std::string text;                                                     // Simple
    std::vector<std::pair<std::string, std::vector<Statement>>> branches; // condition, body
  };
  struct Routine {
    std::vector<std::string> parameters;
    std::vector<Statement> body;
  };
  using Variables = std::map<std::string, Value>;
  enum class Flow { On, Return, Exit };
  struct Parser;     // of the module
  struct Expression; // of a value

  Flow runAll(const std::vector<Statement>& statements, Variables& own);
  Flow runOne(const Statement& statement, Variables& own);
  Flow simple(const std::string& text, Variables& own);
  Value call(const std::string& name, const std::vector<Value>& arguments);
  Value value(const std::string& text, Variables& own);
  void declare(const std::string& text, Variables& into);
  void motion(const std::string& word, const std::vector<std::string>& arguments, Variables& own);
  bool instruction(const std::string& word, const std::string& rest, Variables& own);
  static Eigen::Vector3d position(const Value& value);
  static Eigen::Quaterniond rotation(const Value& value);
  static Value ofRotation(const Eigen::Quaterniond& q);
  static Value number(double value);

  std::map<std::string, Routine> routines_;
  Variables variables_;
  std::string file_;
  std::size_t at_ = 0; // in file_
  double trigger_ = 0.0;
  Value returned_;
  bool exits_ = false;
};

} // namespace voluta::test
