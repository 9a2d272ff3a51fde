# voluta_module(NAME SOURCES a.cpp ... LINK voluta::base ... PRIVATE_LINK lib ...)
# A static library voluta_NAME (alias voluta::NAME) whose headers are included as "NAME/file.h".
# Third-party headers count as system headers, so that only our own code is held to the warnings.
function(voluta_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(voluta_${name} STATIC ${ARG_SOURCES})
  add_library(voluta::${name} ALIAS voluta_${name})
  target_include_directories(voluta_${name} PUBLIC ${CMAKE_SOURCE_DIR}/core)
  target_link_libraries(voluta_${name} PUBLIC ${ARG_LINK} PRIVATE voluta_flags ${ARG_PRIVATE_LINK})
  target_precompile_headers(voluta_${name} REUSE_FROM voluta_headers_core)
endfunction()

# voluta_test(NAME [QT] SOURCES a.cpp ... LINK voluta::geometry ...): bin/test_NAME, one ctest a
# case. QT: what it links has Qt in it.
function(voluta_test name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE ${ARG_LINK} voluta_flags GTest::gtest_main GTest::gmock)
  if(ARG_QT)
    target_precompile_headers(test_${name} REUSE_FROM voluta_headers_qt_test)
  else()
    target_precompile_headers(test_${name} REUSE_FROM voluta_headers_test)
  endif()
  gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600)
endfunction()
