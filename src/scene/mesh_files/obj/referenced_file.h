#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::scene {

/// A file that another file names.
struct ReferencedFile {
    enum class How {
        AsWritten,
        OtherCase,  ///< upper and lower case differ
        BaseName    ///< not at its path, but beside the file that names it
    };
    std::string path;
    How how;
};

/// Looks for a file that `base` names. `written` is the rest of its line: as it is, without a comment,
/// without quotes and with blanks that are escaped by a backslash. Nothing if there is no such regular file.
std::optional<ReferencedFile> findReferenced(const std::string& base, std::string_view written);

/// `written` without comment and quotes, for messages.
std::string referencedName(std::string_view written);

/// " is not found" or why else findReferenced() found nothing.
std::string whyNotFound(const std::string& base, std::string_view written);

/// Without a pair of quotes around it.
std::string_view unquoted(std::string_view text);

}  // namespace rayscope::scene
