#pragma once
// A fixture that writes scenes and meshes into a temporary folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/scene.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace rayscope::test {

class SceneFiles : public ::testing::Test {
  protected:
    SceneFiles() {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("rayscope-") + info->name() + "-" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~SceneFiles() override { std::filesystem::remove_all(folder_); }

    /// Writes a file and returns its path.
    std::string write(const std::string& name, std::string_view content) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        // Some file systems flush a file to the disk when it is overwritten.
        std::filesystem::remove(path);
        std::ofstream(path, std::ios::binary) << content;
        return path.string();
    }

    SceneDescription load(const std::string& path) { return loadScene(path, notes_); }

    /// The error message of load(), without the folder; "" if there is none.
    std::string errorOf(const std::string& path) {
        try {
            load(path);
        } catch (const InputError& error) {
            std::string text = error.what();
            const std::string prefix = folder_.string() + "/";
            for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
                text.erase(at, prefix.size());
            return text;
        }
        return "";
    }

    /// All notes so far, one per line.
    std::string notesText() const {
        std::string text;
        for (const Diagnostic& note : notes_) text += toString(note) + "\n";
        return text;
    }

    std::filesystem::path folder_;
    Diagnostics notes_;
};

}  // namespace rayscope::test
