// What the Layers page shows and how it is coloured; the section plane.
#pragma once

#include "window/picture.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace voluta::window {

// Furthest: whatever the plan has come to.
enum class LayerSubject { Furthest, Voxels, Layers, Paths, Pieces };
inline constexpr int kLayerSubjectCount = 5;

// Beside the Look of the picture.
struct ViewChoices {
  LayerSubject subject = LayerSubject::Furthest;
  bool part = false, travels = false;
  bool front = true, ghosts = false; // while growth is replayed
};

class ViewOptions : public QWidget {
  Q_OBJECT

public:
  explicit ViewOptions(QWidget* parent = nullptr);

  const ViewChoices& choices() const { return choices_; }
  const Look& look() const { return look_; }
  // None of these emits.
  void setChoices(const ViewChoices& choices);
  void setLook(const Look& look);
  // A mode has either voxels or pieces; only one of them is offered.
  void setAvailable(bool voxels, bool pieces, bool layers, bool paths);
  // What is on show, never Furthest: only colourings that it has are offered.
  void setShown(LayerSubject subject);

signals:
  void changed();         // choices, look
  void dragging(bool on); // the section plane is being moved

protected:
  void changeEvent(QEvent* event) override;

private:
  void buildSubjects(QGridLayout& grid);
  void buildPlane(QGridLayout& grid);
  void listen();
  void read();
  void retranslate();

  ViewChoices choices_;
  Look look_;
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
