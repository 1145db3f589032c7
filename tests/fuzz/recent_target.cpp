#include "fuzz/memory_file.h"
#include "viewer/model/recent_files.h"

namespace rayscope::test {

/// Any bytes are a list of at most kMaxCount paths without line feeds, which is stored and read back.
bool fuzzRecentFiles(FuzzInput input) {
    static const MemoryFile file("recent");
    viewer::RecentFiles recent(file.write(input));
    require(recent.paths().size() <= viewer::RecentFiles::kMaxCount, "the list is short");
    for (const std::string& path : recent.paths())
        require(!path.empty() && path.find('\n') == std::string::npos, "a path is one line");
    recent.add("builtin:cornell");
    require(recent.paths().front() == "builtin:cornell", "the newest path comes first");
    require(viewer::RecentFiles(file.path()).paths() == recent.paths(),
            "the list reads back as it is written");
    return true;
}

}  // namespace rayscope::test
