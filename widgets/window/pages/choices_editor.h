// The choices that are no parameters, edited in their form: with a way of building cell, process
// and platform change along, and what does not fit is said beside them with a button that mends it.
#pragma once

#include "document/mode_switch.h"
#include "forms/choices_form.h"

#include <QObject>
#include <QString>
#include <string>
#include <utility>

namespace voluta::document {
class Document;
}

namespace voluta::window {

// Every list of the form, in the language of the window.
forms::ChoiceLists choiceLists();

class ChoicesEditor : public QObject {
  Q_OBJECT

public:
  // The document outlives this.
  ChoicesEditor(document::Document& document, QObject* parent);

  // Made here, to be put somewhere.
  forms::ChoicesForm* form() { return form_; }
  void show();
  void retranslate();

private:
  void change(const QString& field, const QString& text);
  void changeRod(const forms::RodProfile& profile);
  void switchMode(const std::string& mode);
  void showNotice();
  // Of automatic choices: what was chosen, and why nothing else; empty: not planned yet.
  QString wayChosen() const;
  void pressNotice();

  document::Document& document_;
  forms::ChoicesForm* form_;
  document::ModeSwitch modeSwitch_;
  // Of the mode that was last switched to, what was changed with it; empty: nothing.
  std::pair<std::string, QString> wentAlong_;
};

} // namespace voluta::window
