# The modules of src/, lowest first. A module includes modules before it in this list and no others.
set(RAYSCOPE_LIBRARY_MODULES base math image settings scene bvh sampling shading trace render post probe measure)
set(RAYSCOPE_PROGRAM_MODULES cli)
if(RAYSCOPE_VIEWER)
  list(PREPEND RAYSCOPE_PROGRAM_MODULES viewer)
endif()

# rayscope_module(NAME SOURCES a.cpp b.h … [PUBLIC_HEADERS accel.h …] [USES modules…] [FOLDERS folders…]
#                 [NOT_HOT sources or folders…] [PRECOMPILE headers…] [TRACES] [LINK targets…])
# One folder of src/ as an object library.
#   USES            the modules whose headers it includes
#   PUBLIC_HEADERS  the files of include/rayscope/ that it implements
#   FOLDERS         its folders, lowest first: a file includes its own folder, those before it in the list, and the files
#                   beside the folders; only the files beside the folders include all of them
#   NOT_HOT         what does not limit the speed of the program: compiled with -O1 in a release build. Sources, folders, or
#                   "." for the files beside the folders
#   PRECOMPILE      headers that most of its files include, beside the common ones
#   TRACES          limits the speed of tracing: the files that are not NOT_HOT are compiled one by one in a release build
#   LINK            third-party targets
function(rayscope_module name)
  cmake_parse_arguments(MODULE "TRACES" "" "SOURCES;PUBLIC_HEADERS;USES;FOLDERS;NOT_HOT;PRECOMPILE;LINK" ${ARGN})
  set(order ${RAYSCOPE_LIBRARY_MODULES} ${RAYSCOPE_PROGRAM_MODULES})
  list(FIND order ${name} own)
  foreach(used IN LISTS MODULE_USES)
    list(FIND order ${used} below)
    if(below LESS 0 OR NOT below LESS own)
      message(FATAL_ERROR "Module '${name}' may not use '${used}': dependencies point down the list in cmake/modules.cmake")
    endif()
  endforeach()

  set(hot "")
  set(not_hot "")
  foreach(source IN LISTS MODULE_SOURCES)
    get_filename_component(folder ./${source} DIRECTORY)
    string(REGEX REPLACE "^\\./" "" folder ${folder})
    if(source MATCHES "\\.cpp$" AND (source IN_LIST MODULE_NOT_HOT OR folder IN_LIST MODULE_NOT_HOT))
      list(APPEND not_hot ${source})
    else()
      list(APPEND hot ${source})
    endif()
  endforeach()
  rayscope_batch(not_hot ${name}_not_hot_batch SOURCES ${not_hot})
  # Inlining depends on what else is in a file.
  if(NOT MODULE_TRACES OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    rayscope_batch(hot ${name}_batch SOURCES ${hot})
  endif()
  set_property(SOURCE ${not_hot} APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
  add_library(rayscope_${name} OBJECT ${hot} ${not_hot})
  target_include_directories(rayscope_${name} PUBLIC
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(rayscope_${name} PUBLIC rayscope_options ${RAYSCOPE_COMMON_LIBRARIES} ${MODULE_LINK})
  rayscope_precompile(rayscope_${name} rayscope_common_headers ${MODULE_PRECOMPILE})
  set_property(GLOBAL PROPERTY RAYSCOPE_USES_${name} ${MODULE_USES})
  set_property(GLOBAL PROPERTY RAYSCOPE_PUBLIC_HEADERS_${name} ${MODULE_PUBLIC_HEADERS})
  set_property(GLOBAL PROPERTY RAYSCOPE_FOLDERS_${name} ${MODULE_FOLDERS})
  if(name IN_LIST RAYSCOPE_LIBRARY_MODULES)
    target_sources(rayscope PRIVATE $<TARGET_OBJECTS:rayscope_${name}>)
    target_link_libraries(rayscope PRIVATE $<BUILD_INTERFACE:rayscope_options> ${MODULE_LINK})
  else()
    target_sources(rayscope_program PRIVATE $<TARGET_OBJECTS:rayscope_${name}>)
    target_link_libraries(rayscope_program PRIVATE ${MODULE_LINK})
  endif()
endfunction()

# Stops the configuration if an #include of a module violates the order of the list.
function(rayscope_check_layering)
  set(order ${RAYSCOPE_LIBRARY_MODULES} ${RAYSCOPE_PROGRAM_MODULES})
  set(lines "")
  foreach(module IN LISTS order)
    if(NOT TARGET rayscope_${module})
      continue()
    endif()
    get_property(uses GLOBAL PROPERTY RAYSCOPE_USES_${module})
    get_property(headers GLOBAL PROPERTY RAYSCOPE_PUBLIC_HEADERS_${module})
    get_property(folders GLOBAL PROPERTY RAYSCOPE_FOLDERS_${module})
    list(JOIN uses "," uses)
    list(JOIN headers "," headers)
    list(JOIN folders "," folders)
    string(APPEND lines "${module}|${uses}|${headers}|${folders}\n")
  endforeach()
  file(WRITE ${PROJECT_BINARY_DIR}/modules.txt "${lines}")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DMODULES=${PROJECT_BINARY_DIR}/modules.txt -DSOURCE=${PROJECT_SOURCE_DIR}
            -P ${PROJECT_SOURCE_DIR}/cmake/check_layering.cmake
    RESULT_VARIABLE failed ERROR_VARIABLE why)
  if(failed)
    message(FATAL_ERROR "${why}")
  endif()
endfunction()
