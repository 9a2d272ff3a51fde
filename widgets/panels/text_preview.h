// A long text to look at: only the lines in sight are touched.
#pragma once

#include "panels/text_lines.h"

#include <QAbstractScrollArea>

namespace voluta::panels {

class TextPreview : public QAbstractScrollArea {
  Q_OBJECT

public:
  explicit TextPreview(QWidget* parent = nullptr);

  // UTF-8; nullptr: none. Shows its beginning, no line set off.
  void setText(std::shared_ptr<const std::string> text);
  // Sets a line off (1-based; 0: none) and scrolls to it where it is out of sight. Emits nothing.
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
