#include <fmt/format.h>
#include <rayscope/diagnostics.h>
#include <stb_image.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "image/codecs/codecs.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

/// Supplies stb with bytes from memory and records reads beyond the end, after which several of its decoders
/// continue silently with zeros.
class Source {
  public:
    enum class AtEnd { Stop, RepeatOnes };

    explicit Source(FileBytes file, AtEnd atEnd = AtEnd::Stop) : file_(file), atEnd_(atEnd) {}

    static const stbi_io_callbacks& callbacks() {
        static const stbi_io_callbacks table{
            [](void* self, char* data, int size) { return static_cast<Source*>(self)->read(data, size); },
            [](void* self, int count) { static_cast<Source*>(self)->skip(count); },
            [](void* self) { return static_cast<Source*>(self)->left() == 0 ? 1 : 0; }};
        return table;
    }

    bool overrun() const { return overrun_; }

  private:
    // stb fills its own buffer in steps of this size, of which the last may be short; every other read
    // requests what the decoder needs.
    static constexpr int kBufferStep = 128;

    std::size_t left() const { return file_.size() - position_; }

    int read(char* data, int size) {
        const std::size_t count = std::min(left(), static_cast<std::size_t>(size));
        std::memcpy(data, file_.data() + position_, count);
        position_ += count;
        if (count == 0 || (size != kBufferStep && count < static_cast<std::size_t>(size))) overrun_ = true;
        if (count > 0 || atEnd_ == AtEnd::Stop) return static_cast<int>(count);
        std::memset(data, 1, static_cast<std::size_t>(size));
        return size;
    }

    void skip(int count) {
        if (count > 0 && static_cast<std::size_t>(count) > left()) overrun_ = true;
        const long long target = static_cast<long long>(position_) + count;
        position_ = static_cast<std::size_t>(std::clamp(target, 0LL, static_cast<long long>(file_.size())));
    }

    FileBytes file_;
    AtEnd atEnd_;
    std::size_t position_ = 0;
    bool overrun_ = false;
};

template <class T>
using Samples = std::unique_ptr<T, void (*)(void*)>;

/// Decodes with one of stb's load functions into three channels, and converts each sample.
template <class T, class Load, class Convert>
RgbImage load(Source source, const std::string& name, Load loadFromCallbacks, Convert toLinear) {
    int width = 0, height = 0, channels = 0;
    const Samples<T> samples(loadFromCallbacks(&Source::callbacks(), &source, &width, &height, &channels, 3),
                             stbi_image_free);
    if (source.overrun()) throwDamaged(name, "unexpected end of file");
    if (!samples) throwDamaged(name, stbi_failure_reason());
    RgbImage image(width, height);
    const T* sample = samples.get();
    for (Rgb& pixel : image.pixels) {
        pixel = Rgb(toLinear(sample[0]), toLinear(sample[1]), toLinear(sample[2]));
        sample += 3;
    }
    return image;
}

}  // namespace

RgbImage decodeStb(FileBytes file, const std::string& name) {
    int width = 0, height = 0, channels = 0;
    Source header(file);
    if (!stbi_info_from_callbacks(&Source::callbacks(), &header, &width, &height, &channels)) {
        if (header.overrun()) throwDamaged(name, "unexpected end of file");
        throw InputError(fmt::format("not an image ({}); expected PNG, JPEG, BMP, TGA, HDR, EXR or PFM",
                                     stbi_failure_reason()),
                         {name});
    }
    checkImageSize(width, height, file.size(), name);

    Source probe(file);
    if (stbi_is_hdr_from_callbacks(&Source::callbacks(), &probe)) {
        // Beyond the end stb reads zeros, and a run of length zero in the pixels of an HDR file is an endless
        // loop; ones end it. In the header ones would be an endless loop, but it has just been read
        // completely.
        return load<float>(Source(file, Source::AtEnd::RepeatOnes), name, stbi_loadf_from_callbacks,
                           [](float value) { return value; });
    }
    probe = Source(file);
    if (stbi_is_16_bit_from_callbacks(&Source::callbacks(), &probe))
        return load<stbi_us>(Source(file), name, stbi_load_16_from_callbacks, [](stbi_us value) {
            return srgbToLinear(static_cast<float>(value) / 65535.0f);
        });
    return load<stbi_uc>(Source(file), name, stbi_load_from_callbacks, decodeByte);
}

}  // namespace rayscope::image
