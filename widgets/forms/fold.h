// A heading that folds what is under it.
#pragma once

#include <QWidget>

class QToolButton;

namespace voluta::forms {

class Fold : public QWidget {
  Q_OBJECT

public:
  // Takes `content` over; open at first.
  explicit Fold(QWidget* content, QWidget* parent = nullptr);

  QLayout* contentLayout() const { return content_->layout(); }

  void setTitle(const QString& title);
  // A dot behind the title: something under it was changed.
  void setMarked(bool marked);
  void setOpen(bool open);

private:
  void showTitle();

  QToolButton* heading_ = nullptr;
  QWidget* content_ = nullptr;
  QString title_;
  bool open_ = true, marked_ = false;
};

} // namespace voluta::forms
