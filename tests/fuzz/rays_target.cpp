#include <rayscope/accel.h>
#include <rayscope/diagnostics.h>

#include <cstring>
#include <vector>

#include "bvh/isa.h"
#include "bvh/traversal/traverse.h"
#include "cli/ray_file.h"
#include "fuzz/memory_file.h"

namespace rayscope::test {

namespace {

/// A sheet of triangles that share edges, some folded and some without area, and spheres that touch them.
struct Geometry {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    std::vector<Sphere> spheres;

    Geometry() {
        constexpr std::uint32_t kSide = 5;
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x < kSide; ++x)
                vertices.emplace_back(static_cast<float>(x), static_cast<float>(y),
                                      static_cast<float>((x * 7 + y * 3) % 4) * 0.25f);
        for (std::uint32_t y = 0; y + 1 < kSide; ++y)
            for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
                const std::uint32_t corner = y * kSide + x;
                triangles.emplace_back(corner, corner + 1, corner + kSide);
                triangles.emplace_back(corner + 1, corner + kSide + 1, corner + kSide);
            }
        triangles.emplace_back(0, 0, 7);
        triangles.emplace_back(0, 1, 2);
        for (int i = 0; i < 5; ++i)
            spheres.push_back({{static_cast<float>(i), 2.0f, 0.5f}, 0.25f * static_cast<float>(i)});
    }

    AccelInput input() const { return {vertices, triangles, spheres}; }
};

const Geometry& geometry() {
    static const Geometry made;
    return made;
}

const std::vector<Accel>& accels() {
    static const std::vector<Accel> built = [] {
        std::vector<Accel> all;
        BuildSettings settings;
        for (const Isa isa : {Isa::Scalar, Isa::Sse2, Isa::Avx2, Isa::Avx512}) {
            settings.isa = isa;
            if (bvh::isAvailable(isa)) all.push_back(Accel::build(geometry().input(), settings));
        }
        settings = {};
        settings.layout = BvhLayout::Binary;
        all.push_back(Accel::build(geometry().input(), settings));
        return all;
    }();
    return built;
}

bool isSame(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

/// All layouts and instruction sets answer like brute force, one by one and in a batch.
void checkQueries(const std::vector<Ray>& rays) {
    std::vector<Hit> expected(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        bvh::closestHitBruteForce(geometry().input(), rays[i], expected[i]);
    for (const Accel& accel : accels()) {
        std::vector<Hit> hits(rays.size());
        std::vector<std::uint8_t> occluded(rays.size());
        accel.closestHits(rays, hits);
        accel.anyHits(rays, occluded);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool isHit = expected[i].primitive != kNoPrimitive;
            Hit single;
            require(accel.closestHit(rays[i], single) == isHit, "a query tells whether there is a hit");
            require(isSame(single, expected[i]), "a query finds the closest hit");
            require(isSame(hits[i], expected[i]), "a batch finds the closest hits");
            require(accel.anyHit(rays[i]) == isHit, "an any-hit query finds a hit");
            require(occluded[i] == static_cast<std::uint8_t>(isHit), "a batch finds any hits");
        }
    }
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (expected[i].primitive != kNoPrimitive)
            require(expected[i].t > std::max(rays[i].tMin, 0.0f) && expected[i].t <= rays[i].tMax,
                    "a hit lies in the interval of its ray");
}

}  // namespace

/// Any bytes are a ray file whose rays have the same hits in every layout, or are refused with InputError.
bool fuzzRays(FuzzInput input) {
    constexpr std::size_t kLargest = 1 << 12;
    if (input.size() > kLargest) return false;
    static const MemoryFile path("rays");
    try {
        cli::RayFile file(path.write(input));
        std::vector<Ray> rays, all;
        while (file.next(rays)) all.insert(all.end(), rays.begin(), rays.end());
        require(all.size() * sizeof(Ray) == input.size(), "all rays of a file are read");
        checkQueries(all);
    } catch (const InputError&) {
    }
    return true;
}

}  // namespace rayscope::test
