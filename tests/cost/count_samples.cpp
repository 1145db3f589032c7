// Traces the same samples with the silent observer and with none, each between the same gate, so that
// callgrind can say what it costs that the tracer can be watched. usage: count_samples SCENE…        prints
// what was counted, in order
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include <rayscope/diagnostics.h>
#include <rayscope/scene.h>
#include "cost/no_observer.h"
#include "trace/compile.h"

namespace {

using namespace rayscope;

constexpr int kSize = 32;

std::shared_ptr<const trace::World> worldOf(const char* scene) {
    Diagnostics notes;
    trace::CompileRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene(scene, notes));
    request.camera = request.scene->cameras.front();
    request.settings.spp = 1;
    request.settings.glossy = true;
    request.settings.isa = Isa::Sse2;
    request.width = request.height = kSize;
    return trace::compile(request);
}

template <class Observer>
glm::dvec3 sumOf(const trace::World& world) {
    glm::dvec3 sum(0.0);
    Observer observer;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            sum += glm::dvec3(trace::radiance(world, 1, SampleId{x, y, 0}, observer).radiance);
    return sum;
}

}  // namespace

// The gates: callgrind knows them by name.
extern "C" {
[[gnu::noipa]] void countedSilent(const trace::World& world, glm::dvec3& sum) {
    sum = sumOf<trace::NullObserver>(world);
}
[[gnu::noipa]] void countedUnwatched(const trace::World& world, glm::dvec3& sum) {
    sum = sumOf<trace::NoObserver>(world);
}
}

int main(int count, char** arguments) try {
    for (int i = 1; i < count; ++i) {
        const std::shared_ptr<const trace::World> world = worldOf(arguments[i]);
        glm::dvec3 warmUp, silent, unwatched;
        countedSilent(*world, warmUp);
        countedUnwatched(*world, warmUp);
        countedSilent(*world, silent);
        countedUnwatched(*world, unwatched);
        if (silent != unwatched)
            throw std::runtime_error(fmt::format("{}: two tracers, two results", arguments[i]));
        fmt::print("{}\n", arguments[i]);
    }
} catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
}
