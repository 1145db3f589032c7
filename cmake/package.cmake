# Debian packages by CPack: rayscope (component `program`) and librayscope-dev (component `development`). scripts/package.sh
# builds them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rayscope)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "interactive ray tracer that shows how each pixel is computed")
set(CPACK_PACKAGE_VENDOR "The Rayscope authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake)
# Read by that script.
set(CPACK_RAYSCOPE_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_RAYSCOPE_STRIP ${CMAKE_STRIP})

set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Rayscope authors <rayscope@rayscope.invalid>" CACHE STRING "Maintainer of the packages")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE rayscope)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(about "Rayscope renders a scene on all cores while you move through it, and records
the ray tree of any pixel that you select: every ray, its hit, and its
contribution to the colour of the pixel. It is for people who learn, teach
and debug ray tracing.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME rayscope)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# What `rayscope fetch` runs.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "npm, nodejs")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${about}")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librayscope-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What the static library is linked with.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libfmt-dev, libglm-dev, libjpeg-dev, libopenexr-dev, libpng-dev, libtbb-dev, libtinyobjloader-dev, libtomlplusplus-dev, nlohmann-json3-dev, pkg-config, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${about}
.
This package holds the static library, its headers and the CMake package.")
include(CPack)
