# Language level, warnings, floating-point rules, linker and compiler cache, which all targets share.
add_library(rayscope_options INTERFACE)
target_compile_features(rayscope_options INTERFACE cxx_std_20)
target_compile_options(rayscope_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow
  # Without this, two instantiations of a template could differ in bits, because the compiler fuses a*b+c in one of them.
  -ffp-contract=off)
# False alarms of GCC 12 inside std::string: overlapping copies in a concatenation and impossible lengths (GCC bugs 105651 and
# 105329) and, if <string> comes from a precompiled header, accesses beyond the end of a short string.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(rayscope_options INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread $<$<BOOL:${RAYSCOPE_PRECOMPILE}>:-Wno-array-bounds>)
endif()
if(RAYSCOPE_WERROR)
  target_compile_options(rayscope_options INTERFACE -Werror)
endif()
if(RAYSCOPE_SANITIZE)
  target_compile_options(rayscope_options INTERFACE -fsanitize=${RAYSCOPE_SANITIZE} -fno-omit-frame-pointer
                                                    -fno-sanitize-recover=all)
  target_link_options(rayscope_options INTERFACE -fsanitize=${RAYSCOPE_SANITIZE})
endif()
if(RAYSCOPE_FUZZ)
  target_compile_options(rayscope_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# The first of these linkers that is installed and supported by the compiler.
include(CheckLinkerFlag)
set(RAYSCOPE_LINKER "" CACHE STRING "Linker: mold, lld, default; empty chooses")
foreach(linker mold lld)
  if(NOT RAYSCOPE_LINKER)
    check_linker_flag(CXX -fuse-ld=${linker} RAYSCOPE_HAS_${linker})
    if(RAYSCOPE_HAS_${linker})
      set(RAYSCOPE_LINKER ${linker})
    endif()
  endif()
endforeach()
if(RAYSCOPE_LINKER AND NOT RAYSCOPE_LINKER STREQUAL "default")
  add_link_options(-fuse-ld=${RAYSCOPE_LINKER})
endif()

find_program(RAYSCOPE_CCACHE ccache)
if(RAYSCOPE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${RAYSCOPE_CCACHE})
  # ccache caches files with precompiled headers only with these settings.
  if(RAYSCOPE_PRECOMPILE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${RAYSCOPE_CCACHE})
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endif()
