# Headers of others that most files include, parsed once. Half of the time of a compilation goes into them. A build with
# them does not notice when a file of ours forgets one, so the builds that are released and checked do without.
set(RAYSCOPE_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <fmt/format.h> <functional> <glm/glm.hpp> <limits> <map> <memory> <numbers>
  <optional> <random> <span> <string> <string_view> <vector>)

# Whoever shares them has to be compiled alike.
if(RAYSCOPE_PRECOMPILE)
  add_compile_options(-pthread)
endif()

# rayscope_precompiled_headers(NAME KIND library|program HEADERS… LINK targets…): what rayscope_precompile() offers under
# this name. Libraries and programs are compiled for different places in memory.
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

function(rayscope_precompile target name)
  if(RAYSCOPE_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
