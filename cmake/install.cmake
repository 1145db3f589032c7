# An outside project writes find_package(rayscope) and links rayscope::rayscope.
include(CMakePackageConfigHelpers)
target_compile_features(rayscope PUBLIC cxx_std_20)
target_include_directories(rayscope PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(rayscope PUBLIC glm::glm PRIVATE fmt::fmt)

install(TARGETS rayscope EXPORT rayscopeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS rayscope_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/rayscope DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT rayscopeTargets NAMESPACE rayscope:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rayscope)
configure_package_config_file(cmake/rayscopeConfig.cmake.in ${PROJECT_BINARY_DIR}/rayscopeConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rayscope)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rayscopeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rayscopeConfig.cmake ${PROJECT_BINARY_DIR}/rayscopeConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rayscope)
