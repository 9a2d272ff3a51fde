// The list of findings, and the details of the selected one.
#pragma once

#include "plan/finding.h"
#include "plan/stage.h"

#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

class QGridLayout;
class QLabel;
class QListView;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace voluta::panels {

class EffectCard;
class FindingsModel;

// A button for a remedy of a finding.
struct RemedyButton {
  QString id, label, help;
  bool operator==(const RemedyButton&) const = default;
};
using RemedySource = std::function<std::vector<RemedyButton>(const plan::Finding&)>;

class FindingsPanel : public QWidget {
  Q_OBJECT

public:
  explicit FindingsPanel(QWidget* parent = nullptr);

  // Sorts the findings: blocking first, then by stage. Keeps the selection if it is among the new
  // ones. Emits nothing. `before`, `hasPrograms`: as for FindingsModel::setFindings().
  void setFindings(const plan::Findings& findings, const plan::Findings& before = {},
                   bool hasPrograms = false);
  // false (initially): nothing was planned yet, so an empty list has no meaning.
  void setPlanned(bool planned);
  // Stages that have not checked the present choices.
  void setUnchecked(const std::vector<plan::Stage>& stages);
  void setBlockedOnly(bool only);
  // As FindingsModel::setParts(). To be called before setFindings().
  void setParts(const QStringList& names);
  // Sets the source of remedies for a finding; initially none. It is called again after each
  // setFindings(), because the result may depend on more than the finding.
  void setRemedies(RemedySource remedies);
  // Above the list.
  EffectCard& effect() { return *effect_; }
  QSize minimumSizeHint() const override;

signals:
  // By a click, Enter or the button "Show": the views have to move there.
  void activated(const voluta::plan::Finding& finding);
  void remedyChosen(const voluta::plan::Finding& finding, const QString& id);

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  class CountButton;

  void activateCurrent();
  void showCurrent();
  void showPlace(int row);
  void showRemedies(const plan::Finding& finding);
  void showWhyNone(const plan::Finding& finding);
  void arrange();
  int heightOfRows(int rows) const;
  int heightBesideList() const; // at least
  void chooseRemedy(const QString& id);
  void showState();
  QString uncheckedText() const; // empty: all is checked
  void retranslate();

  FindingsModel* model_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* notChecked_ = nullptr;
  EffectCard* effect_ = nullptr;
  CountButton* blockedOnly_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QListView* list_ = nullptr;
  QLabel* empty_ = nullptr;
  QScrollArea* detailsArea_ = nullptr;
  QWidget* details_ = nullptr;
  QLabel* reason_ = nullptr;
  QLabel* where_ = nullptr;
  QLabel* remedy_ = nullptr;
  QLabel* whyNone_ = nullptr;
  QLabel* applying_ = nullptr; // above the buttons of the remedies
  QWidget* actions_ = nullptr;
  QPushButton* show_ = nullptr;
  QGridLayout* buttons_ = nullptr;
  std::vector<QPushButton*> remedyButtons_;
  std::vector<RemedyButton> shownRemedies_;
  RemedySource remedies_;
  std::vector<plan::Stage> unchecked_;
  std::size_t place_ = 0; // of the selected row
  bool isPlaceShown_ = false;
  bool planned_ = false;
};

} // namespace voluta::panels
