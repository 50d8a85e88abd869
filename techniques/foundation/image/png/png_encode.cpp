// Encoding through libpng. Why some functions here own nothing: see png_failure.h.
// SPDX-License-Identifier: MIT
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <new>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/image/png/png_failure.h"
#include "techniques/foundation/image/utf8.h"

namespace shadowlab::image {
namespace {

void appendBytes(png_structp png, png_bytep data, png_size_t size) {
    bool full = false;
    try {
        auto* out = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
        out->insert(out->end(), data, data + size);
    } catch (const std::bad_alloc&) {
        full = true;
    }
    if (full) png_error(png, "out of memory"); // outside the handler: a longjmp may not leave a catch block
}

struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;
    PngFailure failure;
    Writer() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, onPngError, onPngWarning)) {
        if (png) info = png_create_info_struct(png);
        if (!info) {
            png_destroy_write_struct(&png, nullptr);
            throw std::bad_alloc();
        }
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

struct WriteJob {
    png_uint_32 width, height;
    int colorType;
    bool dropAlpha, isColor;
    png_bytepp rows;
    png_textp texts;
    int textCount;
    std::vector<std::uint8_t>* out;
};

/// Returns false after an error. Owns nothing: see png_failure.h.
bool writePng(const Writer& writer, const WriteJob& job) {
    const png_structp png = writer.png;
    const png_infop info = writer.info;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, job.out, appendBytes, nullptr);
    // Level 6: level 9 takes four times as long for pictures 3 % smaller, level 1 gives files half as large again.
    png_set_compression_level(png, 6);
    png_set_IHDR(png, info, job.width, job.height, 8, job.colorType, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    // Relative colorimetric: colours here are codes (false lit orange, false shadow blue) that a viewer has to
    // reproduce as they are. Perceptual would let it shift all of them to fit a printer's range.
    if (job.isColor) png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
    if (job.textCount > 0) png_set_text(png, info, job.texts, job.textCount);
    png_write_info(png, info);
    if (job.dropAlpha) png_set_filler(png, 0, PNG_FILLER_AFTER);
    png_write_image(png, job.rows);
    png_write_end(png, info);
    return true;
}

/// Latin-1 where the text allows (tEXt, understood everywhere), else UTF-8 (iTXt).
struct EncodedText {
    std::string key, value;
    bool latin1 = true;
};
EncodedText encodeText(const PngText& text) {
    const std::u32string key = decodeUtf8(text.key), value = decodeUtf8(text.value);
    const auto printable = [](char32_t c) { return (c >= 32 && c <= 126) || (c >= 161 && c <= 255); };
    if (key.empty() || key.size() > 79 || !std::all_of(key.begin(), key.end(), printable))
        throw Error(ExitStatus::bug,
                    "PNG text key \"" + text.key + "\" is not 1 to 79 printable Latin-1 characters; report it");
    EncodedText result;
    result.latin1 =
        std::all_of(value.begin(), value.end(), [&](char32_t c) { return printable(c) || c == '\n' || c == 160; });
    result.key.assign(key.begin(), key.end());
    if (result.latin1)
        result.value.assign(value.begin(), value.end());
    else
        result.value = encodeUtf8(value);
    return result;
}

std::vector<std::uint8_t> encode(const std::uint8_t* pixels, std::size_t rowBytes, WriteJob job,
                                 const std::vector<PngText>& texts) {
    std::vector<EncodedText> encoded;
    for (const PngText& text : texts)
        encoded.push_back(encodeText(text));
    std::vector<png_text> chunks(encoded.size());
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        chunks[i].compression = encoded[i].latin1 ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        chunks[i].key = encoded[i].key.data();
        chunks[i].text = encoded[i].value.data();
        (encoded[i].latin1 ? chunks[i].text_length : chunks[i].itxt_length) = encoded[i].value.size();
    }
    std::vector<png_bytep> rows(job.height);
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] = const_cast<png_bytep>(pixels + y * rowBytes);

    std::vector<std::uint8_t> bytes;
    const Writer writer;
    job.rows = rows.data();
    job.texts = chunks.data();
    job.textCount = static_cast<int>(chunks.size());
    job.out = &bytes;
    if (!writePng(writer, job))
        throw Error(ExitStatus::bug, std::string("the PNG encoder failed: ") + writer.failure.message + "; report it");
    return bytes;
}

} // namespace

std::vector<std::uint8_t> encodePng(const Image& image, const PngOptions& options) {
    WriteJob job{};
    job.width = static_cast<png_uint_32>(image.width);
    job.height = static_cast<png_uint_32>(image.height);
    job.colorType = options.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
    job.dropAlpha = options.opaque;
    job.isColor = true;
    return encode(image.rgba.data(), static_cast<std::size_t>(image.width) * kChannels, job, options.text);
}

std::vector<std::uint8_t> encodeGreyAlpha(int width, int height, std::span<const std::uint8_t> greyAlpha,
                                          const std::vector<PngText>& text) {
    const std::size_t rowBytes = static_cast<std::size_t>(width) * 2;
    if (greyAlpha.size() != rowBytes * static_cast<std::size_t>(height))
        throw Error(ExitStatus::bug, "a grey and alpha picture has the wrong number of bytes; report it");
    WriteJob job{};
    job.width = static_cast<png_uint_32>(width);
    job.height = static_cast<png_uint_32>(height);
    job.colorType = PNG_COLOR_TYPE_GRAY_ALPHA;
    return encode(greyAlpha.data(), rowBytes, job, text);
}

} // namespace shadowlab::image
