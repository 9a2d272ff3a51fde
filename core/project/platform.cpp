#include "project/platform.h"

#include "base/error.h"
#include "base/number_list.h"
#include "project/file_content.h"
#include "project/platform_kinds.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace voluta::project {

namespace {
using base::Error;
using base::ErrorCode;

std::vector<double> usualSizes(const PlatformKind& kind) {
  std::vector<double> sizes;
  for (const PlatformField& field : kind.fields)
    sizes.push_back(field.usual);
  return sizes;
}

bool within(const PlatformField& field, double mm) {
  return mm >= field.minimum && mm <= field.maximum;
}

std::vector<double> readSizes(const PlatformKind& kind, std::string_view text,
                              std::string_view whole) {
  std::vector<double> sizes;
  for (std::string_view rest = text;;) {
    const std::size_t x = rest.find('x');
    double mm = 0.0;
    if (!base::readNumbers(rest.substr(0, x), ',', {&mm}))
      break;
    sizes.push_back(mm);
    if (x == std::string_view::npos)
      break;
    rest.remove_prefix(x + 1);
  }
  const std::size_t written =
      1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), 'x'));
  if (sizes.size() != kind.fields.size() || written != sizes.size())
    throw Error(ErrorCode::Usage,
                base::message("platform '{platform}' has no valid size"_text, whole), {},
                base::message("write {form}, in mm"_text, platformForm(kind)));
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (const PlatformField& field = kind.fields[i]; !within(field, sizes[i]))
      throw Error(ErrorCode::Usage,
                  base::message("platform '{platform}': {field} {size} is out of range"_text, whole,
                                field.name, base::mm(sizes[i])),
                  {},
                  base::message("give {field} from {least#} to {most}"_text, field.name,
                                base::mm(field.minimum), base::mm(field.maximum)));
  return sizes;
}
} // namespace

Platform::Platform(std::string_view text) : kind_(&platformKinds().front()) {
  const std::size_t colon = text.find(':');
  if (!text.empty())
    kind_ = &findPlatformKind(text.substr(0, colon));
  const std::string_view rest =
      colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  if (!kind_->file.empty()) {
    if (rest.empty())
      throw Error(ErrorCode::Usage,
                  base::message("platform '{platform}' names no file"_text, kind_->word), {},
                  base::message("write {form}"_text, platformForm(*kind_)));
    file_ = rest;
  } else if (rest.empty() && kind_->bare) {
    sizesMm_ = usualSizes(*kind_);
  } else {
    sizesMm_ = readSizes(*kind_, rest, text);
  }
}

Platform::Platform(const PlatformKind& kind) : Platform(kind, usualSizes(kind)) {}

Platform::Platform(const PlatformKind& kind, std::vector<double> sizesMm)
    : kind_(&kind), sizesMm_(std::move(sizesMm)) {
  base::require(kind.file.empty() && sizesMm_.size() == kind.fields.size() &&
                    std::equal(kind.fields.begin(), kind.fields.end(), sizesMm_.begin(), within),
                "Platform: sizes that its kind has");
}

Platform::Platform(const PlatformKind& kind, std::string file)
    : kind_(&kind), file_(std::move(file)) {
  base::require(!kind.file.empty() && !file_.empty(), "Platform: a kind with a file");
}

std::string Platform::text() const {
  if (sizesMm_.empty() && file_.empty())
    return std::string(kind_->word);
  std::string text = fmt::format("{}:{}", kind_->word, file_);
  for (std::size_t i = 0; i < sizesMm_.size(); ++i)
    text += fmt::format("{}{}", i ? "x" : "", sizesMm_[i]);
  return text;
}

base::Message Platform::shown() const {
  if (!file_.empty())
    return {kind_->shown, {std::filesystem::path(file_).filename().string()}};
  const bool plain = !kind_->plain.empty() && std::all_of(sizesMm_.begin(), sizesMm_.end(),
                                                          [](double mm) { return mm == 0.0; });
  if (plain)
    return kind_->plain;
  return {kind_->shown, {fmt::format("{}", fmt::join(sizesMm_, " × "))}};
}

bool Platform::isFor(PlatformUse use) const {
  return std::any_of(kind_->uses.begin(), kind_->uses.end(),
                     [&](const PlatformKind::As& as) { return as.use == use; });
}

bool Platform::isForAnyOf(const std::vector<PlatformUse>& uses) const {
  return std::any_of(uses.begin(), uses.end(), [&](PlatformUse use) { return isFor(use); });
}

std::optional<double> Platform::marginMm() const {
  return kind_->madeForPart ? std::optional(sizesMm_.front()) : std::nullopt;
}

Platform Platform::withMarginMm(double marginMm) const {
  base::require(kind_->madeForPart, "Platform: a margin");
  std::vector<double> sizes = sizesMm_;
  sizes.front() = marginMm;
  return {*kind_, std::move(sizes)};
}

Platform Platform::madeForPart(double marginMm) {
  const std::vector<PlatformKind>& kinds = platformKinds();
  const auto made = std::find_if(kinds.begin(), kinds.end(),
                                 [](const PlatformKind& kind) { return kind.madeForPart; });
  base::require(made != kinds.end(), "Platform: a kind that is made for the part");
  return Platform(*made).withMarginMm(marginMm);
}

std::vector<Eigen::Vector2d> Platform::plateAround(std::vector<Eigen::Vector2d> standing) const {
  if (!kind_->plate)
    throw Error(ErrorCode::Usage,
                base::message("platform '{platform}' is not a plate"_text, text()), {},
                base::message("give {forms}"_text, platformForms({PlatformUse::Plate})));
  if ((kind_->madeForPart || kind_->ofCell) && standing.empty())
    throw Error(ErrorCode::UnusableInput, "the part does not touch the plate"_text, {},
                "drop it to the plate"_text);
  return kind_->plate(sizesMm_, std::move(standing));
}

std::optional<platform::RodShape> Platform::rod(int sides) const {
  return kind_->rod ? std::optional(kind_->rod(sizesMm_, sides)) : std::nullopt;
}

std::string keyOf(const Platform& platform) {
  return platform.file().empty() ? platform.text() : keyOf(FileContent{platform.file()});
}

} // namespace voluta::project
