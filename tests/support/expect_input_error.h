#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>
#include <string>

namespace rayscope::test {

/// The text of the InputError that `action` throws; fails the test if it throws none.
template <class Action>
std::string inputErrorOf(Action&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "expected an InputError";
    return {};
}

}  // namespace rayscope::test
