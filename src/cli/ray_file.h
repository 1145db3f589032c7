#pragma once
#include <rayscope/ray.h>
#include <cstdint>
#include <string>
#include <vector>

#include "base/read_file.h"

namespace rayscope::cli {

/// A file of rays, read in steps: 8 little-endian float32 per ray, origin xyz, direction xyz, tMin, tMax.
class RayFile {
  public:
    /// Rays per step at most: 32 MiB.
    static constexpr std::size_t kRaysPerStep = std::size_t{1} << 20;

    /// Throws InputError with the path and the reason, as next() does.
    explicit RayFile(const std::string& path);

    /// Reads up to `most` rays, fewer at the end of the file. Returns false if there are none.
    bool next(std::vector<Ray>& rays, std::size_t most = kRaysPerStep);

  private:
    [[noreturn]] void throwMalformed(std::uintmax_t size) const;

    std::string path_;
    base::FilePointer file_;
    std::size_t step_ = kRaysPerStep;  ///< fewer for a smaller file
    std::uintmax_t read_ = 0;
};

}  // namespace rayscope::cli
