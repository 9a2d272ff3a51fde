// A heading that folds its content.
#pragma once

#include <QWidget>

class QToolButton;

namespace voluta::forms {

class Fold : public QWidget {
  Q_OBJECT

public:
  // Takes ownership of `content`; open initially.
  explicit Fold(QWidget* content, QWidget* parent = nullptr);

  QLayout* contentLayout() const { return content_->layout(); }

  void setTitle(const QString& title);
  // Shows a dot after the title: something in the content was changed.
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
