#include "base/json_text.h"

#include <nlohmann/json.hpp>

#include "base/printable_text.h"

namespace rayscope::base {

std::string jsonText(const nlohmann::json& value, int indent) {
    constexpr bool kAsciiOnly = false;
    return printableJson(value.dump(indent, ' ', kAsciiOnly, nlohmann::json::error_handler_t::replace)) +
           "\n";
}

}  // namespace rayscope::base
