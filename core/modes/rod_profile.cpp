#include "modes/rod_profile.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/filled_file.h"
#include "base/number_list.h"

#include <filesystem>
#include <fmt/format.h>
#include <sstream>

namespace voluta::modes {

namespace {

bool readPair(const std::string& word, Eigen::Vector2d& pair) {
  return base::readNumbers(word, ',', {&pair.x(), &pair.y()});
}

} // namespace

std::string rodProfileText(const std::string& value) {
  std::istringstream words(value);
  std::string first;
  Eigen::Vector2d pair;
  if (!(words >> first) || readPair(first, pair) || !std::filesystem::exists(value))
    return value;
  std::istringstream read(base::readFilledFile(value));
  std::string text, word;
  while (read >> word) {
    if (!readPair(word, pair))
      throw base::Error(base::ErrorCode::UnreadableFile,
                        base::message("'{text}' is no pair x,radius"_text, word.substr(0, 40)),
                        value, "write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm"_text);
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

std::vector<Eigen::Vector2d> rodProfile(const std::string& text) {
  std::vector<Eigen::Vector2d> points;
  std::istringstream words(text);
  std::string word;
  while (words >> word) {
    Eigen::Vector2d pair;
    if (!readPair(word, pair))
      throw base::Error(
          base::ErrorCode::Usage,
          base::message("`rodProfile`: '{text}' is neither a pair x,radius nor a file"_text,
                        word.substr(0, 40)),
          base::message("pair {number}"_text, points.size() + 1),
          "write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm"_text);
    base::refuseFar({pair.data(), 2}, word, "rodProfile"_name);
    points.push_back(pair);
  }
  return points;
}

} // namespace voluta::modes
