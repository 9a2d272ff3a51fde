#include "window/pages/new_region.h"

#include "regions/region_kinds.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr double kShare = 1.0 / 3.0; // of the part
constexpr double kSkinMm = 2.4;      // usual depth of a skin
constexpr double kRoundMm = 0.1;

double rounded(double value) {
  const double even = std::round(value / kRoundMm) * kRoundMm;
  return std::abs(even) < 0.5 * kRoundMm ? std::abs(value) < 1e-6 ? 0.0 : value : even;
}
} // namespace

project::Region newRegion(const std::string& word, const Eigen::AlignedBox3d& inFile,
                          const Eigen::AlignedBox3d& placed) {
  const auto& kinds = regions::regionKinds();
  const auto kind = std::ranges::find(kinds, word, &regions::RegionKind::word);
  const Eigen::Vector3d middle = inFile.center(), size = kShare * inFile.sizes();
  const double low = placed.min().z(), high = placed.sizes().z();
  std::vector<double> numbers;
  for (const regions::ShapeField& field : kind->fields) {
    const std::string_view name = field.name;
    double value = field.usual.value_or(0.0);
    if (name == "X" || name == "Y" || name == "Z")
      value = middle[name == "X" ? 0 : name == "Y" ? 1 : 2];
    else if (name == "WIDTH" || name == "HEIGHT" || (name == "DEPTH" && kind->body))
      value = size[name == "WIDTH" ? 0 : name == "DEPTH" ? 1 : 2];
    else if (name == "DIAMETER")
      value = word == "sphere" ? size.minCoeff() : size.head<2>().minCoeff();
    else if (name == "DEPTH")
      value = std::min(kSkinMm, kShare * high);
    else if (kind->frame == regions::ShapeFrame::Plate)
      value = low + (name == "FROM" ? kShare : 2.0 * kShare) * high;
    numbers.push_back(std::clamp(rounded(value), field.minimum, field.maximum));
  }
  project::Region region;
  region.use = std::string(kind->usualUse);
  region.shape = shapeText(word, numbers);
  return region;
}

std::string shapeText(std::string_view kind, const std::vector<double>& numbers) {
  QStringList texts;
  for (const double number : numbers)
    texts << QString::number(number, 'g', 9);
  return std::string(kind) + ':' + texts.join(',').toStdString();
}

} // namespace voluta::window
