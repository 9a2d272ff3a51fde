// Prepare, Layers, Simulate, Export: the pages of one flow and how far each has come; beside them
// Compare, which is no step of it.
#pragma once

#include <QString>
#include <QWidget>
#include <array>

namespace voluta::window {

enum class Page { Prepare, Layers, Simulate, Export, Compare };
inline constexpr int kPageCount = 5;

// What the results of a page are worth.
enum class PageState { Nothing, Running, Done, OutOfDate, Blocked };

QString pageName(Page page);
QString stateName(PageState state);

class FlowBar : public QWidget {
  Q_OBJECT

public:
  explicit FlowBar(QWidget* parent = nullptr);

  Page page() const { return page_; }
  PageState state(Page page) const { return states_[static_cast<std::size_t>(page)]; }
  // Emits nothing.
  void setPage(Page page);
  void setState(Page page, PageState state);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  // In widget coordinates; for tests and tool tips.
  QRect segment(Page page) const;

signals:
  void pageChosen(voluta::window::Page page);

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

private:
  int segmentWidth(int page) const;
  void choose(Page page);

  Page page_ = Page::Prepare;
  std::array<PageState, kPageCount> states_{};
};

} // namespace voluta::window
