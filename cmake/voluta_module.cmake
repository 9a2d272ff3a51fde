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
  install(TARGETS voluta_${name} EXPORT Voluta ARCHIVE DESTINATION lib/voluta COMPONENT development)
endfunction()

# voluta_test(NAME [QT] SOURCES a_test.cpp ... LINK voluta::geometry ... SLOW a_test.cpp ...): bin/test_NAME,
# and an entry of ctest for each source with tests, NAME.a, so that what the cases of a source share is
# made once. bin/test_NAME --gtest_filter=Suite.Case runs one case. QT: what it links has Qt in it. SLOW:
# sources that take more than ten seconds; they get the label slow, all others fast.
function(voluta_test name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINK;SLOW" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE ${ARG_LINK} voluta_flags voluta_test_main)
  if(ARG_QT)
    target_precompile_headers(test_${name} REUSE_FROM voluta_headers_qt_test)
  else()
    target_precompile_headers(test_${name} REUSE_FROM voluta_headers_test)
  endif()
  foreach(source IN LISTS ARG_SLOW)
    if(NOT source IN_LIST ARG_SOURCES)
      message(FATAL_ERROR "${source} is slow, but no source of test_${name}")
    endif()
  endforeach()
  foreach(source IN LISTS ARG_SOURCES)
    if(source MATCHES "^([^/]*)_test\\.cpp$")
      voluta_add_test(${name}.${CMAKE_MATCH_1} "${ARG_SLOW}" ${source} $<TARGET_FILE:test_${name}>)
    endif()
  endforeach()
endfunction()

# voluta_add_test(ENTRY "a_test.cpp ..." SOURCE COMMAND ...): the entry of ctest for the cases of SOURCE,
# slow if it is in the list. Slow ones start first, so that none is left alone at the end.
function(voluta_add_test entry slow source)
  add_test(NAME ${entry} COMMAND ${ARGN} --source=${source})
  set_tests_properties(${entry} PROPERTIES TIMEOUT 1800)
  if(source IN_LIST slow)
    set_tests_properties(${entry} PROPERTIES LABELS slow COST 100)
  else()
    set_tests_properties(${entry} PROPERTIES LABELS fast)
  endif()
endfunction()
