# cmake -D PROGRAM=bin/test_NAME -D PATTERNS=A.B:C.* -P slow_cases.cmake: fails unless every pattern names a
# case of the program.
string(REPLACE ":" ";" patterns "${PATTERNS}")
foreach(pattern IN LISTS patterns)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${pattern}
    OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
  if(NOT listed MATCHES "\n  ")
    message(SEND_ERROR "no case is named ${pattern}: correct SLOW in the CMakeLists.txt of its tests")
  endif()
endforeach()
