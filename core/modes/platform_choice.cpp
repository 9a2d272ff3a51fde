#include "modes/platform_choice.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/number_list.h"
#include "curved/platform.h"
#include "geometry/convex_polygon.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::modes {

namespace {
using base::Error;
using base::ErrorCode;

constexpr double kLargestMm = 5000.0;

// Lengths in mm with an x between, each within [0, kLargestMm].
bool readSizes(std::string_view text, std::initializer_list<double*> values) {
  return base::readNumbers(text, 'x', values) &&
         std::all_of(values.begin(), values.end(),
                     [](const double* v) { return *v >= 0.0 && *v <= kLargestMm; });
}

} // namespace

PlatformChoice platformChoice(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  const auto at = std::find(kPlatformWords.begin(), kPlatformWords.end(), word);
  if (at == kPlatformWords.end())
    throw Error(ErrorCode::Usage, fmt::format("unknown platform '{}'", word), {},
                fmt::format("did you mean {}?", base::nearestName(word, {kPlatformWords.begin(),
                                                                         kPlatformWords.end()})));
  PlatformChoice p;
  p.kind = static_cast<PlatformKind>(at - kPlatformWords.begin());
  const std::string size = colon == std::string::npos ? "" : text.substr(colon + 1);
  const auto need = [&](bool usable, const char* form) {
    if (!usable)
      throw Error(ErrorCode::Usage, fmt::format("platform '{}' has no usable size", text), {},
                  fmt::format("write {}, in mm", form));
  };
  switch (p.kind) {
  case PlatformKind::Fit:
    need(size.empty() || readSizes(size, {&p.marginMm}), "fit or fit:MARGIN");
    break;
  case PlatformKind::Disc:
    need(readSizes(size, {&p.widthMm}) && p.widthMm > 0.0, "disc:DIAMETER");
    break;
  case PlatformKind::Rect:
    need(readSizes(size, {&p.widthMm, &p.depthMm}) && p.widthMm > 0.0 && p.depthMm > 0.0,
         "rect:WIDTHxDEPTH");
    break;
  case PlatformKind::Rod:
    need(readSizes(size, {&p.diameterMm, &p.lengthMm}) && p.diameterMm > 0.0 && p.lengthMm > 0.0,
         "rod:DIAMETERxLENGTH");
    break;
  case PlatformKind::Mesh:
    if (size.empty())
      throw Error(ErrorCode::Usage, "platform 'mesh' names no file", {}, "write mesh:FILE");
    p.file = size;
    break;
  }
  return p;
}

std::vector<Eigen::Vector2d> platformPolygon(const std::string& platform,
                                             const voxel::SolidVoxels& voxels,
                                             const std::vector<Eigen::Vector2d>& own) {
  const std::optional<double> margin = fitMargin(platform);
  return margin && own.empty() ? curved::platformFit(voxels, *margin)
                               : platformAround(platform, own);
}

std::optional<double> fitMargin(const std::string& platform) {
  const PlatformChoice p = platformChoice(platform);
  return p.kind == PlatformKind::Fit ? std::optional(p.marginMm) : std::nullopt;
}

std::vector<Eigen::Vector2d> platformAround(const std::string& platform,
                                            std::vector<Eigen::Vector2d> standing) {
  const PlatformChoice p = platformChoice(platform);
  if (p.kind == PlatformKind::Disc)
    return curved::platformDisc(p.widthMm);
  if (p.kind == PlatformKind::Rect)
    return curved::platformRect(p.widthMm, p.depthMm);
  if (p.kind != PlatformKind::Fit)
    throw Error(ErrorCode::Usage, fmt::format("platform '{}' is no plate", platform), {},
                "give fit, disc:D or rect:WxD");
  if (standing.empty())
    throw Error(ErrorCode::UnusableInput, "the part does not touch the plate", {},
                "drop it to the plate");
  return geometry::convexPolygon(std::move(standing), p.marginMm);
}

} // namespace voluta::modes
