#pragma once
#include <vector>

#include "render/film.h"

namespace rayscope::measure {

/// Samples of each tile relative to a mean of 1, from a pilot film of at least two samples per pixel. They
/// are proportional to the standard deviation of the samples, which minimises the squared error of the image
/// (Neyman 1934), or with `equalErrors` to their variance, which gives all tiles the same error. No tile gets
/// less than half of its noisiest neighbour or a quarter of the mean, so that noise which the pilot missed is
/// still sampled. `relative`: for relative errors.
std::vector<double> allocateSamples(const render::Film& pilot, bool relative, bool equalErrors);

}  // namespace rayscope::measure
