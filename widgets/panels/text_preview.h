// View of a long text that processes only the visible lines.
#pragma once

#include "panels/text_lines.h"

#include <QAbstractScrollArea>

namespace voluta::panels {

class TextPreview : public QAbstractScrollArea {
  Q_OBJECT

public:
  explicit TextPreview(QWidget* parent = nullptr);

  // UTF-8; nullptr: none. Scrolls to the beginning, without a highlighted line.
  void setText(std::shared_ptr<const std::string> text);
  // Highlights a line (1-based; 0: none) and scrolls to it if it is not visible. Emits nothing.
  void showLine(std::size_t line);
  std::size_t currentLine() const { return current_; }
  const TextLines& lines() const { return lines_; }

  QSize sizeHint() const override;

signals:
  // 1-based; by a click or the keyboard.
  void lineClicked(qulonglong line);

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  int lineHeight() const;
  int gutterWidth() const;
  std::size_t visibleLines() const;
  void adjustBars();
  void goTo(std::size_t line);

  TextLines lines_;
  std::size_t current_ = 0;
};

} // namespace voluta::panels
