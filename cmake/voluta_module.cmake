# voluta_module(NAME SOURCES a.cpp ... LINK voluta::base ... PRIVATE_LINK lib ...)
# A static library voluta_NAME (alias voluta::NAME) whose headers are included as "NAME/file.h".
# Third-party headers count as system headers, so that only our own code is held to the warnings.
# Installed as voluta::NAME of the package Voluta (voluta_install.cmake).
function(voluta_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(voluta_${name} STATIC ${ARG_SOURCES})
  add_library(voluta::${name} ALIAS voluta_${name})
  target_include_directories(voluta_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/core>
    $<INSTALL_INTERFACE:include/voluta>)
  target_compile_features(voluta_${name} PUBLIC cxx_std_20)
  target_link_libraries(voluta_${name} PUBLIC ${ARG_LINK}
    PRIVATE $<BUILD_INTERFACE:voluta_flags> ${ARG_PRIVATE_LINK})
  target_precompile_headers(voluta_${name} REUSE_FROM voluta_headers_core)
  set_target_properties(voluta_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS voluta_${name} EXPORT Voluta ARCHIVE DESTINATION lib/voluta)
endfunction()

# voluta_test(NAME [QT] SOURCES a.cpp ... LINK voluta::geometry ... SLOW Suite.Case ...): bin/test_NAME, one
# ctest a case. QT: what it links has Qt in it. SLOW: cases (or patterns of gtest) that get the label
# slow; all others are fast.
function(voluta_test name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINK;SLOW" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE ${ARG_LINK} voluta_flags GTest::gtest_main GTest::gmock)
  if(ARG_QT)
    target_precompile_headers(test_${name} REUSE_FROM voluta_headers_qt_test)
  else()
    target_precompile_headers(test_${name} REUSE_FROM voluta_headers_test)
  endif()
  list(JOIN ARG_SLOW ":" slow)
  set(fast "*")
  if(slow)
    set(fast "-${slow}")
    gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 TEST_FILTER ${slow}
      PROPERTIES TIMEOUT 600 LABELS slow)
    # A case that was renamed would be fast unnoticed.
    add_test(NAME slow_cases_of_${name} COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:test_${name}>
      -D PATTERNS=${slow} -P ${CMAKE_SOURCE_DIR}/cmake/slow_cases.cmake)
    set_tests_properties(slow_cases_of_${name} PROPERTIES TIMEOUT 120 LABELS fast)
  endif()
  gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 TEST_FILTER ${fast}
    PROPERTIES TIMEOUT 600 LABELS fast)
endfunction()
