#pragma once
#include <memory>
#include <string>
#include <string_view>

namespace rayscope::base {

/// Writes a file whole or not at all: a temporary file in the same folder takes its place once all bytes are
/// in it; until then an old file of that name stays as it was. A symbolic link keeps its name and its target
/// is replaced; pipes and devices are written to directly. Throws InputError that names the file and the
/// reason.
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// The same for what is too long to hold in memory: write() any number of times, then commit(). Without
/// commit() nothing has happened to the file.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Throws InputError unless a file could be created at (or replaced under) this path now.
void checkFileDestination(const std::string& path);

}  // namespace rayscope::base
