// The platform: one of the kinds there are, with its sizes or its file; and of a rod, what is
// across it.
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

// Across a rod: round where sides is 0, else a prism; `points` (x,radius pairs) instead of
// straight.
struct RodProfile {
  int sides = 0;
  QString points;
  bool operator==(const RodProfile&) const = default;
};

class PlatformEditor : public QWidget {
  Q_OBJECT

public:
  explicit PlatformEditor(QWidget* parent = nullptr);

  // The kinds to choose from: those that can be used so. Emits nothing.
  void setUses(const std::vector<project::PlatformUse>& uses);
  // Emits nothing; a text that is no platform leaves all as it is. A kind that is not to be chosen
  // from is added.
  void setText(const QString& text);
  QString text() const;
  // Emits nothing.
  void setProfile(const RodProfile& profile);

  // Asks for the file of a body; without an answer all stays as it was.
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
  std::vector<NumberBox*> sizes_; // as many as any kind has fields
  std::vector<QLabel*> times_;    // before each but the first
  QToolButton* fileButton_ = nullptr;
  QComboBox* shape_ = nullptr;
  QLineEdit* points_ = nullptr;
  QString shownText_, file_;
  RodProfile profile_;
  std::vector<project::PlatformUse> uses_;
};

} // namespace voluta::forms
