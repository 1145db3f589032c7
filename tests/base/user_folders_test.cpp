#include "base/user_folders.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace rayscope {
namespace {

TEST(UserFolders, RelativeVariablesAreIgnored) {
    const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
    ::setenv("HOME", "/people/a", 1);
    for (const char* value : {"", "relative", "./x"}) {
        ::setenv("XDG_CACHE_HOME", value, 1);
        ::setenv("XDG_CONFIG_HOME", value, 1);
        ::setenv("XDG_DATA_HOME", value, 1);
        EXPECT_EQ(base::userCacheFolder(), "/people/a/.cache/rayscope");
        EXPECT_EQ(base::userConfigFolder(), "/people/a/.config/rayscope");
        EXPECT_EQ(base::userDataFolder(), "/people/a/.local/share/rayscope");
    }
    ::setenv("XDG_CACHE_HOME", "/cache", 1);
    EXPECT_EQ(base::userCacheFolder(), "/cache/rayscope");
    ::unsetenv("XDG_CACHE_HOME");
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("XDG_DATA_HOME");
    ::setenv("HOME", "relative", 1);
    EXPECT_EQ(base::userCacheFolder(), "");
    EXPECT_EQ(base::userConfigFolder(), "");
    EXPECT_EQ(base::userDataFolder(), "");
    ::setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace rayscope
