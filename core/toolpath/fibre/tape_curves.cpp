#include "toolpath/fibre/tape_curves.h"

#include "base/error.h"

#include <charconv>
#include <sstream>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

[[noreturn]] void refuse(const std::string& part) {
  throw base::Error(base::ErrorCode::Usage,
                    base::message("'{part}' is no point of a curve for tapes"_text, part),
                    "fibreCurves"_name,
                    "give points in mm: x,y or x,y,z, separated by spaces, at least two for each "
                    "curve, and semicolons between curves"_text);
}

Vector3d pointOf(const std::string& word) {
  Vector3d point = Vector3d::Zero();
  int count = 0;
  const char *at = word.data(), *end = word.data() + word.size();
  while (count < 3) {
    const auto [next, error] = std::from_chars(at, end, point[count]);
    if (error != std::errc{} || !std::isfinite(point[count]))
      refuse(word);
    ++count;
    at = next;
    if (at == end || *at != ',')
      break;
    ++at;
  }
  if (at != end || count < 2)
    refuse(word);
  return point;
}
} // namespace

std::vector<std::vector<Vector3d>> tapeCurves(const std::string& text) {
  std::vector<std::vector<Vector3d>> curves;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line, ';');) {
    std::vector<Vector3d> curve;
    std::istringstream words(line);
    for (std::string word; words >> word;)
      curve.push_back(pointOf(word));
    if (curve.size() == 1)
      refuse(line);
    if (!curve.empty())
      curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace voluta::toolpath
