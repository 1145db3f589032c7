#include "cli/version_text.h"

#include <fmt/format.h>

#include <rayscope/settings.h>
#include <vector>

#include "bvh/isa.h"

namespace rayscope::cli {

namespace {

std::string compilerText() {
#if defined(__clang__)
    return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return "unknown compiler";
#endif
}

std::string kernelsText() {
    std::vector<std::string_view> built, unavailable;
    std::string_view best;
    for (const SettingInfo& info : describeSettings()) {
        if (info.key != "isa") continue;
        for (std::size_t i = 0; i < info.choices.size(); ++i) {
            const auto isa = static_cast<Isa>(i);
            if (isa == Isa::Auto || !bvh::isBuilt(isa)) continue;
            built.push_back(info.choices[i]);
            if (!bvh::isAvailable(isa)) unavailable.push_back(info.choices[i]);
            if (isa == bvh::bestIsa()) best = info.choices[i];
        }
    }
    const std::string rest =
        unavailable.empty() ? "" : fmt::format("; this processor lacks {}", fmt::join(unavailable, ", "));
    return fmt::format("{}; auto selects {}{}", fmt::join(built, ", "), best, rest);
}

}  // namespace

std::string versionText() {
    return fmt::format("rayscope {}\ncompiler: {}, {}\nkernels: {}\nlibraries: {}\n", RAYSCOPE_VERSION,
                       compilerText(), RAYSCOPE_BUILD_TYPE, kernelsText(), RAYSCOPE_LIBRARIES);
}

}  // namespace rayscope::cli
