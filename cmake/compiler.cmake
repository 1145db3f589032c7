# Language level, warnings and floating-point rules that every module shares.
add_library(rayscope_options INTERFACE)
target_compile_features(rayscope_options INTERFACE cxx_std_20)
target_compile_options(rayscope_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow
  # Two instantiations of one template give the same bits only if the compiler never fuses a*b+c on its own.
  -ffp-contract=off)
# GCC 12 sees overlapping copies in plain std::string concatenation (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(rayscope_options INTERFACE -Wno-restrict)
endif()
if(RAYSCOPE_WERROR)
  target_compile_options(rayscope_options INTERFACE -Werror)
endif()
if(RAYSCOPE_SANITIZE)
  target_compile_options(rayscope_options INTERFACE -fsanitize=${RAYSCOPE_SANITIZE} -fno-omit-frame-pointer
                                                    -fno-sanitize-recover=all)
  target_link_options(rayscope_options INTERFACE -fsanitize=${RAYSCOPE_SANITIZE})
endif()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(RAYSCOPE_CCACHE ccache)
if(RAYSCOPE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${RAYSCOPE_CCACHE})
  # Without this leave it does not keep what was compiled with precompiled headers.
  if(RAYSCOPE_PRECOMPILE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${RAYSCOPE_CCACHE})
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endif()
