set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

option(VOLUTA_WERROR "Treat warnings as errors" ON)
set(VOLUTA_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")

find_program(VOLUTA_CCACHE ccache)
if(VOLUTA_CCACHE)
  # Without these it keeps nothing of what a precompiled header goes into.
  set(VOLUTA_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${VOLUTA_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${VOLUTA_LAUNCHER})
  set(CMAKE_C_COMPILER_LAUNCHER ${VOLUTA_LAUNCHER})
endif()
find_program(VOLUTA_MOLD mold)
if(VOLUTA_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

add_library(voluta_flags INTERFACE)
target_compile_options(voluta_flags INTERFACE -Wall -Wextra -Wnon-virtual-dtor)
if(NOT VOLUTA_UNITY)
  target_compile_options(voluta_flags INTERFACE -Wshadow)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # There a local name of one source may be a name at file scope of another, and GCC takes every source
  # for a header. By default it frees memory late on a machine that has much.
  target_compile_options(voluta_flags INTERFACE -Wno-subobject-linkage
    --param=ggc-min-expand=50 --param=ggc-min-heapsize=524288)
endif()
# Behind a precompiled header GCC 12 warns of the insides of the standard library's strings, where
# nothing is wrong (its bugs 105329, 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(voluta_flags INTERFACE -Wno-array-bounds -Wno-restrict
    -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# GCC 14 does not see that Eigen initialises vectors with a largest size.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  target_compile_options(voluta_flags INTERFACE -Wno-maybe-uninitialized)
endif()
if(VOLUTA_WERROR)
  target_compile_options(voluta_flags INTERFACE -Werror)
endif()
# The same sums on every machine: no contraction into fused multiply-adds.
target_compile_options(voluta_flags INTERFACE -ffp-contract=off)
if(VOLUTA_SANITIZE)
  # GCC takes what the sanitizers add for uses of what is not set.
  add_compile_options(-fsanitize=${VOLUTA_SANITIZE} -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${VOLUTA_SANITIZE})
  # Eigen keeps memory aligned in a way of its own where it sees the address sanitizer; OMPL was
  # built without, and frees what ours has taken.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()

# voluta_heavy_templates(FILE ...): files that are little else than calls of large template libraries.
# Each is compiled alone, and its compiler is short of memory rather than of time. A sanitizer would find
# nothing of ours in them and take many minutes to build them.
function(voluta_heavy_templates)
  set(options "--param=ggc-min-expand=20;--param=ggc-min-heapsize=65536")
  if(VOLUTA_SANITIZE)
    set(options "-fno-sanitize=all;-O1")
  elseif(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${options}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()
