// The regions of a part: their list, and shape, use and settings of the selected one.
#pragma once

#include "base/parameters.h"
#include "project/region.h"
#include "regions/region_kinds.h"

#include <QColor>
#include <QWidget>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace voluta::forms {
class Fold;
class NumberBox;
class ParameterRow;
} // namespace voluta::forms

namespace voluta::panels {

class PaintForm;
struct PaintChoices;

class RegionsPanel : public QWidget {
  Q_OBJECT

public:
  explicit RegionsPanel(QWidget* parent = nullptr);

  // None of these emits.
  void setPart(const QString& name);
  // Keeps the selection as far as possible.
  void setRegions(const std::vector<project::Region>& regions);
  void select(std::optional<std::size_t> region);
  // Sets the part's values, as the defaults of a table, and the keys of the settings that affect
  // the result.
  void setPartValues(const base::ParameterTable& table, const std::set<std::string>& applying);
  // Colours of regions with settings, with layers of their own, that cut, and that hold or push the
  // part.
  void setColours(const std::array<QColor, 4>& colours);
  void setProblem(const QString& text);

  const std::vector<project::Region>& regions() const { return regions_; }
  std::optional<std::size_t> selected() const;
  const PaintChoices& paint() const;
  // Opens the list of shapes that can be added.
  void openAddMenu();

signals:
  void addRequested(const QString& kind); // word of regions::regionKinds()
  void edited(const std::vector<voluta::project::Region>& regions, const QString& editName);
  void selectionChanged();
  void paintChanged();
  void closeRequested();

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // A number of the shape or of the use.
  struct Field {
    QLabel* label = nullptr;
    forms::NumberBox* box = nullptr;
  };
  void build();
  void buildList(QVBoxLayout& column);
  void buildFields(QVBoxLayout& column);
  void buildSettings(QVBoxLayout& column);
  Field addField(QGridLayout& grid, const QString& name, std::function<void(double)> takes);
  void refresh();
  void showList();
  void showFields(const project::Region& region);
  void showSettings(const project::Region& region);
  void retranslate();

  project::Region* chosen();
  void emitEdited(const QString& editName);
  void takeName(QTreeWidgetItem* item);
  void takeUse(const QString& id);
  void takeShapeNumber(std::size_t at, double number);
  void takeUseNumber(std::size_t at, double number);
  void takeSetting(const QString& key, const QString& text);
  void removeChosen();
  void moveChosen(int by);

  std::vector<project::Region> regions_;
  QString part_;
  std::set<std::string> applying_;
  base::ParameterValue partDensity_ = 1.0; // density of the infill
  std::array<QColor, 4> colours_;
  QLabel *title_, *none_, *useLabel_, *icon_, *problem_;
  QTreeWidget* list_;
  QToolButton *add_, *up_, *down_;
  QMenu* shapes_;
  QPushButton *remove_, *close_;
  QComboBox* use_;
  std::vector<Field> shapeFields_, useFields_;
  PaintForm* paint_;
  QWidget* details_;
  forms::Fold* settings_;
  std::vector<forms::ParameterRow*> rows_;
  bool filling_ = false;
};

} // namespace voluta::panels
