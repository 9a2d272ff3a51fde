// The card about the remedy applied last: what it has changed, and a button that takes it back.
#pragma once

#include "forms/icons.h"

#include <QFrame>
#include <QString>
#include <QStringList>

class QLabel;
class QToolButton;

namespace voluta::panels {

struct Effect {
  QString title;
  QStringList lines;
  forms::Icon sign = forms::Icon::Pending;
  bool operator==(const Effect&) const = default;
};

class EffectCard : public QFrame {
  Q_OBJECT

public:
  // Hidden initially.
  explicit EffectCard(QWidget* parent = nullptr);

  void setEffect(const Effect& effect); // Shows it

signals:
  void undoWished();
  void closed();
  void languageChanged();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  QLabel *sign_, *title_, *lines_;
  QToolButton *undo_, *close_;
};

} // namespace voluta::panels
