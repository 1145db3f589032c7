#include "scene/mesh_files/gltf/resources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "base/base64.h"
#include "base/little_endian.h"
#include "base/lower_case.h"
#include "scene/mesh_files/text/foreign_format.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

constexpr std::string_view kGlbMagic = "glTF";

GltfBytes bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

GltfContainer splitGlb(std::string_view file, const std::string& path, Oddities& oddities) {
    const auto fail = [&](const std::string& reason) {
        throw InputError(fmt::format("damaged GLB file: {}; export or copy it again", reason), {path});
    };
    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
    if (file.size() < kHeader) fail(fmt::format("it ends after {} bytes", file.size()));
    const std::uint32_t version = base::littleEndian32(file, 4), length = base::littleEndian32(file, 8);
    if (version != 2)
        throw InputError(fmt::format("glTF {} is not supported; convert the file to glTF 2.0", version),
                         {path});
    if (length > file.size())
        fail(fmt::format("it has {} of the {} bytes that its header states", file.size(), length));
    if (length < file.size())
        oddities.add(Severity::Warning,
                     fmt::format("{} bytes behind the end of the GLB data; ignored", file.size() - length));
    GltfContainer container{.isBinary = true};
    for (std::size_t at = kHeader; at < length;) {
        if (length - at < kChunkHeader) fail("a chunk ends in its header");
        const std::uint32_t size = base::littleEndian32(file, at), type = base::littleEndian32(file, at + 4);
        const bool isFirst = at == kHeader;
        at += kChunkHeader;
        if (size > length - at) fail(fmt::format("a chunk of {} bytes where {} are left", size, length - at));
        const std::string_view content = file.substr(at, size);
        if (isFirst != (type == kJson)) fail("the first chunk, and no other, must be JSON");
        if (isFirst) container.json = content;
        if (type == kBinary && !container.binary) container.binary = bytesOf(content);
        at += size;
    }
    if (container.json.empty()) fail("it has no JSON chunk");
    return container;
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// %41 → A; sequences that are not valid stay as they are.
std::string percentDecoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' && i + 2 < text.size() ? hexDigit(text[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
        result += low >= 0 ? static_cast<char>(high * 16 + low) : text[i];
        if (low >= 0) i += 2;
    }
    return result;
}

/// The part of a URI before its first colon, in lower case; empty if there is none. One letter is a drive of
/// Windows.
std::string schemeOf(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == uri.npos || colon < 2 || uri.substr(0, colon).find_first_of("/\\. ") != uri.npos) return {};
    return base::lowerCase(uri.substr(0, colon));
}

/// The content of "data:TYPE;base64,…" or "data:TYPE,…".
std::string dataUriContent(std::string_view uri, const std::string& place, const std::string& path) {
    const std::size_t comma = uri.find(',');
    const auto fail = [&](std::string_view reason) {
        throw InputError(fmt::format("{}: the data URI {}", place, reason), {path});
    };
    if (comma == uri.npos) fail("has no comma");
    const std::string_view content = uri.substr(comma + 1);
    if (!uri.substr(0, comma).ends_with(";base64")) return percentDecoded(content);
    auto decoded = base::base64Decoded(content);
    if (!decoded) fail("is not valid base64");
    return *std::move(decoded);
}

}  // namespace

GltfContainer splitGltfFile(std::string_view file, const std::string& path, Oddities& oddities) {
    constexpr std::size_t kSignatureLength = 64;
    if (file.empty()) throw InputError("the file is empty", {path});
    if (file.starts_with(kGlbMagic)) return splitGlb(file, path, oddities);
    if (const std::string_view what = foreignFormat(file.substr(0, kSignatureLength), "glTF"); !what.empty())
        throw InputError(describeForeign(file.substr(0, kSignatureLength), "glTF", {}), {path});
    return {.json = file};
}

GltfResources::GltfResources(const std::string& path, const GltfContainer& container,
                             const GltfDocument& document, const LoadControl& control, Oddities& oddities)
    : path_(path),
      container_(container),
      document_(document),
      control_(control),
      oddities_(oddities),
      buffers_(document.buffers.size()),
      images_(document.images.size()),
      totalBytes_(container.json.size() + (container.binary ? container.binary->size() : 0)) {}

std::string GltfResources::resolve(const std::string& uri, const std::string& place) const {
    if (!schemeOf(uri).empty())
        throw InputError(fmt::format("{}: '{}' is not a file; only files and data URIs are read", place, uri),
                         {path_});
    const std::string decoded = resolvePath(path_, percentDecoded(uri)), literal = resolvePath(path_, uri);
    for (const std::string& candidate : {decoded, literal})
        if (fileExists(candidate)) return candidate;
    throw InputError(fmt::format("{}: file not found: {}", place, decoded), {path_});
}

GltfBytes GltfResources::buffer(std::uint32_t index) {
    const GltfBuffer& buffer = document_.buffers[index];
    const std::string place = fmt::format("buffers[{}]", index);
    GltfBytes bytes;
    if (buffer.uri) {
        std::optional<std::string>& loaded = buffers_[index];
        if (!loaded) {
            loaded = schemeOf(*buffer.uri) == "data" ? dataUriContent(*buffer.uri, place, path_)
                                                     : readSource(resolve(*buffer.uri, place), control_);
            totalBytes_ += loaded->size();
            if (loaded->size() < buffer.byteLength)
                oddities_.add(Severity::Warning, fmt::format("{}: has {} bytes, byteLength says {}", place,
                                                             loaded->size(), buffer.byteLength));
        }
        bytes = bytesOf(*loaded);
    } else if (index == 0 && container_.binary) {
        bytes = *container_.binary;
    } else {
        throw InputError(fmt::format("{}: has neither a uri nor the binary chunk of a GLB file", place),
                         {path_});
    }
    return bytes.first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), buffer.byteLength)));
}

GltfBytes GltfResources::view(std::uint32_t index) {
    const GltfBufferView& view = document_.views[index];
    if (view.isCompressed && !document_.buffers[view.buffer].uri && view.buffer != 0)
        throw InputError(
            fmt::format("bufferViews[{}]: the compression EXT_meshopt_compression is not supported; "
                        "export the file without compression",
                        index),
            {path_});
    const GltfBytes bytes = buffer(view.buffer);
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        throw InputError(fmt::format("bufferViews[{}]: {} bytes at {} exceed the {} bytes of buffers[{}]",
                                     index, view.byteLength, view.byteOffset, bytes.size(), view.buffer),
                         {path_});
    return bytes.subspan(static_cast<std::size_t>(view.byteOffset),
                         static_cast<std::size_t>(view.byteLength));
}

GltfImageSource GltfResources::image(std::uint32_t index) {
    const GltfImage& image = document_.images[index];
    if (image.view) return {.bytes = view(*image.view)};
    const std::string place = fmt::format("images[{}]", index);
    if (image.uri.empty())
        throw InputError(fmt::format("{}: has neither a uri nor a bufferView", place), {path_});
    if (schemeOf(image.uri) != "data") return {.path = resolve(image.uri, place)};
    std::optional<std::string>& decoded = images_[index];
    if (!decoded) decoded = dataUriContent(image.uri, place, path_);
    return {.bytes = bytesOf(*decoded)};
}

}  // namespace rayscope::scene
