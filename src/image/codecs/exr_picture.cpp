#include "image/codecs/exr_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rayscope::image {

namespace {

/// The channels of a layer by their last name, in capitals.
struct Layer {
    std::string name;
    std::map<std::string, const ExrChannel*> channels;

    bool has(const char* channel) const { return channels.contains(channel); }
    bool isColored() const { return has("R") || has("G") || has("B"); }
    /// X, Y and Z together are a vector: a position or a normal.
    bool isLuminance() const { return has("Y") && !(has("X") || has("Z")); }
};

/// Channels without a layer first, then the layers in the order of the file, which is alphabetical.
std::vector<Layer> layersOf(const ExrPart& part) {
    std::vector<Layer> layers{{}};
    std::map<std::string, std::size_t> indices{{"", 0}};
    for (const ExrChannel& channel : part.channels) {
        const std::size_t dot = channel.name.rfind('.');
        const std::string layer = dot == std::string::npos ? "" : channel.name.substr(0, dot);
        std::string last = dot == std::string::npos ? channel.name : channel.name.substr(dot + 1);
        std::transform(last.begin(), last.end(), last.begin(),
                       [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
        const auto [known, isNew] = indices.try_emplace(layer, layers.size());
        if (isNew) layers.push_back({layer, {}});
        layers[known->second].channels.emplace(last, &channel);
    }
    return layers;
}

std::string listOfChannels(const ExrFile& headers) {
    constexpr std::size_t kMost = 12;
    std::vector<std::string_view> names;
    for (const ExrPart& part : headers.parts)
        for (const ExrChannel& channel : part.channels) names.push_back(channel.name);
    std::string list = fmt::format(
        "{}", fmt::join(names.begin(),
                        names.begin() + static_cast<std::ptrdiff_t>(std::min(kMost, names.size())), ", "));
    if (names.size() > kMost) list += fmt::format(" and {} more", names.size() - kMost);
    return names.empty() ? "none" : list;
}

class Chooser {
  public:
    Chooser(const ExrFile& headers, const std::string& name, Diagnostics* notes)
        : headers_(headers), name_(name), notes_(notes) {}

    ExrPicture run() {
        bool flat = false;
        for (std::size_t i = 0; i < headers_.parts.size(); ++i) {
            if (headers_.parts[i].isDeep) continue;
            flat = true;
            const std::vector<Layer> layers = layersOf(headers_.parts[i]);
            for (const Layer& layer : layers)
                if (layer.isColored()) return colored(i, layer, layers);
            for (const Layer& layer : layers)
                if (layer.isLuminance()) return luminance(i, layer, layers);
        }
        if (!flat)
            refuse("deep EXR image (several samples per pixel); flatten it, e.g. with oiiotool --flatten");
        refuse(fmt::format("EXR image without channels R, G, B or Y; export it with one of these; it has {}",
                           listOfChannels(headers_)));
    }

  private:
    [[noreturn]] void refuse(std::string message) const { throw InputError(std::move(message), {name_}); }
    void note(std::string message) const {
        if (notes_) notes_->push_back({Severity::Note, std::move(message), {name_}});
    }

    ExrPicture colored(std::size_t part, const Layer& layer, const std::vector<Layer>& layers) const {
        ExrPicture picture{part, layer.name, {}, false, false};
        std::string missing;
        constexpr std::array<const char*, 3> kNames{"R", "G", "B"};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto found = layer.channels.find(kNames[i]);
            if (found == layer.channels.end()) {
                missing += (missing.empty() ? "" : " and ") + std::string(kNames[i]);
                continue;
            }
            if (found->second->xSampling != 1 || found->second->ySampling != 1)
                refuse(fmt::format("EXR image whose channel {} is subsampled; export it at full resolution",
                                   found->second->name));
            picture.channels[i] = found->second->name;
        }
        noteChoice(part, layer, layers);
        if (!missing.empty()) note(fmt::format("no channel {}; read as 0", missing));
        return picture;
    }

    ExrPicture luminance(std::size_t part, const Layer& layer, const std::vector<Layer>& layers) const {
        const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
        const ExrChannel& y = *layer.channels.at("Y");
        ExrPicture picture{
            part, layer.name, {y.name, y.name, y.name}, true, layer.has("RY") || layer.has("BY")};
        bool isUsual = y.xSampling == 1 && y.ySampling == 1;
        for (const char* name : {"RY", "BY"})
            if (picture.hasChroma) {
                const auto found = layer.channels.find(name);
                isUsual = isUsual && found != layer.channels.end() && found->second->xSampling == 2 &&
                          found->second->ySampling == 2 && found->second->name == prefix + name;
            }
        if (!isUsual)
            refuse(
                "EXR image with luminance and chroma that are not channels Y at full and RY and BY at half "
                "resolution; export it as R, G, B");
        if (picture.hasChroma && part > 0)
            refuse(fmt::format("EXR image with luminance and chroma in part {}; export it as R, G, B",
                               part + 1));
        noteChoice(part, layer, layers);
        return picture;
    }

    void noteChoice(std::size_t part, const Layer& layer, const std::vector<Layer>& layers) const {
        if (headers_.parts.size() > 1)
            note(fmt::format("part {} of {}, '{}', is read; the others are ignored", part + 1,
                             headers_.parts.size(), headers_.parts[part].name));
        if (layer.name.empty()) return;
        const auto others =
            static_cast<std::size_t>(std::count_if(layers.begin(), layers.end(),
                                                   [](const Layer& l) { return !l.channels.empty(); })) -
            1;
        note(others == 0 ? fmt::format("the layer '{}' is read", layer.name)
                         : fmt::format("the layer '{}' is read; {} others are ignored", layer.name, others));
    }

    const ExrFile& headers_;
    const std::string& name_;
    Diagnostics* notes_;
};

}  // namespace

ExrPicture choosePicture(const ExrFile& headers, const std::string& name, Diagnostics* notes) {
    return Chooser(headers, name, notes).run();
}

}  // namespace rayscope::image
