// Selection of the shown layers: two handles on a vertical groove.
#pragma once

#include <QWidget>
#include <vector>

namespace voluta::timeline {

// Layers are counted from 0 in the interface and from 1 on the labels. Keys: up and down move the
// upper handle, with Shift the lower one, Page up and Page down by ten; Home and End extend the
// range to the first or to the last layer. The wheel moves the upper handle, with Shift the lower
// one, with Ctrl both. A click on the groove moves the nearer handle there; a double click shows a
// single layer, another one all of them. In single-layer mode both handles move together. A + above
// the upper handle, or the key +, adds a pause before that layer; a − there, or the key −, removes
// it.
class LayerRangeSlider : public QWidget {
  Q_OBJECT

public:
  explicit LayerRangeSlider(QWidget* parent = nullptr);

  int layerCount() const { return count_; }
  int first() const { return first_; }
  int last() const { return last_; }
  bool single() const { return single_; }

  // Tops of the layers for the labels [mm]: heights, or radii about an axis; empty, or one per
  // layer. Shows all layers when the count changes. count >= 0.
  void setLayers(int count, std::vector<double> topMm = {}, bool radii = false);
  // Returns the label's text: "12.8 mm", "r 3.75 mm"; empty: not known.
  QString topText(int layer) const;
  // Returns the heights [mm] that are marked along the groove: round numbers, as many as there is
  // room for; none if the layers' tops are not known or do not rise.
  std::vector<double> ruledMm() const;
  // Layers before which the print pauses, ascending. `pausable`: the user may change them.
  void setPauses(std::vector<int> layers, bool pausable);
  const std::vector<int>& pauses() const { return pauses_; }
  // Layers before which something else happens, ascending.
  void setEvents(std::vector<int> layers);
  const std::vector<int>& events() const { return events_; }
  // Returns the place of the + or −; empty: there is none.
  QRectF pauseButton() const;
  // Clamped to [0, layerCount() - 1]; first <= last.
  void setRange(int first, int last);
  void setSingle(bool single);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void rangeChanged(int first, int last);
  void dragging(bool on);
  void singleChanged(bool single);
  // The user adds a pause before that layer, or removes it.
  void pauseWished(int layer, bool pause);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

private:
  enum class Handle { None, Lower, Upper };

  QRectF grooveRect() const;
  double yOf(int layer) const;
  int layerAt(double y) const;
  Handle nearestHandle(double y) const;
  QRectF handleRect(Handle handle) const;
  QString labelOf(int layer) const;
  QString topText(double mm, bool radius) const;
  int textWidth(const QString& text) const;
  double yOfTop(double mm) const;
  bool pausesAtUpper() const;
  void wishPause(bool pause);
  void paintPauses(QPainter& painter) const;
  void paintRuler(QPainter& painter, const std::vector<QRectF>& taken) const;
  QRectF labelRect(double y) const;
  void paintLabel(QPainter& painter, int layer, double y) const;
  void moveHandle(Handle handle, int layer);
  void describe();

  int count_ = 0, first_ = 0, last_ = 0;
  std::vector<double> topMm_;
  bool radii_ = false;
  bool single_ = false, pausable_ = false;
  std::vector<int> pauses_, events_;
  Handle held_ = Handle::None;
  int wheelRest_ = 0; // eighths of a degree not yet used for a step
};

} // namespace voluta::timeline
