// Files that an export has written, with links to them.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace voluta::panels {

class WrittenBar : public QWidget {
  Q_OBJECT

public:
  explicit WrittenBar(QWidget* parent = nullptr);

  // Hidden while `text` is empty.
  void setWritten(const QString& text, bool hasProof);

signals:
  void openProofRequested();
  void showFolderRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  QLabel* text_;
  QPushButton *openProof_, *showFolder_;
};

} // namespace voluta::panels
