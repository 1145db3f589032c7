#pragma once
#include <rayscope/render_session.h>
#include <string>

namespace rayscope::cli {

enum class ProgressStyle { Bar, Json, None };

/// What --progress says; without it a bar on a terminal and nothing elsewhere.
ProgressStyle progressStyle(const std::string& option, bool quiet);

/// Reports on stderr how far a render is.
class Progress {
  public:
    explicit Progress(ProgressStyle style) : style_(style) {}
    void show(const RenderStatus& status);
    void finish(const RenderStatus& status);

  private:
    ProgressStyle style_;
    bool drawn_ = false;
};

/// Draws a bar on stderr over the present line, with a word on what is going on.
void showProgressBar(double fraction, const std::string& phase, double remainingSeconds);

/// "1:02:03", "2:03" or "0.42 s".
std::string durationText(double seconds);

}  // namespace rayscope::cli
