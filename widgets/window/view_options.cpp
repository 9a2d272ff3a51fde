#include "window/view_options.h"

#include "forms/value_boxes.h"
#include "language/words.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

namespace voluta::window {

namespace {
constexpr int kPlaceSteps = 1000;

bool offers(LayerSubject subject, scene::ColourBy colourBy) {
  using scene::ColourBy;
  if (subject == LayerSubject::Pieces)
    return false; // They have their own colours
  switch (colourBy) {
  case ColourBy::Layer:
    return true;
  case ColourBy::Group:
  case ColourBy::Height:
  case ColourBy::Direction:
    return subject != LayerSubject::Voxels;
  case ColourBy::Kind:
  case ColourBy::Tool:
  case ColourBy::Width:
  case ColourBy::Speed:
  case ColourBy::Time:
  case ColourBy::LayerTime:
    return subject == LayerSubject::Paths;
  case ColourBy::Part:
    return subject != LayerSubject::Voxels;
  case ColourBy::Spacing:
  case ColourBy::Region:
    return subject == LayerSubject::Layers;
  case ColourBy::GrowthStep:
  case ColourBy::Peeling:
    return subject == LayerSubject::Voxels;
  }
  return false;
}
} // namespace

ViewOptions::ViewOptions(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  auto* subjects = new QGridLayout;
  buildSubjects(*subjects);
  column->addLayout(subjects);
  const auto box = [&](const char* name) {
    auto* made = new QCheckBox(this);
    made->setObjectName(name);
    column->addWidget(made);
    return made;
  };
  part_ = box("partSurface");
  travels_ = box("travels");
  beads_ = box("beads");
  front_ = box("front");
  ghosts_ = box("ghosts");
  auto* plane = new QGridLayout;
  buildPlane(*plane);
  column->addLayout(plane);
  listen();
  retranslate();
  setChoices(choices_);
  setLook(look_);
  setAvailable(false, false, false, false);
}

void ViewOptions::buildSubjects(QGridLayout& grid) {
  grid.setColumnStretch(1, 1);
  subjectLabel_ = new QLabel(this);
  colourLabel_ = new QLabel(this);
  subjects_ = new QButtonGroup(this);
  // The checked button must be obvious, also in the dark theme.
  setStyleSheet("QToolButton { border: 1px solid palette(mid); padding: 4px 2px; }"
                "QToolButton:checked { background: palette(highlight); "
                "color: palette(highlighted-text); }"
                "QToolButton:disabled { color: palette(mid); }");
  // Two per row: one row would be wider than a narrow panel.
  auto* pairs = new QGridLayout;
  pairs->setSpacing(0);
  for (const LayerSubject subject :
       {LayerSubject::Furthest, LayerSubject::Voxels, LayerSubject::Pieces, LayerSubject::Layers,
        LayerSubject::Paths}) {
    const int id = static_cast<int>(subject);
    auto* button = new QToolButton(this);
    button->setCheckable(true);
    button->setAutoRaise(false);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setObjectName(QString("subject%1").arg(id));
    subjects_->addButton(button, id);
    const bool below = subject == LayerSubject::Layers || subject == LayerSubject::Paths;
    const bool left = subject == LayerSubject::Furthest || subject == LayerSubject::Layers;
    pairs->addWidget(button, below ? 1 : 0, left ? 0 : 1); // Either voxels or pieces are hidden
  }
  colourBy_ = forms::makeCombo(this); // Its entries may be wider than the panel
  colourBy_->setObjectName("colourBy");
  for (const scene::ColourByRow& entry : scene::colourByTable())
    if (entry.colourBy != scene::ColourBy::Part && entry.colourBy != scene::ColourBy::Tool &&
        entry.colourBy != scene::ColourBy::Region)
      colourBy_->addItem(QString(), static_cast<int>(entry.colourBy));
  grid.addWidget(subjectLabel_, 0, 0, 1, 2);
  grid.addLayout(pairs, 1, 0, 1, 2);
  grid.addWidget(colourLabel_, 2, 0);
  grid.addWidget(colourBy_, 2, 1);
}

void ViewOptions::buildPlane(QGridLayout& grid) {
  section_ = new QCheckBox(this);
  section_->setObjectName("section");
  axis_ = new QComboBox(this);
  axis_->addItems({"X", "Y", "Z"});
  place_ = new QSlider(Qt::Horizontal, this);
  place_->setObjectName("sectionPlace");
  place_->setRange(0, kPlaceSteps);
  flip_ = new QToolButton(this);
  flip_->setCheckable(true);
  grid.addWidget(section_, 0, 0, 1, 3);
  grid.addWidget(axis_, 1, 0);
  grid.addWidget(place_, 1, 1);
  grid.addWidget(flip_, 1, 2);
  grid.setColumnStretch(1, 1);
}

void ViewOptions::listen() {
  connect(subjects_, &QButtonGroup::idClicked, this, &ViewOptions::read);
  for (QComboBox* combo : {colourBy_, axis_})
    connect(combo, &QComboBox::currentIndexChanged, this, &ViewOptions::read);
  for (QCheckBox* box : {part_, travels_, beads_, front_, ghosts_, section_})
    connect(box, &QCheckBox::toggled, this, &ViewOptions::read);
  connect(flip_, &QToolButton::toggled, this, &ViewOptions::read);
  connect(place_, &QSlider::valueChanged, this, &ViewOptions::read);
  connect(place_, &QSlider::sliderPressed, this, [this] { emit dragging(true); });
  connect(place_, &QSlider::sliderReleased, this, [this] { emit dragging(false); });
}

void ViewOptions::retranslate() {
  subjectLabel_->setText(tr("Show"));
  colourLabel_->setText(tr("Colour by"));
  const QStringList names{tr("Latest"), tr("Voxels"), tr("Layers"), tr("Paths"), tr("Pieces")};
  const QStringList tips{tr("The latest result of the plan"),
                         tr("Solid voxels and their growth order"),
                         tr("Layers drawn with their thickness"), tr("Tool-paths drawn as beads"),
                         tr("Pieces printable without support, and their base planes")};
  for (int id = 0; id < kLayerSubjectCount; ++id) {
    subjects_->button(id)->setText(names[id]);
    subjects_->button(id)->setToolTip(tips[id]);
  }
  const QSignalBlocker quiet(colourBy_);
  for (int i = 0; i < colourBy_->count(); ++i)
    colourBy_->setItemText(
        i, language::words(
               scene::colourByTable()[static_cast<std::size_t>(colourBy_->itemData(i).toInt())]
                   .label));
  part_->setText(tr("Part surface"));
  travels_->setText(tr("Travel moves"));
  beads_->setText(tr("True bead width"));
  front_->setText(tr("Convex front"));
  front_->setToolTip(
      tr("During growth replay: the convex front; the next voxels must be outside it"));
  ghosts_->setText(tr("Later voxels faint"));
  ghosts_->setToolTip(tr("During growth replay: voxels not yet printed"));
  section_->setText(tr("Section plane"));
  flip_->setText(tr("Flip"));
  flip_->setToolTip(tr("Remove the other side"));
  place_->setToolTip(tr("Position of the section plane"));
  place_->setAccessibleName(place_->toolTip());
}

void ViewOptions::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

void ViewOptions::setChoices(const ViewChoices& choices) {
  filling_ = true;
  choices_ = choices;
  subjects_->button(static_cast<int>(choices.subject))->setChecked(true);
  part_->setChecked(choices.part);
  travels_->setChecked(choices.travels);
  front_->setChecked(choices.front);
  ghosts_->setChecked(choices.ghosts);
  filling_ = false;
}

void ViewOptions::setLook(const Look& look) {
  filling_ = true;
  look_ = look;
  colourBy_->setCurrentIndex(shownColouring());
  beads_->setChecked(look.beads);
  section_->setChecked(look.section);
  axis_->setCurrentIndex(look.sectionAxis);
  place_->setValue(static_cast<int>(look.sectionPlace * kPlaceSteps));
  flip_->setChecked(look.sectionFlipped);
  for (QWidget* widget :
       {static_cast<QWidget*>(axis_), static_cast<QWidget*>(place_), static_cast<QWidget*>(flip_)})
    widget->setEnabled(look.section);
  filling_ = false;
}

void ViewOptions::setAvailable(bool voxels, bool pieces, bool layers, bool paths) {
  subjects_->button(static_cast<int>(LayerSubject::Voxels))->setVisible(!pieces);
  subjects_->button(static_cast<int>(LayerSubject::Pieces))->setVisible(pieces);
  subjects_->button(static_cast<int>(LayerSubject::Voxels))->setEnabled(voxels);
  subjects_->button(static_cast<int>(LayerSubject::Layers))->setEnabled(layers);
  subjects_->button(static_cast<int>(LayerSubject::Paths))->setEnabled(paths);
}

void ViewOptions::setSeveral(bool parts, bool tools, bool regions) {
  offer(scene::ColourBy::Tool, tools);
  offer(scene::ColourBy::Part, parts);
  offer(scene::ColourBy::Region, regions);
}

void ViewOptions::offer(scene::ColourBy colourBy, bool offered) {
  const int at = colourBy_->findData(static_cast<int>(colourBy));
  if (offered == (at >= 0))
    return;
  if (offered) {
    colourBy_->addItem(QString(), static_cast<int>(colourBy));
    retranslate();
    showColourings();
    return;
  }
  if (colourBy_->currentIndex() == at)
    colourBy_->setCurrentIndex(0);
  colourBy_->removeItem(at);
}

void ViewOptions::setShown(LayerSubject subject) {
  if (std::exchange(shown_, subject) == subject)
    return;
  for (QCheckBox* box : {front_, ghosts_})
    box->setVisible(subject == LayerSubject::Voxels);
  for (QCheckBox* box : {travels_, beads_})
    box->setVisible(subject == LayerSubject::Paths);
  for (QWidget* widget : {static_cast<QWidget*>(colourLabel_), static_cast<QWidget*>(colourBy_)})
    widget->setVisible(subject != LayerSubject::Pieces);
  showColourings();
}

void ViewOptions::showColourings() {
  auto* items = qobject_cast<QStandardItemModel*>(colourBy_->model());
  for (int i = 0; i < colourBy_->count(); ++i)
    items->item(i)->setEnabled(
        offers(shown_, static_cast<scene::ColourBy>(colourBy_->itemData(i).toInt())));
  const QSignalBlocker quiet(colourBy_);
  colourBy_->setCurrentIndex(shownColouring());
}

// A subject that does not have the chosen colouring is coloured by its layers.
int ViewOptions::shownColouring() const {
  const auto shown = offers(shown_, look_.colourBy) ? look_.colourBy : scene::ColourBy::Layer;
  return colourBy_->findData(static_cast<int>(shown));
}

void ViewOptions::read() {
  if (filling_)
    return;
  ViewChoices now;
  now.subject = static_cast<LayerSubject>(subjects_->checkedId());
  now.part = part_->isChecked();
  now.travels = travels_->isChecked();
  now.front = front_->isChecked();
  now.ghosts = ghosts_->isChecked();
  Look look = look_;
  if (colourBy_->currentIndex() != shownColouring())
    look.colourBy = static_cast<scene::ColourBy>(colourBy_->currentData().toInt());
  look.beads = beads_->isChecked();
  look.section = section_->isChecked();
  look.sectionAxis = axis_->currentIndex();
  look.sectionPlace = static_cast<double>(place_->value()) / kPlaceSteps;
  look.sectionFlipped = flip_->isChecked();
  setChoices(now);
  setLook(look);
  emit changed();
}

} // namespace voluta::window
