// A list of all commands and settings that is searched by typing.
#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace voluta::window {

struct PaletteEntry {
  QString name;
  QString place;        // Menu or page
  QString meaning = {}; // Synonyms; searched too, not shown
  QString more = {};    // Help; likewise
  QString keys = {};
  bool enabled = true;
  std::function<void()> does = {};
};

// Returns the entries that contain all words, the best first: words in the name come before words
// elsewhere, and enabled entries before others. Without any word: all, in their order.
std::vector<const PaletteEntry*> found(const std::vector<PaletteEntry>& entries,
                                       const QStringList& words);

class CommandPalette : public QDialog {
  Q_OBJECT

public:
  CommandPalette(std::vector<PaletteEntry> entries, QWidget* window);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void show(const QString& text);
  void use();

  std::vector<PaletteEntry> entries_;
  std::vector<const PaletteEntry*> shown_; // In the order of the rows
  QLineEdit* search_;
  QTreeWidget* list_;
  QLabel* nothing_;
};

} // namespace voluta::window
