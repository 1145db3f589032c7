# Libraries that have a pkg-config module on some systems and a CMake package on others. The installed package includes this
# file too.

# rayscope_library(NAME MODULE [PACKAGE TARGET]): makes the imported target rayscope_external::NAME from the pkg-config module
# or, where there is none, from a target of the CMake package. Sets NAME_VERSION.
function(rayscope_library name module)
  find_package(PkgConfig QUIET)
  set(found FALSE)
  if(PkgConfig_FOUND)
    pkg_check_modules(RAYSCOPE_${module} QUIET IMPORTED_TARGET ${module})
    set(found ${RAYSCOPE_${module}_FOUND})
  endif()
  if(found)
    set(target PkgConfig::RAYSCOPE_${module})
    set(version ${RAYSCOPE_${module}_VERSION})
  elseif(ARGC EQUAL 4)
    find_package(${ARGV2} REQUIRED)
    set(target ${ARGV3})
    set(version ${${ARGV2}_VERSION})
  else()
    message(FATAL_ERROR "pkg-config does not find '${module}': install pkg-config and the development files of ${name}")
  endif()
  if(NOT TARGET rayscope_external::${name})
    add_library(rayscope_external::${name} INTERFACE IMPORTED)
    target_link_libraries(rayscope_external::${name} INTERFACE ${target})
  endif()
  set(${name}_VERSION "${version}" PARENT_SCOPE)
endfunction()

# What the library is linked with.
macro(rayscope_find_libraries)
  rayscope_library(toml tomlplusplus tomlplusplus tomlplusplus::tomlplusplus)
  rayscope_library(png libpng PNG PNG::PNG)
  rayscope_library(jpeg libjpeg JPEG JPEG::JPEG)
  rayscope_library(exr OpenEXR OpenEXR OpenEXR::OpenEXR)
endmacro()
