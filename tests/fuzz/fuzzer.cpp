// The main program of libFuzzer: the target is the name of the program behind "fuzz_".
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/targets.h"

namespace {
const rayscope::test::FuzzTarget* target = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** arguments) {
    const std::string program = (*arguments)[0];
    const std::size_t start = program.rfind("fuzz_");
    if (start != std::string::npos) target = rayscope::test::findFuzzTarget(program.substr(start + 5));
    if (!target) {
        std::fprintf(stderr, "%s: run it as fuzz_TARGET, with one of these targets:", program.c_str());
        for (const auto& known : rayscope::test::fuzzTargets())
            std::fprintf(stderr, " %s", std::string(known.name).c_str());
        std::fputc('\n', stderr);
        std::exit(1);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int kKeep = 0, kLeaveOut = -1;
    return target->run({reinterpret_cast<const std::byte*>(data), size}) ? kKeep : kLeaveOut;
}
