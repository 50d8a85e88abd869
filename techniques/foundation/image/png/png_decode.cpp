// Decoding through libpng. Why some functions here own nothing: see png_failure.h.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csetjmp>
#include <cstring>
#include <new>
#include <system_error>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/image/png/png_failure.h"
#include "techniques/foundation/image/utf8.h"

namespace shadowlab::image {
namespace {

struct Source {
    const std::uint8_t* next;
    std::size_t left;
};
void takeBytes(png_structp png, png_bytep data, png_size_t size) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (size > source->left) png_error(png, "the file ends too early");
    std::memcpy(data, source->next, size);
    source->next += size;
    source->left -= size;
}

struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    PngFailure failure;
    Reader() : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, onPngError, onPngWarning)) {
        if (png) info = png_create_info_struct(png);
        if (!info) {
            png_destroy_read_struct(&png, nullptr, nullptr);
            throw std::bad_alloc();
        }
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// Everything up to the pixels.
bool readHeader(const Reader& reader, Source& source, bool withTexts) {
    const png_structp png = reader.png;
    constexpr png_byte kTexts[] = "tEXt\0zTXt\0iTXt\0iCCP"; // the last one is compressed, too
    constexpr int kTextKinds = 4;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_read_fn(png, &source, takeBytes);
    png_set_user_limits(png, 0x7fffffff, 0x7fffffff); // the size is judged by our own limits, with our own message
    png_set_chunk_malloc_max(png, 8u << 20);          // a text chunk that unpacks to more is an attack, not a caption
    png_set_chunk_cache_max(png, 128);
    if (!withTexts) png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kTexts, kTextKinds);
    png_read_info(png, reader.info);
    return true;
}

/// Asks for the pixels as 8-bit RGBA. libpng then takes memory for rows, so their length has to be judged before.
bool askForRgba(const Reader& reader, bool& hasAlpha) {
    const png_structp png = reader.png;
    const png_infop info = reader.info;
    if (setjmp(png_jmpbuf(png))) return false;
    hasAlpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS);
    png_set_expand(png); // palette to RGB, few-bit grey to 8, tRNS to alpha
    png_set_strip_16(png);
    png_set_gray_to_rgb(png);
    png_set_filler(png, 0xFF, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool readPixels(const Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, reader.info);
    return true;
}

std::vector<PngText> readTexts(const Reader& reader) {
    png_textp chunks = nullptr;
    int count = 0;
    png_get_text(reader.png, reader.info, &chunks, &count);
    std::vector<PngText> texts;
    const auto fromLatin1 = [](const std::string& text) {
        std::u32string points;
        for (const char c : text)
            points.push_back(static_cast<unsigned char>(c));
        return encodeUtf8(points);
    };
    for (int i = 0; i < count; ++i) {
        const bool latin1 = chunks[i].compression < PNG_ITXT_COMPRESSION_NONE;
        const std::string value = chunks[i].text ? chunks[i].text : "";
        texts.push_back({fromLatin1(chunks[i].key), latin1 ? fromLatin1(value) : value});
    }
    return texts;
}

[[noreturn]] void badPng(std::string_view name, std::string_view why) {
    throw Error(ExitStatus::badInput,
                std::string(name) + ": not a readable PNG: " + std::string(why) + "; save it again");
}

PngSize judgedSize(const Reader& reader, Source& source, std::string_view name, const PngLimits& limits) {
    constexpr std::size_t kSignatureBytes = 8;
    if (source.left < kSignatureBytes || png_sig_cmp(source.next, 0, kSignatureBytes) != 0)
        badPng(name, "it does not start like one");
    if (!readHeader(reader, source, limits.withTexts)) badPng(name, reader.failure.message);
    const PngSize size{png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info)};
    if (size.width > limits.side || size.height > limits.side)
        throw Error(ExitStatus::overLimit, std::string(name) + ": " + std::to_string(size.width) + " x " +
                                               std::to_string(size.height) + " pixels are more than the limit of " +
                                               std::to_string(limits.side) + " a side; scale it down");
    return size;
}

} // namespace

PngSize pngSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    const Reader reader;
    Source source{bytes.data(), bytes.size()};
    PngLimits sizeAlone = limits;
    sizeAlone.withTexts = false;
    return judgedSize(reader, source, name, sizeAlone);
}

DecodedPng decodePng(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    const Reader reader;
    Source source{bytes.data(), bytes.size()};
    const auto [width, height] = judgedSize(reader, source, name, limits);
    DecodedPng decoded;
    if (!askForRgba(reader, decoded.hasAlpha)) badPng(name, reader.failure.message);
    decoded.image = Image(static_cast<int>(width), static_cast<int>(height));
    std::vector<png_bytep> rows(height);
    for (png_uint_32 y = 0; y < height; ++y)
        rows[y] = decoded.image.rgba.data() + std::size_t{y} * width * kChannels;
    if (!readPixels(reader, rows.data())) badPng(name, reader.failure.message);
    decoded.text = readTexts(reader);
    return decoded;
}

Image loadPng(const std::filesystem::path& file, const PngLimits& limits) {
    const auto systemError = [&](int number) {
        return Error(ExitStatus::badInput, file.string() +
                                               ": cannot be read: " + std::generic_category().message(number) +
                                               "; check the name and its permissions");
    };
    struct Descriptor {
        int value = -1;
        ~Descriptor() {
            if (value >= 0) ::close(value);
        }
    } descriptor;
    do {
        descriptor.value = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    } while (descriptor.value < 0 && errno == EINTR); // on file systems of a network
    struct stat status {};
    if (descriptor.value < 0 || ::fstat(descriptor.value, &status) != 0) throw systemError(errno);
    if (!S_ISREG(status.st_mode))
        throw Error(ExitStatus::badInput, file.string() + ": is not a regular file; name a PNG file");
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > limits.fileBytes)
        throw Error(ExitStatus::overLimit, file.string() + ": " + std::to_string(size) +
                                               " bytes are more than the limit of " + std::to_string(limits.fileBytes) +
                                               "; scale the picture down");
    std::vector<std::uint8_t> bytes(size);
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count = ::read(descriptor.value, bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw systemError(errno);
        if (count == 0) break; // it has become shorter: the decoder will say so
        filled += static_cast<std::size_t>(count);
    }
    bytes.resize(filled);
    return decodePng(bytes, file.string(), limits).image;
}

} // namespace shadowlab::image
