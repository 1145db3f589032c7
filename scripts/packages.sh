# shellcheck shell=bash disable=SC2034
# The distribution packages that Rayscope is built from, by their names in Debian and Ubuntu. Sourced.

build_packages=(
    build-essential cmake ninja-build pkg-config
    libglm-dev libfmt-dev libtbb-dev                               # numbers, text, threads
    libtomlplusplus-dev libtinyobjloader-dev                       # scenes, meshes
    libpng-dev libjpeg-dev libopenexr-dev zlib1g-dev               # images
    nlohmann-json3-dev                                             # JSON reports, glTF
    libglfw3-dev libepoxy-dev libimgui-dev                         # window
    fonts-dejavu-core                                              # its font, compiled into the program
)

test_packages=(
    libgtest-dev libgmock-dev clang-format valgrind libstb-dev     # stb is an oracle for image files
    xvfb xdotool x11-utils imagemagick libgl1-mesa-dri python3     # the window on a virtual display
)

# Used if installed; some distributions do not have all of them. Embree and GMP are test oracles, mold links faster,
# universal-ctags measures the length of functions, assimp reads its test models for comparison, and the last line checks the
# packages and the completions.
optional_packages=(
    libembree-dev libbenchmark-dev libgmp-dev mold universal-ctags
    assimp-testmodels assimp-utils
    lintian patchelf openimageio-tools fish zsh debootstrap desktop-file-utils appstream man-db
)

# What scripts/fuzz.sh needs besides build_packages.
fuzz_packages=(clang imagemagick libopenexr-dev python3)

# What scripts/tidy.sh needs besides build_packages.
tidy_packages=(clang clang-tidy)

# What scripts/package.sh needs besides build_packages; lintian and debootstrap check the packages in the tests.
package_packages=(dpkg-dev patchelf)
