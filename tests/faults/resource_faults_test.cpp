// Lack of memory and of threads at a selection of points of every command.
#include <gtest/gtest.h>

#include <cstdlib>

#include "faults/command_faults.h"

namespace rayscope::test {
namespace {

constexpr std::uint64_t kAllocations = 25, kThreads = 20;

const auto kNameOf = [](const testing::TestParamInfo<FaultyCommand>& info) { return info.param.name; };

class LackOfMemory : public testing::TestWithParam<FaultyCommand> {};

TEST_P(LackOfMemory, EndsClearly) { expectClearEnds(GetParam(), FaultKind::Allocation, kAllocations); }

INSTANTIATE_TEST_SUITE_P(Commands, LackOfMemory, testing::ValuesIn(faultyCommands()), kNameOf);

class LackOfThreads : public testing::TestWithParam<FaultyCommand> {};

TEST_P(LackOfThreads, EndsClearly) { expectClearEnds(GetParam(), FaultKind::Thread, kThreads); }

INSTANTIATE_TEST_SUITE_P(Commands, LackOfThreads, testing::ValuesIn(commandsWithThreads()), kNameOf);

}  // namespace
}  // namespace rayscope::test
