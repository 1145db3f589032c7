// One triangle, hit in its middle and missed beside it.
#include <rayscope/accel.h>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace {
void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "not so: %s\n", what);
    std::exit(1);
}
}  // namespace

int main() {
    const std::array vertices{glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
    const std::array triangles{glm::uvec3(0, 1, 2)};
    rayscope::AccelInput input;
    input.vertices = std::span<const glm::vec3>{vertices};
    input.triangles = std::span<const glm::uvec3>{triangles};
    const rayscope::Accel accel = rayscope::Accel::build(input, rayscope::BuildSettings{});

    const rayscope::Ray inside{glm::vec3(0.25f, 0.5f, 2.0f), glm::vec3(0, 0, -4), 0.0f, 10.0f};
    const rayscope::Ray beside{glm::vec3(0.75f, 0.5f, 2.0f), glm::vec3(0, 0, -4), 0.0f, 10.0f};
    rayscope::Hit hit;
    require(accel.closestHit(inside, hit), "the ray hits");
    require(hit.primitive == 0 && hit.t == 0.5f, "t counts in lengths of the direction");
    require(hit.u == 0.25f && hit.v == 0.5f, "u and v weigh the second and third vertex");
    require(accel.anyHit(inside) && !accel.anyHit(beside), "any hit agrees");
    require(!accel.closestHit(beside, hit) && hit.primitive == rayscope::kNoPrimitive,
            "a miss holds no primitive");

    const std::array rays{inside, beside};
    std::array<rayscope::Hit, 2> hits;
    std::array<std::uint8_t, 2> occluded;
    accel.closestHits(std::span<const rayscope::Ray>{rays}, std::span<rayscope::Hit>{hits});
    accel.anyHits(std::span<const rayscope::Ray>{rays}, std::span<std::uint8_t>{occluded});
    require(hits[0].primitive == 0 && hits[1].primitive == rayscope::kNoPrimitive, "many at once agree");
    require(occluded[0] == 1 && occluded[1] == 0, "many occlusions at once agree");
    require(!rayscope::Accel().closestHit(inside, hit), "an empty one is missed by every ray");
    std::puts("one triangle hit");
}
