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
  set(CMAKE_CXX_COMPILER_LAUNCHER ${VOLUTA_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${VOLUTA_CCACHE})
endif()
find_program(VOLUTA_MOLD mold)
if(VOLUTA_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

add_library(voluta_flags INTERFACE)
target_compile_options(voluta_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
if(VOLUTA_WERROR)
  target_compile_options(voluta_flags INTERFACE -Werror)
endif()
# The same sums on every machine: no contraction into fused multiply-adds.
target_compile_options(voluta_flags INTERFACE -ffp-contract=off)
if(VOLUTA_SANITIZE)
  # GCC takes what the sanitizers add for uses of what is not set.
  add_compile_options(-fsanitize=${VOLUTA_SANITIZE} -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  add_link_options(-fsanitize=${VOLUTA_SANITIZE})
endif()
