// The list of findings, and what the chosen one says.
#pragma once

#include "plan/finding.h"

#include <QWidget>

class QLabel;
class QListView;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace voluta::panels {

class FindingsModel;

class FindingsPanel : public QWidget {
  Q_OBJECT

public:
  explicit FindingsPanel(QWidget* parent = nullptr);

  // Sorted here: blocking first, then by stage. Emits nothing.
  void setFindings(const plan::Findings& findings);
  // false (as at first): nothing was planned yet, so an empty list says nothing of the part.
  void setPlanned(bool planned);
  void setBlockedOnly(bool only);

signals:
  // A click, Enter or the button "Show": take the views there.
  void activated(const voluta::plan::Finding& finding);

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void activateCurrent();
  void showCurrent();
  void showState();
  void retranslate();

  FindingsModel* model_ = nullptr;
  QLabel* title_ = nullptr;
  QToolButton* blockedOnly_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QListView* list_ = nullptr;
  QLabel* empty_ = nullptr;
  QWidget* details_ = nullptr;
  QLabel* reason_ = nullptr;
  QLabel* where_ = nullptr;
  QLabel* remedy_ = nullptr;
  QPushButton* show_ = nullptr;
  bool planned_ = false;
};

} // namespace voluta::panels
