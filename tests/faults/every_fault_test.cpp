// Lack of memory and of threads at every point of every command.
#include <gtest/gtest.h>

#include <limits>

#include "faults/command_faults.h"

namespace rayscope::test {
namespace {

class EveryFault : public testing::TestWithParam<FaultyCommand> {};

TEST_P(EveryFault, LackOfMemoryEndsClearly) {
    expectClearEnds(GetParam(), FaultKind::Allocation, std::numeric_limits<std::uint64_t>::max());
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryFault, testing::ValuesIn(faultyCommands()),
                         [](const auto& command) { return command.param.name; });

}  // namespace
}  // namespace rayscope::test
