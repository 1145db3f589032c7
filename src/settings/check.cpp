#include <rayscope/settings.h>

#include "base/check_argument.h"
#include "settings/table.h"

namespace rayscope {

namespace {

void check(const settings::Toggle&, const Settings&) {}

template <class T>
void check(const settings::Range<T>& row, const Settings& settings) {
    const T value = settings.*row.member;
    base::checkArgument(value >= row.lowest && value <= row.highest, "settings: {} is {}; expected {} … {}",
                        row.text.key, value, row.lowest, row.highest);
}

template <class E, std::size_t N>
void check(const settings::Choice<E, N>& row, const Settings& settings) {
    const auto value = static_cast<long long>(settings.*row.member);
    base::checkArgument(value >= 0 && value < static_cast<long long>(N),
                        "settings: {} is enumerator {}; expected 0 … {}", row.text.key, value, N - 1);
}

}  // namespace

void checkSettings(const Settings& settings) {
    settings::forEachSetting([&](const auto& row) { check(row, settings); });
}

}  // namespace rayscope
