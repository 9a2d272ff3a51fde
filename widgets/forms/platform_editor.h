// Editor for the platform: its kind, with its sizes or its file; for a rod, also its cross-section.
#pragma once

#include "project/platform.h"

#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace voluta::forms {

class NumberBox;

// Cross-section of a rod: round if sides is 0, else a prism; `points` (x,radius pairs) for a
// stepped rod instead of a straight one.
struct RodProfile {
  int sides = 0;
  QString points;
  bool operator==(const RodProfile&) const = default;
};

class PlatformEditor : public QWidget {
  Q_OBJECT

public:
  explicit PlatformEditor(QWidget* parent = nullptr);

  // Limits the kinds to those with one of these uses. Emits nothing.
  void setUses(const std::vector<project::PlatformUse>& uses);
  // Emits nothing; ignores a text that is no platform. A kind that is not in the list is added.
  void setText(const QString& text);
  QString text() const;
  // Emits nothing.
  void setProfile(const RodProfile& profile);

  // Shows a file dialog for a body; cancelling it changes nothing.
  void chooseFile();

signals:
  void changed(const QString& text);
  void profileChanged(const voluta::forms::RodProfile& profile);

protected:
  void changeEvent(QEvent* event) override;

private:
  const project::PlatformKind& kind() const;
  project::PlatformKind::As used(const project::PlatformKind& kind) const;
  int indexOf(const project::PlatformKind& kind) const;
  void addKind(const project::PlatformKind& kind);
  void chooseKind();
  void showKind();
  void setSizes(const std::vector<double>& sizesMm);
  void showProfile();
  void commit();
  void commitProfile();
  void retranslate();

  QComboBox* kind_ = nullptr;
  std::vector<NumberBox*> sizes_; // As many as the kind with the most fields
  std::vector<QLabel*> times_;    // Before each but the first
  QToolButton* fileButton_ = nullptr;
  QComboBox* shape_ = nullptr;
  QLineEdit* points_ = nullptr;
  QString shownText_, file_;
  RodProfile profile_;
  std::vector<project::PlatformUse> uses_;
};

} // namespace voluta::forms
