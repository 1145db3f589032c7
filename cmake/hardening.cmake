# What limits the damage of an error of memory access: release builds check the stack and the sizes of known buffers, and the
# linker makes the program position independent and its tables of addresses read-only. The presets for tests define
# _GLIBCXX_ASSERTIONS instead, so that the standard library checks indices, iterators and empty containers.
option(RAYSCOPE_HARDEN "Harden builds that are optimised for users" ON)
if(NOT RAYSCOPE_HARDEN OR RAYSCOPE_SANITIZE)
  return()
endif()

include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)

# Level 3 needs sizes that are known at run time, which GCC computes since 12; the C library warns if they are missing.
set(fortify 3)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
  set(fortify 2)
endif()
set(hardening -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=${fortify})
include(CheckCXXCompilerFlag)
foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection)
  string(MAKE_C_IDENTIFIER "RAYSCOPE_HAS${flag}" supported)
  check_cxx_compiler_flag(${flag} ${supported})
  if(${supported})
    list(APPEND hardening ${flag})
  endif()
endforeach()
target_compile_options(rayscope_options INTERFACE "$<$<NOT:$<CONFIG:Debug>>:${hardening}>")

include(CheckLinkerFlag)
foreach(flag -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
  string(MAKE_C_IDENTIFIER "RAYSCOPE_HAS${flag}" supported)
  check_linker_flag(CXX ${flag} ${supported})
  if(${supported})
    target_link_options(rayscope_options INTERFACE $<$<NOT:$<CONFIG:Debug>>:${flag}>)
  endif()
endforeach()
