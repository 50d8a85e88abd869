// SPDX-License-Identifier: MIT
#include "app/cli/slides_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/capture_options.h"
#include "app/cli/option_values.h"
#include "app/picture/limits.h"

namespace shadowlab::cli {

void describeSlides(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    addArguments(command, "DECK",
                 "a built-in name (`list decks`) or a .json deck; may be repeated (default: all built-in decks)");
    add("-o,--output", "DIR", "the folder that the slides are written into; it is made where there is none");
    add("--only", "SLIDE", "draws that slide alone, and no page of all; several with commas between them");
    add("--size", "WxH", "width and height of the slides in pixels (default 1920x1080; 4K is 3840x2160)");
    add("--supersample", "N", "N x N samples for each pixel of a picture, from 1 to 8 (default 2)");
    add("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
    add("--allow", "DIR", "a further folder that the decks' scenes may take meshes from; may be repeated");
    command.footer(
        "For each deck: DECK-01-NAME.png ..., the same without words as pictures/DECK-01-NAME.png, DECK.html for "
        "a browser,\nand DECK.md for pandoc. Interrupted, the same command goes on where it was.\n"
        "Examples:\n"
        "  shadowlab slides -o out\n"
        "  shadowlab slides my-deck.json -o out --size 3840x2160\n"
        "  cd out && pandoc shadow-rendering-techniques.md -o lecture.pptx");
}

SlidesOptions slidesOptions(const CLI::App& command) {
    const GivenOptions given(command);
    SlidesOptions options;
    options.decks = given.texts("DECK");
    options.output = given.required("--output", "shadowlab slides -o DIR");
    options.only = splitAtCommas(given.texts("--only"));
    options.look.size = sizeFrom("--size", given.text("--size", "1920x1080"), "picture-side");
    constexpr int kLeastHeight = 360;                 // below, type dissolves
    constexpr double kNarrowest = 1.2, kWidest = 2.5; // shapes that slides are laid out for
    const double aspect = static_cast<double>(options.look.size.x) / options.look.size.y;
    if (options.look.size.y < kLeastHeight || aspect < kNarrowest || aspect > kWidest)
        refuseUsage(
            "--size: slides are at least 360 pixels high and 1.2 to 2.5 times as wide; write for example 1920x1080");
    constexpr int kMostSamples = 8;
    options.look.supersample = countFrom("--supersample", given.text("--supersample", "2"), kMostSamples);
    const std::uint64_t samplesOnASide = static_cast<std::uint64_t>(options.look.supersample);
    picture::reserveForPictures(static_cast<std::uint64_t>(options.look.size.x) * samplesOnASide *
                                    static_cast<std::uint64_t>(options.look.size.y) * samplesOnASide,
                                picture::kBytesPerDrawnSample, "--size " + given.text("--size", "1920x1080"),
                                "choose a smaller --size or --supersample");
    options.backend = context::backendFromName(given.text("--backend", "auto"));
    options.allowed = given.allowedFolders();
    return options;
}

} // namespace shadowlab::cli
