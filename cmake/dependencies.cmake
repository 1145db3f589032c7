# Everything comes from the distribution or a package manager; nothing is vendored or downloaded.
include(libraries)
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
find_package(embree 3 QUIET)
rayscope_find_libraries()
# For --version.
set(RAYSCOPE_LIBRARIES "fmt ${fmt_VERSION}" "GLM ${glm_VERSION}" "JSON for Modern C++ ${nlohmann_json_VERSION}"
  "libjpeg ${jpeg_VERSION}" "libpng ${png_VERSION}" "oneTBB ${TBB_VERSION}" "OpenEXR ${exr_VERSION}"
  "tinyobjloader ${tinyobjloader_VERSION}" "toml++ ${toml_VERSION}" "zlib ${ZLIB_VERSION_STRING}")
if(embree_FOUND)
  list(APPEND RAYSCOPE_LIBRARIES "Embree ${embree_VERSION}")
endif()

if(RAYSCOPE_VIEWER)
  find_package(glfw3 3.3 REQUIRED)
  rayscope_library(epoxy epoxy)
  rayscope_library(imgui imgui imgui imgui::imgui)
  list(APPEND RAYSCOPE_LIBRARIES "Dear ImGui ${imgui_VERSION}" "GLFW ${glfw3_VERSION}" "libepoxy ${epoxy_VERSION}")
endif()

if(RAYSCOPE_TESTS)
  find_package(GTest REQUIRED)
  rayscope_library(stb stb)
endif()
if(RAYSCOPE_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
