#pragma once
// The parsers of untrusted bytes, each with what must hold for any bytes. libFuzzer runs them on inputs that
// it finds (fuzzer.cpp), and GoogleTest on the stored corpus (corpus_test.cpp).
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>

namespace rayscope::test {

/// Thrown if a parser breaks a promise.
struct BrokenPromise : std::logic_error {
    using std::logic_error::logic_error;
};

/// Throws BrokenPromise unless the promise is kept.
inline void require(bool isKept, const char* promise) {
    if (!isKept) throw BrokenPromise(promise);
}

using FuzzInput = std::span<const std::byte>;

inline std::string_view textOf(FuzzInput input) {
    return {reinterpret_cast<const char*>(input.data()), input.size()};
}

struct FuzzTarget {
    std::string_view name;
    /// Parses the bytes. Returns whether they say something about the parser: false for an input that the
    /// target leaves out. Throws BrokenPromise, or whatever the parser must not throw.
    bool (*run)(FuzzInput input);
};

std::span<const FuzzTarget> fuzzTargets();

/// Null if there is none of this name.
const FuzzTarget* findFuzzTarget(std::string_view name);

bool fuzzFilms(FuzzInput input);
bool fuzzImage(FuzzInput input);
bool fuzzMtl(FuzzInput input);
bool fuzzObj(FuzzInput input);
bool fuzzPly(FuzzInput input);
bool fuzzStl(FuzzInput input);
bool fuzzGltf(FuzzInput input);
bool fuzzOptions(FuzzInput input);
bool fuzzPrintableText(FuzzInput input);
bool fuzzRays(FuzzInput input);
bool fuzzRecentFiles(FuzzInput input);
bool fuzzScene(FuzzInput input);
bool fuzzSettings(FuzzInput input);

}  // namespace rayscope::test
