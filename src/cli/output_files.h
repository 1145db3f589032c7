#pragma once
// What commands write: destinations checked before the work, and failures that do not take other files along.
#include <functional>
#include <string>

namespace rayscope::cli {

class OptionList;

/// Whether two paths name the same file, which need not exist.
bool isSameFile(const std::string& a, const std::string& b);

/// Throws InputError unless every path that an option names as an output can be written, and UsageError if
/// two of them are the same file or one is also read. Creates folders.
void checkDestinations(const OptionList& list);

/// Writes several outputs: one that fails does not prevent the others.
class OutputFiles {
  public:
    /// Runs `work`. Prints the exception that it throws while writing `name`, except Stopped.
    void write(const std::string& name, const std::function<void()>& work);
    bool failed() const { return failed_; }
    /// kInputError if an output failed, else `code`.
    int exitCode(int code) const;

  private:
    bool failed_ = false;
};

}  // namespace rayscope::cli
