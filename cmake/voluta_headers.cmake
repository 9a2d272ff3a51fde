# Precompiled headers, made once and shared: what nearly every file includes of the standard library,
# Eigen, Qt and the test libraries. None of our own is in them, so that no change of ours makes them
# anew, and a target still finds only the modules it links.
#   voluta_headers_core     modules, programs, what is drawn
#   voluta_headers_test     tests without Qt
#   voluta_headers_qt       the window
#   voluta_headers_qt_test  tests of the window
set(voluta_common_headers <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional>
  <map> <memory> <optional> <string> <string_view> <utility> <variant> <vector> <Eigen/Core>
  <Eigen/Geometry>)
# Not <QtWidgets> as a whole, whose precompiled header takes 400 MB of each compiler.
set(voluta_qt_headers <QApplication> <QComboBox> <QEvent> <QFileInfo> <QHBoxLayout> <QLabel> <QLineEdit>
  <QLocale> <QObject> <QPainter> <QPushButton> <QSignalBlocker> <QString> <QTimer> <QToolButton> <QVBoxLayout>
  <QWidget>)

# voluta_headers(NAME HEADERS <a> ... LINK lib ... DEFINITIONS X ...)
function(voluta_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK;DEFINITIONS" ${ARGN})
  add_library(${name} OBJECT ${CMAKE_SOURCE_DIR}/cmake/headers.cpp)
  target_precompile_headers(${name} PRIVATE ${voluta_common_headers} ${ARG_HEADERS})
  target_compile_definitions(${name} PRIVATE ${ARG_DEFINITIONS})
  # The libraries' folders and flags, but not all of their definitions: a header is taken only by
  # what has every definition that it was made with.
  foreach(lib voluta_flags Eigen3::Eigen ${ARG_LINK})
    target_include_directories(${name} SYSTEM PRIVATE
      $<TARGET_PROPERTY:${lib},INTERFACE_INCLUDE_DIRECTORIES>)
    target_compile_options(${name} PRIVATE $<TARGET_PROPERTY:${lib},INTERFACE_COMPILE_OPTIONS>)
  endforeach()
endfunction()
