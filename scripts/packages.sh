# shellcheck shell=bash disable=SC2034
# The distribution packages that Rayscope is built from, by their names in Debian and Ubuntu. Sourced.

build_packages=(
    build-essential cmake ninja-build pkg-config
    libglm-dev libfmt-dev libtbb-dev                               # numbers, text, threads
    libtomlplusplus-dev libtinyobjloader-dev libstb-dev libopenexr-dev # scenes, meshes, images
    nlohmann-json3-dev                                             # reports
    libglfw3-dev libepoxy-dev libimgui-dev                         # window
)

test_packages=(
    libgtest-dev libgmock-dev clang-format valgrind
    xvfb xdotool x11-utils imagemagick libgl1-mesa-dri python3     # the window on a virtual display
)

# Used if installed; some distributions do not have all of them. Embree and GMP are test oracles, mold links faster, and
# universal-ctags measures the length of functions.
optional_packages=(libembree-dev libbenchmark-dev libgmp-dev mold universal-ctags)
