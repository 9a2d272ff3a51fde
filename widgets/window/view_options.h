// Display options of the Layers page: content, colouring and the section plane.
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

// Furthest: the last result of the plan.
enum class LayerSubject { Furthest, Voxels, Layers, Paths, Pieces };
inline constexpr int kLayerSubjectCount = 5;

// Options that are not part of Look.
struct ViewChoices {
  LayerSubject subject = LayerSubject::Furthest;
  bool part = false, travels = false;
  bool front = true, ghosts = false; // While growth is replayed
};

class ViewOptions : public QWidget {
  Q_OBJECT

public:
  explicit ViewOptions(QWidget* parent = nullptr);

  const ViewChoices& choices() const { return choices_; }
  const Look& look() const { return look_; }
  // These functions emit no signals.
  void setChoices(const ViewChoices& choices);
  void setLook(const Look& look);
  // A mode has either voxels or pieces; only one of them is offered.
  void setAvailable(bool voxels, bool pieces, bool layers, bool paths);
  // Several: offers the colouring by part. Without it, a choice of it emits changed().
  void setSeveral(bool parts, bool tools, bool regions);
  // `subject`: the content shown, never Furthest. Only its colourings are offered.
  void setShown(LayerSubject subject);

signals:
  void changed();         // Choices or look
  void dragging(bool on); // While the section plane is being moved

protected:
  void changeEvent(QEvent* event) override;

private:
  void offer(scene::ColourBy colourBy, bool offered);
  void buildSubjects(QGridLayout& grid);
  void buildPlane(QGridLayout& grid);
  void listen();
  void read();
  void showColourings();
  int shownColouring() const;
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
