#include "bvh/isa.h"

#include <stdexcept>

namespace rayscope::bvh {

#ifdef __x86_64__
bool isBuilt(Isa) { return true; }

bool isAvailable(Isa isa) {
    switch (isa) {
        case Isa::Avx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                   __builtin_cpu_supports("bmi2");
        case Isa::Avx512:
            return isAvailable(Isa::Avx2) && __builtin_cpu_supports("avx512f") &&
                   __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512dq");
        default:
            return true;
    }
}
#else
bool isBuilt(Isa isa) { return isa == Isa::Auto || isa == Isa::Scalar; }

bool isAvailable(Isa isa) { return isBuilt(isa); }
#endif

Isa bestIsa() {
    for (const Isa isa : {Isa::Avx512, Isa::Avx2, Isa::Sse2})
        if (isAvailable(isa)) return isa;
    return Isa::Scalar;
}

const kernel::Kernels& kernelsFor(Isa isa) {
    if (!isAvailable(isa))
        throw std::invalid_argument(
            "the instruction set of setting isa is not available on this machine; use auto");
    switch (isa == Isa::Auto ? bestIsa() : isa) {
#ifdef __x86_64__
        case Isa::Sse2:
            return kernel::kSse2Kernels;
        case Isa::Avx2:
            return kernel::kAvx2Kernels;
        case Isa::Avx512:
            return kernel::kAvx512Kernels;
#endif
        default:
            return kernel::kPortableKernels;
    }
}

}  // namespace rayscope::bvh
