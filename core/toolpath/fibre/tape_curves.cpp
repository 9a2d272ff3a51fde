#include "toolpath/fibre/tape_curves.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/filled_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <sstream>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

[[noreturn]] void refuse(const std::string& part, const std::string& parameter) {
  throw base::Error(base::ErrorCode::Usage,
                    base::message("'{part}' is no point of a curve"_text, part), parameter,
                    "give points in mm: x,y or x,y,z, separated by spaces, at least two for each "
                    "curve, and semicolons between curves"_text);
}

// Returns up to seven numbers separated by commas; none if the word has anything else.
std::vector<double> numbersOf(const std::string& word) {
  constexpr std::size_t kMaxCount = 7;
  std::vector<double> numbers;
  const char *at = word.data(), *end = word.data() + word.size();
  while (true) {
    double number = 0.0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || !std::isfinite(number) || numbers.size() == kMaxCount)
      return {};
    numbers.push_back(number);
    if (next == end)
      return numbers;
    if (*next != ',')
      return {};
    at = next + 1;
  }
}

Vector3d pointOf(const std::string& word, const std::string& parameter) {
  const std::vector<double> n = numbersOf(word);
  if (n.size() != 2 && n.size() != 3)
    refuse(word, parameter);
  base::refuseFar(n, word, parameter);
  return {n[0], n[1], n.size() == 3 ? n[2] : 0.0};
}
} // namespace

std::vector<std::vector<Vector3d>> tapeCurves(const std::string& text,
                                              const std::string& parameter) {
  std::vector<std::vector<Vector3d>> curves;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line, ';');) {
    std::vector<Vector3d> curve;
    std::istringstream words(line);
    for (std::string word; words >> word;)
      curve.push_back(pointOf(word, parameter));
    if (curve.size() == 1)
      refuse(line, parameter);
    if (!curve.empty())
      curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<FieldSample> tapeField(const std::string& text, const std::string& parameter) {
  std::string blanks = text;
  std::ranges::replace(blanks, ';', ' ');
  std::vector<FieldSample> samples;
  std::istringstream words(blanks);
  for (std::string word; words >> word;) {
    const std::vector<double> n = numbersOf(word);
    const double weight = n.size() == 7 ? n[6] : 1.0;
    const bool isSample = n.size() >= 6 && weight > 0.0;
    const Vector3d direction = isSample ? Vector3d(n[3], n[4], n[5]) : Vector3d::Zero();
    if (!(direction.norm() > 0.0) || !std::isfinite(direction.norm()))
      throw base::Error(
          base::ErrorCode::Usage, base::message("'{part}' is no direction at a place"_text, word),
          parameter,
          "give place and direction as x,y,z,dx,dy,dz, separated by spaces or lines"_text);
    base::refuseFar(std::span(n).first(3), word, parameter);
    samples.push_back({Vector3d(n[0], n[1], n[2]), direction.normalized(), weight});
  }
  return samples;
}

std::string tapeText(const std::string& text) {
  const bool isData = text.empty() || text.find(',') != std::string::npos;
  if (isData)
    return text;
  std::string read = base::readFilledFile(text);
  if (read.find(',') == std::string::npos)
    throw base::Error(base::ErrorCode::UnreadableFile, "contains no points"_text, text,
                      "give numbers in mm, separated by commas: x,y,z"_text);
  return read;
}

} // namespace voluta::toolpath
