#pragma once
#include <vector>

#include "render/film.h"

namespace rayscope::measure {

/// How many samples each tile should get, relative to a mean of 1, judged by a pilot film of two or more
/// samples: in proportion to the standard deviation of its samples, which makes the squared error of the
/// whole image smallest (Neyman 1934), or to its variance, which makes all tiles alike. No tile gets less
/// than half of what its noisiest neighbour gets, nor less than a quarter of the mean, so that one which saw
/// nothing yet is not given up.
std::vector<double> allocateSamples(const render::Film& pilot, bool relative, bool alike);

}  // namespace rayscope::measure
