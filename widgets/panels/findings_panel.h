// The list of findings, and what the chosen one says.
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

class FindingsModel;

// A button beside a finding.
struct RemedyButton {
  QString id, label, help;
  bool operator==(const RemedyButton&) const = default;
};
using RemedySource = std::function<std::vector<RemedyButton>(const plan::Finding&)>;

class FindingsPanel : public QWidget {
  Q_OBJECT

public:
  explicit FindingsPanel(QWidget* parent = nullptr);

  // Sorted here: blocking first, then by stage. What is chosen stays so where it is among the new
  // ones. Emits nothing.
  // `before`: found before the choices were what they are now.
  void setFindings(const plan::Findings& findings, const plan::Findings& before = {});
  // false (as at first): nothing was planned yet, so an empty list says nothing of the part.
  void setPlanned(bool planned);
  // Stages that have not looked at the choices as they are now.
  void setUnchecked(const std::vector<plan::Stage>& stages);
  void setBlockedOnly(bool only);
  // Says what can be done about a finding; none, as at first: nothing. Asked again with each
  // setFindings(): the answer may depend on more than the finding.
  void setRemedies(RemedySource remedies);
  QSize minimumSizeHint() const override;

signals:
  // A click, Enter or the button "Show": take the views there.
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
  QWidget* actions_ = nullptr;
  QPushButton* show_ = nullptr;
  QGridLayout* buttons_ = nullptr;
  std::vector<QPushButton*> remedyButtons_;
  std::vector<RemedyButton> shownRemedies_;
  RemedySource remedies_;
  std::vector<plan::Stage> unchecked_;
  bool planned_ = false;
};

} // namespace voluta::panels
