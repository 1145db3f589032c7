#pragma once
// Images of two folders that belong together.
#include <string>
#include <vector>

namespace rayscope::measure {

struct ImagePair {
    std::string name;   ///< path of the reference image within its folder
    std::string image;  ///< empty if the folder of images has none of this name
    std::string reference;
};

struct ImagePairs {
    std::vector<ImagePair> pairs;  ///< one for each reference image, in the order of their names
    std::vector<std::string>
        unpaired;  ///< paths of the images without a reference image, within their folder
};

/// Pairs the image files, by suffix, of two folders and their subfolders: those of equal paths, then those
/// whose paths are equal without the suffix, if that is the only such image. Throws InputError if a folder
/// cannot be read or `references` has no images.
ImagePairs pairImages(const std::string& images, const std::string& references);

}  // namespace rayscope::measure
