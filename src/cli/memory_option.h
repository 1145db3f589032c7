#pragma once
#include <string>

namespace rayscope::cli {

class OptionList;

/// --memory-limit, which every command has that allocates by its input.
class MemoryOption {
  public:
    void addTo(OptionList& list);
    /// Limits the memory of the process for the command whose options are in the list. Throws UsageError if
    /// the value is no size.
    void apply(const OptionList& list, bool opensWindow) const;

  private:
    std::string limit_;
};

}  // namespace rayscope::cli
