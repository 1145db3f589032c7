#include "cli/output_files.h"

#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/image.h>
#include <filesystem>
#include <map>
#include <new>

#include "base/atomic_file.h"
#include "base/console.h"
#include "base/file_suffix.h"
#include "base/memory_budget.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/failure.h"

namespace rayscope::cli {

namespace {

namespace fs = std::filesystem;

/// The paths that the option was set to.
std::vector<std::string> pathsOf(const Option& option) {
    if (const auto* const* path = std::get_if<std::string*>(&option.target))
        return **path == "" ? std::vector<std::string>{} : std::vector{**path};
    if (const auto* const* paths = std::get_if<std::vector<std::string>*>(&option.target)) return **paths;
    return {};
}

void checkFolder(const std::string& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw InputError("the folder cannot be created: " + error.message(), {path});
    base::checkFileDestination((fs::path(path) / "report").string());
}

void checkDestination(const Option& option, const std::string& path) {
    if (path == "-" && option.output == Option::Output::ImageOrStandardOutput) return;
    if (path == "/dev/stdout" && option.output == Option::Output::ImageOrStandardOutput)
        throw UsageError(std::string(option.mainName()),
                         "to write the image to the standard output, write '-' and --format");
    if (path == "-")
        throw UsageError(std::string(option.mainName()),
                         "'-' does not mean the standard output here: write /dev/stdout for it, or ./- for a "
                         "file of this name");
    switch (option.output) {
        case Option::Output::None:
            return;
        case Option::Output::Folder:
            return checkFolder(path);
        case Option::Output::Image:
        case Option::Output::ImageOrStandardOutput:
            return checkImageDestination(path);
        case Option::Output::ImageOrTable:
            if (base::hasSuffix(path, ".csv")) return base::checkFileDestination(path);
            return checkImageDestination(path);
        case Option::Output::File:
            return base::checkFileDestination(path);
    }
}

/// Equal for names of the same file.
std::string identityOf(const std::string& path) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(fs::absolute(path), error);
    return error ? path : canonical.string();
}

}  // namespace

bool isSameFile(const std::string& a, const std::string& b) { return identityOf(a) == identityOf(b); }

void checkDestinations(const OptionList& list) {
    std::map<std::string, const Option*> written, read;
    bool imageToStandardOutput = false;
    for (const Option& option : list.options())
        if (option.isPositional() || option.isInput)
            for (const std::string& path : pathsOf(option)) read.emplace(identityOf(path), &option);
    for (const Option& option : list.options()) {
        if (option.output == Option::Output::None) continue;
        for (const std::string& path : pathsOf(option)) {
            checkDestination(option, path);
            imageToStandardOutput |= path == "-";
            if (imageToStandardOutput && (path == "/dev/stdout" || path == "/dev/fd/1"))
                throw UsageError(std::string(option.mainName()),
                                 "the standard output already receives the image of '-'");
            std::error_code ignored;
            const bool isDevice = fs::is_other(path, ignored);
            if (const auto input = read.find(identityOf(path)); input != read.end() && !isDevice)
                throw UsageError(
                    std::string(option.mainName()),
                    fmt::format("{} is also read by {}", base::quoted(path), input->second->mainName()));
            const auto [place, isNew] = written.emplace(identityOf(path), &option);
            if (!isNew && !isDevice)
                throw UsageError(
                    std::string(option.mainName()),
                    fmt::format("{} is also written by {}", base::quoted(path), place->second->mainName()));
        }
    }
}

void OutputFiles::write(const std::string& name, const std::function<void()>& work) {
    try {
        return work();
    } catch (const InputError& error) {
        base::printMessage("{}\n", error.what());
    } catch (const std::bad_alloc& error) {
        base::printMessage("{}\n", toString({Severity::Error, base::messageOf(error), {name}}));
    } catch (const Stopped&) {
        throw;
    } catch (const std::exception& error) {
        base::printMessage("{}\n", toString({Severity::Error, messageOf(error), {name}}));
    }
    failed_ = true;
}

int OutputFiles::exitCode(int code) const { return failed_ ? static_cast<int>(kInputError) : code; }

}  // namespace rayscope::cli
