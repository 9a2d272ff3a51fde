// Library of processes and materials: those that come with the program, and the user's own, which
// are edited, saved, imported and exported here.
#pragma once

#include "process/head_shapes.h"
#include "window/library/library_shelf.h"

#include <QDialog>
#include <QString>
#include <array>
#include <functional>
#include <optional>

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QTabBar;

namespace voluta::panels {
class HeadDrawing;
class HeadTable;
class ItemForm;
} // namespace voluta::panels

namespace voluta::window {

class LibraryDialog : public QDialog {
  Q_OBJECT

public:
  // `jobProcess`: the choice of the job, an id or a text. Shows that process, or its material.
  LibraryDialog(const std::string& jobProcess, process::Shelf shelf, QWidget* parent);
  ~LibraryDialog() override;

  // Whether files of the library were written or deleted.
  bool libraryChanged() const { return libraryChanged_; }
  const LibraryShelf& shown() const { return shelves_[static_cast<std::size_t>(shelf_)]; }
  // The selected entry; -1: none.
  int current() const;
  void select(const std::string& id);
  // Marks the process, and its material, that the job uses.
  void setJobProcess(const std::string& choice);
  void reject() override;

signals:
  // `choice`: as process::jobChoice() for a process, the id of a material. Emitted after the files
  // were written.
  void useRequested(voluta::process::Shelf shelf, const QString& choice);

private:
  LibraryShelf& shelf() { return shelves_[static_cast<std::size_t>(shelf_)]; }
  void build();
  QWidget* buildList();
  QWidget* buildItem();
  QWidget* buildHead();
  QPushButton* button(const char* name, const QString& text, void (LibraryDialog::*does)());
  void showShelf(process::Shelf shelf);
  void fillList(const std::string& chosen);
  void showRow(QListWidgetItem& row, const ShelfEntry& entry) const;
  void showEntry();
  void showState();
  bool jobHasAnother(const ShelfEntry& entry) const;
  void edit(const process::LibraryItem& draft);
  void setHead(const process::HeadShape& head);
  void duplicate();
  void rename();
  void removeEntry();
  void save();
  void revert();
  void importFile();
  void exportFile();
  void compare();
  void use();
  void headFromNumbers();
  void headFromMesh();
  // Asks how a head lies that seems to be upside down; nullopt: cancelled.
  std::optional<process::NozzlePoints> askNozzle(const base::Message& reason);
  void sizesFromPlate();
  // Runs work that writes files; shows an error in a box. Returns whether it succeeded.
  bool tried(const std::function<void()>& work);
  bool saveChanged();

  std::string jobProcess_;
  process::Shelf shelf_;
  std::array<LibraryShelf, 2> shelves_;
  bool libraryChanged_ = false;
  QTabBar* tabs_;
  QListWidget* list_;
  panels::ItemForm* form_;
  panels::HeadDrawing* drawing_;
  panels::HeadTable* head_;
  QWidget* headSide_ = nullptr;
  QLabel *title_, *about_, *stateIcon_, *state_;
  QPushButton *rename_ = nullptr, *remove_ = nullptr, *duplicate_ = nullptr, *save_ = nullptr,
              *revert_ = nullptr, *export_ = nullptr, *use_ = nullptr, *numbers_ = nullptr,
              *mesh_ = nullptr, *sizes_ = nullptr;
};

} // namespace voluta::window
