# Unity builds: with RAYSCOPE_UNITY, the compiler reads several source files of a module or of a test program at a time,
# because headers take most of the time of a compilation. Such files share their anonymous namespaces, so names in them are
# unique within a module, except for overloads (style.names). The presets `dev` and `plain` compile every file alone.
set(RAYSCOPE_UNITY_BATCH 8)

# rayscope_batch(RESULT NAME SOURCES files…): RESULT becomes the list of files, with the .cpp files replaced
# by generated files NAME_0.cpp … that include up to RAYSCOPE_UNITY_BATCH of them each. Files with options of their own
# (COMPILE_OPTIONS), or with SKIP_UNITY_BUILD_INCLUSION, stay in the list.
function(rayscope_batch result name)
  cmake_parse_arguments(BATCH "" "" "SOURCES" ${ARGN})
  set(batched "")
  foreach(source IN LISTS BATCH_SOURCES)
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(source MATCHES "\\.cpp$" AND NOT options AND NOT alone)
      list(APPEND batched ${source})
    endif()
  endforeach()
  list(LENGTH batched count)
  if(NOT RAYSCOPE_UNITY OR count LESS 2)
    set(${result} ${BATCH_SOURCES} PARENT_SCOPE)
    return()
  endif()
  list(REMOVE_ITEM BATCH_SOURCES ${batched})
  math(EXPR batches "(${count} + ${RAYSCOPE_UNITY_BATCH} - 1) / ${RAYSCOPE_UNITY_BATCH}")
  math(EXPR last "${batches} - 1")
  foreach(number RANGE ${last})
    math(EXPR begin "${number} * ${count} / ${batches}")
    math(EXPR size "(${number} + 1) * ${count} / ${batches} - ${begin}")
    list(SUBLIST batched ${begin} ${size} sources)
    set(content "")
    foreach(source IN LISTS sources)
      get_filename_component(path ${source} ABSOLUTE)
      string(APPEND content "#include \"${path}\"\n")
    endforeach()
    set(batch ${CMAKE_CURRENT_BINARY_DIR}/${name}_${number}.cpp)
    file(GENERATE OUTPUT ${batch} CONTENT "${content}")
    # In a batch, a local name may be that of another file, and a type in a file seems to be one in a header.
    set_source_files_properties(${batch} PROPERTIES COMPILE_OPTIONS
      "-Wno-shadow;$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>")
    list(APPEND BATCH_SOURCES ${batch})
  endforeach()
  set(${result} ${BATCH_SOURCES} PARENT_SCOPE)
endfunction()
