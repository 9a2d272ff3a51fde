// Keys that commands of the window share with widgets: Space plays and ticks a box, Home shows
// everything and goes to a list's first row, PgUp is the next layer and scrolls. After a click they
// are the command's. A widget that was reached by the Tab key has Space and Home to itself, so that
// the window can be used without a mouse. Text and sliders always keep their keys, combo boxes and
// tables keep Home, and what scrolls keeps PgUp and PgDown.
#pragma once

#include <QObject>

class QWidget;

namespace voluta::window {

class SharedKeys : public QObject {
public:
  // `picture` has no use for these keys itself; it belongs to `window`, which owns this.
  SharedKeys(QWidget& window, const QWidget& picture);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool keeps(const QWidget& widget, int key) const;

  const QWidget& window_;
  const QWidget& picture_;
  bool byTab_ = false; // the last way of getting to a widget
};

} // namespace voluta::window
