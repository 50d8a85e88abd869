// Reads a deck with the readers of lessons and scene files.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "app/course/deck.h"
#include "app/course/explore/explored_slide.h"
#include "app/course/lessons/lesson_parts.h"
#include "app/course/state_json.h"
#include "app/drawing/prose.h"
#include "app/figures/figures.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

using scene::JsonObject;
using scene::JsonValue;
using scene::Range;

// What fits on a slide in type that is read from the last row.
constexpr std::size_t kLongestCaption = 280, kLongestParagraph = 320, kLongestFormula = 600, kLongestAlt = 600,
                      kLongestNote = 1200, kLongestName = 60;
constexpr std::size_t kMostSlides = 300, kMostPictures = 8, kMostLines = 12;

std::string optionalText(const JsonObject& object, std::string_view key, std::size_t longest) {
    return object.find(key) ? shortText(object, key, longest) : "";
}

std::vector<std::string> paragraphs(const JsonObject& object, std::string_view key, std::size_t longest) {
    std::vector<std::string> found;
    for (const auto& [text, offset] : texts(object, key)) {
        if (text.empty() || text.size() > longest)
            object.document().fail(offset, text.empty() ? "is empty; write it, or leave it out"
                                                        : "has " + std::to_string(text.size()) + " characters, and " +
                                                              std::to_string(longest) + " fit; make it shorter");
        found.push_back(text);
    }
    if (found.size() > kMostLines)
        object.fail(key, "has " + std::to_string(found.size()) + " entries, and " + std::to_string(kMostLines) +
                             " fit; make two slides of it");
    return found;
}

std::optional<dvec2> share(const JsonObject& object, std::string_view key) {
    if (!object.find(key)) return {};
    return object.pair(key, Range::between(0, 1));
}

std::vector<Callout> readCallouts(const JsonObject& picture) {
    std::vector<Callout> callouts;
    for (const JsonValue& value : picture.array("callouts")) {
        const JsonObject keys(picture.document(), value, "callout " + std::to_string(callouts.size() + 1),
                              {"box", "from", "to", "label"});
        Callout callout;
        callout.label = optionalText(keys, "label", kLongestLabel);
        callout.isArrow = keys.find("box") == nullptr;
        if (callout.isArrow) {
            callout.from = keys.pair("from", Range::between(0, 1));
            callout.to = keys.pair("to", Range::between(0, 1));
        } else {
            for (const char* key : {"from", "to"})
                if (keys.find(key)) keys.fail(key, "is an arrow's, and \"box\" is a frame; write either");
            const LookBox box = readBox(keys);
            callout.from = box.corner;
            callout.to = box.corner + box.size;
        }
        callouts.push_back(std::move(callout));
    }
    return callouts;
}

} // namespace

struct Deck::File {
    std::string name;
    std::filesystem::path path;
    scene::LoadOptions options;
    scene::JsonDocument document;
    JsonObject top;
    StateReader states;
    std::string title, subtitle;
    std::vector<std::string> names;

    File(std::filesystem::path file, const scene::LoadOptions& loading)
        : name(file.stem().string()), path(std::move(file)), options(loading),
          document(scene::readFile(path, picture::limits().sceneFileBytes, "scene-file"), path,
                   picture::limits().jsonDepth, "a deck, starting with {"),
          top(document, document.root(), "the deck",
              {"title", "subtitle", "scene", "camera", "lights", "layout", "light", "slots", "stage", "step", "split",
               "set", "slides"}),
          states(document, path, options) {
        title = shortText(top, "title", kLongestTitle);
        subtitle = optionalText(top, "subtitle", kLongestTitle);
        if (top.find("scene")) (void)top.text("scene"); // also where every slide names its own
        if (top.array("slides").size() > kMostSlides)
            top.fail("slides", "has more than " + std::to_string(kMostSlides) + " slides; make two decks of it");
        for (const JsonValue& value : top.array("slides")) {
            const JsonValue* found = nullptr;
            if (value.kind == JsonValue::Kind::object)
                for (const scene::JsonMember& member : value.members)
                    if (member.key == "name") found = &member.value;
            const bool isName = found && found->kind == JsonValue::Kind::string && !found->string.empty() &&
                                found->string.size() <= kLongestName && std::ranges::all_of(found->string, [](char c) {
                                    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
                                });
            const std::string which = "slide " + std::to_string(names.size() + 1);
            if (!isName)
                document.fail(found ? found->offset : value.offset,
                              which +
                                  " needs a \"name\" of small letters, digits and -, which its files get; write for "
                                  "example \"z-fail\"");
            if (std::ranges::find(names, found->string) != names.end())
                document.fail(found->offset, "two slides are called " + scene::inQuotes(found->string) +
                                                 "; choose another name for one");
            names.push_back(found->string);
        }
        if (names.empty()) top.fail("slides", "is missing or empty; write a list of slides");
    }

    /// Its formulas in plain words; a fault in one is told with the place of the key.
    [[nodiscard]] std::string plainText(const JsonObject& own, std::string_view key, const std::string& written) const {
        const JsonValue* value = own.find(key);
        return value ? saidAt(document, value->offset, [&] { return drawing::plainProse(written); }) : "";
    }

    SlidePicture picture(std::span<const JsonObject* const> levels) {
        const JsonObject& own = *levels.back();
        SlidePicture picture;
        picture.state = states.read(levels);
        picture.pixel = share(own, "pixel");
        picture.partner = share(own, "partner");
        if (own.find("diagram")) {
            picture.figure = own.text("diagram");
            saidAt(document, own.require("diagram", "").offset,
                   [&] { return figures::findFigure(picture.figure).name; });
        }
        picture.writtenLabel = optionalText(own, "label", kLongestTitle);
        picture.label = plainText(own, "label", picture.writtenLabel);
        picture.callouts = readCallouts(own);
        if (const JsonValue* camera = own.find("outside"))
            picture.outside = scene::readCamera(scene::NumberRanges{}, document, *camera, "the camera outside",
                                                lab::outsideCameraOf(*picture.state.scene, picture.state.camera));
        if (own.find("volumes") || own.find("near-clip"))
            picture.outsideChoice = saidAt(document, own.require(own.find("volumes") ? "volumes" : "near-clip", "").offset, [&] {
                return picture::outsideChoiceOf(own.find("volumes") ? own.text("volumes") : "",
                                                own.boolean("near-clip", false), *picture.state.scene,
                                                "volumes");
            });
        if (!picture.figure.empty() && !picture.pixel)
            own.fail("diagram", "is about a pixel; write \"pixel\": [0.5, 0.5], in shares of the picture");
        if (!picture.figure.empty() && picture.state.slots.size() != 1)
            own.fail("diagram", "is drawn by one technique; write one under \"slots\"");
        if (picture.partner && !picture.pixel)
            own.fail("partner", "is the second of two pixels; write the first under \"pixel\"");
        return picture;
    }

    Slide slide(std::size_t number) {
        const JsonValue& value = top.array("slides")[number];
        const JsonObject own(document, value, "slide " + scene::inQuotes(names[number]),
                             {"name",     "title",   "supersample", "pictures", "text",    "pseudocode", "marked",
                              "formulas", "caption", "alt",         "scene",    "camera",  "lights",     "layout",
                              "light",    "slots",   "stage",       "step",     "split",   "set",        "pixel",
                              "partner",  "diagram", "outside",     "volumes",  "near-clip", "label",    "callouts", "notes",     "explore"});
        Slide slide;
        slide.name = names[number];
        slide.written = {shortText(own, "title", kLongestTitle), optionalText(own, "caption", kLongestCaption),
                         paragraphs(own, "text", kLongestParagraph)};
        slide.title = plainText(own, "title", slide.written.title);
        slide.caption = plainText(own, "caption", slide.written.caption);
        for (const std::string& text : slide.written.text)
            slide.text.push_back(plainText(own, "text", text));
        slide.formulas = paragraphs(own, "formulas", kLongestFormula);
        slide.written.notes = paragraphs(own, "notes", kLongestNote);
        for (const std::string& note : slide.written.notes)
            slide.notes.push_back(plainText(own, "notes", note));
        if (own.find("supersample")) slide.supersample = own.integer("supersample", 1, 8);
        readPseudocode(own, slide);
        if (own.find("pictures")) {
            for (const JsonValue& one : own.array("pictures")) {
                const JsonObject keys(document, one, "picture " + std::to_string(slide.pictures.size() + 1),
                                      {"scene", "camera", "lights", "layout", "light", "slots", "stage", "step",
                                       "split", "set", "pixel", "partner", "diagram", "outside", "volumes",
                                       "near-clip", "label", "callouts"});
                const std::array<const JsonObject*, 3> levels{&top, &own, &keys};
                slide.pictures.push_back(picture(levels));
            }
            for (const char* key : {"pixel", "partner", "diagram", "outside", "volumes", "near-clip", "label", "callouts"})
                if (own.find(key)) own.fail(key, "belongs to one picture; write it there");
            if (slide.pictures.empty() || slide.pictures.size() > kMostPictures)
                own.fail("pictures", "are 1 to " + std::to_string(kMostPictures) + "; write as many");
        } else if (own.find("slots")) {
            const std::array<const JsonObject*, 2> levels{&top, &own};
            slide.pictures.push_back(picture(levels));
        }
        slide.explore = readExplore(own);
        if (slide.explore)
            saidAt(document, own.require("explore", "").offset, [&] { return panesOf(slide, *slide.explore).size(); });
        if (!slide.pictures.empty()) slide.alt = shortText(own, "alt", kLongestAlt);
        if (slide.pictures.empty() && slide.text.empty() && slide.formulas.empty() && slide.pseudocode.empty())
            own.fail("title", "stands alone: the slide shows nothing; write \"slots\", \"pictures\", \"text\" or "
                              "\"formulas\"");
        return slide;
    }

    void readPseudocode(const JsonObject& own, Slide& slide) const {
        if (!own.find("pseudocode")) {
            if (own.find("marked")) own.fail("marked", "are lines of \"pseudocode\"; write that, too");
            return;
        }
        const std::string technique = own.text("pseudocode");
        const TechniqueInfo& info = saidAt(document, own.require("pseudocode", "").offset,
                                           [&]() -> const TechniqueInfo& { return findTechnique(technique); });
        std::istringstream text{std::string(info.pseudocode)};
        for (std::string line; std::getline(text, line);)
            slide.pseudocode.push_back(line);
        if (slide.pseudocode.empty()) own.fail("pseudocode", "is of a technique that has none; choose another");
        const auto lines = static_cast<int>(slide.pseudocode.size());
        for (const JsonValue& value : own.array("marked")) {
            if (value.kind != JsonValue::Kind::number || value.number != std::floor(value.number) ||
                !(value.number >= 1 && value.number <= lines)) // before it becomes an int, which 1e300 cannot
                document.fail(value.offset,
                              "is no line of the pseudocode; write a number from 1 to " + std::to_string(lines));
            slide.marked.push_back(static_cast<int>(value.number));
        }
    }
};

Deck::Deck(const std::string& nameOrPath, const scene::LoadOptions& options) {
    std::filesystem::path file(nameOrPath);
    if (file.extension() != ".json") {
        const std::vector<std::string> known = builtInDecks(options.assetsRoot);
        if (std::ranges::find(known, nameOrPath) == known.end())
            throw Error(ExitStatus::badInput, "deck '" + scene::shown(nameOrPath) +
                                                  "': neither a built-in deck nor a .json file; " +
                                                  suggestion(nameOrPath, known));
        file = options.assetsRoot / "decks" / (nameOrPath + ".json");
    }
    opened_ = std::make_unique<File>(std::move(file), options);
}
Deck::~Deck() = default;
Deck::Deck(Deck&&) noexcept = default;

const std::string& Deck::name() const { return opened_->name; }
const std::filesystem::path& Deck::file() const { return opened_->path; }
const std::string& Deck::text() const { return opened_->document.text(); }
const std::string& Deck::title() const { return opened_->title; }
const std::string& Deck::subtitle() const { return opened_->subtitle; }
const std::vector<std::string>& Deck::slides() const { return opened_->names; }
Slide Deck::read(std::size_t slide) { return opened_->slide(slide); }

std::vector<std::string> builtInDecks(const std::filesystem::path& assets) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(assets / "decks", ignored))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

} // namespace shadowlab::course
