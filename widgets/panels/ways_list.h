// The possible orientations of the part, as pictures to choose from.
#pragma once

#include "panels/way_card.h"

#include <QWidget>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;

namespace voluta::panels {

class WaysList : public QWidget {
  Q_OBJECT

public:
  explicit WaysList(QWidget* parent = nullptr);

  // Size of a picture that is sufficient for any screen.
  static QSize pictureSize();

  static constexpr std::size_t kMax = 4;

  // The best first. Precondition (Error{Internal}): at most kMax. None of these emits.
  void setWays(const std::vector<ShownOrientation>& ways);
  // The present orientation; nullopt: none of the list.
  void setNow(std::optional<std::size_t> orientation);
  // Orientations are being computed.
  void setLooking(bool looking);
  bool isLooking() const { return looking_; }
  std::size_t count() const { return count_; }

signals:
  void chosen(int orientation);

protected:
  void changeEvent(QEvent* event) override;

private:
  void addCard(int n);
  void retranslate();
  void showState();

  std::array<WayCard*, kMax> cards_{}; // created at once, for the tab order
  std::size_t count_ = 0;              // number of cards shown
  std::optional<std::size_t> now_;
  bool looking_ = false;
  QLabel* title_ = nullptr;
  QLabel* state_ = nullptr;
  QGridLayout* grid_ = nullptr;
};

} // namespace voluta::panels
