// What the Layers page shows and how it is coloured; the section plane.
#pragma once

#include "scene/view_state.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace voluta::window {

// Furthest: whatever the plan has come to.
enum class LayerSubject { Furthest, Voxels, Layers, Paths, Pieces };
inline constexpr int kLayerSubjectCount = 5;

struct ViewChoices {
  LayerSubject subject = LayerSubject::Furthest;
  scene::ColourBy colourBy = scene::ColourBy::Layer;
  bool part = false, travels = false, beads = true;
  bool front = true, ghosts = false; // while growth is replayed
  bool section = false, sectionFlipped = false;
  int sectionAxis = 0;       // x, y, z
  double sectionPlace = 0.5; // share of the part's box along the axis
};

class ViewOptions : public QWidget {
  Q_OBJECT

public:
  explicit ViewOptions(QWidget* parent = nullptr);

  const ViewChoices& choices() const { return choices_; }
  // Emits nothing.
  void setChoices(const ViewChoices& choices);
  // A mode has either voxels or pieces; only one of them is offered.
  void setAvailable(bool voxels, bool pieces, bool layers, bool paths);
  // What is on show, never Furthest: only colourings that it has are offered.
  void setShown(LayerSubject subject);

signals:
  void changed(const voluta::window::ViewChoices& choices);
  void dragging(bool on); // the section plane is being moved

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void read();
  void retranslate();

  ViewChoices choices_;
  LayerSubject shown_ = LayerSubject::Furthest;
  bool filling_ = false;
  QLabel *subjectLabel_, *colourLabel_;
  QButtonGroup* subjects_;
  QComboBox* colourBy_;
  QCheckBox *part_, *travels_, *beads_, *front_, *ghosts_, *section_;
  QComboBox* axis_;
  QSlider* place_;
  QToolButton* flip_;
};

} // namespace voluta::window
