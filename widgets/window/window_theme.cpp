#include "window/window_theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

namespace voluta::window {

namespace {
// Fusion draws the outlines of check boxes darker than the background, which makes them invisible
// in the dark theme.
class OutlinedBoxes : public QProxyStyle {
public:
  OutlinedBoxes() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox)
      return;
    painter->save();
    painter->setBrush(Qt::NoBrush);
    painter->setPen(option->palette.color(QPalette::Disabled, QPalette::Text));
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
  }
};
} // namespace

QPalette paletteOf(Appearance appearance) {
  const bool dark = appearance == Appearance::Dark;
  QPalette p;
  const auto set = [&](QPalette::ColorRole role, const char* light, const char* darkColour) {
    p.setColor(role, QColor(dark ? darkColour : light));
  };
  set(QPalette::Window, "#f3f4f6", "#25282d");
  set(QPalette::WindowText, "#1c1f24", "#e4e7eb");
  set(QPalette::Base, "#ffffff", "#1c1f23");
  set(QPalette::AlternateBase, "#f7f8fa", "#212429");
  set(QPalette::Text, "#1c1f24", "#e4e7eb");
  set(QPalette::Button, "#e9ebee", "#343840");
  set(QPalette::ButtonText, "#1c1f24", "#e4e7eb");
  set(QPalette::BrightText, "#ffffff", "#ffffff");
  set(QPalette::ToolTipBase, "#ffffff", "#343840");
  set(QPalette::ToolTipText, "#1c1f24", "#e4e7eb");
  set(QPalette::PlaceholderText, "#6b7280", "#9aa2ad");
  set(QPalette::Highlight, "#1f6fb2", "#3d8fd1");
  set(QPalette::HighlightedText, "#ffffff", "#ffffff");
  set(QPalette::Link, "#1f6fb2", "#6cb2eb");
  set(QPalette::LinkVisited, "#5b4b9a", "#a99be0");
  set(QPalette::Light, "#ffffff", "#3f444d");
  set(QPalette::Midlight, "#e3e6ea", "#383d45");
  set(QPalette::Mid, "#b9bfc7", "#4a505a");
  set(QPalette::Dark, "#9aa1ab", "#15171a");
  set(QPalette::Shadow, "#6f7782", "#0d0e10");
  const QColor faint(dark ? "#7b838e" : "#8d949e");
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
    p.setColor(QPalette::Disabled, role, faint);
  p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(dark ? "#4a505a" : "#c3c8cf"));
  return p;
}

void applyAppearance(QApplication& app, Appearance appearance) {
  app.setStyle(new OutlinedBoxes); // Owned by the application
  app.setPalette(paletteOf(appearance));
  const QPalette p = app.palette();
  app.setStyleSheet(QString("QToolTip { color: %1; background: %2; border: 1px solid %3; "
                            "padding: 4px; } "
                            "QMainWindow::separator { width: 4px; height: 4px; } "
                            "QDockWidget { font-weight: 600; }")
                        .arg(p.color(QPalette::ToolTipText).name(),
                             p.color(QPalette::ToolTipBase).name(), p.color(QPalette::Mid).name()));
}

QString appearanceName(Appearance appearance) {
  return appearance == Appearance::Dark ? "dark" : "light";
}

Appearance appearanceNamed(const QString& name) {
  return name == "dark" ? Appearance::Dark : Appearance::Light;
}

} // namespace voluta::window
