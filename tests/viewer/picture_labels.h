#pragma once

namespace rayscope::viewer {

/// Makes random edits, changes of the view, pauses, comparisons, recordings and saves, without a
/// window. After each, pixels in the view, in A, in the recorded rays and in saved files must be those that
/// their labels claim: they are computed again from the label alone.
void checkRandomSequence(int steps, unsigned seed);

}  // namespace rayscope::viewer
