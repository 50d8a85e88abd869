// SPDX-License-Identifier: MIT
#include "app/picture/limits.h"

#include <algorithm>
#include <charconv>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::picture {

namespace {

scene::Limits& inForce() {
    static scene::Limits limits;
    return limits;
}

PictureLimits& picturesInForce() {
    static PictureLimits limits;
    return limits;
}

template <typename Limits, typename Value>
NamedLimit limit(std::string name, std::string unit, std::uint64_t most, Limits& (*inForce)(), Value Limits::*member) {
    return {std::move(name),
            std::move(unit),
            static_cast<std::uint64_t>(Limits().*member),
            most,
            [=] { return static_cast<std::uint64_t>(inForce().*member); },
            [=](std::uint64_t value) { inForce().*member = static_cast<Value>(value); }};
}
template <typename Value>
NamedLimit limit(std::string name, std::string unit, std::uint64_t most, Value scene::Limits::*member) {
    return limit(std::move(name), std::move(unit), most, inForce, member);
}
template <typename Value>
NamedLimit limit(std::string name, std::string unit, std::uint64_t most, Value PictureLimits::*member) {
    return limit(std::move(name), std::move(unit), most, picturesInForce, member);
}

} // namespace

const std::vector<NamedLimit>& namedLimits() {
    using scene::Limits;
    // Where raising ends: file sizes and lines where no disk and no memory follows; an image where no graphics card does; triangles
    // where a corner's number leaves 32 bits; levels of JSON where the reader's own recursion would leave its stack; a coordinate
    // where its square leaves float; memory where no machine follows; pictures where their numbers of pixels leave 32 bits (what the
    // driver draws is asked of it).
    static const std::vector<NamedLimit> all = {
        limit("mesh-file", "bytes", 1'000'000'000'000, &Limits::fileBytes),
        limit("material-file", "bytes", 1'000'000'000, &Limits::materialFileBytes),
        limit("mesh-line", "bytes", 1'000'000'000, &Limits::lineBytes),
        limit("scene-file", "bytes", 10'000'000'000, &Limits::sceneFileBytes),
        limit("image-file", "bytes", 10'000'000'000, &Limits::imageFileBytes),
        limit("image-side", "pixels", 32768, &Limits::imageSide),
        limit("triangles", "", 1'000'000'000, &Limits::triangles),
        limit("polygon-corners", "", 1'000'000, &Limits::polygonCorners),
        limit("objects", "", 10'000'000, &Limits::objects),
        limit("lights", "", 10'000, &Limits::lights),
        limit("json-depth", "levels", 1000, &Limits::jsonDepth),
        limit("coordinate", "m", 1'000'000'000'000'000, &Limits::coordinate),
        limit("memory", "bytes", 1'000'000'000'000'000, &Limits::memoryBytes),
        limit("picture-side", "pixels", 32768, &PictureLimits::side),
        limit("picture-samples", "samples", 1'000'000'000, &PictureLimits::samples),
        limit("measured-side", "pixels", 32768, &PictureLimits::measuredSide),
        limit("supersample", "samples on a side", 64, &PictureLimits::supersample),
        limit("frames", "", 100'000'000, &PictureLimits::frames),
    };
    return all;
}

const scene::Limits& limits() { return inForce(); }

const PictureLimits& pictureLimits() { return picturesInForce(); }

std::uint64_t limitNamed(std::string_view name) {
    return std::ranges::find(namedLimits(), name, &NamedLimit::name)->value();
}

std::vector<std::string> limitWords() {
    std::vector<std::string> words;
    for (const NamedLimit& one : namedLimits())
        if (one.value() != one.standard)
            words.insert(words.end(), {"--limit", one.name + "=" + std::to_string(one.value())});
    return words;
}

void setLimit(const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    std::vector<std::string> known;
    for (const NamedLimit& one : namedLimits()) {
        known.push_back(one.name);
        if (one.name != name) continue;
        const std::string text = equals == std::string::npos ? "" : assignment.substr(equals + 1);
        std::uint64_t value = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (fault != std::errc() || end != text.data() + text.size() || value < 1 || value > one.most)
            throw Error(ExitStatus::usage, "--limit " + name + ": " + scene::inQuotes(text) +
                                               " is no whole number from 1 to " + std::to_string(one.most) +
                                               "; write --limit " + name + "=" + std::to_string(one.standard));
        one.set(value);
        return;
    }
    throw Error(ExitStatus::usage, "--limit: no limit that can be set is called " + scene::inQuotes(name) + "; " +
                                       suggestion(name, known));
}

void reserveForPictures(std::uint64_t samples, std::uint64_t bytesPerSample, const std::string& asked,
                        const std::string& remedy) {
    scene::Limits& limits = inForce();
    limits.pictureBytes = samples * bytesPerSample;
    if (const std::uint64_t needed = scene::memoryForTriangles(0, limits); needed > limits.memoryBytes)
        throw Error(ExitStatus::overLimit, asked + ": " + scene::beyondMemory(needed, limits.memoryBytes) + "; " +
                                               remedy + ", or set --limit memory=VALUE");
}

} // namespace shadowlab::picture
