// Edits the choices that are not parameters in their form. A change of print mode also changes
// cell, process and platform; conflicts are shown beside the form with a button that resolves them.
#pragma once

#include "document/mode_switch.h"
#include "forms/choices_form.h"
#include "process/library.h"

#include <QObject>
#include <QString>
#include <string>
#include <utility>

namespace voluta::document {
class Document;
}

namespace voluta::window {

// Returns all lists of the form, in the language of the window.
forms::ChoiceLists choiceLists();

class ChoicesEditor : public QObject {
  Q_OBJECT

public:
  // The document must outlive this.
  ChoicesEditor(document::Document& document, QObject* parent);

  // Created here, to be placed by the caller.
  forms::ChoicesForm* form() { return form_; }
  void show();
  void retranslate();
  // Opens the library of processes and materials.
  void openLibrary(process::Shelf shelf);

private:
  void connectTools();
  void change(const QString& field, const QString& text);
  void changeRod(const forms::RodProfile& profile);
  void switchMode(const std::string& mode);
  void showNotice();
  // For automatic choices: the choice made and why others were rejected; empty: not planned yet.
  QString chosenStrategy() const;
  void pressNotice();

  document::Document& document_;
  forms::ChoicesForm* form_;
  document::ModeSwitch modeSwitch_;
  // The mode last switched to, and the choices changed with it; empty: none.
  std::pair<std::string, QString> wentAlong_;
};

} // namespace voluta::window
