#include "forms/platform_editor.h"

#include "base/error.h"
#include "forms/file_patterns.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "project/platform_kinds.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace voluta::forms {

namespace {
constexpr int kHexagon = 6;
constexpr std::array<const char*, 3> kBoxNames{"first", "second", "third"};

std::size_t maxFields() {
  std::size_t maximum = 0;
  for (const project::PlatformKind& kind : project::platformKinds())
    maximum = std::max(maximum, kind.fields.size());
  return maximum;
}

QString wordOf(const project::PlatformKind& kind) {
  return QString::fromUtf8(kind.word.data(), static_cast<qsizetype>(kind.word.size()));
}

// The kind of platform that is a body from a file.
const project::PlatformKind& kindWithFile() {
  const auto& kinds = project::platformKinds();
  return *std::find_if(kinds.begin(), kinds.end(),
                       [](const project::PlatformKind& kind) { return !kind.file.empty(); });
}
} // namespace

PlatformEditor::PlatformEditor(QWidget* parent) : QWidget(parent) {
  kind_ = makeCombo(this);
  kind_->setObjectName(QStringLiteral("kind"));
  auto* sizes = new QHBoxLayout;
  sizes->setSpacing(4);
  for (std::size_t i = 0; i < maxFields(); ++i) {
    if (i > 0) {
      times_.push_back(new QLabel(QStringLiteral("×"), this));
      sizes->addWidget(times_.back());
    }
    auto* box = new NumberBox(this);
    box->setObjectName(QLatin1String(kBoxNames.at(i)));
    box->setUnit(QStringLiteral("mm"));
    box->setMinimumWidth(fontMetrics().averageCharWidth() * 9);
    connect(box, &QDoubleSpinBox::valueChanged, this, &PlatformEditor::commit);
    sizes->addWidget(box, 1);
    sizes_.push_back(box);
  }
  fileButton_ = new QToolButton(this);
  fileButton_->setObjectName(QStringLiteral("file"));
  fileButton_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  shape_ = makeCombo(this);
  shape_->setObjectName(QStringLiteral("rodShape"));
  for (const int sides : {0, kHexagon, -1})
    shape_->addItem(QString(), sides);
  points_ = new QLineEdit(this);
  points_->setObjectName(QStringLiteral("rodPoints"));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(kind_);
  column->addLayout(sizes);
  column->addWidget(fileButton_);
  column->addWidget(shape_);
  column->addWidget(points_);

  connect(kind_, &QComboBox::currentIndexChanged, this, &PlatformEditor::chooseKind);
  connect(fileButton_, &QToolButton::clicked, this, &PlatformEditor::chooseFile);
  connect(shape_, &QComboBox::currentIndexChanged, this, [this] {
    const int sides = shape_->currentData().toInt();
    profile_.sides = std::max(0, sides);
    showProfile();
    if (sides >= 0)
      profile_.points.clear();
    if (sides >= 0 || !profile_.points.isEmpty())
      commitProfile();
    else
      points_->setFocus();
  });
  connect(points_, &QLineEdit::editingFinished, this, [this] {
    if (points_->text().trimmed() == profile_.points)
      return;
    profile_.points = points_->text().trimmed();
    commitProfile();
  });
  setFocusProxy(kind_);
  setUses({project::PlatformUse::Plate});
  shownText_ = text();
}

const project::PlatformKind& PlatformEditor::kind() const {
  return project::findPlatformKind(kind_->currentData().toString().toStdString());
}

// Returns the kind's first possible use among the requested ones.
project::PlatformKind::As PlatformEditor::used(const project::PlatformKind& kind) const {
  for (const project::PlatformUse use : uses_)
    for (const project::PlatformKind::As& as : kind.uses)
      if (as.use == use)
        return as;
  return kind.uses.front();
}

int PlatformEditor::indexOf(const project::PlatformKind& kind) const {
  return kind_->findData(wordOf(kind));
}

void PlatformEditor::addKind(const project::PlatformKind& kind) {
  kind_->addItem(QString(), wordOf(kind));
}

void PlatformEditor::setUses(const std::vector<project::PlatformUse>& uses) {
  if (uses == uses_)
    return;
  const QSignalBlocker quiet(kind_);
  const project::PlatformKind* chosen = uses_.empty() ? nullptr : &kind();
  uses_ = uses;
  kind_->clear();
  for (const project::PlatformKind* one : project::platformKindsFor(uses))
    addKind(*one);
  kind_->setCurrentIndex(chosen ? std::max(0, indexOf(*chosen)) : 0);
  retranslate();
}

void PlatformEditor::setSizes(const std::vector<double>& sizesMm) {
  for (std::size_t i = 0; i < sizesMm.size(); ++i) {
    const QSignalBlocker quiet(sizes_[i]);
    sizes_[i]->setValue(sizesMm[i]);
  }
}

void PlatformEditor::chooseKind() {
  showKind();
  if (!kind().file.empty()) {
    chooseFile();
    return;
  }
  setSizes(project::Platform(kind()).sizesMm());
  commit();
}

// Without a file the platform is unchanged.
void PlatformEditor::chooseFile() {
  const QString folder = QSettings().value(QStringLiteral("open/folder")).toString();
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Body to print on"), file_.isEmpty() ? folder : file_,
      tr("Meshes (%1);;All files (*)").arg(forms::filePatterns(project::NamedFiles::Meshes)));
  if (file.isEmpty()) {
    setText(shownText_);
    return;
  }
  QSettings().setValue(QStringLiteral("open/folder"), QFileInfo(file).absolutePath());
  setText(QString::fromStdString(project::Platform(kindWithFile(), file.toStdString()).text()));
  commit();
}

void PlatformEditor::setText(const QString& text) {
  std::optional<project::Platform> platform;
  try {
    platform.emplace(text.toStdString());
  } catch (const base::Error&) {
    return;
  }
  const QSignalBlocker quiet(kind_);
  shownText_ = text;
  if (!platform->file().empty())
    file_ = QString::fromStdString(platform->file());
  if (indexOf(platform->kind()) < 0) {
    addKind(platform->kind());
    retranslate();
  }
  kind_->setCurrentIndex(indexOf(platform->kind()));
  showKind();
  setSizes(platform->sizesMm());
}

QString PlatformEditor::text() const {
  const project::PlatformKind& chosen = kind();
  if (!chosen.file.empty())
    return file_.isEmpty()
               ? shownText_
               : QString::fromStdString(project::Platform(chosen, file_.toStdString()).text());
  std::vector<double> sizes;
  for (std::size_t i = 0; i < chosen.fields.size(); ++i)
    sizes.push_back(
        std::clamp(sizes_[i]->value(), chosen.fields[i].minimum, chosen.fields[i].maximum));
  return QString::fromStdString(project::Platform(chosen, sizes).text());
}

void PlatformEditor::setProfile(const RodProfile& profile) {
  profile_ = profile;
  const QSignalBlocker quiet(shape_), quietPoints(points_);
  const int wanted = profile.points.isEmpty() ? profile.sides : -1;
  if (shape_->findData(wanted) < 0) {
    shape_->addItem(QString(), wanted);
    retranslate();
  }
  shape_->setCurrentIndex(shape_->findData(wanted));
  points_->setText(profile.points);
  showProfile();
}

void PlatformEditor::showKind() {
  const project::PlatformKind& chosen = kind();
  const std::size_t shown = used(chosen).sized ? chosen.fields.size() : 0;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    sizes_[i]->setVisible(i < shown);
    if (i > 0)
      times_[i - 1]->setVisible(i < shown);
    if (i >= chosen.fields.size())
      continue;
    const project::PlatformField& field = chosen.fields[i];
    const QSignalBlocker quiet(sizes_[i]);
    sizes_[i]->setRange(field.minimum, field.maximum);
    sizes_[i]->setToolTip(language::words(field.label));
    sizes_[i]->setAccessibleName(language::words(field.label));
  }
  kind_->setToolTip(tr("Surface on which the print begins"));
  fileButton_->setVisible(!chosen.file.empty());
  fileButton_->setText(file_.isEmpty() ? tr("Choose a file…") : QFileInfo(file_).fileName());
  fileButton_->setToolTip(file_.isEmpty() ? tr("A closed mesh, positioned as in the part's file")
                                          : tr("%1\nClick to choose another one").arg(file_));
  showProfile();
}

void PlatformEditor::showProfile() {
  const bool rod = used(kind()).use == project::PlatformUse::Rod;
  shape_->setVisible(rod);
  points_->setVisible(rod && shape_->currentData().toInt() < 0);
}

void PlatformEditor::commit() {
  shownText_ = text();
  emit changed(shownText_);
}

void PlatformEditor::commitProfile() {
  emit profileChanged(profile_);
}

void PlatformEditor::retranslate() {
  for (int i = 0; i < kind_->count(); ++i)
    kind_->setItemText(
        i, language::words(
               used(project::findPlatformKind(kind_->itemData(i).toString().toStdString())).label));
  for (int i = 0; i < shape_->count(); ++i) {
    const int sides = shape_->itemData(i).toInt();
    shape_->setItemText(i, sides < 0           ? tr("Stepped: x,radius points")
                           : sides == 0        ? tr("Round")
                           : sides == kHexagon ? tr("Hexagonal, across corners")
                                               : tr("%1 sides, across corners").arg(sides));
  }
  shape_->setAccessibleName(tr("Shape of the rod"));
  points_->setAccessibleName(tr("Profile of the rod"));
  points_->setPlaceholderText(QStringLiteral("-20,2.5 0,2.5 0,3.5 20,3.5"));
  points_->setToolTip(tr("Pairs of x and radius in mm; a step has two pairs at one x"));
  showKind();
}

void PlatformEditor::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::forms
