#include "program/press_words.h"

#include "base/error.h"
#include "base/number_list.h"
#include "program/common/program_text.h"
#include "program/common/rotation_vector.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace voluta::program {

namespace {
using Eigen::Vector3d;

constexpr int kDecimals = 4;

class PressWords {
public:
  explicit PressWords(const robot::Cell& cell)
      : cell_(cell), isFixed_(cell.nozzleMount() == robot::Mount::World) {}

  void fill(std::string& statement) const {
    for (std::size_t open = 0; (open = statement.find("{press", open)) != std::string::npos;) {
      const std::size_t close = statement.find('}', open);
      if (close == std::string::npos)
        return;
      const std::string text = said(std::string_view(statement).substr(open + 1, close - open - 1));
      statement.replace(open, close - open + 1, text);
      open += text.size();
    }
  }

private:
  std::string said(std::string_view word) const {
    if (word == "pressFrame")
      return isFixed_ ? fixedFrame() : "tool_pose()";
    if (word == "pressSpace")
      return isFixed_ ? "1" : "0";
    constexpr std::string_view kSigned = "press ", kAxis = "pressAxis ";
    const bool isSigned = word.starts_with(kSigned);
    double value = 0.0;
    if ((!isSigned && !word.starts_with(kAxis)) ||
        !base::readNumbers(word.substr((isSigned ? kSigned : kAxis).size()), ',', {&value}))
      throw base::Error(base::ErrorCode::Usage,
                        base::message("beadWords: '{word}' is not a word for a force"_text, word),
                        {}, "write {pressFrame}, {pressSpace}, {press 5} or {pressAxis 20}"_text);
    return components(value, isSigned);
  }

  std::string fixedFrame() const {
    // Turned about x by half a turn, the nozzle's frame has z from the part towards the nozzle.
    const Eigen::Isometry3d& nozzle = cell_.base_T_fixed();
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(nozzle.linear()) * Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
    const Vector3d vector = rotationVector(rotation);
    std::string text = "p[";
    for (int k = 0; k < 3; ++k)
      text += joined({k > 0 ? "," : "", fixedText(nozzle.translation()[k] / 1000.0, kDecimals)});
    for (int k = 0; k < 3; ++k)
      text += joined({",", fixedText(vector[k], kDecimals)});
    return text + "]";
  }

  std::string components(double value, bool isSigned) const {
    constexpr double kAligned = 1e-3;
    int axis = 2;
    if (isFixed_) {
      const Vector3d force = -cell_.base_T_fixed().linear().col(2);
      if (force.cwiseAbs().maxCoeff(&axis) < 1.0 - kAligned)
        throw base::Error(
            base::ErrorCode::Usage,
            base::message("the nozzle of cell {cell} is along no axis of the arm's base, so that "
                          "MELFA cannot press along it"_text,
                          cell_.id()),
            {}, "use a cell whose nozzle is upright, or another format"_text);
      if (isSigned)
        value = std::copysign(value, value * force[axis]);
    }
    std::string text;
    for (int k = 0; k < 6; ++k)
      text += joined({k > 0 ? "," : "", k == axis ? fixedText(value, kDecimals) : "0"});
    return text;
  }

  const robot::Cell& cell_;
  const bool isFixed_;
};

} // namespace

void fillPressWords(process::Process& process, const robot::Cell& cell) {
  const PressWords words(cell);
  for (process::BeadWords& format : process.beadWords)
    for (std::vector<std::string>* statements : {&format.start, &format.end})
      for (std::string& statement : *statements)
        words.fill(statement);
}

} // namespace voluta::program
