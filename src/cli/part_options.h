#pragma once
#include <rayscope/render_session.h>
#include <rayscope/vector.h>
#include <optional>
#include <stop_token>
#include <string>

#include "cli/progress.h"

namespace rayscope::cli {

class OptionList;

/// The options of a render that makes one part of an image, for `merge`.
struct PartOptions {
    std::optional<glm::ivec2> part;  ///< K of N
    std::string file;

    void addTo(OptionList& list);
    bool wanted() const { return part.has_value(); }
    /// Throws UsageError unless both options or none are given.
    void check() const;
};

/// Renders the part and writes its file. Throws Stopped and writes nothing if it is interrupted.
void renderPart(const RenderRequest& request, const PartOptions& options, int threads, ProgressStyle style,
                const std::stop_token& stop);

}  // namespace rayscope::cli
