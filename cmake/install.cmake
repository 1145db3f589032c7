# What is installed, in two components: `program`, and `development` for outside projects, which write find_package(rayscope)
# and link rayscope::rayscope. No installed file names a folder of the build, so an installation may be moved.
include(CMakePackageConfigHelpers)
target_compile_features(rayscope PUBLIC cxx_std_20)
target_include_directories(rayscope PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(rayscope PUBLIC glm::glm PRIVATE fmt::fmt)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rayscope)
install(TARGETS rayscope EXPORT rayscopeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY include/rayscope DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT rayscopeTargets NAMESPACE rayscope:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(cmake/rayscopeConfig.cmake.in ${PROJECT_BINARY_DIR}/rayscopeConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rayscopeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rayscopeConfig.cmake ${PROJECT_BINARY_DIR}/rayscopeConfigVersion.cmake
              cmake/libraries.cmake
  DESTINATION ${package_folder} COMPONENT development)

install(TARGETS rayscope_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
set(data_folder ${CMAKE_INSTALL_DATADIR}/rayscope)
# Fetched meshes belong to the user who fetched them.
install(DIRECTORY scenes DESTINATION ${data_folder} COMPONENT program PATTERN meshes EXCLUDE)
install(PROGRAMS scripts/fetch_dragon.sh DESTINATION ${data_folder}/scripts COMPONENT program)
install(FILES scripts/reduce_mesh.mjs DESTINATION ${data_folder}/scripts COMPONENT program)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
if(RAYSCOPE_VIEWER)
  install(FILES packaging/rayscope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
  install(FILES packaging/rayscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
  install(FILES packaging/rayscope.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT program)
  install(FILES packaging/org.rayscope.rayscope.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT program)
endif()

# rayscope_printed(FILE FOLDER ARGUMENTS…): installs in FOLDER what the program prints with these arguments.
function(rayscope_printed file folder)
  set(output ${PROJECT_BINARY_DIR}/generated/printed/${file})
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/generated/printed
    COMMAND rayscope_program ${ARGN} > ${output}
    DEPENDS rayscope_program)
  set_property(GLOBAL APPEND PROPERTY RAYSCOPE_PRINTED ${output})
  install(FILES ${output} DESTINATION ${folder} COMPONENT program)
endfunction()
# A program for another system does not run here.
if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  rayscope_printed(rayscope.1 ${CMAKE_INSTALL_MANDIR}/man1 manual)
  rayscope_printed(rayscope ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completions bash)
  rayscope_printed(rayscope.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d completions fish)
  rayscope_printed(_rayscope ${CMAKE_INSTALL_DATADIR}/zsh/site-functions completions zsh)
  get_property(printed GLOBAL PROPERTY RAYSCOPE_PRINTED)
  add_custom_target(rayscope_printed ALL DEPENDS ${printed})
endif()
