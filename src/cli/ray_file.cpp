#include "cli/ray_file.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace rayscope::cli {

// The records of the file have the memory layout of the struct.
static_assert(sizeof(Ray) == 32 && offsetof(Ray, direction) == 12 && offsetof(Ray, tMin) == 24);
static_assert(std::endian::native == std::endian::little, "ray files are little-endian");

RayFile::RayFile(const std::string& path) : path_(path), file_(base::openForReading(path)) {
    std::error_code unknownSize;
    const auto size = std::filesystem::file_size(path, unknownSize);
    if (unknownSize) return;
    if (size % sizeof(Ray) != 0) throwMalformed(size);
    step_ = static_cast<std::size_t>(std::clamp<std::uintmax_t>(size / sizeof(Ray), 1, kRaysPerStep));
}

bool RayFile::next(std::vector<Ray>& rays, std::size_t most) {
    const std::size_t count = std::min(step_, most);
    rays.resize(count);
    const std::size_t bytes =
        base::readBytes(file_.get(), path_, reinterpret_cast<char*>(rays.data()), count * sizeof(Ray));
    read_ += bytes;
    if (bytes % sizeof(Ray) != 0) throwMalformed(read_);
    rays.resize(bytes / sizeof(Ray));
    return !rays.empty();
}

void RayFile::throwMalformed(std::uintmax_t size) const {
    throw InputError(
        fmt::format("not a ray file: its size of {} bytes is not a multiple of 32 (8 little-endian "
                    "float32: origin xyz, direction xyz, tMin, tMax)",
                    size),
        {path_});
}

}  // namespace rayscope::cli
