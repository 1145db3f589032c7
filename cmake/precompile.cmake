# Precompiled headers: third-party headers that most files include are parsed once, which is half of the time of a
# compilation. A build with them does not detect missing includes; the preset `plain` builds without them.
set(RAYSCOPE_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <fmt/format.h> <functional> <glm/glm.hpp> <limits> <map> <memory> <numbers>
  <optional> <random> <span> <string> <string_view> <tbb/parallel_for.h> <tbb/task_arena.h> <vector>)
# All modules and tests link these, because their definitions (TBB_USE_DEBUG) must agree with the precompiled header.
set(RAYSCOPE_COMMON_LIBRARIES glm::glm fmt::fmt TBB::tbb)

# All files that share a precompiled header need the same options, except for the level of optimization.
if(RAYSCOPE_PRECOMPILE)
  add_compile_options(-pthread)
endif()

# rayscope_precompiled_headers(NAME KIND library|program HEADERS… LINK targets…): headers for rayscope_precompile().
# Libraries and programs differ in their options for position-independent code, so they cannot share one.
function(rayscope_precompiled_headers name)
  cmake_parse_arguments(PCH "" "KIND" "HEADERS;LINK" ${ARGN})
  if(NOT RAYSCOPE_PRECOMPILE)
    return()
  endif()
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "int main() {}\n")
  if(PCH_KIND STREQUAL "program")
    add_executable(${name} EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  else()
    add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  endif()
  target_link_libraries(${name} PRIVATE rayscope_options ${PCH_LINK})
  target_precompile_headers(${name} PRIVATE ${PCH_HEADERS})
endfunction()

# rayscope_precompile(TARGET NAME [headers…]): compiles a target with the headers of that name or, if further headers are
# given, with a precompiled header of its own that holds the common ones and these. Batches (RAYSCOPE_UNITY) are too few for
# one to save what it takes.
function(rayscope_precompile target name)
  if(NOT RAYSCOPE_PRECOMPILE)
    return()
  endif()
  if(ARGN AND NOT RAYSCOPE_UNITY)
    target_precompile_headers(${target} PRIVATE ${RAYSCOPE_COMMON_HEADERS} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
