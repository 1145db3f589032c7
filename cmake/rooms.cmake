# The rooms of the house, from the ground up. A room includes rooms before it in this list and no others.
set(RAYSCOPE_LIBRARY_ROOMS base math image settings scene bvh sampling shading trace render post probe measure)
set(RAYSCOPE_PROGRAM_ROOMS cli)
if(RAYSCOPE_VIEWER)
  list(PREPEND RAYSCOPE_PROGRAM_ROOMS viewer)
endif()

# rayscope_room(NAME SOURCES a.cpp b.h … [PUBLIC_HEADERS accel.h …] [USES rooms…] [LINK targets…])
# One folder of src/, compiled once. USES names the rooms whose headers it includes; PUBLIC_HEADERS are the files of
# include/rayscope/ that this room stands behind; LINK names third-party targets.
function(rayscope_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC_HEADERS;USES;LINK" ${ARGN})
  set(order ${RAYSCOPE_LIBRARY_ROOMS} ${RAYSCOPE_PROGRAM_ROOMS})
  list(FIND order ${name} own)
  foreach(used IN LISTS ROOM_USES)
    list(FIND order ${used} below)
    if(below LESS 0 OR NOT below LESS own)
      message(FATAL_ERROR "Room '${name}' may not use '${used}': dependencies point down the list in cmake/rooms.cmake")
    endif()
  endforeach()

  add_library(rayscope_${name} OBJECT ${ROOM_SOURCES})
  target_include_directories(rayscope_${name} PUBLIC
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(rayscope_${name} PUBLIC rayscope_options glm::glm fmt::fmt ${ROOM_LINK})
  set_property(GLOBAL PROPERTY RAYSCOPE_USES_${name} ${ROOM_USES})
  set_property(GLOBAL PROPERTY RAYSCOPE_PUBLIC_HEADERS_${name} ${ROOM_PUBLIC_HEADERS})
  if(name IN_LIST RAYSCOPE_LIBRARY_ROOMS)
    target_sources(rayscope PRIVATE $<TARGET_OBJECTS:rayscope_${name}>)
    target_link_libraries(rayscope PRIVATE $<BUILD_INTERFACE:rayscope_options> ${ROOM_LINK})
  else()
    target_sources(rayscope_program PRIVATE $<TARGET_OBJECTS:rayscope_${name}>)
    target_link_libraries(rayscope_program PRIVATE ${ROOM_LINK})
  endif()
endfunction()

# Reads every #include of every room and stops the configuration at the first one that points up.
function(rayscope_check_layering)
  set(order ${RAYSCOPE_LIBRARY_ROOMS} ${RAYSCOPE_PROGRAM_ROOMS})
  set(lines "")
  foreach(room IN LISTS order)
    if(NOT TARGET rayscope_${room})
      continue()
    endif()
    get_property(uses GLOBAL PROPERTY RAYSCOPE_USES_${room})
    get_property(headers GLOBAL PROPERTY RAYSCOPE_PUBLIC_HEADERS_${room})
    list(JOIN uses "," uses)
    list(JOIN headers "," headers)
    string(APPEND lines "${room}|${uses}|${headers}\n")
  endforeach()
  file(WRITE ${PROJECT_BINARY_DIR}/rooms.txt "${lines}")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DROOMS=${PROJECT_BINARY_DIR}/rooms.txt -DSOURCE=${PROJECT_SOURCE_DIR}
            -P ${PROJECT_SOURCE_DIR}/cmake/check_layering.cmake
    RESULT_VARIABLE failed ERROR_VARIABLE why)
  if(failed)
    message(FATAL_ERROR "${why}")
  endif()
endfunction()
