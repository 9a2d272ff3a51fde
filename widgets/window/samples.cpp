#include "window/samples.h"

#include "base/files.h"

#include <QtGlobal>
#include <string_view>

namespace voluta::window {

QString Sample::path() const {
  if (std::string_view(part).starts_with("sample:"))
    return QString::fromUtf8(part);
  return QString::fromStdString((base::resourceFolder() / part).string());
}

project::Choices Sample::required(project::Choices choices) const {
  if (*body) {
    project::ItemChoices& item = choices.item();
    item.automatic = false;
    item.mode = "substrate";
    item.platform = project::Platform(std::string("mesh:") + body);
    for (const auto& [key, value] : parameters)
      item.parameters[key] = value;
  }
  if (*process)
    choices.tool().process = process;
  if (*cell)
    choices.cell = cell;
  return choices;
}

const std::vector<Sample>& samples() {
  static const std::map<std::string, std::string> kRibLayers{{"layerHeightMm", "0.2"},
                                                             {"firstLayerMm", "0.25"}};
  static const std::vector<Sample> kSamples{
      {"sampleVase", QT_TRANSLATE_NOOP("Commands", "Vase"),
       QT_TRANSLATE_NOOP("Commands", "A fluted vase, 60 mm high"), "sample:vase"},
      {"sampleMushroom", QT_TRANSLATE_NOOP("Commands", "Mushroom"),
       QT_TRANSLATE_NOOP("Commands", "A wide cap on a stem, made of voxels"),
       "samples/mushroom.txt"},
      {"sampleFork", QT_TRANSLATE_NOOP("Commands", "Fork"),
       QT_TRANSLATE_NOOP("Commands", "A stem with two branches, made of voxels"),
       "samples/fork.txt"},
      {"sampleDumbbell", QT_TRANSLATE_NOOP("Commands", "Dumb-bell for tension"),
       QT_TRANSLATE_NOOP("Commands", "A specimen of 165 × 19 × 3 mm"), "sample:dumbbell"},
      {"sampleBar", QT_TRANSLATE_NOOP("Commands", "Bar for bending"),
       QT_TRANSLATE_NOOP("Commands", "A specimen of 250 × 10 × 5 mm"), "sample:bar"},
      {"samplePlate", QT_TRANSLATE_NOOP("Commands", "Plate with a hole"),
       QT_TRANSLATE_NOOP("Commands", "A specimen of 120 × 60 × 3 mm"), "sample:plate"},
      {.id = "sampleCurvedBar",
       .text = QT_TRANSLATE_NOOP("Commands", "Curved bar on its mould"),
       .tip = QT_TRANSLATE_NOOP("Commands", "Seven layers around a cylinder of 60 mm radius"),
       .part = "sample:curved-bar",
       .body = "sample:curved-mould",
       .parameters = {{"layerHeightMm", "0.6"}}},
      {"sampleRoofRib", QT_TRANSLATE_NOOP("Commands", "Rib on a gable roof"),
       QT_TRANSLATE_NOOP("Commands", "Ten layers over both slopes; the nozzle tilts by 60°"),
       "sample:roof-rib", "sample:roof", "fdm-0.35", "rv2f-moving", kRibLayers},
      {"sampleCylinderRib", QT_TRANSLATE_NOOP("Commands", "Rib on a half cylinder"),
       QT_TRANSLATE_NOOP("Commands", "Ten layers around it; the nozzle tilts by 87°"),
       "sample:cylinder-rib", "sample:half-cylinder", "fdm-0.35", "rv2f-moving", kRibLayers},
      {"sampleAccuracyPlate", QT_TRANSLATE_NOOP("Commands", "Accuracy plate"),
       QT_TRANSLATE_NOOP("Commands", "Slots and a hole of known sizes, to be measured"),
       "sample:accuracy-plate"},
  };
  return kSamples;
}

} // namespace voluta::window
