# rayscope_embed(TARGET HEADER NAMESPACE files…): compiles text files into the binary.
# The generated header declares, in namespace rayscope::NAMESPACE, `std::span<const EmbeddedFile> files()`.
function(rayscope_embed target header namespace)
  set(output ${PROJECT_BINARY_DIR}/generated/${header})
  string(REPLACE ".h" ".cpp" source ${output})
  list(JOIN ARGN "|" files)
  add_custom_command(
    OUTPUT ${output} ${source}
    COMMAND ${CMAKE_COMMAND} -DHEADER=${output} -DSOURCE=${source} -DINCLUDE=${header} -DNAMESPACE=${namespace}
            "-DFILES=${files}" -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${source} ${output})
endfunction()
