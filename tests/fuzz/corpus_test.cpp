// The targets of the fuzzers on stored inputs, and on inputs that random changes make of them: a regression
// test that needs no Clang.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "fuzz/targets.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

namespace fs = std::filesystem;

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class FuzzCorpus : public testing::TestWithParam<std::string_view> {
  protected:
    /// The stored inputs in the order of their names.
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        const fs::path folder = fs::path(RAYSCOPE_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam();
        if (!fs::is_directory(folder)) return found;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
        std::ranges::sort(found);
        return found;
    }

    /// The last line that is printed before a crash names the input.
    void expectPromisesKept(const std::string& input, const std::string& what) const {
        constexpr double kMostSeconds = 20.0;  // of the slowest build
        std::printf("%s\n", what.c_str());
        std::fflush(stdout);
        const double start = processorSeconds();
        try {
            test::findFuzzTarget(GetParam())->run(std::as_bytes(std::span(input)));
        } catch (const std::exception& error) {
            ADD_FAILURE() << what << ": " << error.what();
        }
        EXPECT_LT(processorSeconds() - start, kMostSeconds) << what;
    }
};

TEST_P(FuzzCorpus, StoredInputsKeepThePromises) {
    const std::vector<fs::path> inputs = files();
    ASSERT_GE(inputs.size(), 5u);
    for (const fs::path& path : inputs) expectPromisesKept(test::readText(path), path.filename().string());
}

/// Bytes that are set, inserted and removed, and pieces of other inputs.
std::string changed(std::string input, const std::string& other, std::mt19937& random) {
    for (unsigned n = random() % 4 + 1; n > 0 && !input.empty(); --n) {
        const std::size_t at = random() % input.size(), size = random() % 16 + 1;
        switch (random() % 4) {
            case 0:
                input[at] = static_cast<char>(random() % 3 ? random() : 0xff);
                break;
            case 1:
                input.erase(at, size);
                break;
            case 2:
                input.insert(at, input.substr(random() % input.size(), size));
                break;
            default:
                input.replace(at, std::string::npos, other.substr(std::min(at, other.size())));
        }
    }
    return input;
}

TEST_P(FuzzCorpus, ChangedInputsKeepThePromises) {
    const char* const wanted =
        std::getenv("RAYSCOPE_FUZZ_INPUTS");  // NOLINT(concurrency-mt-unsafe): one thread
    const unsigned long count = wanted ? std::stoul(wanted) : 300;
    const std::vector<fs::path> inputs = files();
    ASSERT_FALSE(inputs.empty());
    std::mt19937 random(16);
    for (unsigned long i = 0; i < count; ++i) {
        const fs::path &path = inputs[random() % inputs.size()], other = inputs[random() % inputs.size()];
        expectPromisesKept(changed(test::readText(path), test::readText(other), random),
                           path.filename().string() + ", change " + std::to_string(i));
    }
}

std::vector<std::string_view> targetNames() {
    std::vector<std::string_view> names;
    for (const test::FuzzTarget& target : test::fuzzTargets()) names.push_back(target.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, testing::ValuesIn(targetNames()),
                         [](const auto& target) { return std::string(target.param); });

TEST(FuzzTargets, EveryFolderOfTheCorpusIsUsed) {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(RAYSCOPE_SOURCE_DIR) / "tests/fuzz/corpus"))
        EXPECT_NE(test::findFuzzTarget(entry.path().filename().string()), nullptr) << entry.path();
}

}  // namespace
}  // namespace rayscope
