#include "scene/mesh_files/obj/referenced_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "scene/mesh_files/text/text_encoding.h"
#include "scene/mesh_files/text/text_lines.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

namespace fs = std::filesystem;

/// Without the backslashes before blanks.
std::string unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\\' || i + 1 == text.size() || !isBlank(text[i + 1])) result += text[i];
    return result;
}

/// The names that the text may mean, the most literal one first.
std::vector<std::string> spellings(std::string_view written) {
    std::vector<std::string> names;
    const auto add = [&](std::string name) {
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(std::move(name));
    };
    add(std::string(written));
    const std::string_view plain = trimmed(withoutComment(written));
    add(std::string(plain));
    add(std::string(unquoted(plain)));
    add(unescaped(unquoted(plain)));
    // Files that were named by a program with this code page, in a text file of the same encoding.
    for (std::size_t i = 0, count = names.size(); i < count; ++i)
        if (std::optional<std::string> name = utf8ToWindows1252(names[i])) add(std::move(*name));
    return names;
}

std::string baseName(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name.substr(name.find_last_of('/') + 1);
}

bool equalsIgnoringCase(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

/// The file in the folder of `path` whose name differs from it in case only; if there are several, the first
/// in the order of their names.
std::optional<std::string> findInOtherCase(const std::string& path) {
    const fs::path wanted(path);
    const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
    std::error_code error;
    std::vector<std::string> found;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (equalsIgnoringCase(entry->path().filename().string(), wanted.filename().string()))
            found.push_back((wanted.parent_path() / entry->path().filename()).string());
    std::sort(found.begin(), found.end());
    for (std::string& candidate : found)
        if (fileExists(candidate)) return std::move(candidate);
    return {};
}

}  // namespace

std::string_view unquoted(std::string_view text) {
    const bool isQuoted =
        text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.front() == text.back();
    return isQuoted ? trimmed(text.substr(1, text.size() - 2)) : text;
}

std::optional<ReferencedFile> findReferenced(const std::string& base, std::string_view written) {
    using How = ReferencedFile::How;
    const std::vector<std::string> names = spellings(written);
    for (const std::string& name : names)
        if (std::string path = resolvePath(base, name); fileExists(path))
            return ReferencedFile{std::move(path), How::AsWritten};
    for (const std::string& name : names)
        if (auto path = findInOtherCase(resolvePath(base, name)))
            return ReferencedFile{std::move(*path), How::OtherCase};
    for (const std::string& name : names) {
        const std::string last = baseName(name);
        if (last.empty() || last == name) continue;
        const std::string path = resolvePath(base, last);
        if (fileExists(path)) return ReferencedFile{path, How::BaseName};
        if (auto other = findInOtherCase(path)) return ReferencedFile{std::move(*other), How::BaseName};
    }
    return {};
}

std::string referencedName(std::string_view written) {
    std::string name(unquoted(trimmed(withoutComment(written))));
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

std::string whyNotFound(const std::string& base, std::string_view written) {
    std::error_code ignored;
    const std::string path = resolvePath(base, referencedName(written));
    switch (fs::status(path, ignored).type()) {
        case fs::file_type::directory:
            return "is a folder, not a file";
        case fs::file_type::fifo:
        case fs::file_type::socket:
        case fs::file_type::block:
        case fs::file_type::character:
            return "is a pipe or device, not a regular file";
        default:
            return "is not found";
    }
}

}  // namespace rayscope::scene
