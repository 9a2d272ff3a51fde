#include "window/data_labels.h"

#include "base/data_files.h"
#include "base/error.h"
#include "process/own_materials.h"
#include "process/process.h"
#include "robot/cell_draft.h"

#include <map>

namespace voluta::window {

namespace {
template <typename Read> QString labelOr(const std::string& choice, Read read) {
  try {
    if (const std::string label = read(); !label.empty())
      return QString::fromStdString(label);
  } catch (const base::Error&) {
    // Planning reports it
  }
  return QString::fromStdString(base::dataName(choice));
}
} // namespace

QString cellLabel(const std::string& choice) {
  return labelOr(choice, [&] { return robot::draftOfCell(choice).label(); });
}

QString processLabel(const std::string& choice) {
  return labelOr(choice, [&] { return process::loadProcess(choice).label; });
}

QString materialLabel(const std::string& id) {
  return labelOr(id, [&] { return process::loadMaterial(id).label; });
}

std::vector<forms::ChoiceItem> labelledItems(const std::vector<std::string>& ids,
                                             QString (*labelOf)(const std::string&)) {
  std::map<QString, int> uses;
  std::vector<forms::ChoiceItem> items;
  for (const std::string& id : ids) {
    items.push_back({QString::fromStdString(id), labelOf(id), {}});
    ++uses[items.back().label];
  }
  for (forms::ChoiceItem& item : items) {
    if (uses[item.label] > 1)
      item.label += QStringLiteral(" (%1)").arg(item.id);
    item.help = item.label; // Where the box is too narrow for it
  }
  return items;
}

} // namespace voluta::window
