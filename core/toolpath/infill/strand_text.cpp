#include "toolpath/infill/strand_text.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ranges>
#include <sstream>
#include <vector>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kCurveStepMm = 1.0; // of samples along a curve
const char* const kFieldParameter = "infillField";

// Returns how many numbers each word of the text has.
std::vector<std::ptrdiff_t> numbersPerWord(const std::string& text) {
  std::string blanks = text;
  std::ranges::replace(blanks, ';', ' ');
  std::istringstream words(blanks);
  std::vector<std::ptrdiff_t> counts;
  for (std::string word; words >> word;)
    counts.push_back(std::ranges::count(word, ',') + 1);
  return counts;
}

std::vector<FieldSample> alongCurves(const std::string& text) {
  std::vector<FieldSample> samples;
  for (const std::vector<Vector3d>& curve : tapeCurves(text, kFieldParameter))
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Vector3d step = curve[i] - curve[i - 1];
      const auto count = std::max(1.0, std::ceil(step.norm() / kCurveStepMm));
      for (double k = 0.5; k < count && step.norm() > 0.0; k += 1.0)
        samples.push_back({curve[i - 1] + k / count * step, step.normalized()});
    }
  return samples;
}

std::vector<FieldSample> samplesOf(const std::string& text) {
  const std::vector<std::ptrdiff_t> counts = numbersPerWord(text);
  const bool isPoints = std::ranges::all_of(counts, [](auto n) { return n == 2 || n == 3; });
  if (isPoints && counts.size() == 1 && counts[0] == 3)
    return tapeField("0,0,0," + text, kFieldParameter);
  return isPoints && counts.size() > 1 ? alongCurves(text) : tapeField(text, kFieldParameter);
}
} // namespace

Eigen::Matrix3d dyadsAt(std::span<const FieldSample> samples, const Vector3d& place) {
  constexpr double kNearMm2 = 1e-6;
  Eigen::Matrix3d dyads = Eigen::Matrix3d::Zero();
  for (const FieldSample& sample : samples)
    dyads += sample.weight / ((sample.place - place).squaredNorm() + kNearMm2) * sample.direction *
             sample.direction.transpose();
  return dyads;
}

StrandDyads strandsOf(const std::string& text) {
  const auto samples = std::make_shared<const std::vector<FieldSample>>(samplesOf(text));
  if (samples->size() == 1) {
    const Eigen::Matrix3d dyad =
        samples->front().direction * samples->front().direction.transpose();
    return [dyad](const Vector3d&) { return dyad; };
  }
  return [samples](const Vector3d& place) { return dyadsAt(*samples, place); };
}

} // namespace voluta::toolpath
