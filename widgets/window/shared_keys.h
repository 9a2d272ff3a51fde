// Keys that commands of the window share with widgets: Space plays and toggles check boxes, Home
// shows everything and selects a list's first row, PgUp is the next layer and scrolls. After a
// click they belong to the command. A widget that was focused with the Tab key keeps Space and
// Home, so that the window can be used without a mouse. Text fields and sliders always keep their
// keys, combo boxes and tables keep Home, and scrollable widgets keep PgUp and PgDown.
#pragma once

#include <QObject>

class QWidget;

namespace voluta::window {

class SharedKeys : public QObject {
public:
  // `picture` does not use these keys itself; it belongs to `window`, which owns this object.
  SharedKeys(QWidget& window, const QWidget& picture);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool keeps(const QWidget& widget, int key) const;

  const QWidget& window_;
  const QWidget& picture_;
  bool byTab_ = false; // The focused widget was last reached with the Tab key
};

} // namespace voluta::window
