#include "toolpath/infill/strand_text.h"

#include "base/error.h"
#include "base/number_list.h"
#include "toolpath/infill/sample_tree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ranges>
#include <sstream>
#include <vector>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kCurveStepMm = 1.0;   // of samples along a curve
constexpr std::size_t kMostShown = 60; // characters of a text that is wrong
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

Vector3d directionIn(const std::string& text) {
  Vector3d direction;
  if (!base::readNumbers(text, ',', {&direction.x(), &direction.y(), &direction.z()}) ||
      !(direction.stableNorm() > 0.0))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{text}' is no direction"_text, text.substr(0, kMostShown)),
                      std::string(kFieldParameter),
                      "give three numbers, x,y,z, of which one is not 0"_text);
  return direction.stableNormalized();
}

std::vector<FieldSample> samplesOf(const std::string& text) {
  if (isOneDirection(text))
    return {{Vector3d::Zero(), directionIn(text)}};
  const std::vector<std::ptrdiff_t> counts = numbersPerWord(text);
  const bool isPoints = std::ranges::all_of(counts, [](auto n) { return n == 2 || n == 3; });
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

bool isOneDirection(const std::string& text) {
  return numbersPerWord(text) == std::vector<std::ptrdiff_t>{3};
}

StrandDyads strandsOf(const std::string& text) {
  std::vector<FieldSample> samples = samplesOf(text);
  if (samples.size() == 1) {
    const Eigen::Matrix3d dyad = samples.front().direction * samples.front().direction.transpose();
    return [dyad](const Vector3d&) { return dyad; };
  }
  const auto tree = std::make_shared<const SampleTree>(std::move(samples));
  return [tree](const Vector3d& place) { return tree->dyadsAt(place); };
}

} // namespace voluta::toolpath
